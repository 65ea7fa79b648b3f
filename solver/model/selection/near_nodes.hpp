#pragma once

#include <string>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// Every selection of the scene by plane, line or box that some nodes lie near to without being taken, a sentence each.
std::vector<std::string> find_near_nodes(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
