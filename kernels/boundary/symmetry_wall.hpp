#pragma once

#include "node_arrays.hpp"

namespace pinball {

/// Bounces nodes off a plane of symmetry which they would cross in the coming step:
///
///     v <- v - 2 (v.n) n ,   x <- x - 2 dt (v.n) n     where n.(x - p) < 0 and n.v < 0
///
/// The impulse that does it, -2 m (v.n) n, does no work on the node. But the force f that its elements had on it before
/// does 2 (v.n) f.n dt/2 less work in the coming step than its velocity had got by it: that is what the plane does.
template <class S>
struct ReflectNodes {
  const std::int32_t* of;
  S point[3], inward[3];  ///< p [length]; n, the unit normal towards the bodies
  S position_step;        ///< dt: that just made with the present velocities [time]
  S *position, *velocity;
  /// Of so many nodes in a row each: a node of level l has just made 2^l steps at once; null: all have made one.
  const std::int8_t* level = nullptr;
  std::int32_t nodes_of_level = 1;

  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    S *x = position + 4 * std::int64_t(of[i]), *v = velocity + 4 * std::int64_t(of[i]);
    S distance = 0, speed = 0;
    for (int k = 0; k < 3; ++k) distance += (x[k] - point[k]) * inward[k];
    if (!(distance < S(0))) return;
    for (int k = 0; k < 3; ++k) speed += v[k] * inward[k];
    if (!(speed < S(0))) return;
    const S step = level == nullptr ? position_step : S(1 << level[of[i] / nodes_of_level]) * position_step;
    for (int k = 0; k < 3; ++k) {
      x[k] -= S(2) * step * speed * inward[k];
      v[k] -= S(2) * speed * inward[k];
    }
  }
};

/// Keeps n.f of the nodes.
template <class S>
struct KeepForcesAcross {
  const std::int32_t* of;
  S inward[3];
  const S* force;
  S* across;  ///< per node [force]

  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    const S* const f = force + 4 * std::int64_t(of[i]);
    across[i] = inward[0] * f[0] + inward[1] * f[1] + inward[2] * f[2];
  }
};

/// What a plane does to nodes that it turns round.
struct Reflection {
  double impulse = 0;  ///< on them, along n [mass length/time]
  double work = 0;     ///< [energy]

  PINBALL_FUNCTION void join(const Reflection& other) {
    impulse += other.impulse;
    work += other.work;
  }
};

/// Before ReflectNodes. across: as kept when elements have given their forces.
template <class S>
struct SumReflection {
  ReflectNodes<S> nodes;
  const double* mass;
  const S* across;

  PINBALL_FUNCTION void operator()(std::int64_t i, Reflection& sum) const {
    const std::int64_t n = nodes.of[i];
    const S *x = nodes.position + 4 * n, *v = nodes.velocity + 4 * n;
    S distance = 0, speed = 0;
    for (int k = 0; k < 3; ++k) distance += (x[k] - nodes.point[k]) * nodes.inward[k];
    if (!(distance < S(0))) return;
    for (int k = 0; k < 3; ++k) speed += v[k] * nodes.inward[k];
    if (!(speed < S(0))) return;
    const double rate = speed;
    sum.join({-2 * mass[n] * rate, static_cast<double>(nodes.position_step) * rate * static_cast<double>(across[i])});
  }
};

}  // namespace pinball
