#pragma once

#include <cstdint>
#include <vector>

#include "node_selection.hpp"

namespace pinball {

/// The nodes that a rigid wall may stop: all where nothing says which. Throws InputError where what says so has none.
inline std::vector<std::int32_t> nodes_of_wall(const ModelMesh& mesh, const RigidWall& wall) {
  const NodeSelection nodes = nodes_of(wall);
  return nodes.all() && nodes.without.empty() ? matching_nodes(mesh, nodes) : select_nodes(mesh, nodes);
}

}  // namespace pinball
