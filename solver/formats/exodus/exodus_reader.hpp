#pragma once

#include <string>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Mesh of an Exodus II file: blocks of 8-node hexahedra and of 6-node wedges, which become collapsed hexahedra, as
/// parts, node sets, side sets as sets of faces and also of their nodes, element sets, numbers of nodes and elements.
/// parts: names or numbers of the blocks that are needed; none: all. Blocks of other elements are refused by name where
/// they are needed or have a volume and all are; shells, bars and points are passed over, with a note. Throws
/// InputError "PATH: variable NAME: ...".
MeshFile read_exodus(const std::string& path, const std::vector<std::string>& parts);

}  // namespace pinball
