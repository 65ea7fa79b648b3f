#pragma once

#include <cstdint>
#include <span>
#include <vector>

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
  S horizon = 0;             ///< for which the lists are to last, beyond that step [time]
  std::vector<float> depth;  ///< per slave: how deep it is [length]
};

/// Where segments, their nodes and edges, and spheres may be while lists last, and where they look.
template <class S>
class FeatureBounds {
 public:
  /// motion: as started with these nodes.
  void update(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
              const SphereSurface<S>& spheres, const SurfaceMotion<S>& motion, const ListScope<S>& scope);

  const MovingBoxes<S>& boxes() const { return boxes_; }  ///< of segments and, behind them, of spheres
  const MovingBox<S>& node_box(std::int32_t slave) const { return node_box_[slave]; }
  const MovingBox<S>& edge_box(std::int32_t edge) const { return edge_box_[edge]; }
  S edge_size(std::int32_t edge) const { return edge_size_[edge]; }  ///< of the largest segment there [length]
  const Facing<S>& facing(std::int32_t segment) const { return facing_[segment]; }
  const Facing<S>& around(std::int32_t segment) const { return around_[segment]; }  ///< of all around its nodes
  const Facing<S>& node_facing(std::int32_t slave) const { return node_facing_[slave]; }
  const Facing<S>& edge_facing(std::int32_t edge) const { return edge_facing_[edge]; }
  std::size_t bytes() const;

 private:
  MovingBox<S> box_of(const NodeRecords<S>& nodes, std::int32_t node) const;
  Facing<S> facing_of(const NodeRecords<S>& nodes, const std::int32_t (&node)[4]) const;
  /// Of several segments together.
  Facing<S> facing_of_all(std::span<const std::int32_t> segments) const;
  void find_facings(const SegmentSurface<S>& surface, const EdgeTable<S>& edges);

  const SurfaceMotion<S>* motion_ = nullptr;
  S last_step_ = 0, horizon_ = 0;
  MovingBoxes<S> boxes_;
  std::vector<MovingBox<S>> node_box_, edge_box_;
  std::vector<S> edge_size_;
  std::vector<Facing<S>> facing_, around_, node_facing_, edge_facing_;
};

}  // namespace pinball
