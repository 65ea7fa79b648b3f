#pragma once

#include "../folding.hpp"
#include "../hourglass.hpp"
#include "step_geometry.hpp"

/// Forces of a pack's corners at the end of a step: minus the internal ones, first of the modes, then of the corners.
namespace pinball {

/// stress: with bulk viscosity; x: modes of x_n; inverse_volume: at the end of the step; weight: of ElementStep.
template <HourglassKind kind, class T>
PINBALL_FUNCTION void forces_of_corners(const Symmetric<T>& stress, const HourglassForce<T>& hourglass,
                                        const HexahedronModes<T>& x, const UniformGradient<T>& b,
                                        const T& inverse_volume, ScalarOf<T> step_weight, Vec3<T> (&value)[8]) {
  // What acts through B: the stress, and a tensor of the hourglass forces
  Tensor<T> acting;
  if constexpr (kind == HourglassKind::none) {
    acting = to_tensor(stress);
  } else {
    acting = hourglass_stress(hourglass, x, inverse_volume) + stress;
  }
  const T weight(step_weight), minus_weight(-step_weight);
  acting = minus_weight * acting;
  Vec3<T> linear[3], hourglass_mode[4];
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    linear[m] = acting * b.linear[m];
    hourglass_mode[m] = acting * b.hourglass[m] - weight * hourglass.p[m];
  }
  hourglass_mode[3] = minus_weight * hourglass.p[3];
  from_modes(linear, hourglass_mode, value);
}

}  // namespace pinball
