#pragma once

#include <string>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// Every pressure, contact pair and tied contact of the scene by a set of faces some of which are of none of its
/// bodies, a sentence each: nothing acts there. Throws InputError for a file that no body is from.
std::vector<std::string> find_left_out_faces(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
