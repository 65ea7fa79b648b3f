#include "tied_at_walls.hpp"

#include <fmt/format.h>

#include <solver/model/selection/node_selection.hpp>

namespace pinball {

std::vector<std::string> find_tied_at_walls(const Scene& scene, const ModelMesh& mesh,
                                            const std::vector<TiedNode>& ties) {
  std::vector<std::string> found;
  if (ties.empty()) return found;
  for (const RigidWall& wall : scene.rigid_walls) {
    const NodeSelection nodes = nodes_of(wall);
    if (nodes.all() && nodes.without.empty()) continue;
    std::vector<std::uint8_t> takes(mesh.nodes.size(), 0);
    for (const std::int32_t n : matching_nodes(mesh, nodes)) takes[n] = 1;
    std::int64_t count = 0;
    for (const TiedNode& tied : ties) {
      const TiedContact& times = scene.tied_contacts[tied.tie];
      if (takes[tied.node] == 0 || times.end <= wall.when.start || times.start >= wall.when.end) continue;
      bool all_corners = true;
      for (std::size_t k = 0; k < 4; ++k) {
        all_corners = all_corners && (!(tied.weight[k] > 0) || takes[tied.corner[k]] != 0);
      }
      if (!all_corners) ++count;
    }
    if (count == 0) continue;
    found.push_back(
        fmt::format("rigid wall {}: {} of the nodes that it takes {} tied to faces whose nodes it does not take, and "
                    "{} these through it: let it take the nodes of the faces, too",
                    wall.name, count, count == 1 ? "is" : "are", count == 1 ? "follows" : "follow"));
  }
  return found;
}

}  // namespace pinball
