#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh_file.hpp"

namespace pinball {

/// Hexahedra of a Gmsh mesh (text, format 4.1 or 2.2): 8-node hexahedra, and 6-node prisms as collapsed hexahedra.
///
/// physicals: names of the physical volumes to take, each of which becomes a set of elements; none: all volumes. Nodes
/// of other elements are left out, the rest keep their order; elements of lower dimensions are ignored. An element that
/// format 2.2 repeats, because it belongs to several groups, is taken once. Throws InputError "PATH:LINE: expected ...,
/// got ..." where the file is cut short, binary, of another version or not well formed, an element refers to a missing
/// node or is a volume of another type, nothing is left, or no volume has the name (the message names the nearest).
MeshFile read_gmsh(const std::string& path, const std::vector<std::string>& physicals);

/// The same for a text in memory; `name` stands for the path in messages.
MeshFile parse_gmsh(std::string_view text, const std::string& name, const std::vector<std::string>& physicals);

}  // namespace pinball
