#include "symmetry_walls.hpp"

#include <algorithm>
#include <utility>

#include <solver/base/point.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

/// A body beside a plane.
struct BodyAtPlane {
  std::vector<std::int32_t> nodes;  ///< of the scene, that are not in the plane
  double sign = 0;                  ///< of the side along the normal on which it lies; 0: on both
  bool held = false;                ///< it has nodes in the plane
};

/// held: nodes in the plane, ascending.
BodyAtPlane body_at(const PlaneConstraint& plane, const Point& through, const std::vector<std::int32_t>& held,
                    const ModelMesh& mesh, const std::string& name) {
  constexpr double nothing = 0.01;  // of how far a body reaches: nodes of a rounded plane lie to both of its sides
  BodyAtPlane body;
  double low = 0, high = 0;
  for (const std::int32_t n : matching_nodes(mesh, {.where = plane.where, .body = name})) {
    if (std::ranges::binary_search(held, n)) {
      body.held = true;
      continue;
    }
    const double distance = dot(minus(mesh.nodes[n], through), plane.normal);
    low = std::min(low, distance);
    high = std::max(high, distance);
    body.nodes.push_back(n);
  }
  if (-low <= nothing * high) body.sign = 1;
  if (high <= nothing * -low) body.sign = -1;
  return body;
}

std::vector<BodyAtPlane> bodies_at(const PlaneConstraint& plane, const Point& through,
                                   const std::vector<std::int32_t>& held, const ModelMesh& mesh) {
  std::vector<BodyAtPlane> bodies;
  for (const std::string& name : mesh.body_names) {
    if (plane.body.empty() || plane.body == name) bodies.push_back(body_at(plane, through, held, mesh, name));
  }
  return bodies;
}

}  // namespace

template <class S>
SymmetryWalls<S>::SymmetryWalls(const Model<S>& model, const BoundaryKernels<S>& kernels) {
  bool erodes = false;
  for (const Part& part : model.parts) erodes = erodes || part.features.erosion;
  if (!erodes) return;
  for (const PlaneConstraint& plane : model.scene.constraints) {
    const std::vector<std::int32_t> held = matching_nodes(model.mesh, nodes_of(plane));
    const Point through = plane.set.empty() || held.empty() ? plane.point : model.mesh.nodes[held.front()];
    const std::vector<BodyAtPlane> bodies = bodies_at(plane, through, held, model.mesh);
    Wall& wall = walls_.emplace_back(Wall{{}, plane.name, plane.normal});
    for (const double sign : {1.0, -1.0}) {
      const auto holds = [&](const BodyAtPlane& body) { return body.sign == sign && (body.held || held.empty()); };
      if (std::ranges::none_of(bodies, holds)) continue;
      std::vector<std::int32_t> nodes;
      for (const BodyAtPlane& body : bodies) {
        if (body.sign != sign) continue;
        for (const std::int32_t n : body.nodes) nodes.push_back(model.node_of_scene_node[n]);
      }
      for (const RigidNodes& rigid : model.rigid)  // they do not cross it one by one
        std::erase_if(nodes, [&](std::int32_t n) { return std::ranges::binary_search(rigid.nodes, n); });
      // All are looked at in each step after the first erosion: in the order in which they lie.
      std::ranges::sort(nodes);
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      Point inward = plane.normal;
      for (double& c : inward) c *= sign;
      if (wall.sides.empty()) wall.inward = inward;
      wall.sides.push_back({kernels.reflection(nodes, through, inward), wall.sides.empty() ? 1.0 : -1.0});
    }
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
    if (begins_cycle) wall.force = 0;
    for (Side& side : wall.sides) {
      const Reflection sum = side.nodes->reflect(nodes, static_cast<S>(step.after), due);
      if (step.velocity() > 0) wall.force += side.sign * sum.impulse / step.velocity();
      work_ += sum.work;
    }
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
  for (const Wall& wall : walls_) {
    for (const Side& side : wall.sides) sum += side.nodes->bytes();
  }
  return sum;
}

template class SymmetryWalls<double>;
template class SymmetryWalls<float>;

}  // namespace pinball
