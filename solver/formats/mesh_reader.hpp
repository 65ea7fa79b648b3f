#pragma once

#include <string>
#include <vector>

#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh_settings.hpp>

namespace pinball {

/// Reads the file of a mesh, with its coordinates scaled and its hexahedra split. parts: which are needed ("": all).
/// Throws InputError for a number that two nodes, or two elements, of different content have.
MeshFile read_mesh_file(const FileMesh& settings, const std::vector<std::string>& parts);

}  // namespace pinball
