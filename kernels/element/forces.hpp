#pragma once

#include "../folding.hpp"
#include "../hourglass.hpp"
#include "step_geometry.hpp"

/// Forces of a pack's corners at the end of a step: minus the internal ones, first of the modes, then of the corners.
namespace pinball {

/// a - s
template <class T>
PINBALL_FUNCTION Tensor<T> operator-(const Tensor<T>& a, const Symmetric<T>& s) {
  return {{a.row_x.x - s.xx, a.row_x.y - s.xy, a.row_x.z - s.zx},
          {a.row_y.x - s.xy, a.row_y.y - s.yy, a.row_y.z - s.yz},
          {a.row_z.x - s.zx, a.row_z.y - s.yz, a.row_z.z - s.zz}};
}

/// stress: with bulk viscosity; x: modes of x_n; inverse_volume: at the end of the step; step_weight: of ElementStep, 1
/// but with subcycling.
template <HourglassKind kind, class T>
PINBALL_FUNCTION void forces_of_corners(const Symmetric<T>& stress, const HourglassForce<T>& hourglass,
                                        const HexahedronModes<T>& x, const UniformGradient<T>& b,
                                        const T& inverse_volume, ScalarOf<T> step_weight, Vec3<T> (&value)[8]) {
  const bool weighs = step_weight != ScalarOf<T>(1);
  const T weight(step_weight);
  // What acts through B, with its sign turned: the stress, and a tensor of the hourglass forces
  Tensor<T> acting;
  if constexpr (kind == HourglassKind::none) {
    acting = T(-1) * to_tensor(stress);
  } else {
    acting = hourglass_stress(hourglass, x, T(-1) * inverse_volume) - stress;
  }
  if (weighs) [[unlikely]]
    acting = weight * acting;
  Vec3<T> linear[3], hourglass_mode[4];
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    linear[m] = acting * b.linear[m];
    hourglass_mode[m] = acting * b.hourglass[m];
  }
  const Vec3<T>(&p)[4] = hourglass.p;
  if (weighs) [[unlikely]] {
    PINBALL_UNROLL
    for (int m = 0; m < 3; ++m) hourglass_mode[m] = hourglass_mode[m] - weight * p[m];
    hourglass_mode[3] = T(-step_weight) * p[3];
  } else {
    PINBALL_UNROLL
    for (int m = 0; m < 3; ++m) hourglass_mode[m] = hourglass_mode[m] - p[m];
    hourglass_mode[3] = T(-1) * p[3];
  }
  from_modes(linear, hourglass_mode, value);
}

}  // namespace pinball
