#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pinball {

/// Local nodes of the six faces in the order xi-, xi+, eta-, eta+, zeta-, zeta+; each counterclockwise seen from
/// outside, so that the area vector (x2 - x0) x (x3 - x1) / 2 points outward.
inline constexpr int face_nodes[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                         {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};

/// For each element and face (in the order of face_nodes) the element on the other side, or -1 on the surface.
///
/// Two faces are the same if they have the same four nodes. Time is O(n log n) at worst and linear for meshes in which
/// few elements meet at a node; beside the result it needs 24 bytes per element and 4 bytes per node.
/// Throws InputError, naming an element (counted from 0), if three elements share a face, an element has two faces with
/// the same nodes, a node index is negative, or there are more than 2^31 / 6 elements.
std::vector<std::array<std::int32_t, 6>> face_neighbours(const std::vector<std::array<std::int32_t, 8>>& hexahedra);

}  // namespace pinball
