#pragma once

#include <cstdint>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Makes eight tetrahedra of four nodes of each that has ten, which fill it with faces between its nodes: first the
/// four inside, around the shortest line between the nodes of two opposite edges, then that at each corner. They have
/// its number, part and line, and are in its sets of elements; a face of it in a set of faces becomes four. Nodes and
/// their sets stay as they are. What is done is noted in `notes`.
///
/// Returns per element, and for one behind the last, its first place from now on; empty: no element has ten nodes.
/// Throws InputError for a node that is nearer to another place than the middle of its edge, and for meshes that 32
/// bits cannot number.
std::vector<std::int32_t> split_ten_nodes(MeshFile& file);

}  // namespace pinball
