#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pinball {

/// Local nodes of the six faces in the order xi-, xi+, eta-, eta+, zeta-, zeta+; each counterclockwise seen from
/// outside, so that the area vector (x2 - x0) x (x3 - x1) / 2 points outward.
inline constexpr int face_nodes[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                         {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};

/// What face_neighbours gives for a face of a collapsed hexahedron that is a line or a point: no surface, no neighbour.
inline constexpr std::int32_t collapsed_face = -2;

/// For each element and face (in the order of face_nodes) the element on the other side, -1 on the surface, or
/// collapsed_face.
///
/// Two faces are the same if they have the same nodes; a hexahedron collapsed to a wedge has triangles among its faces,
/// which meet the triangles of others. Time is O(n log n) at worst and linear for meshes in which
/// few elements meet at a node; beside the result it needs 24 bytes per element and 4 bytes per node.
/// Throws InputError, naming an element (counted from 0), if three elements share a face, an element has two faces with
/// the same nodes or a face with the same node at opposite corners, a node index is negative, or there are more than
/// 2^31 / 6 elements.
std::vector<std::array<std::int32_t, 6>> face_neighbours(const std::vector<std::array<std::int32_t, 8>>& hexahedra);

}  // namespace pinball
