#pragma once

#include "../element_results.hpp"
#include "../material/general_material.hpp"
#include "../material/mooney_rivlin.hpp"
#include "../material/neo_hookean.hpp"
#include "../material/ogden.hpp"
#include "../material/orthotropic.hpp"
#include "averaged_step.hpp"
#include "element_pack.hpp"
#include "hourglass_control.hpp"
#include "stability.hpp"
#include "step_geometry.hpp"
#include "step_motion.hpp"

/// Strength of a pack over a step: the stress that strain makes of the old one, first as if nothing yielded, then
/// returned to the yield surface together with the hourglass stresses that are kept.
///
/// What yields follows a rate law, what never does an energy (neo_hookean.hpp).
namespace pinball {

template <class T, int L>
PINBALL_FUNCTION Symmetric<T> load_stress(const ElementPack<T, L>& own) {
  const ElementNumbers<T, L> stored = own.numbers(own.arrays.stress, 6);
  return {stored.get(0), stored.get(1), stored.get(2), stored.get(3), stored.get(4), stored.get(5)};
}

template <class T, int L>
PINBALL_FUNCTION void store_stress(const Symmetric<T>& stress, const ElementPack<T, L>& own) {
  const ElementNumbers<T, L> stored = own.numbers(own.arrays.stress, 6);
  stored.set(0, stress.xx);
  stored.set(1, stress.yy);
  stored.set(2, stress.zz);
  stored.set(3, stress.xy);
  stored.set(4, stress.yz);
  stored.set(5, stress.zx);
}

/// The stress of the rate law without yield. The increment belongs to the middle of the rotation: half of it turns with
/// the old stress. Added whole after the rotation it would be turned by half a step, a skew part of the stiffness that
/// feeds the high modes of a spinning body.
template <class T>
PINBALL_FUNCTION Symmetric<T> turned_and_strained(const MaterialConstants<ScalarOf<T>>& material,
                                                  const Symmetric<T>& stress_old, const Symmetric<T>& strain,
                                                  const Rotation<T>& rotation) {
  using S = ScalarOf<T>;
  const Symmetric<T> half_increment = elastic_increment(T(S(0.5) * material.lambda), T(S(0.5) * material.mu), strain);
  return rotate(rotation, stress_old + half_increment) + half_increment;
}

/// The stress of the energy, and moduli for the stable step.
template <ElementFeatures features, class T>
PINBALL_FUNCTION NeoHookeanState<T> stress_of_energy(const MaterialConstants<ScalarOf<T>>& material,
                                                     const Symmetric<T>& stress_old,
                                                     const StepMotion<T, features>& motion, ScalarOf<T> dt,
                                                     const VolumeChange<T>& change, const MaskOf<T>& whole) {
  using S = ScalarOf<T>;
  if constexpr (features.plastic) {
    const Symmetric<T> old = stress_old;  // of their own: what is called sees them in memory
    const MaskOf<T> there = whole;
    NeoHookeanState<T> now;
    update_neo_hookean<T>(material.lambda, material.mu, T(S(0.5) * dt) * motion.gradient, change, there, old, now);
    return now;
  } else {
    return neo_hookean_step<T>(material.lambda, material.mu, motion.half_gradient, change, whole, stress_old);
  }
}

/// The volumes of a step.
template <class T, int L>
PINBALL_FUNCTION VolumeChange<T> volume_change(const ElementConstants<ScalarOf<T>>& constants,
                                               const ElementPack<T, L>& own, const StabilityBound<T>& bound,
                                               const MiddleSize<T>& middle) {
  return {own.mass * T(constants.specific_volume), T(constants.material.density) * bound.end.inverse_mass,
          middle.volume, bound.end.volume, middle.inverse_end_volume};
}

/// The same, with the stable rate of those moduli.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION void follow_energy(const ElementConstants<ScalarOf<T>>& constants, const ElementPack<T, L>& own,
                                    const StabilityBound<T>& bound, const MiddleSize<T>& middle,
                                    const StepMotion<T, features>& motion, ScalarOf<T> dt,
                                    const Symmetric<T>& stress_old, Symmetric<T>& stress, T& stable_rate) {
  const MaterialConstants<ScalarOf<T>>& material = constants.material;
  const VolumeChange<T> change = volume_change(constants, own, bound, middle);
  const NeoHookeanState<T> now = stress_of_energy<features>(material, stress_old, motion, dt, change, middle.whole);
  stress = now.stress;
  stable_rate = bound.rate(now.lambda, now.mu);
}

/// The stress of a step of length dt in which nothing yields. What never does has an energy: erosion has no kernel of
/// its own for that; that of the general law has its place for it beside yield, where it branches anyway.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION Symmetric<T> stress_without_yield(const ElementConstants<ScalarOf<T>>& constants,
                                                   const ElementPack<T, L>& own, const StabilityBound<T>& bound,
                                                   const MiddleSize<T>& middle, const StepMotion<T, features>& motion,
                                                   ScalarOf<T> dt, const Symmetric<T>& stress_old, T& stable_rate) {
  Symmetric<T> stress;
  if constexpr (features.plastic) {
    stress = turned_and_strained(constants.material, stress_old, motion.strain, motion.rotation);
  }
  constexpr bool may_be_elastic = features.erosion && features.yield == YieldLaw::linear && features.rare_cases;
  if (!features.plastic || (may_be_elastic && constants.never_yields)) {
    follow_energy(constants, own, bound, middle, motion, dt, stress_old, stress, stable_rate);
  }
  return stress;
}

