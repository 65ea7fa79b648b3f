#pragma once

#include <cstdint>
#include <vector>

#include <kernels/edge_pair.hpp>
#include <kernels/exec/array.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "feature_lists.hpp"
#include "row_pieces.hpp"

namespace pinball {

/// Edges against edges that cross them. Where two flat surfaces lie on each other these are, with their nodes, the
/// corners of all common parts of their faces: a uniform pressure is then held by the nodes of both as their own faces
/// would hold it, whatever the meshes (the contact patch test).
template <class S>
class EdgeRows {
 public:
  using EdgePairs = typename FeatureLists<S>::EdgePairs;

  /// Finds the rows of all pairs listed in the parts that are this process' own, in the order of the list. impulses:
  /// has the pairs that touched in the step before; null: none did.
  void find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
            const EdgePairs& pairs, const StepReach& step, const ImpulseSolver<S>* impulses, const ListShare& share);
  void find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
            const EdgePairs& pairs, const StepReach& step) {
    find(source, surface, edges, pairs, step, nullptr, ListShare(pairs));
  }
  const RowPieces& rows() const { return rows_; }
  RowPieces& rows() { return rows_; }
  std::size_t bytes() const { return rows_.bytes(); }

 private:
  using Edge = typename EdgeTable<S>::Edge;
  static void find_near(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                        const EdgePairs& pairs, const ListPart& part, const StepReach& step,
                        std::vector<std::int32_t>& near_pairs);
  static void add_row(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const Edge& first,
                      const Edge& second, const StepReach& step, const ImpulseSolver<S>* impulses,
                      std::vector<FeatureRow>& rows);

  RowPieces rows_;
};

}  // namespace pinball
