#include <algorithm>
#include <cmath>

#include <solver/base/point.hpp>
#include <solver/model/selection/node_selection.hpp>

#include "model.hpp"

namespace pinball {

namespace {

/// A direction in which the velocity of a node is given, before those of one node are made orthogonal.
struct GivenDirection {
  std::int32_t node = 0;   ///< of the store
  Point direction{};       ///< of unit length
  double speed = 0;        ///< along it [length/time]
  std::int32_t table = 0;  ///< number of the prescribed velocity, or of the constraint
  bool held = false;       ///< a constraint
};

/// The directions of a fixed constraint at a place, in global components. On the axis of a cylindrical frame nothing
/// tells radial from circumferential: a direction that is not purely axial holds the node across the axis altogether.
std::vector<Point> directions_at(const FixedConstraint& fixed, const Point& place, double tolerance) {
  if (fixed.frame == Frame::global) return fixed.directions;
  const Point& axial = fixed.axis.direction;
  Point radial = minus(place, fixed.axis.point);
  const bool on_axis = make_orthogonal(radial, {axial}) <= tolerance;
  if (on_axis) {
    radial = std::abs(axial[0]) < 0.5 ? Point{1, 0, 0} : Point{0, 1, 0};
    make_orthogonal(radial, {axial});
  }
  const Point circumferential = cross(axial, radial);
  std::vector<Point> result;
  for (const Point& d : fixed.directions) {
    if (on_axis && std::hypot(d[0], d[1]) > 1e-12) {
      result.push_back(radial);
      result.push_back(circumferential);
    }
    Point global{};
    for (std::size_t k = 0; k < 3; ++k) global[k] = d[0] * radial[k] + d[1] * circumferential[k] + d[2] * axial[k];
    result.push_back(global);
  }
  return result;
}

/// Of all nodes: constraints first, then prescribed velocities, each in the order of the scene.
template <class S>
std::vector<GivenDirection> given_directions(const Model<S>& model, double time) {
  const Scene& scene = model.scene;
  const double tolerance = 1e-9 * mesh_size(model.mesh);
  std::vector<GivenDirection> directions;
  std::int32_t constraint = 0;
  std::vector<bool> is_rigid(model.rigid.empty() ? 0 : model.nodes.count, false);  // these are held as a whole
  for (const RigidNodes& rigid : model.rigid) {
    for (const std::int32_t n : rigid.nodes) is_rigid[n] = true;
  }
  const auto hold = [&](std::int32_t scene_node, const Point& direction) {
    if (!is_rigid.empty() && is_rigid[model.node_of_scene_node[scene_node]]) return;
    directions.push_back({model.node_of_scene_node[scene_node], direction, 0, constraint, true});
  };
  const auto move = [&](std::int32_t scene_node, const Point& direction, double speed, std::int32_t table) {
    directions.push_back({model.node_of_scene_node[scene_node], direction, speed, table, false});
  };
  for (const PlaneConstraint& plane : scene.constraints) {
    const NodeSelection nodes = nodes_of(plane);  // none may lie on a plane, but a set is meant to have some
    for (const std::int32_t n : plane.set.empty() ? matching_nodes(model.mesh, nodes) : select_nodes(model.mesh, nodes))
      hold(n, plane.normal);
    ++constraint;
  }
  for (const FixedConstraint& fixed : scene.fixed_constraints) {
    for (const std::int32_t n : select_nodes(model.mesh, fixed.nodes)) {
      if (!fixed.when.contains(time)) break;
      const Point& place = model.mesh.nodes[n];
      for (const Point& d : directions_at(fixed, place, tolerance)) hold(n, d);
    }
    ++constraint;
  }
  for (std::size_t t = 0; t < scene.prescribed_velocities.size(); ++t) {
    const PrescribedVelocity& given = scene.prescribed_velocities[t];
    for (const std::int32_t n : select_nodes(model.mesh, given.nodes)) {
      if (!given.when.contains(time)) break;
      const std::int32_t table = t;
      if (given.direction) {
        move(n, *given.direction, dot(given.velocity, *given.direction), table);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        Point axis{};
        axis[k] = 1;
        move(n, axis, given.velocity[k], table);
      }
    }
  }
  return directions;
}

}  // namespace

template <class S>
void set_constraints(Model<S>& model, double time) {
  model.constraints.clear();
  model.prescribed.clear();
  std::vector<GivenDirection> directions = given_directions(model, time);
  // Orthonormal per node, so that removing one direction leaves the others removed: the first of a node counts most.
  std::stable_sort(directions.begin(), directions.end(),
                   [](const GivenDirection& a, const GivenDirection& b) { return a.node < b.node; });
  std::vector<Point> basis;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const GivenDirection& h = directions[i];
    if (i == 0 || h.node != directions[i - 1].node) basis.clear();
    Point d = h.direction;
    const double length = make_orthogonal(d, basis);
    if (length < 1e-6) continue;
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
