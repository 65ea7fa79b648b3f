#pragma once

#include <string>
#include <vector>

#include <solver/contact/tied/tied_nodes.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// In words, per rigid wall that takes tied nodes and not all nodes of the faces that they follow: nothing stops these
/// then. ties: in the numbers of the scene. Walls of all nodes take those of faces, too.
std::vector<std::string> find_tied_at_walls(const Scene& scene, const ModelMesh& mesh,
                                            const std::vector<TiedNode>& ties);

}  // namespace pinball
