#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Hexahedra of a Gmsh mesh (format 4.1 or 2.2, text or binary): 8-node hexahedra, and 6-node prisms as collapsed
/// hexahedra.
///
/// physicals: names or numbers of the physical volumes to take; none: all volumes. Physical volumes become parts, or
/// sets of elements where some of them have elements in common; groups of points, curves and surfaces become sets of
/// nodes, those of surfaces also sets of faces. Nodes that no hexahedron has are left out, the rest keep their order.
/// An element that format 2.2 repeats, because it belongs to several groups, is taken once. Throws InputError
/// "PATH:LINE: expected ..., got ..." where the file is cut short, of another version or byte order or not well formed,
/// an element refers to a missing node or is a volume of another type, nothing is left, or no volume has the name (the
/// message names the nearest).
MeshFile read_gmsh(const std::string& path, const std::vector<std::string>& physicals);

/// The same for a file in memory; `name` stands for the path in messages.
MeshFile parse_gmsh(std::string_view text, const std::string& name, const std::vector<std::string>& physicals);

}  // namespace pinball
