#pragma once

#include "../element/element_pack.hpp"
#include "../element/step_geometry.hpp"
#include "../element_data.hpp"
#include "../rotation.hpp"
#include "general_yield.hpp"

/// What the element kernel asks of a material beyond MaterialConstants (YieldLaw::general): which law of strength an
/// element has, what it keeps, and whether it has failed. Numbers are those of MaterialPlaces.
namespace pinball {

/// Five numbers of a back stress: xx yy xy yz zx; its trace is zero.
template <class T, int L>
PINBALL_FUNCTION Symmetric<T> back_stress(const ElementNumbers<T, L>& numbers, int place) {
  const T xx = numbers.get(place), yy = numbers.get(place + 1);
  return {xx, yy, -(xx + yy), numbers.get(place + 2), numbers.get(place + 3), numbers.get(place + 4)};
}
template <class T, int L>
PINBALL_FUNCTION void set_back_stress(const Symmetric<T>& back, const ElementNumbers<T, L>& numbers, int place) {
  numbers.set(place, back.xx);
  numbers.set(place + 1, back.yy);
  numbers.set(place + 2, back.xy);
  numbers.set(place + 3, back.yz);
  numbers.set(place + 4, back.zx);
}

/// 1 - V/V_0 at a density; 0 where there is no element.
template <class T>
PINBALL_FUNCTION T compaction_of(const ElementConstants<ScalarOf<T>>& constants, const T& density) {
  const auto there = density > T(0);
  return select(there, T(1) - T(1) / select(there, density * T(constants.specific_volume), T(1)), T(0));
}

/// How an element moves in a step.
template <class T>
struct ElementMotion {
  const Symmetric<T>& deformation;  ///< rate of it in the middle of the step [1/time]
  const Rotation<T>& rotation;
  ScalarOf<T> dt;           ///< [time]
  const T& density;         ///< [mass/length^3]
  const EndSize<T>& shape;  ///< of the element itself
};

/// What a material makes of a trial stress.
template <class T>
struct YieldOutcome {
  LostHourglassEnergy<T> lost{T(0), T(0)};
  bool any_lost = false;    ///< whether any lane may have yielded
  MaskOf<T> failed{false};  ///< elements that the material lets go
};

/// Johnson and Cook: heat, and damage where the material fails.
template <HourglassKind kind, class T, int L>
PINBALL_FUNCTION void yield_with_heat(const ElementConstants<ScalarOf<T>>& constants, const ElementMotion<T>& motion,
                                      const ElementNumbers<T, L>& numbers, KeptHourglass<T, kind>& kept,
                                      Symmetric<T>& stress, T& plastic_strain, YieldOutcome<T>& outcome) {
  const JohnsonCookConstants<ScalarOf<T>>& law = constants.johnson_cook;
  const MaterialPlaces& places = constants.places;
  const T temperature = places.temperature < 0 ? T(0) : numbers.get(places.temperature);
  const T damage_before = places.damage < 0 ? T(0) : numbers.get(places.damage);
  const T hardened = places.hardening < 0 ? plastic_strain : numbers.get(places.hardening);
  JohnsonCookYield<T> strength(constants.material, law, motion.deformation, motion.dt, hardened, temperature);
  if (places.hardening >= 0) strength.weaken(damage_before);
  Symmetric<T> back{T(0), T(0), T(0), T(0), T(0), T(0)};
  const Symmetric<T> trial = stress;
  const T strain_before = plastic_strain;
  outcome.any_lost = return_generally(strength, kept, stress, back, plastic_strain, outcome.lost);
  if (!outcome.any_lost) return;
  if (places.temperature >= 0) {
    // s : de_p, of what the return has taken of the stress: 2 mu de_p
    const T work = contract(stress, trial - stress) * T(ScalarOf<T>(0.5) / constants.material.mu);
    const auto there = motion.density > T(0);
    const T heating = select(there, T(law.heating) * work / select(there, motion.density, T(1)), T(0));
    numbers.set(places.temperature, temperature + heating);
  }
  if (places.damage >= 0) {
    const T increment = plastic_strain - strain_before;
    const T damage = damage_before + damage_increment(law, stress, increment, strength.rate(increment), temperature);
    if (places.hardening >= 0) numbers.set(places.hardening, hardened + left_by(law, damage_before) * increment);
    numbers.set(places.damage, damage);
    outcome.failed = damage >= T(1);
  }
}

/// Johnson and Holmquist: pressure, strength and damage. In a step of no length nothing yields.
template <HourglassKind kind, class T, int L>
PINBALL_FUNCTION void break_brittly(const ElementConstants<ScalarOf<T>>& constants, const ElementMotion<T>& motion,
                                    const ElementNumbers<T, L>& numbers, KeptHourglass<T, kind>& kept,
                                    Symmetric<T>& stress, T& plastic_strain, YieldOutcome<T>& outcome) {
  const JohnsonHolmquistConstants<ScalarOf<T>>& law = constants.brittle;
  const MaterialPlaces& places = constants.places;
  const T damage = numbers.get(places.damage), bulking = numbers.get(places.bulking);
  const auto there = motion.density > T(0);
  const T compression = select(there, motion.density * T(constants.specific_volume) - T(1), T(0));
  const T least = (damage - T(1)) * T(law.tension);
  const T pressure = maximum(brittle_pressure(law, compression).value + bulking, least);
  const T shift = -pressure - number<T>(1.0 / 3.0) * trace(stress);
  stress.xx += shift;
  stress.yy += shift;
  stress.zz += shift;
  if (!(motion.dt > 0)) return;
  JohnsonHolmquistYield<T> strength(constants.material, law, motion.deformation, pressure, damage);
  Symmetric<T> back{T(0), T(0), T(0), T(0), T(0), T(0)};
  const T strain_before = plastic_strain;
  outcome.any_lost = return_generally(strength, kept, stress, back, plastic_strain, outcome.lost);
  if (!outcome.any_lost) return;
  const T after = strength.damaged_by(plastic_strain - strain_before);
  numbers.set(places.bulking, bulking_after(law, constants.material.mu, T(T(law.modulus[0]) * compression), bulking,
                                            strength.strength_at(damage), strength.strength_at(after)));
  numbers.set(places.damage, after);
  if (law.erodes) outcome.failed = after >= T(1);
}

/// Strength of the pressure alone, which is that of the equation of state, or of the stress.
template <HourglassKind kind, class T, int L>
PINBALL_FUNCTION void yield_under_pressure(const ElementConstants<ScalarOf<T>>& constants,
                                           const ElementMotion<T>& motion, const ElementNumbers<T, L>& numbers,
                                           KeptHourglass<T, kind>& kept, Symmetric<T>& stress, T& plastic_strain,
                                           YieldOutcome<T>& outcome) {
  const EquationOfState<ScalarOf<T>>& eos = constants.pressure;
  const MaterialPlaces& places = constants.places;
  T pressure = number<T>(-1.0 / 3.0) * trace(stress);
  if (eos.law != PressureLaw::linear) {
    const auto there = motion.density > T(0);
    const T compression = select(there, motion.density * T(constants.specific_volume) - T(1), T(0));
    const T most = eos.crushes ? numbers.get(places.compaction) : T(0);
    const T torn = eos.tears ? numbers.get(places.torn) : T(0);
    pressure = pressure_of_energy(eos, compression, most, torn, numbers.get(places.energy));
  }
  IdealYield<T> strength(constants.material, effective_strength(constants.granular, pressure));
  Symmetric<T> back{T(0), T(0), T(0), T(0), T(0), T(0)};
  outcome.any_lost = return_generally(strength, kept, stress, back, plastic_strain, outcome.lost);
}

/// What foams have beside the stress of their skeleton, at the end of a step.
template <class T>
PINBALL_FUNCTION Symmetric<T> stress_beside_skeleton(const ElementConstants<ScalarOf<T>>& constants,
                                                     const ElementMotion<T>& motion, const T& compaction) {
  using S = ScalarOf<T>;
  const CrushableFoamConstants<S>& law = constants.foam;
  Symmetric<T> beside{T(0), T(0), T(0), T(0), T(0), T(0)};
  if (law.damping > 0) {
    const T time = T(law.damping) * (motion.shape.volume / motion.shape.area);
    const MaterialConstants<S>& material = constants.material;
    beside = elastic_increment(T(time * T(material.lambda)), T(time * T(material.mu)), motion.deformation);
  }
  if (law.air_pressure > 0) {
    const T pressure = air_pressure(law, compaction).value;
    beside.xx -= pressure;
    beside.yy -= pressure;
    beside.zz -= pressure;
  }
  return beside;
}

/// Foams: each principal stress of the skeleton by itself, then what is beside it.
template <HourglassKind kind, class T, int L>
PINBALL_FUNCTION void crush(const ElementConstants<ScalarOf<T>>& constants, const ElementMotion<T>& motion,
                            const ElementNumbers<T, L>& numbers, KeptHourglass<T, kind>& kept, Symmetric<T>& stress,
                            T& plastic_strain, YieldOutcome<T>& outcome) {
  const CrushableFoamConstants<ScalarOf<T>>& law = constants.foam;
  const int place = constants.places.beside;
  if (place >= 0) stress = stress - rotate(motion.rotation, symmetric_at(numbers, place));
  const T compaction = compaction_of(constants, motion.density);
  const T yield = foam_strength(constants.hardening, compaction).stress;
  const T most = law.cutoff < ScalarOf<T>(INFINITY) ? T(law.cutoff) : yield;
  const Symmetric<T> taken = limit_principal_values(T(T(-1) * yield), most, stress);
  plastic_strain += crushing_increment(constants.material, taken);
  if constexpr (keeps_hourglass_state(kind)) {
    // Hourglass stresses are bounded by themselves, at half of the range of a principal stress (bending_yield.hpp).
    const T bending = number<T>(0.5) * (yield + most), variation = kept.variation(), none(0);
    outcome.any_lost = any_lane(largest_effective_square(none, variation) > bending * bending);
    if (outcome.any_lost) {
      Symmetric<T> centre{T(0), T(0), T(0), T(0), T(0), T(0)};
      const Symmetric<T> deviator = centre;
      T strain(0);
      outcome.lost = kept.yield(IdealYield<T>(constants.material, bending), deviator, none, variation, centre, strain);
    }
  }
  if (place < 0) return;
  const Symmetric<T> beside = stress_beside_skeleton(constants, motion, compaction);
  set_symmetric(beside, numbers, place);
  stress = stress + beside;
}

/// Yield of a step, with what is kept. In a step of no length nothing strains, and its rates are those of the next.
template <HourglassKind kind, class T, int L>
PINBALL_FUNCTION YieldOutcome<T> yield_generally(const ElementConstants<ScalarOf<T>>& constants,
                                                 const ElementMotion<T>& motion, const ElementNumbers<T, L>& numbers,
                                                 KeptHourglass<T, kind>& kept, Symmetric<T>& stress,
                                                 T& plastic_strain) {
  YieldOutcome<T> outcome;
  if (constants.fluid.used) {
    flow(constants.fluid, motion.deformation, stress);
    return outcome;
  }
  if (constants.johnson_cook.used) {
    if (motion.dt > 0) yield_with_heat(constants, motion, numbers, kept, stress, plastic_strain, outcome);
    return outcome;
  }
  if (constants.brittle.used) {
    break_brittly(constants, motion, numbers, kept, stress, plastic_strain, outcome);
    return outcome;
  }
  if (constants.granular.used) {
    if (motion.dt > 0) yield_under_pressure(constants, motion, numbers, kept, stress, plastic_strain, outcome);
    return outcome;
  }
  if (constants.foam.used) {
    if (motion.dt > 0) crush(constants, motion, numbers, kept, stress, plastic_strain, outcome);
    return outcome;
  }
  const int place = constants.places.back_stress;
  Symmetric<T> back{T(0), T(0), T(0), T(0), T(0), T(0)};
  if (place >= 0) back = rotate(motion.rotation, back_stress(numbers, place));
  if (motion.dt > 0) {
    GeneralYield<T> law(constants.material, constants.hardening, motion.deformation, motion.dt);
    outcome.any_lost = return_generally(law, kept, stress, back, plastic_strain, outcome.lost);
  }
  if (place >= 0) set_back_stress(back, numbers, place);
  return outcome;
}

}  // namespace pinball
