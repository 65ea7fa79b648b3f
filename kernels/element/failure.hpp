#pragma once

#include "../element_results.hpp"
#include "../folding.hpp"
#include "../material/failure.hpp"
#include "../rotation.hpp"
#include "corners.hpp"
#include "element_pack.hpp"
#include "hourglass_control.hpp"
#include "step_geometry.hpp"
#include "step_motion.hpp"
#include "viscosity.hpp"

/// Failure of a pack's elements: which fail in a step, and what goes with them. An element that fails keeps its nodes
/// and their mass, and carries no stress from then on; its mass of the material becomes 0.
namespace pinball {

/// What elements carry on after a step.
template <class T>
struct ElementFailure {
  MaskOf<T> fails;     ///< in this step
  bool any;            ///< whether any lane does
  MaskOf<T> carries;   ///< there, with volumes, and not failed
  MaskOf<T> inverted;  ///< there without a volume, and not failed
};

/// The strain that elements have come to (failure.hpp), kept from step to step at `place`. The increment belongs to the
/// middle of the rotation, as that of the stress does.
template <class T, int L>
PINBALL_FUNCTION Symmetric<T> kept_strain(const ElementNumbers<T, L>& numbers, int place, const Symmetric<T>& increment,
                                          const Rotation<T>& rotation) {
  const Symmetric<T> old = symmetric_at(numbers, place);
  const Symmetric<T> half = number<T>(0.5) * increment, strain = rotate(rotation, old + half) + half;
  set_symmetric(strain, numbers, place);
  return strain;
}

/// beyond_limits, with the strain where a limit needs it. Called: few scenes have such limits.
template <class T, int L>
PINBALL_OUTLINED MaskOf<T> look_at_limits(const FailureLimits<ScalarOf<T>>& limits, const ElementNumbers<T, L>& numbers,
                                          int place, const Symmetric<T>& increment, const Rotation<T>& rotation,
                                          const Symmetric<T>& stress, const T& stable_rate, ScalarOf<T> time) {
  Symmetric<T> strain{T(0), T(0), T(0), T(0), T(0), T(0)};
  if (place >= 0) strain = kept_strain(numbers, place, increment, rotation);
  return beyond_limits(limits, stress, strain, stable_rate, time);
}

/// Elements that are beyond a limit of their material at the end of a step.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION MaskOf<T> limits_exceeded(const ElementConstants<ScalarOf<T>>& constants,
                                           const ElementNumbers<T, L>& numbers, const StepMotion<T, features>& motion,
                                           const Symmetric<T>& stress, const T& stable_rate, ScalarOf<T> time) {
  MaskOf<T> beyond(false);
  if constexpr (features.erosion && features.yield == YieldLaw::general) {
    if (constants.failure.limits.any) [[unlikely]] {
      const ElementNumbers<T, L> kept = numbers;  // copies: what is called sees them in memory
      const Symmetric<T> increment = motion.strain, now = stress;
      const Rotation<T> rotation = motion.rotation;
      const T rate = stable_rate;
      beyond =
          look_at_limits(constants.failure.limits, kept, constants.places.strain, increment, rotation, now, rate, time);
    }
  }
  return beyond;
}

/// Elements that fail. plastic_strain: at the end of the step; failed: for a reason of their material's;
/// inside_out: at a corner.
template <ElementFeatures features, class T>
PINBALL_FUNCTION ElementFailure<T> find_failure(const FailureConstants<ScalarOf<T>>& constants, const MaskOf<T>& alive,
                                                const EndSize<T>& end, const MiddleSize<T>& middle,
                                                const T& plastic_strain, const MaskOf<T>& failed,
                                                const MaskOf<T>& inside_out) {
  ElementFailure<T> failure{MaskOf<T>(false), false, middle.whole, alive && !middle.has_volume};
  if constexpr (features.erosion) {
    failure.fails = plastic_strain > T(constants.plastic_strain) && alive;
    if constexpr (features.yield == YieldLaw::general) failure.fails = failure.fails || (alive && failed);
    // A volume that is not a number is no reason to erode: it is counted, and stops the run.
    if (constants.negative_volume) {
      failure.fails = failure.fails || (alive && minimum(end.volume, middle.volume) <= T(0));
    }
    if (constants.inside_out) failure.fails = failure.fails || inside_out;
    failure.any = any_lane(failure.fails);
    if (failure.any) {
      failure.carries = failure.carries && !failure.fails;
      failure.inverted = failure.inverted && !failure.fails;
    }
  }
  return failure;
}

/// Takes from elements that fail what they carry, and their plastic strain, which would be gone in the next step where
/// others of their pack live.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION void let_go(const ElementFailure<T>& failure, const ElementPack<T, L>& own, Symmetric<T>& stress,
                             T& plastic_strain, HourglassStep<T, features>& hourglass, ViscousStep<T>& viscosity,
                             ElementSums<T>& sums) {
  const MaskOf<T>& fails = failure.fails;
  sums.eroded_count += count_lanes(fails);
  own.set(own.arrays.mass, select(fails, T(0), own.mass));
  stress = select(fails, Symmetric<T>{T(0), T(0), T(0), T(0), T(0), T(0)}, stress);
  plastic_strain = select(fails, T(0), plastic_strain);
  hourglass.let_go(own, fails);
  viscosity.let_go(fails);
}

/// The same of forces at corners, whose energy is lost as what is inside.
template <class T>
PINBALL_FUNCTION void let_go_of_corners(const MaskOf<T>& fails, CornerResistance<T>& corners, ElementSums<T>& sums) {
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) corners.force[i] = select(fails, Vec3<T>{T(0), T(0), T(0)}, corners.force[i]);
  const T taken_along = select(fails, corners.energy, T(0));
  sums.internal += taken_along;
  sums.eroded += taken_along;
  corners.energy = select(fails, T(0), corners.energy);
}

/// Of what has not failed. weight: of ElementStep.
template <ElementFeatures features, class T>
PINBALL_FUNCTION void add_resistance(const ElementFailure<T>& failure, CornerResistance<T>& corners, const T& weight,
                                     Vec3<T> (&value)[8], ElementSums<T>& sums) {
  if (features.erosion && failure.any) let_go_of_corners(failure.fails, corners, sums);
  add_resistance(corners, weight, value, sums);
}

}  // namespace pinball
