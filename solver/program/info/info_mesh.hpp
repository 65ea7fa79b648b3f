#pragma once

#include <string>
#include <vector>

#include <solver/mesh/element_types.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh_settings.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// Edges and shapes of elements in a sentence without its end. length: unit of the mesh; empty: none.
std::string quality_text(const MeshQuality& q, const std::string& length);

/// " (12 of them tetrahedra)", where not all are hexahedra.
std::string other_shapes(const std::vector<Corners8>& elements);

/// Parts and sets of the mesh files, parts that no body has, and what is reported of them at the start.
void print_mesh_files(const ModelMesh& mesh);

/// What a mesh file holds, which is no scene and no deck. Throws InputError.
void print_mesh_file(const std::string& path, MeshFormat format);

}  // namespace pinball
