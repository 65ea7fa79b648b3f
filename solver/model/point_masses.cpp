#include "point_masses.hpp"

#include <fmt/core.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

bool is_weighed_as_given(const RigidBody& rigid) {
  return rigid.mass > 0 || rigid.centre || rigid.inertia != std::array<Point, 3>{};
}

/// What is given of a rigid body is all of it: a mass at one of its nodes would be beside it, or in it.
template <class S>
void require_own_weight(const Model<S>& model, const std::vector<std::int32_t>& nodes, const PointMass& point) {
  for (std::size_t r = 0; r < model.rigid.size(); ++r) {
    const RigidBody& rigid = model.scene.rigid_bodies[r];
    if (!is_weighed_as_given(rigid)) continue;
    const std::vector<std::int32_t>& own = model.rigid[r].nodes;
    if (std::ranges::none_of(nodes, [&](std::int32_t n) { return std::ranges::binary_search(own, n); })) continue;
    throw InputError(
        fmt::format("{}: nodes of the rigid body {}, whose mass, centre or inertia is given: expected none "
                    "of them; put the mass into what is given",
                    point.nodes.where, rigid.name));
  }
}

}  // namespace

template <class S>
void add_point_masses(Model<S>& model) {
  if (model.scene.point_masses.empty()) return;
  std::vector<double> added(model.node_mass.size(), 0.0);
  for (const PointMass& point : model.scene.point_masses) {
    const std::vector<std::int32_t> nodes = select_nodes(model.mesh, point.nodes);
    require_own_weight(model, nodes, point);
    double of_elements = 0;
    for (const std::int32_t n : nodes) of_elements += model.material_mass_of_node(model.node_of_scene_node[n]);
    for (const std::int32_t n : nodes) {
      const std::int32_t node = model.node_of_scene_node[n];
      added[node] += point.each ? point.mass : point.mass * (model.material_mass_of_node(node) / of_elements);
    }
  }
  for (std::size_t n = 0; n < added.size(); ++n) model.node_mass[n] += added[n];
  model.point_mass = std::move(added);
}

template void add_point_masses(Model<double>&);
template void add_point_masses(Model<float>&);

}  // namespace pinball
