#pragma once

#include "../material/equation_of_state.hpp"
#include "element_pack.hpp"
#include "hourglass_control.hpp"
#include "stability.hpp"
#include "step_geometry.hpp"
#include "step_motion.hpp"
#include "viscosity.hpp"

/// Pressure of a pack over a step, where an equation of state gives it: it takes the place of the mean stress that
/// strength has left, and of the bulk modulus in the stable step.
namespace pinball {

/// The work of a step that is none of the pressure's: of the deviator, of the bulk viscosity, and what yield has taken
/// from hourglass modes [energy].
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION T work_beside_pressure(const ElementPack<T, L>& own, const MiddleSize<T>& middle,
                                        const StepMotion<T, features>& motion, const Symmetric<T>& stress_old,
                                        const Symmetric<T>& stress, const ViscousStep<T>& viscosity,
                                        const HourglassStep<T, features>& hourglass) {
  const Symmetric<T> sum = stress_old + stress;
  const T half_volume = number<T>(0.5) * middle.volume;
  T work = half_volume * (contract(sum, motion.strain) - number<T>(1.0 / 3.0) * trace(sum) * motion.volumetric);
  if (viscosity.acts()) {
    work += half_volume * (own.get(own.arrays.viscous_stress) + viscosity.stress()) * motion.volumetric;
  }
  if (hourglass.any_lost) work += hourglass.taken();
  return work;
}

/// Gives a stress the pressure of the equation of state; returns rho c^2 [stress]. numbers: of `places`; volume: of the
/// undeformed element; inverse_volume: of the one at the end of the step; change: of the volume in the step; old: the
/// stress before it; work: of work_beside_pressure [energy]; there: elements that have a volume.
template <class T, int L>
PINBALL_FUNCTION T set_pressure(const EquationOfState<ScalarOf<T>>& eos, const ElementNumbers<T, L>& numbers,
                                const MaterialPlaces& places, const MaskOf<T>& there, const T& volume,
                                const T& inverse_volume, const T& change, const T& work, const Symmetric<T>& old,
                                Symmetric<T>& stress) {
  const T third = number<T>(1.0 / 3.0), inverse = select(there, T(1) / select(there, volume, T(1)), T(0));
  PressureStep<T> step{select(there, volume * inverse_volume - T(1), T(0)), inverse * change, inverse * work,
                       -third * trace(old)};
  if (eos.crushes) {
    step.most = numbers.get(places.compaction);
    const T strain = table_strain(eos, step.compression).value;
    numbers.set(places.compaction, select(there, most_after(eos, strain, step.most), step.most));
  }
  if (eos.tears) step.torn = numbers.get(places.torn);
  const PressureState<T> now = pressure_after(eos, step, numbers.get(places.energy));
  numbers.set(places.energy, select(there, now.energy, T(0)));
  if (eos.tears) numbers.set(places.torn, select(there, now.torn, step.torn));
  const T difference = -now.value - third * trace(stress);
  stress.xx += difference;
  stress.yy += difference;
  stress.zz += difference;
  return now.bulk_modulus;
}

/// Stable rate of a foam.
template <class T>
PINBALL_FUNCTION T rate_of_foam(const ElementConstants<ScalarOf<T>>& constants, const StabilityBound<T>& bound,
                                const T& compaction) {
  using S = ScalarOf<T>;
  const MaterialConstants<S>& material = constants.material;
  const S elastic = material.lambda + S(2.0 / 3.0) * material.mu;
  const T bulk_modulus = foam_bulk_modulus(constants.foam, constants.hardening, elastic, compaction);
  StabilityBound<T> damped = bound;
  if (constants.foam.damping > 0) {
    damped.viscosity += damping_viscosity(constants.foam, material, T(bound.end.volume / bound.end.area));
  }
  return damped.rate(bulk_modulus - T(S(2.0 / 3.0) * material.mu), T(material.mu));
}

/// Both, after yield; the stable rate is that of a linear material of that rho c^2. A brittle material has its pressure
/// from its strength, and rho c^2 = (1 + mu) dp/dmu; a foam has no pressure of its own.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION void follow_equation_of_state(const ElementConstants<ScalarOf<T>>& constants,
                                               const ElementPack<T, L>& own, const ElementNumbers<T, L>& numbers,
                                               const StabilityBound<T>& bound, const MiddleSize<T>& middle,
                                               const StepMotion<T, features>& motion, const ViscousStep<T>& viscosity,
                                               const HourglassStep<T, features>& hourglass,
                                               const Symmetric<T>& stress_old, Symmetric<T>& stress, T& stable_rate) {
  using S = ScalarOf<T>;
  if constexpr (features.yield == YieldLaw::general) {
    if (constants.pressure.law != PressureLaw::linear) {
      const T work = work_beside_pressure(own, middle, motion, stress_old, stress, viscosity, hourglass);
      const T bulk_modulus = set_pressure(constants.pressure, numbers, constants.places, middle.whole,
                                          own.mass * T(constants.specific_volume), middle.inverse_end_volume,
                                          middle.volume * motion.volumetric, work, stress_old, stress);
      if (constants.fluid.used) {
        StabilityBound<T> damped = bound;
        damped.viscosity += T(damping_viscosity(constants.fluid));
        stable_rate = damped.rate(bulk_modulus, T(0));
        return;
      }
      stable_rate = bound.rate(bulk_modulus - T(S(2.0 / 3.0) * constants.material.mu), T(constants.material.mu));
    } else if (constants.brittle.used) {
      const T density = own.mass * T(constants.specific_volume) * middle.inverse_end_volume;  // over that at rest
      const T slope = brittle_pressure(constants.brittle, T(density - T(1))).slope;
      stable_rate = bound.rate(maximum(T(0), density * slope) - T(S(2.0 / 3.0) * constants.material.mu),
                               T(constants.material.mu));
    } else if (constants.foam.used) {
      const T density = own.mass * middle.inverse_end_volume;
      stable_rate = rate_of_foam(constants, bound, compaction_of(constants, density));
    }
  }
}

}  // namespace pinball
