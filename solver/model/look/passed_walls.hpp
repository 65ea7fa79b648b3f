#pragma once

#include <string>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// Walls take no node from what gives its motion along their normal: a sentence for each wall and prescribed velocity
/// that moves nodes through it, or constraint that holds nodes where a wall goes. Of walls without end in space whose
/// motion is given, and of motions that begin with the run.
std::vector<std::string> passed_walls(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
