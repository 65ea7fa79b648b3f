#pragma once

#include "../element_results.hpp"
#include "element_pack.hpp"
#include "failure.hpp"
#include "step_geometry.hpp"
#include "step_motion.hpp"

/// Work of a pack's stresses in a step, and the energy inside its elements.
namespace pinball {

/// V/2 (sigma_old + sigma_new) : strain [energy]; an element that erodes in this step has sigma_new = 0, as its forces
/// are. Strains of padding and of elements without volume are zero.
template <ElementFeatures features, class T>
PINBALL_FUNCTION T work_of_stresses(const MiddleSize<T>& middle, const StepMotion<T, features>& motion,
                                    const Symmetric<T>& stress_old, const Symmetric<T>& stress) {
  return number<T>(0.5) * middle.volume * contract(stress_old + stress, motion.strain);
}

/// Adds work to what is inside; what an element holds that fails is lost.
template <ElementFeatures features, class T, int L>
PINBALL_FUNCTION void count_work(const ElementPack<T, L>& own, const T& work, const ElementFailure<T>& failure,
                                 ElementSums<T>& sums) {
  sums.internal += work;
  if (features.erosion && own.arrays.internal_energy != nullptr) {
    const T energy = own.get(own.arrays.internal_energy) + work;
    own.set(own.arrays.internal_energy, energy);
    if (failure.any) sums.eroded += select(failure.fails, energy, T(0));
  }
}

}  // namespace pinball
