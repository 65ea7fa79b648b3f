#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <kernels/exec/array.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "sorted_pairs.hpp"

namespace pinball {

/// Slaves and segments, by their numbers in the surface, with what the kernels read of each pair.
template <class S>
struct ListedNodes : SortedPairs {
  Array<std::int32_t> node;  ///< of the slave
  Array<S> size, radius;     ///< of the segment [length]
  /// No element around the node has a corner in common with that of the segment, whatever erodes.
  Array<std::uint8_t> apart;

  /// Of all pairs.
  void fill(const SegmentSurface<S>& surface);
  /// Takes in pairs that the list does not have.
  void take_in(const SortedPairs& more, const SegmentSurface<S>& surface);
  std::size_t bytes() const {
    return SortedPairs::bytes() + node.bytes() + size.bytes() + radius.bytes() + apart.bytes();
  }

 private:
  void fill_place(std::int64_t place, const SegmentSurface<S>& surface);
};

/// Edges, by their numbers in the table, with what the kernels read of each pair.
template <class S>
struct ListedEdges : SortedPairs {
  std::array<Array<std::int32_t>, 4> node;  ///< ends of the first and of the second
  Array<S> size;                            ///< of the largest segments of both, together [length]

  void fill(const SegmentSurface<S>& surface, const EdgeTable<S>& edges);
  void take_in(const SortedPairs& more, const SegmentSurface<S>& surface, const EdgeTable<S>& edges);
  std::size_t bytes() const { return SortedPairs::bytes() + 4 * node[0].bytes() + size.bytes(); }

 private:
  void fill_place(std::int64_t place, const SegmentSurface<S>& surface, const EdgeTable<S>& edges);
};

}  // namespace pinball
