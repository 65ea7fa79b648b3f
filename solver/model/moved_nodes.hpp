#pragma once

#include <string>
#include <vector>

#include "model.hpp"

namespace pinball {

/// What a start has made of a mesh by moving its nodes.
class MovedNodes {
 public:
  /// Of a mesh as it is before its nodes are moved.
  explicit MovedNodes(const ModelMesh& mesh) : before_(mesh.nodes) {}

  /// How many nodes are at other places now, how far the furthest has gone, and which bodies have another mass, in
  /// words; empty: so little that nobody is to be told. by: what has moved them. From now on it is of this mesh.
  std::string take(const ModelMesh& mesh, const std::string& by);

 private:
  std::vector<Point> before_;
};

}  // namespace pinball
