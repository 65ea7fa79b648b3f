#pragma once

#include <string>
#include <vector>

#include <solver/model/model.hpp>

#include "movers.hpp"

namespace pinball {

/// Walls take no node from what gives its motion along their normal: a sentence for each wall and prescribed velocity
/// that moves nodes through it, or constraint that holds nodes where a wall goes. Of walls without end in space whose
/// motion is given, and of motions that begin with the run.
std::vector<std::string> passed_walls(const Scene& scene, const ModelMesh& mesh);

/// A wall that begins later lets nodes alone that lie behind it then: a sentence for each wall and mover of which nodes
/// will, if nothing that they meet keeps them from it. Of walls without end in space.
std::vector<std::string> walls_begun_late(const Scene& scene, const ModelMesh& mesh, const Movers& movers);

}  // namespace pinball
