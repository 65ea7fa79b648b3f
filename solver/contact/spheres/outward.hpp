#pragma once

#include <cstdint>

#include <solver/contact/segments/segment_surface.hpp>

namespace pinball {

/// Where the outside of a surface is, at a point of it.
struct Outward {
  Vec3<double> normal;  ///< of unit length, or zero where the faces have no area [-]
  bool closed;          ///< at an edge or a node: there are faces on all sides
};

/// Inside a face its mean normal; at an edge the sum of those of both faces; at a node the sum of those around it, by
/// their angles there: what is nearest to the point is outside where it lies on the side of this normal (J. A.
/// Baerentzen and H. Aanaes, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11,
/// 243-253, 2005). rim: as NearestOnFace has it. Of active segments.
template <class S>
Outward outward_at(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface, std::int32_t segment,
                   const int (&rim)[2]);

}  // namespace pinball
