#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <solver/contact/segments/segment_surface.hpp>

#include "feature_lists.hpp"
#include "node_feet.hpp"
#include "row_pieces.hpp"

namespace pinball {

/// Nodes against faces. Of the faces of a body that look at it, a node meets the nearest, and another besides where
/// they make a valley: where it is outside of both.
template <class S>
class NodeRows {
 public:
  using NodePairs = typename FeatureLists<S>::NodePairs;

  /// Finds the rows of all pairs listed in the parts that are this process' own, in the order of the nodes.
  void find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const NodePairs& pairs,
            const StepReach& step, const ListShare& share);
  /// When all rows are here. Of two nodes on each other each has a row: one is enough, and where one is a corner it is
  /// the only one that has the normal of the contact.
  void drop_mirrored(const SurfaceSource<S>& source, const SegmentSurface<S>& surface);
  const RowPieces& rows() const { return rows_; }
  RowPieces& rows() { return rows_; }
  std::size_t bytes() const;

 private:
  RowPieces rows_;
  std::array<std::vector<NodeFoot>, fixed_pieces> feet_;  ///< per part, kept for their memory
  std::vector<FeatureRow*> on_node_;  ///< per node of the store: a row in which it is on another node, or null
};

}  // namespace pinball
