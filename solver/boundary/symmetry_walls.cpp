#include "symmetry_walls.hpp"

#include <algorithm>

#include <solver/base/point.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

template <class S>
SymmetryWalls<S>::SymmetryWalls(const Model<S>& model, const BoundaryKernels<S>& kernels) {
  bool erodes = false;
  for (const Part& part : model.parts) erodes = erodes || part.features.erosion;
  if (!erodes) return;
  for (const PlaneConstraint& plane : model.scene.constraints) {
    std::vector<std::int32_t> nodes;
    double side = 0;  // of the plane on which the bodies lie
    const std::vector<std::int32_t> held = matching_nodes(model.mesh, nodes_of(plane));
    const Point through = plane.set.empty() || held.empty() ? plane.point : model.mesh.nodes[held.front()];
    for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
      const auto body = static_cast<std::size_t>(model.mesh.body_of_node[n]);
      if (!plane.body.empty() && plane.body != model.mesh.body_names[body]) continue;
      side += dot(minus(model.mesh.nodes[n], through), plane.normal);
      const bool in_plane = std::binary_search(held.begin(), held.end(), static_cast<std::int32_t>(n));
      if (!in_plane) nodes.push_back(model.node_of_scene_node[n]);
    }
    for (const RigidNodes& rigid : model.rigid)  // they do not cross it one by one
      std::erase_if(nodes, [&](std::int32_t n) { return std::ranges::binary_search(rigid.nodes, n); });
    Point inward = plane.normal;
    if (side < 0) {
      for (double& c : inward) c = -c;
    }
    std::ranges::sort(nodes);  // all are looked at in each step after the first erosion: in the order in which they lie
    walls_.push_back(kernels.reflection(nodes, through, inward));
  }
}

template <class S>
std::size_t SymmetryWalls<S>::bytes() const {
  std::size_t sum = 0;
  for (const auto& wall : walls_) sum += wall->bytes();
  return sum;
}

template class SymmetryWalls<double>;
template class SymmetryWalls<float>;

}  // namespace pinball
