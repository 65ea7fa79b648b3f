#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <kernels/face_projection.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "feature_lists.hpp"
#include "feature_row.hpp"

namespace pinball {

/// Nodes against faces. Of the faces of a body that look at it, a node meets the nearest, and others besides where they
/// make a valley: where it is outside of all of them.
template <class S>
class NodeRows {
 public:
  using NodePairs = typename FeatureLists<S>::NodePairs;

  /// Finds the rows of all pairs listed.
  void find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const NodePairs& pairs,
            const StepReach& step);
  /// Gives the rows found, in the order of the nodes.
  void give_to(ImpulseSolver<S>& impulses) const;
  /// Calls visit(row) for each row found.
  template <class Visit>
  void for_each_row(const Visit& visit) const {
    for (std::int64_t piece = 0; piece < pieces_; ++piece) {
      for (const FeatureRow& row : work_[piece].rows) visit(row);
    }
  }
  std::size_t bytes() const;

 private:
  /// Where a node would touch a segment.
  struct Foot {
    std::int32_t slave, segment;
    double gap, outside;  ///< beyond the edges of the segment [length]
    Vec3<double> normal;
    double weight[4];
  };
  /// Of one piece, kept for their memory.
  struct Work {
    std::vector<std::int32_t> near;  ///< places of pairs that are near each other; with room for more
    std::vector<Foot> feet;
    std::vector<FeatureRow> rows;
  };

  /// Of two nodes on each other each has a row: one is enough, and where one is a corner it is the only one that has
  /// the normal of the contact.
  void drop_mirrored(const SurfaceSource<S>& source, const SegmentSurface<S>& surface);
  static void find_near(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const NodePairs& pairs,
                        std::int64_t piece, const StepReach& step, Work& work);
  static void find_feet(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const NodePairs& pairs,
                        Work& work);
  /// Rows of a node, given the feet of it.
  static void add_rows(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const StepReach& step,
                       const Foot* begin, const Foot* end, std::vector<FeatureRow>& rows);

  std::int64_t pieces_ = 0;
  std::array<Work, fixed_pieces> work_;
  std::vector<FeatureRow*> on_node_;  ///< per node of the store: a row in which it is on another node, or null
};

}  // namespace pinball
