#pragma once

#include <cstdint>
#include <vector>

#include <kernels/tensor.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "feature_lists.hpp"
#include "feature_row.hpp"
#include "row_pieces.hpp"

namespace pinball {

/// How far beyond an edge a foot may lie and still belong to the face: a part of the face, over its half length, and of
/// the radius of the segment [-].
inline constexpr double edge_margin = 1e-3;

/// The nearest point of a segment to a node (kernels/face_projection.hpp).
struct NodeFoot {
  std::int32_t slave, segment;  ///< numbers in the surface
  double gap, outside;          ///< along the normal; along the plane, of what is beyond the edges [length]
  double past_margin;           ///< the same, of what is beyond the part of the face that counts as the face [length]
  Vec3<double> normal;
  double weight[4];

  double distance() const;  ///< of the node from the segment [length]
};

/// Places of the pairs of a part of a list of which the node is near the ball and the plane of the segment.
template <class S>
void find_near_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                     const typename FeatureLists<S>::NodePairs& pairs, const ListPart& part, const StepReach& step,
                     std::vector<std::int32_t>& near);

/// The feet of these, in their order.
template <class S>
void find_feet(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
               const typename FeatureLists<S>::NodePairs& pairs, const std::vector<std::int32_t>& near,
               std::vector<NodeFoot>& feet);

}  // namespace pinball
