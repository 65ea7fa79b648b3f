#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <kernels/edge_pair.hpp>
#include <solver/base/aligned_array.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "feature_lists.hpp"
#include "feature_row.hpp"

namespace pinball {

/// Edges against edges that cross them. Where two flat surfaces lie on each other these are, with their nodes, the
/// corners of all common parts of their faces: a uniform pressure is then held by the nodes of both as their own faces
/// would hold it, whatever the meshes (the contact patch test).
template <class S>
class EdgeRows {
 public:
  using EdgePairs = typename FeatureLists<S>::EdgePairs;

  /// Finds the rows of all pairs listed.
  void find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
            const EdgePairs& pairs, const StepReach& step);
  /// Gives the rows found, in the order of the list.
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
  using Edge = typename EdgeTable<S>::Edge;
  /// Of one piece, kept for their memory.
  struct Work {
    std::vector<std::int32_t> near;  ///< places of pairs that are near each other
    std::vector<FeatureRow> rows;
  };
  static void find_near(const SurfaceSource<S>& source, const EdgeTable<S>& edges, const EdgePairs& pairs,
                        std::int64_t piece, const StepReach& step, Work& work);
  static void add_row(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Edge& first,
                      const Edge& second, const StepReach& step, std::vector<FeatureRow>& rows);

  std::int64_t pieces_ = 0;
  std::array<Work, fixed_pieces> work_;
};

}  // namespace pinball
