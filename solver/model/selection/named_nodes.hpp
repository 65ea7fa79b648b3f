#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/scene_boundary.hpp>

/// Nodes and faces by the names and numbers that mesh files give them. Every one throws InputError that names
/// the selection for what the file does not have.
namespace pinball {

/// The file that a set or numbers of nodes are of. file: how its path ends; empty: the only one there is. where: for
/// messages.
const FileNodes& file_of(const ModelMesh& mesh, const std::string& file, const std::string& where);

/// Of a body those that it has to itself, and those that it shares; ascending.
std::vector<std::int32_t> nodes_of_body(const ModelMesh& mesh, const std::string& name);

/// Of a set of nodes of this name or number; or else of faces, of elements or of a part: their nodes; ascending.
std::vector<std::int32_t> nodes_of_set(const ModelMesh& mesh, const NodeSelection& selection, const std::string& set);

/// The one that the file of the selection gives this number.
std::int32_t node_of_number(const ModelMesh& mesh, const NodeSelection& selection, std::int64_t number);

/// Those of the numbers of the selection, ascending.
std::vector<std::int32_t> numbered_nodes(const ModelMesh& mesh, const NodeSelection& selection);

/// The node or the element that a probe names by its number in the mesh file of its body; without a body in the only
/// one that there is.
std::int32_t place_of_number(const ModelMesh& mesh, const Probe& probe);

/// The set of faces that the selection names; null: it is a set of something else.
const FaceSet* faces_of_set(const ModelMesh& mesh, const NodeSelection& selection);

}  // namespace pinball
