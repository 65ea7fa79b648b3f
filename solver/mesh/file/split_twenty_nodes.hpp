#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Makes eight hexahedra of eight nodes of each that has twenty, one at each corner, in the order of the corners: with
/// its number, part and line, in its sets of elements; a face of it in a set of faces becomes four. It gets nodes in
/// the middle of its faces and of itself, where its own shape functions have them; their numbers follow the largest.
/// These are in the sets of nodes that have all other nodes of the face, or of the element. What is done is noted in
/// `notes`.
///
/// Returns as split_ten_nodes does, behind which it comes; empty: no element has twenty nodes. Throws InputError for a
/// node that is not near the middle of its edge, for corners that are the same node, and for meshes that 32 bits cannot
/// number.
std::vector<std::int32_t> split_twenty_nodes(MeshFile& file);

}  // namespace pinball
