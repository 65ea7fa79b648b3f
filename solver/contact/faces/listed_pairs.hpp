#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <kernels/exec/array.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>

#include "sorted_pairs.hpp"

namespace pinball {

template <class S>
class FeatureBounds;

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
  /// What pairs do not do while no node strays and nothing erodes, for one of both edges stays flat; of others nothing
  /// is known.
  static constexpr std::uint8_t flat_at_end = 1, flat_along = 2;
  Array<std::uint8_t> flat;

  /// Finds out which edges stay flat. bounds: of the lists.
  void find_flat(const SegmentSurface<S>& surface, const EdgeTable<S>& edges, const FeatureBounds<S>& bounds);
  /// Some edges may become sharp that were to stay flat.
  void forget_flat();
  /// Those of `count` pairs from a place on that have a bit of `flat`, one bit each.
  template <int count>
  unsigned flat_bits(std::int64_t place, std::uint8_t bit) const {
    unsigned bits = 0;
    for (int i = 0; any_flat_ && i < count; ++i) bits |= (flat[place + i] & bit) != 0 ? 1U << i : 0U;
    return bits;
  }

  void fill(const SegmentSurface<S>& surface, const EdgeTable<S>& edges);
  void take_in(const SortedPairs& more, const SegmentSurface<S>& surface, const EdgeTable<S>& edges);
  std::size_t bytes() const { return SortedPairs::bytes() + 4 * node[0].bytes() + size.bytes() + flat.bytes(); }

 private:
  void fill_place(std::int64_t place, const SegmentSurface<S>& surface, const EdgeTable<S>& edges);

  bool any_flat_ = false;
};

}  // namespace pinball
