#include "rigid_at_planes.hpp"

#include <algorithm>

#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

constexpr double independent = 1e-6;  ///< of a unit vector across others, as where bodies are held [-]

/// Those that no combination of the ones before gives.
std::vector<std::size_t> independent_of(const std::vector<Point>& directions) {
  std::vector<Point> basis;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    Point across = directions[i];
    if (!(make_orthogonal(across, basis) > independent)) continue;
    basis.push_back(across);
    found.push_back(i);
  }
  return found;
}

}  // namespace

template <class S>
RigidAtPlanes::RigidAtPlanes(const Model<S>& model) {
  const std::vector<PlaneConstraint>& all = model.scene.constraints;
  if (model.rigid.empty() || std::ranges::all_of(all, [](const PlaneConstraint& p) { return p.name.empty(); })) return;
  std::vector<std::vector<std::size_t>> planes(model.rigid.size());
  for (std::size_t p = 0; p < all.size(); ++p) {
    const std::vector<std::int32_t> nodes = matching_nodes(model.mesh, nodes_of(all[p]));
    for (std::size_t r = 0; r < model.rigid.size(); ++r) {
      const auto is_of_body = [&](std::int32_t n) {
        return std::ranges::binary_search(model.rigid[r].nodes, model.node_of_scene_node[n]);
      };
      if (std::ranges::any_of(nodes, is_of_body)) planes[r].push_back(p);
    }
  }
  for (std::size_t r = 0; r < planes.size(); ++r) add_body(model.scene, r, planes[r]);
}

/// A reaction is the sum of the forces along the directions that hold: each is found across all others.
void RigidAtPlanes::add_body(const Scene& scene, std::size_t body, const std::vector<std::size_t>& planes) {
  std::vector<Point> directions;
  for (const std::size_t p : planes) directions.push_back(scene.constraints[p].normal);
  const std::vector<Point>& own = scene.rigid_bodies[body].held;
  directions.insert(directions.end(), own.begin(), own.end());
  const std::vector<std::size_t> holding = independent_of(directions);
  for (const std::size_t i : holding) {
    if (i >= planes.size() || scene.constraints[planes[i]].name.empty()) continue;
    std::vector<Point> others;
    for (const std::size_t j : holding) {
      Point across = directions[j];
      if (j == i) continue;
      make_orthogonal(across, others);
      others.push_back(across);
    }
    Point part = directions[i];
    const double along = make_orthogonal(part, others);
    for (double& c : part) c /= along;
    holds_.push_back({body, scene.constraints[planes[i]].name, directions[i], part});
  }
}

void RigidAtPlanes::add_forces(const std::vector<RigidBodyResult>& bodies, std::vector<ForceResult>& forces) const {
  for (const Hold& hold : holds_) {
    const double force = dot(bodies[hold.body].force, hold.part);
    Point& sum = std::ranges::find(forces, hold.name, &ForceResult::name)->force;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += force * hold.normal[k];
  }
}

template RigidAtPlanes::RigidAtPlanes(const Model<double>&);
template RigidAtPlanes::RigidAtPlanes(const Model<float>&);

}  // namespace pinball
