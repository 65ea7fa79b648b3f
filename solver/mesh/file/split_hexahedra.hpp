#pragma once

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Splits each hexahedron in eight, at the middles of its edges, faces and body; what is flat stays flat, and facets of
/// curved surfaces stay facets. Nodes keep their places and numbers, new ones follow them and have numbers beyond the
/// largest. The eight have the number, part and line of the one that they are of. Sets go with it: a new node belongs
/// to the sets of nodes, and is held by the file, where all nodes of its edge, face or body are; sets of elements have
/// the eight, sets of faces the four. Throws InputError for collapsed hexahedra and for meshes that 32 bits cannot
/// number.
void split_hexahedra(MeshFile& file);

}  // namespace pinball
