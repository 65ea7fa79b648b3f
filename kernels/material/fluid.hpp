#pragma once

#include "../tensor.hpp"

/// A fluid after Newton: it has no strength, and its deviator is that of the rate at which it is strained,
///
///     s = 2 eta D' .
///
/// Its pressure is that of an equation of state (equation_of_state.hpp), into whose energy the work of s goes.
namespace pinball {

template <class S>
struct FluidConstants {
  bool used = false;
  S viscosity = S(0);  ///< eta [stress time]
};

/// Gives a stress that deviator, and leaves its mean. deformation: D, in the middle of the step [1/time].
template <class T>
PINBALL_FUNCTION void flow(const FluidConstants<ScalarOf<T>>& fluid, const Symmetric<T>& deformation,
                           Symmetric<T>& stress) {
  const T mean = number<T>(1.0 / 3.0) * trace(stress);
  stress = T(2 * fluid.viscosity) * deviator_of(deformation);
  stress.xx += mean;
  stress.yy += mean;
  stress.zz += mean;
}

/// A bulk viscosity that damps any motion at least as much [stress time]: of principal values s_i of S_ij
/// (stable_time_step.hpp) the damping of s is no more than 2 eta s_max, and that of a bulk viscosity its sum of s_i.
template <class S>
PINBALL_FUNCTION S damping_viscosity(const FluidConstants<S>& fluid) {
  return 2 * fluid.viscosity;
}

}  // namespace pinball
