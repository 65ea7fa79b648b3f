#pragma once

#include <cstddef>
#include <cstdint>

#include "model.hpp"

namespace pinball {

/// Calls visit(body, node) for the nodes of all bodies: those that bodies share for each of them, after all others.
template <class Visit>
void for_nodes_of_bodies(const ModelMesh& mesh, const Visit& visit) {
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) visit(mesh.body_of_node[n], static_cast<std::int32_t>(n));
  for (std::size_t b = 0; b < mesh.shared.size(); ++b) {
    for (const std::int32_t n : mesh.shared[b]) visit(static_cast<std::int32_t>(b), n);
  }
}

}  // namespace pinball
