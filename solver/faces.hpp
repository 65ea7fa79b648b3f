#pragma once

#include <array>
#include <cstdint>
#include <pinball/kernels/hexahedron.hpp>
#include <vector>

namespace pinball {

/// For each element and face (in the order of face_nodes) the element on the other side, or -1 on the surface.
///
/// Two faces are the same if they have the same four nodes. Time is O(n log n) at worst and linear for meshes in which
/// few elements meet at a node; beside the result it needs 24 bytes per element and 4 bytes per node.
/// Throws InputError, naming an element (counted from 0), if three elements share a face, an element has two faces with
/// the same nodes, a node index is negative, or there are more than 2^31 / 6 elements.
std::vector<std::array<std::int32_t, 6>> face_neighbours(const std::vector<std::array<std::int32_t, 8>>& hexahedra);

}  // namespace pinball
