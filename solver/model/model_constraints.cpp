#include <algorithm>

#include <solver/base/point.hpp>

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
void set_constraints(Model<S>& model, double time) {
  model.constraints.clear();
  model.prescribed.clear();
  std::vector<GivenDirection> directions = directions_of_store(model, time);
  // Orthonormal per node, so that removing one direction leaves the others removed: the first of a node counts most.
  std::stable_sort(directions.begin(), directions.end(),
                   [](const GivenDirection& a, const GivenDirection& b) { return a.node < b.node; });
  std::vector<Point> basis;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const GivenDirection& h = directions[i];
    if (i == 0 || h.node != directions[i - 1].node) basis.clear();
    Point d = h.direction;
    const double length = make_orthogonal(d, basis);
    if (length < least_length_left) continue;
    basis.push_back(d);
    const S x = static_cast<S>(d[0]), y = static_cast<S>(d[1]), z = static_cast<S>(d[2]);
    if (h.held) {
      model.constraints.push_back({h.node, {x, y, z}, h.table});
      continue;
    }
    // Of a whole velocity, what is left along d; of a speed along one direction, what gives it that component.
    const PrescribedVelocity& given = model.scene.prescribed_velocities[h.table];
    const double speed = given.direction ? h.speed / length : dot(given.velocity, d);
    model.prescribed.push_back({h.node, {x, y, z}, static_cast<S>(speed), h.table});
  }
}

template void set_constraints<double>(Model<double>&, double);
template void set_constraints<float>(Model<float>&, double);

}  // namespace pinball
