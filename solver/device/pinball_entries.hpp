#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <solver/contact/algorithm/pinball_kernels.hpp>

namespace pinball {

/// Of each of some things its own entries of a list (EntriesOf), as the host has made them.
struct EntryLists {
  std::vector<std::uint32_t> first;  ///< of each thing, and one more
  std::vector<std::uint32_t> entry;
};

/// The pairs of each pinball, for SumPairForces: those of which it is the second before those of which it is the first,
/// both by the number of the other pinball.
EntryLists entries_of_pinballs(std::span<const PairPiece> pieces, const std::int32_t* first, const std::int32_t* second,
                               std::int32_t pinballs);

/// The pinballs of each node, for LoadNodes, in the order in which the host adds their forces: colours, tiles,
/// pinballs, corners.
class NodeEntries {
 public:
  /// corner: of the listed pinballs, in packs of `row`; tiles: by colour.
  EntryLists of(std::span<const std::int32_t> nodes, std::int32_t node_count, const std::int32_t* corner, int row,
                std::span<const std::int32_t> tile_first, std::span<const std::int32_t> tiles);

 private:
  std::vector<std::int32_t> number_;  ///< of each node of the store, in `nodes`; kept for its memory
};

}  // namespace pinball
