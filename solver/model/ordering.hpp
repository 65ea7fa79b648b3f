#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <solver/mesh.hpp>

/// Renumberings that keep neighbours in space close in memory. An order lists old indices by new index:
/// order[new] = old. `inverse_permutation` gives the other direction.
namespace pinball {

/// Elements in tiles: those of tile t are order[offsets[t]] ... order[offsets[t + 1] - 1].
struct TileOrder {
  std::vector<std::int32_t> order;    ///< [elements]
  std::vector<std::int32_t> offsets;  ///< [tiles + 1], first 0
};

/// Cuts the elements into tiles of at most `largest`, as compact as may be, so that few nodes belong to several tiles:
/// by halves, each time across the direction with the most layers of elements. Within a tile elements lie in rows, the
/// rows in layers, so that neighbours in a row share nodes while these are in the nearest cache. Tiles come in the
/// order of the halves: near ones are near in memory.
///
/// centres, extents: of the box around each element [length]; elements: the indices to take, each once; tiles are
/// multiples of `multiple` elements but for the last. Depends on positions alone, ties by index. Coordinates are to be
/// finite. row_axis: the direction of rows, along which tiles are then up to four times as long as they are thick; -1:
/// that with the most layers.
TileOrder compact_tiles(std::span<const Point> centres, std::span<const Point> extents,
                        std::vector<std::int32_t> elements, std::int64_t largest, std::int64_t multiple,
                        int row_axis = -1);

/// Nodes in the order in which the elements first touch them, elements taken as listed; unused nodes come last,
/// by index. Throws InputError if an element names a node outside 0 ... node_count - 1.
std::vector<std::int32_t> first_touch_node_order(const std::vector<std::array<std::int32_t, 8>>& hexahedra,
                                                 std::int32_t node_count);

/// new_index[old] for order[new] = old. The order is to be a permutation.
std::vector<std::int32_t> inverse_permutation(const std::vector<std::int32_t>& order);

}  // namespace pinball
