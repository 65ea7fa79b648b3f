#pragma once

#include <string>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// Every place where the scene names a set some of whose nodes, elements or faces are of none of its bodies, a sentence
/// each: nothing acts there. Throws InputError for a file that no body is from.
std::vector<std::string> find_left_out(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