/// Whether a material of the general kernel is elastic.
template <ElementFeatures features, class S>
PINBALL_FUNCTION bool never_yields_generally(const ElementConstants<S>& constants) {
  return features.erosion && features.yield == YieldLaw::general && constants.never_yields;
}

/// Gives it the stress of its energy where its moduli differ with the direction.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION void follow_orthotropic_energy(const ElementConstants<ScalarOf<T>>& constants,
                                                const ElementNumbers<T, L>& numbers, const StabilityBound<T>& bound,
                                                const MiddleSize<T>& middle, const StepMotion<T, features>& motion,
                                                ScalarOf<T> dt, const Symmetric<T>& stress_old, Symmetric<T>& stress,
                                                T& stable_rate) {
  const int place = constants.places.gradient;
  Tensor<T> gradient = tensor_at(numbers, place);
  const Symmetric<T> old = stress_old;  // of their own, as above
  const MaskOf<T> there = middle.whole;
  NeoHookeanState<T> now;
  update_orthotropic<T>(constants.orthotropic, T(ScalarOf<T>(0.5) * dt) * motion.gradient, there, old, gradient, now);
  set_tensor(gradient, numbers, place);
  stress = now.stress;
  stable_rate = bound.rate(now.lambda, now.mu);
}

/// Gives it the stress of its energy.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION void follow_energy_generally(const ElementConstants<ScalarOf<T>>& constants,
                                              const ElementPack<T, L>& own, const ElementNumbers<T, L>& numbers,
                                              const StabilityBound<T>& bound, const MiddleSize<T>& middle,
                                              const StepMotion<T, features>& motion, ScalarOf<T> dt,
                                              const Symmetric<T>& stress_old, Symmetric<T>& stress, T& stable_rate) {
  if (constants.orthotropic.used) {
    follow_orthotropic_energy(constants, numbers, bound, middle, motion, dt, stress_old, stress, stable_rate);
    return;
  }
  if (!constants.rubber.used && !constants.ogden.used) {
    follow_energy(constants, own, bound, middle, motion, dt, stress_old, stress, stable_rate);
    return;
  }
  const int place = constants.places.deformation;
  Symmetric<T> strain = symmetric_at(numbers, place);
  const Symmetric<T> old = stress_old;  // of their own, as above
  const MaskOf<T> there = middle.whole;
  NeoHookeanState<T> now;
  const Tensor<T> half = T(ScalarOf<T>(0.5) * dt) * motion.gradient;
  const VolumeChange<T> volume = volume_change(constants, own, bound, middle);
  if (constants.ogden.used) {
    update_ogden<T>(constants.ogden, half, volume, there, old, strain, now);
  } else {
    update_mooney_rivlin<T>(constants.rubber, half, volume, there, old, strain, now);
  }
  set_symmetric(strain, numbers, place);
  stress = now.stress;
  stable_rate = bound.rate(now.lambda, now.mu);
}

/// Returns the stress, and hourglass stresses, to the yield surface; plastic_strain: of the old state. Returns elements
/// that fail for a reason of their law's own.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION MaskOf<T> yield(const ElementConstants<ScalarOf<T>>& constants, const ElementPack<T, L>& own,
                                 const ElementNumbers<T, L>& numbers, const LawStep<T, features>& law, ScalarOf<T> dt,
                                 HourglassStep<T, features>& hourglass, Symmetric<T>& stress, T& plastic_strain) {
  if constexpr (features.yield == YieldLaw::general) {
    const Symmetric<T> deformation = symmetric_part(law.motion.gradient);
    const T density = own.mass * law.middle.inverse_end_volume;
    const ElementMotion<T> motion{deformation, law.motion.rotation, dt, density, law.shape};
    const YieldOutcome<T> outcome = yield_generally(constants, motion, numbers, hourglass.kept, stress, plastic_strain);
    hourglass.lost = outcome.lost;
    hourglass.any_lost = outcome.any_lost;
    return outcome.failed;
  } else if constexpr (keeps_hourglass_state(features.hourglass)) {
    const MaterialConstants<ScalarOf<T>>& material = constants.material;
    const Symmetric<T> deviator = deviator_of(stress);
    const T mean = effective_square(deviator), variation = hourglass.kept.variation();
    const T yield = yield_stress(material, plastic_strain);
    // Packs without yield are done with the comparison; a lane is returned, or not, whatever its neighbours do.
    hourglass.any_lost = any_lane(largest_effective_square(mean, variation) > yield * yield);
    if (hourglass.any_lost) {
      hourglass.lost = hourglass.kept.yield(material, deviator, mean, variation, stress, plastic_strain);
    }
  } else {
    radial_return(constants.material, stress, plastic_strain);
  }
  return MaskOf<T>(false);
}

}  // namespace pinball
