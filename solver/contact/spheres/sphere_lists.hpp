#pragma once

#include <cstdint>
#include <vector>

#include <solver/contact/contact_settings.hpp>
#include <solver/contact/search/box_pairs.hpp>
#include <solver/contact/search/surface_motion.hpp>
#include <solver/contact/segments/segment_surface.hpp>
#include <solver/contact/surface/joined_bodies.hpp>

#include "sphere_surface.hpp"

namespace pinball {

/// Deepest that the centre of a sphere may be behind the segment that it came in through, over its thickness [-]: no
/// nearer to the other side.
inline constexpr double deepest_centre = 0.5;

/// The segments that spheres may touch in a time to come: found by boxes, while the owner of the lists watches that no
/// node strays too far (SurfaceMotion).
template <class S>
class SphereLists {
 public:
  /// Builds the lists from nothing. motion: as started with the nodes of source; joined: bodies that hang together;
  /// horizon: the time to come [time].
  void build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const SphereSurface<S>& spheres,
             const SurfaceMotion<S>& motion, const ContactSettings& settings, const JoinedBodies& joined, S horizon);

  /// Numbers of the segments that sphere s may touch: places first(s) to first(s + 1), ascending.
  std::int64_t first(std::int64_t s) const { return first_[s]; }
  std::int32_t segment(std::int64_t place) const { return segment_[place]; }
  std::int64_t pairs() const { return segment_.size(); }
  std::size_t bytes() const;

 private:
  void set_boxes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const SphereSurface<S>& spheres,
                 const SurfaceMotion<S>& motion, S horizon);
  void sort(std::int32_t segments, std::int32_t spheres);

  std::vector<std::int64_t> first_;    ///< per sphere and one more
  std::vector<std::int32_t> segment_;  ///< one sphere after the other
  // What follows is kept for its memory alone.
  MovingBoxes<S> boxes_;
  BoxPairs<S> pairs_;
};

}  // namespace pinball
