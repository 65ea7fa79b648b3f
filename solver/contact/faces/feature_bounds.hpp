#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <kernels/exec/array.hpp>
#include <solver/contact/search/box_tree.hpp>
#include <solver/contact/search/moving_boxes.hpp>
#include <solver/contact/search/surface_motion.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>
#include <solver/contact/spheres/sphere_surface.hpp>

#include "feature_row.hpp"

namespace pinball {

/// Where segments look while lists last: within an angle around a direction.
template <class S>
struct Facing {
  Vec3<S> normal;  ///< of unit length; zero with an angle of 2: any direction
  S angle;         ///< [radians]

  /// Whether some of these may come to look at some of the others.
  bool may_face(const Facing& other) const {
    return dot(normal, other.normal) < static_cast<S>(most_facing) + angle + other.angle;
  }
};

/// For what lists are built.
template <class S>
struct ListScope {
  S last_step = 0;           ///< length of the step just made [time]
  S leap = 0;                ///< the way that given motions may add to what velocities tell [length]
  S horizon = 0;             ///< for which the lists are to last, beyond that step [time]
  std::vector<float> depth;  ///< per slave: how deep it is [length]
};

/// Where segments, their nodes and edges, and spheres may be while lists last, and where they look. That of edges, and
/// of what several segments have in common, is worked out for those who ask.
template <class S>
class FeatureBounds {
 public:
  /// motion: as started with these nodes.
  void update(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, const SphereSurface<S>& spheres,
              const SurfaceMotion<S>& motion, const ListScope<S>& scope);
  /// Renews what is known of slaves that have been started anew. scope: has their depths.
  void move(const SegmentSurface<S>& surface, std::span<const std::int32_t> slaves, const ListScope<S>& scope);
  /// Renews where a segment with such slaves looks, if it may look elsewhere than was known; returns whether that is
  /// so.
  bool turn(const SegmentSurface<S>& surface, std::int32_t segment);
  /// Makes the box of a segment anew, as that of an active one.
  void renew_box(const SegmentSurface<S>& surface, std::int32_t segment);
  /// Segments and slaves may have other numbers from the next update() on.
  void renumber() { order_.clear(); }

  /// Of segments in an order of their own and, behind them, of spheres. Those of segments that are not active are
  /// empty.
  const MovingBoxes<S>& boxes() const { return boxes_; }
  std::int32_t segment_of(std::int32_t box) const { return order_[box]; }
  std::int32_t box_of_segment(std::int32_t segment) const { return place_[segment]; }
  MovingBox<S> segment_box(std::int32_t segment) const { return boxes_.box(place_[segment]); }
  /// Of the groups of these boxes: two groups none of whose nodes and edges may face each other, or that have no active
  /// segment, have nothing with each other.
  const GroupDirections<S>& directions() const { return directions_; }
  const MovingBox<S>& node_box(std::int32_t slave) const { return node_box_[slave]; }
  MovingBox<S> edge_box(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, std::int32_t edge) const;
  const Facing<S>& facing(std::int32_t segment) const { return facing_[segment]; }
  /// The angle of facing() while no corner has strayed, as of the last update() [radians].
  S angle_on_way(std::int32_t segment) const { return angle_on_way_[segment]; }
  /// Of several segments together: those around a node or at an edge.
  Facing<S> facing_of_all(std::span<const std::int32_t> segments) const;
  std::size_t bytes() const;

 private:
  MovingBox<S> box_of(const Vec3<S>& x, const Vec3<S>& v, std::int32_t node) const;
  /// x, v: where the corners of a segment are at the start, and their velocities; allowance: theirs; strays: by how
  /// many of these they may stray. angle_on_way: that by one, if it is not null.
  template <class T>
  Facing<T> facing_of(const Vec3<T> (&x)[4], const Vec3<T> (&v)[4], const T (&allowance)[4], S strays,
                      T* angle_on_way = nullptr) const;

  /// Where segments look and, with_boxes, their boxes, a pack after the other in the order of the boxes.
  void bound_segments(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, const ListScope<S>& scope,
                      bool with_boxes);
  void choose_order(const SegmentSurface<S>& surface);
  void find_around(const SegmentSurface<S>& surface);
  void find_directions(const SegmentSurface<S>& surface);

  const SurfaceMotion<S>* motion_ = nullptr;
  S last_step_ = 0, leap_ = 0, horizon_ = 0;
  MovingBoxes<S> boxes_;
  Array<MovingBox<S>> node_box_;
  Array<Facing<S>> facing_;
  Array<S> angle_on_way_;
  std::vector<std::int32_t> order_, place_;  ///< segments in the order of their boxes; per segment: its box
  /// Segments around the nodes of those of each group, one group after the other, and where each begins.
  std::vector<std::int32_t> around_, around_begin_;
  GroupDirections<S> directions_;
};

/// Size of the largest segment at an edge [length].
template <class S>
S size_at_edge(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, std::int32_t edge) {
  S size = 0;
  for (const std::int32_t s : edges.segments_of(edge)) size = std::max(size, surface.segments()[s].size);
  return size;
}

}  // namespace pinball
