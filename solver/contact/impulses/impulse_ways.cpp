#include <algorithm>
#include <cmath>

#include "impulse_solver.hpp"

/// Gaps close, and nodes slide, by the ways of the nodes. Those of a rigid body that turns have other velocities than
/// their ways (rigid_sides.hpp). Impulses act at the time of the forces, with the arms of then, so that both momenta
/// are kept, and their work is that on the velocities of then; what they have to stop are the ways. So nothing that
/// sticks drifts, and the energy of the turning is kept: what is added to the velocities of a step is opposite to what
/// is added to those of the step before.
namespace pinball {

namespace {

/// Way of a step, over the size of a pair, up to which a pair that is new counts as being at rest.
constexpr double at_rest = 1e-6;

}  // namespace

/// Of nodes of rigid bodies, in the step just made or in the coming one.
template <class S>
void ImpulseSolver<S>::find_ways(const SurfaceSource<S>& source, RowTensor RigidSide::*way) {
  way_.renew(4 * node_.size());
  for_all("ways of nodes", node_.size(), [&](std::int64_t i) {
    const std::int32_t body = rigid_.sides->body_of_node[node_[i]];
    Vec3<double> more{0, 0, 0};
    if (body >= 0) {
      const RigidSide& side = rigid_.side(body);
      more = side.*way * (double_vector_of(source.x(node_[i])) - side.centre);
    }
    put_vector(record(way_.data(), i), more);
  });
}

/// What a row sees of them.
template <class S>
Vec3<double> ImpulseSolver<S>::way_of(const RowView& row) const {
  return weighted_sum(row.nodes, row.node, row.weight, way_.data());
}

/// The depth of a pair grows by approach alone. Erosion exposes a face deep inside another body, a distorted element
/// turns another face to its partner: such depths are not pushed out.
template <class S>
void ImpulseSolver<S>::limit_depth(const SurfaceSource<S>& /*source*/, std::size_t i, double dt) {
  const RowView row = rows_[i];
  Pair& pair = pairs_[i];
  const Vec3<double> a{row.direction[0], row.direction[1], row.direction[2]};
  Vec3<double> v{0, 0, 0};
  for (int k = 0; k < row.nodes; ++k) v = v + row.weight[k] * vector_of(record(velocity_.data(), row.node[k]));
  pair.rate_before = dot(a, v);
  double approach = pair.rate_before;
  Vec3<double> slid = v - pair.rate_before * a;
  if (has_friction()) {
    pair.sliding_before[0] = slid.x;
    pair.sliding_before[1] = slid.y;
    pair.sliding_before[2] = slid.z;
  }
  if (rigid_) {
    const Vec3<double> way = way_of(row);
    const double closes = dot(a, way);
    approach += closes;
    slid = slid + way - closes * a;
  }
  if (has_friction()) {
    slid_[i] = std::sqrt(dot(slid, slid));
    if (!(pair.memory.force > 0 || pair.memory.depth > 0)) {  // without a past: as it moves now
      pair.memory.slides = slid_[i] * dt > at_rest * pair.size;
    }
  }
  pair.seen = pair.depth;
  if (pair.depth > 0) pair.depth = std::min(pair.depth, pair.memory.depth + std::max(0.0, approach) * dt);
  pair.memory.depth = std::max(0.0, pair.depth);
}

/// From the velocities at the time of the forces to those on the way of the step, or back.
template <class S>
void ImpulseSolver<S>::move_on_ways(double sign) {
  for_all("velocities on ways", node_.size(), [&](std::int64_t i) {
    double* const v = record(velocity_.data(), i);
    put_vector(v, vector_of(v) + sign * vector_of(record(way_.data(), i)));
  });
}

#define PINBALL_INSTANTIATE(S)                                                                \
  template void ImpulseSolver<S>::find_ways(const SurfaceSource<S>&, RowTensor RigidSide::*); \
  template void ImpulseSolver<S>::limit_depth(const SurfaceSource<S>&, std::size_t, double);  \
  template Vec3<double> ImpulseSolver<S>::way_of(const RowView&) const;                       \
  template void ImpulseSolver<S>::move_on_ways(double);
PINBALL_INSTANTIATE(double)
PINBALL_INSTANTIATE(float)
#undef PINBALL_INSTANTIATE

}  // namespace pinball
