#pragma once

#include <array>
#include <cstdint>
#include <pinball/solver/mesh.hpp>
#include <vector>

/// Renumberings that keep neighbours in space close in memory. An order lists old indices by new index:
/// order[new] = old. `inverse_permutation` gives the other direction.
namespace pinball {

/// Indices of the points sorted along a 3-D Hilbert curve, ties by index.
///
/// The cube that the curve fills has the largest extent of the points' bounding box as its edge, cut into 2^21 cells.
/// Coordinates are to be finite.
std::vector<std::int32_t> space_filling_order(const std::vector<Point>& centres);

/// Nodes in the order in which the elements first touch them, elements taken as listed; unused nodes come last,
/// by index. Throws InputError if an element names a node outside 0 ... node_count - 1.
std::vector<std::int32_t> first_touch_node_order(const std::vector<std::array<std::int32_t, 8>>& hexahedra,
                                                 std::int32_t node_count);

/// new_index[old] for order[new] = old. The order is to be a permutation.
std::vector<std::int32_t> inverse_permutation(const std::vector<std::int32_t>& order);

}  // namespace pinball
