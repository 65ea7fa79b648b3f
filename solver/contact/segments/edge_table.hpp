#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <kernels/exec/array.hpp>

#include "segment_surface.hpp"

namespace pinball {

/// The edges of master segments, each once: of active segments and of those that wait.
template <class S>
class EdgeTable {
 public:
  static constexpr std::size_t most_segments = 12;  ///< of an edge that are kept: both faces of six elements around it
  struct Edge {
    std::int32_t node[2];                             ///< of the node store, the lower number first
    std::int32_t slave[2];                            ///< of the surface
    std::array<std::int32_t, most_segments> segment;  ///< that meet here; -1: no more
  };

  /// Collects the edges of all segments anew.
  void collect(const SegmentSurface<S>& surface);
  std::span<const Edge> edges() const { return {edges_.data(), edges_.size()}; }
  /// By its nodes: keeps from collection to collection, and is the same whatever waits.
  static std::int64_t name_of(const Edge& edge) { return static_cast<std::int64_t>(edge.node[0]) << 31 | edge.node[1]; }
  /// Edges of a segment; -1 for a side of no length.
  const std::array<std::int32_t, 4>& edges_of(std::int32_t segment) const { return edges_of_[segment]; }
  /// Segments that meet at an edge, in their order.
  static std::span<const std::int32_t> segments_of(const Edge& edge) {
    return {edge.segment.begin(), std::find(edge.segment.begin(), edge.segment.end(), -1)};
  }
  std::span<const std::int32_t> segments_of(std::int32_t edge) const { return segments_of(edges_[edge]); }
  bool share_node(std::int32_t e, std::int32_t f) const {
    const std::int32_t *const a = edges_[e].node, *const b = edges_[f].node;
    return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
  }
  std::size_t bytes() const {
    return edges_.bytes() + edges_of_.bytes() + (first_.capacity() + ends_up_to_.capacity()) * sizeof(first_[0]);
  }

 private:
  Array<Edge> edges_;
  Array<std::array<std::int32_t, 4>> edges_of_;  ///< per segment
  // Per slave, only while edges are collected; kept for their memory.
  std::vector<std::int64_t> first_;       ///< number of its first edge
  std::vector<std::int64_t> ends_up_to_;  ///< of the ends of its piece of the work
};

}  // namespace pinball
