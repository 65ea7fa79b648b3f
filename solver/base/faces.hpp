#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../../kernels/hexahedron.hpp"

namespace pinball {

/// What face_neighbours gives for a face of a collapsed hexahedron that is a line or a point: no surface, no neighbour.
inline constexpr std::int32_t collapsed_face = -2;

/// For each element and face (in the order of face_nodes) the element on the other side, -1 on the surface, or
/// collapsed_face.
///
/// Two faces are the same if they have the same nodes; a hexahedron collapsed to a wedge has triangles among its faces,
/// which meet the triangles of others. Time is O(n log n) at worst and linear for meshes in which
/// few elements meet at a node; beside the result it needs 24 bytes per element and 4 bytes per node.
/// Throws InputError, naming an element (counted from 0), if three elements share a face, two elements have the same
/// nodes, an element has two faces with the same nodes or a face with the same node at opposite corners, a node index
/// is negative, or there are more than 2^31 / 6 elements.
std::vector<std::array<std::int32_t, 6>> face_neighbours(const std::vector<std::array<std::int32_t, 8>>& hexahedra);

}  // namespace pinball
