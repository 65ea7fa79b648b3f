#include <algorithm>
#include <utility>

#include "given_directions.hpp"
#include "model.hpp"

namespace pinball {

namespace {

/// Those of a time, with nodes of the store; those of rigid bodies are held as a whole.
template <class S>
std::vector<GivenDirection> directions_of_store(const Model<S>& model, double time) {
  std::vector<GivenDirection> directions = given_directions(model.scene, model.mesh);
  std::erase_if(directions, [time](const GivenDirection& given) { return !given.when.contains(time); });
  for (GivenDirection& given : directions) given.node = model.node_of_scene_node[given.node];
  if (model.rigid.empty()) return directions;
  std::vector<bool> is_rigid(model.nodes.count, false);
  for (const RigidNodes& rigid : model.rigid) {
    for (const std::int32_t n : rigid.nodes) is_rigid[n] = true;
  }
  std::erase_if(directions, [&](const GivenDirection& given) { return given.held && is_rigid[given.node]; });
  return directions;
}

}  // namespace

template <class S>
HeldNodes<S> held_nodes(const Model<S>& model, double time) {
  HeldNodes<S> held;
  std::vector<GivenDirection> directions = directions_of_store(model, time);
  std::stable_sort(directions.begin(), directions.end(),
                   [](const GivenDirection& a, const GivenDirection& b) { return a.node < b.node; });
  NodeDirections of_node(model.scene);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const GivenDirection& given = directions[i];
    if (i == 0 || given.node != directions[i - 1].node) of_node.clear();
    if (!of_node.add(given)) continue;
    const Point& d = of_node.all().back().direction;
    const S x = static_cast<S>(d[0]), y = static_cast<S>(d[1]), z = static_cast<S>(d[2]);
    if (given.held) {
      held.constraints.push_back({given.node, {x, y, z}, given.table});
    } else {
      const bool accelerates = model.scene.prescribed_velocities[given.table].quantity == MotionQuantity::acceleration;
      held.prescribed.push_back(
          {given.node, {x, y, z}, static_cast<S>(of_node.all().back().speed), given.table, accelerates});
    }
  }
  return held;
}

template <class S>
void set_constraints(Model<S>& model, double time) {
  HeldNodes<S> held = held_nodes(model, time);
  model.constraints = std::move(held.constraints);
  model.prescribed = std::move(held.prescribed);
}

template HeldNodes<double> held_nodes(const Model<double>&, double);
template HeldNodes<float> held_nodes(const Model<float>&, double);
template void set_constraints<double>(Model<double>&, double);
template void set_constraints<float>(Model<float>&, double);

}  // namespace pinball
