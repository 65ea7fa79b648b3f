#pragma once

#include "node_arrays.hpp"

namespace pinball {

/// Bounces nodes off a plane of symmetry which they would cross in the coming step:
///
///     v <- v - 2 (v.n) n ,   x <- x - 2 dt (v.n) n     where n.(x - p) < 0 and n.v < 0
template <class S>
struct ReflectNodes {
  const std::int32_t* of;
  S point[3], inward[3];  ///< p [length]; n, the unit normal towards the bodies
  S position_step;        ///< dt: that just made with the present velocities [time]
  S *position, *velocity;

  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    S *x = position + 4 * std::int64_t(of[i]), *v = velocity + 4 * std::int64_t(of[i]);
    S distance = 0, speed = 0;
    for (int k = 0; k < 3; ++k) distance += (x[k] - point[k]) * inward[k];
    if (!(distance < S(0))) return;
    for (int k = 0; k < 3; ++k) speed += v[k] * inward[k];
    if (!(speed < S(0))) return;
    for (int k = 0; k < 3; ++k) {
      x[k] -= S(2) * position_step * speed * inward[k];
      v[k] -= S(2) * speed * inward[k];
    }
  }
};

}  // namespace pinball
