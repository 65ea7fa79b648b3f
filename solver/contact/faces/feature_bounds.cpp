#include "feature_bounds.hpp"

#include <algorithm>

#include <kernels/exec.hpp>

namespace pinball {

namespace {

static_assert(near_gap > open_gap && 2 * near_gap >= deepest_edges);

template <class S>
void take(MovingBox<S>& box, const MovingBox<S>& other) {
  for (int k = 0; k < 12; ++k) {
    box.bound[k] = k % 6 < 3 ? minimum(box.bound[k], other.bound[k]) : maximum(box.bound[k], other.bound[k]);
  }
}

template <class S>
void widen(MovingBox<S>& box, S by) {
  for (int k = 0; k < 12; ++k) box.bound[k] += k % 6 < 3 ? -by : by;
}

RangePolicy<> all_of(std::int64_t count) { return {0, count}; }

}  // namespace

template <class S>
MovingBox<S> FeatureBounds<S>::box_of(const NodeRecords<S>& nodes, std::int32_t node) const {
  const S* x = nodes.x(node);
  const S* v = nodes.v(node);
  const S stray = motion_->allowance(std::array{node});
  MovingBox<S> box;
  for (int k = 0; k < 3; ++k) {
    const S begin = x[k] - last_step_ * v[k], end = x[k] + horizon_ * v[k];
    box.bound[k] = begin - stray;
    box.bound[3 + k] = begin + stray;
    box.bound[6 + k] = end - stray;
    box.bound[9 + k] = end + stray;
  }
  return box;
}

template <class S>
void FeatureBounds<S>::update(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                              const SphereSurface<S>& spheres, const SurfaceMotion<S>& motion,
                              const ListScope<S>& scope) {
  motion_ = &motion;
  last_step_ = scope.last_step;
  // What has closed within the step just made is found, and what closes within the step after the horizon.
  horizon_ = scope.horizon + 2 * last_step_;
  const std::int32_t segments = surface.segments().size();
  node_box_.resize(surface.slaves().size());
  edge_box_.resize(edges.edges().size());
  edge_size_.resize(edges.edges().size());
  facing_.resize(surface.segments().size());
  boxes_.reset(segments + spheres.count());
  parallel_for("boxes of nodes", all_of(node_box_.size()), [&](std::int64_t i) {
    node_box_[i] = box_of(nodes, surface.slaves()[i].node);
    widen(node_box_[i], static_cast<S>(scope.depth[i]));
  });
  parallel_for("boxes of segments", all_of(surface.segments().size()), [&](std::int64_t i) {
    const auto& segment = surface.segments()[i];
    MovingBox<S> box = empty_box<S>();
    for (const std::int32_t slave : surface.slaves_of(i)) take(box, node_box_[slave]);
    facing_[i] = facing_of(nodes, segment.node);
    widen(box, static_cast<S>(near_gap) * segment.size);
    boxes_.set(i, box);
  });
  parallel_for("boxes of edges", all_of(edge_box_.size()), [&](std::int64_t e) {
    const auto& edge = edges.edges()[e];
    MovingBox<S> box = node_box_[edge.slave[0]];
    take(box, node_box_[edge.slave[1]]);
    S size = 0;
    for (const std::int32_t s : edges.segments_of(e)) {
      size = std::max(size, surface.segments()[s].size);
    }
    widen(box, static_cast<S>(near_gap) * size);
    edge_box_[e] = box;
    edge_size_[e] = size;
  });
  parallel_for("boxes of spheres", all_of(spheres.spheres().size()), [&](std::int64_t i) {
    const auto& sphere = spheres.spheres()[i];
    MovingBox<S> box = box_of(nodes, sphere.node);
    widen(box, S(1.01) * sphere.radius);
    boxes_.set(segments + static_cast<std::int32_t>(i), box);
  });
  find_facings(surface, edges);
}

/// The diagonals span the face; each of their ends may go the way that it makes more than their mean, and stray.
template <class S>
Facing<S> FeatureBounds<S>::facing_of(const NodeRecords<S>& nodes, const std::int32_t (&node)[4]) const {
  Vec3<S> diagonal[2];
  S turned = 0;
  for (int d = 0; d < 2; ++d) {
    const std::int32_t a = node[d], b = node[d + 2];
    diagonal[d] = vector_of(nodes.x(b)) - vector_of(nodes.x(a));
    const Vec3<S> v = vector_of(nodes.v(b)) - vector_of(nodes.v(a));
    const S way =
        horizon_ * square_root(dot(v, v)) + motion_->allowance(std::array{a}) + motion_->allowance(std::array{b});
    turned += way / square_root(dot(diagonal[d], diagonal[d]));
  }
  const Vec3<S> area = cross(diagonal[0], diagonal[1]);
  const S size = square_root(dot(area, area));
  const S lengths = square_root(dot(diagonal[0], diagonal[0]) * dot(diagonal[1], diagonal[1]));
  Facing<S> facing{(1 / size) * area, S(1.2) * turned * lengths / size};  // the arcus sine of up to 0.8
  if (!(facing.angle < S(0.96))) facing = {{S(0), S(0), S(0)}, S(2)};     // any direction; also where there is no area
  return facing;
}

template <class S>
Facing<S> FeatureBounds<S>::facing_of_all(std::span<const std::int32_t> segments) const {
  Vec3<S> sum{S(0), S(0), S(0)};
  for (const std::int32_t s : segments) sum = sum + facing_[s].normal;
  const S length = square_root(dot(sum, sum));
  Facing<S> all{(length > S(0) ? 1 / length : S(0)) * sum, S(0)};
  for (const std::int32_t s : segments) {
    const Vec3<S> d = facing_[s].normal - all.normal;
    const S chord2 = dot(d, d);
    if (!(length > S(0)) || !(chord2 < S(2))) return {{S(0), S(0), S(0)}, S(2)};
    all.angle = maximum(all.angle, S(1.12) * square_root(chord2) + facing_[s].angle);  // up to a right angle
  }
  return all;
}

template <class S>
void FeatureBounds<S>::find_facings(const SegmentSurface<S>& surface, const EdgeTable<S>& edges) {
  node_facing_.resize(surface.slaves().size());
  edge_facing_.resize(edges.edges().size());
  around_.resize(facing_.size());
  parallel_for("facing of nodes", all_of(node_facing_.size()),
               [&](std::int64_t i) { node_facing_[i] = facing_of_all(surface.around(i)); });
  parallel_for("facing of edges", all_of(edge_facing_.size()),
               [&](std::int64_t e) { edge_facing_[e] = facing_of_all(edges.segments_of(e)); });
  parallel_for("facing around segments", all_of(around_.size()), [&](std::int64_t i) {
    around_[i] = facing_[i];
    for (const std::int32_t slave : surface.slaves_of(i)) {
      const Vec3<S> d = node_facing_[slave].normal - facing_[i].normal;
      around_[i].angle = maximum(around_[i].angle, S(1.12) * square_root(dot(d, d)) + node_facing_[slave].angle);
    }
  });
}

template <class S>
std::size_t FeatureBounds<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return boxes_.bytes() + of(node_box_) + of(edge_box_) + of(edge_size_) + of(facing_) + of(around_) +
         of(node_facing_) + of(edge_facing_);
}

template class FeatureBounds<double>;
template class FeatureBounds<float>;

}  // namespace pinball
