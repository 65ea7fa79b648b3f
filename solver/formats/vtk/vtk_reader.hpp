#pragma once

#include <string>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

#include "vtk_grid.hpp"

namespace pinball {

/// Mesh of a file of VTK with an unstructured grid: legacy (.vtk), text or binary, or of XML (.vtu), with ascii,
/// base64, raw and zlib-compressed data. What becomes of it: mesh_of_grid (vtk_grid.hpp). Throws InputError "PATH:LINE:
/// ...".
MeshFile read_vtk(const std::string& path, const std::string& array, const std::vector<std::string>& parts);

/// The same for a file in memory; `name` stands for the path in messages.
MeshFile parse_vtk(std::string bytes, const std::string& name, const std::string& array,
                   const std::vector<std::string>& parts);

/// The two kinds of files. Bytes of XML are changed by reading them.
VtkGrid parse_vtk_legacy(const std::string& bytes, const std::string& name);
VtkGrid parse_vtu(std::string& bytes, const std::string& name);

}  // namespace pinball
