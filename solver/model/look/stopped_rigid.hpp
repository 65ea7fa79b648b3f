#pragma once

#include <string>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// Rigid bodies that are given a velocity along directions in which they, or planes of symmetry, hold them: a sentence
/// for each, since they begin without. Of bodies whose nodes begin with one velocity, or whose own is given.
std::vector<std::string> stopped_rigid_bodies(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
