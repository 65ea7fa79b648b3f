#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pinball {

/// Tiles by colour: those of colour c are items[colour_offsets[c]] ... items[colour_offsets[c + 1] - 1], ascending.
struct Colouring {
  std::vector<std::int32_t> colour_offsets;  ///< [colours + 1], first 0, last the number of tiles
  std::vector<std::int32_t> items;           ///< [tiles]
};

/// The tiles for which keep(tile) holds, colours in the same order, without those of which none is left.
template <class Keep>
Colouring chosen_of(const Colouring& all, const Keep& keep) {
  Colouring chosen;
  chosen.colour_offsets = {0};
  for (std::size_t c = 0; c + 1 < all.colour_offsets.size(); ++c) {
    for (std::int32_t i = all.colour_offsets[c]; i < all.colour_offsets[c + 1]; ++i) {
      const std::int32_t tile = all.items[i];
      if (keep(tile)) chosen.items.push_back(tile);
    }
    const std::int32_t end = chosen.items.size();
    if (end > chosen.colour_offsets.back()) chosen.colour_offsets.push_back(end);
  }
  return chosen;
}

/// Colours tiles of consecutive elements so that no two tiles of one colour share a node; such tiles may add to their
/// nodes at the same time.
///
/// tile_offsets_in_elements: [tiles + 1], ascending from 0 to the number of elements; tile t has the elements
/// tile_offsets_in_elements[t] ... tile_offsets_in_elements[t + 1] - 1. Greedy: the first colour free at all nodes of
/// the tile, in the order of the tiles; then tiles leave crowded colours for emptier ones. The same input gives the
/// same colours. Time is linear in elements (times colours / 64), memory 8 bytes per node for each 64 colours.
/// Throws InputError if the offsets do not fit the elements or an element names a node outside 0 ... node_count - 1.
Colouring colour_tiles(const std::vector<std::int32_t>& tile_offsets_in_elements,
                       const std::vector<std::array<std::int32_t, 8>>& hexahedra, std::int32_t node_count);

}  // namespace pinball
