#pragma once

#include <cstdint>
#include <string>

#include "model.hpp"

/// What messages call elements and nodes: by the number that their mesh file gives them, where they are from one; else
/// counted from 0 in the order of the scene, over all bodies, as in fields_*.vtu.
namespace pinball {

/// "element 4711 of body rod"
std::string element_name(const ModelMesh& mesh, std::int64_t element);
/// "node 17 of body rod", the first body that has it
std::string node_name(const ModelMesh& mesh, std::int64_t node);

}  // namespace pinball
