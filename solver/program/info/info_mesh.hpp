#pragma once

#include <solver/model/model.hpp>

namespace pinball {

/// Parts and sets of the mesh files, and what is told of them at the start.
void print_mesh_files(const ModelMesh& mesh);

}  // namespace pinball
