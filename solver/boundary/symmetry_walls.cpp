#include "symmetry_walls.hpp"

#include <algorithm>
#include <utility>

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
    for (const std::int32_t n : matching_nodes(model.mesh, {.where = plane.where, .body = plane.body})) {
      side += dot(minus(model.mesh.nodes[n], through), plane.normal);
      const bool in_plane = std::binary_search(held.begin(), held.end(), n);
      if (!in_plane) nodes.push_back(model.node_of_scene_node[n]);
    }
    for (const RigidNodes& rigid : model.rigid)  // they do not cross it one by one
      std::erase_if(nodes, [&](std::int32_t n) { return std::ranges::binary_search(rigid.nodes, n); });
    Point inward = plane.normal;
    if (side < 0) {
      for (double& c : inward) c = -c;
    }
    std::ranges::sort(nodes);  // all are looked at in each step after the first erosion: in the order in which they lie
    walls_.push_back({kernels.reflection(nodes, through, inward), plane.name, inward});
  }
}

template <class S>
double SymmetryWalls<S>::reflect(const NodeArrays<S>& nodes, const StepLengths& step, bool ends_cycle,
                                 const DueSpans& due) {
  const double before = std::exchange(work_, 0.0);
  const bool begins_cycle = std::exchange(cycle_ends_, ends_cycle);
  if (begins_cycle) steps_ = 0;
  ++steps_;
  for (Wall& wall : walls_) {
    const Reflection sum = wall.nodes->reflect(nodes, static_cast<S>(step.after), due);
    if (begins_cycle) wall.force = 0;
    if (step.velocity() > 0) wall.force += sum.impulse / step.velocity();
    work_ += sum.work;
  }
  return before;
}

template <class S>
void SymmetryWalls<S>::add_forces(std::vector<ForceResult>& forces) const {
  for (const Wall& wall : walls_) {
    if (wall.name.empty() || wall.force == 0) continue;
    Point& sum = std::ranges::find(forces, wall.name, &ForceResult::name)->force;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += wall.force / static_cast<double>(steps_) * wall.inward[k];
  }
}

template <class S>
void SymmetryWalls<S>::persist(StateArchive& archive) {
  archive(steps_, work_);
  for (Wall& wall : walls_) archive(wall.force);
  archive.require(steps_ >= 0);
}

template <class S>
std::size_t SymmetryWalls<S>::bytes() const {
  std::size_t sum = 0;
  for (const Wall& wall : walls_) sum += wall.nodes->bytes();
  return sum;
}

template class SymmetryWalls<double>;
template class SymmetryWalls<float>;

}  // namespace pinball
