#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <solver/contact/search/moving_boxes.hpp>
#include <solver/contact/search/surface_motion.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "feature_row.hpp"
#include "sphere_surface.hpp"

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

/// Where segments, their nodes and edges, and spheres may be while lists last, and where they look.
template <class S>
class FeatureBounds {
 public:
  /// motion: as started now; depth: per node of the store, how deep it is [length]; horizon: for which lists are built,
  /// beyond the step just made [time].
  void update(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
              const SphereSurface<S>& spheres, const SurfaceMotion<S>& motion, const std::vector<float>& depth,
              S last_step, S horizon);

  const MovingBoxes<S>& boxes() const { return boxes_; }  ///< of segments and, behind them, of spheres
  const MovingBox<S>& node_box(std::int32_t slave) const { return node_box_[slave]; }
  const MovingBox<S>& edge_box(std::int32_t edge) const { return edge_box_[edge]; }
  const Facing<S>& facing(std::int32_t segment) const { return facing_[segment]; }
  const Facing<S>& around(std::int32_t segment) const { return around_[segment]; }  ///< of all around its nodes
  const Facing<S>& node_facing(std::int32_t slave) const { return node_facing_[slave]; }
  const Facing<S>& edge_facing(std::int32_t edge) const { return edge_facing_[edge]; }
  std::size_t bytes() const;

 private:
  MovingBox<S> box_of(const SurfaceSource<S>& source, std::int32_t node) const;
  Facing<S> facing_of(const SurfaceSource<S>& source, const std::int32_t (&node)[4]) const;
  /// Of several segments together.
  Facing<S> facing_of_all(std::span<const std::int32_t> segments) const;
  void find_facings(const SegmentSurface<S>& surface, const EdgeTable<S>& edges);

  const SurfaceMotion<S>* motion_ = nullptr;
  S last_step_ = 0, horizon_ = 0;
  MovingBoxes<S> boxes_;
  std::vector<MovingBox<S>> node_box_, edge_box_;
  std::vector<Facing<S>> facing_, around_, node_facing_, edge_facing_;
};

}  // namespace pinball
