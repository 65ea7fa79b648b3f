#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/scene_boundary.hpp>

#include "model.hpp"

namespace pinball {

/// Numbers in the mesh of the nodes of a selection, ascending; there may be none. Places count as equal within 1e-9 of
/// the size of the mesh.
std::vector<std::int32_t> matching_nodes(const ModelMesh& mesh, const NodeSelection& selection);

/// The same, but throws InputError that names the selection if there is none.
std::vector<std::int32_t> select_nodes(const ModelMesh& mesh, const NodeSelection& selection);

/// Largest extent of the mesh along x, y or z [length].
double mesh_size(const ModelMesh& mesh);

/// The selection in words: "on the plane through (0, 0, 0) with normal (1, 0, 0), of body bar".
std::string describe(const NodeSelection& selection);

}  // namespace pinball
