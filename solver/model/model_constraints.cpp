#include <algorithm>
#include <cmath>

#include <solver/base/point.hpp>

#include "model.hpp"
#include "node_selection.hpp"

namespace pinball {

namespace {

/// A direction in which the velocity of a node is given, before those of one node are made orthogonal.
struct GivenDirection {
  std::int32_t node = 0;    ///< of the store
  Point direction{};        ///< of unit length
  double speed = 0;         ///< along it [length/time]
  std::int32_t table = -1;  ///< of the prescribed velocity; -1: a constraint
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

}  // namespace

template <class S>
void add_constraints(Model<S>& model) {
  const Scene& scene = model.scene;
  const double tolerance = 1e-9 * mesh_size(model.mesh);
  std::vector<GivenDirection> directions;
  const auto hold = [&](std::int32_t scene_node, const Point& direction, double speed, std::int32_t table) {
    const std::int32_t node = model.node_of_scene_node[scene_node];
    directions.push_back({node, direction, speed, table});
  };
  for (const PlaneConstraint& plane : scene.constraints) {
    const NodeSelection on_plane{.body = plane.body, .plane = Plane{plane.point, plane.normal}};
    for (const std::int32_t n : matching_nodes(model.mesh, on_plane)) hold(n, plane.normal, 0, -1);
  }
  for (const FixedConstraint& fixed : scene.fixed_constraints) {
    for (const std::int32_t n : select_nodes(model.mesh, fixed.nodes)) {
      const Point& place = model.mesh.nodes[n];
      for (const Point& d : directions_at(fixed, place, tolerance)) hold(n, d, 0, -1);
    }
  }
  for (std::size_t t = 0; t < scene.prescribed_velocities.size(); ++t) {
    const PrescribedVelocity& given = scene.prescribed_velocities[t];
    for (const std::int32_t n : select_nodes(model.mesh, given.nodes)) {
      const auto table = static_cast<std::int32_t>(t);
      if (given.direction) {
        hold(n, *given.direction, dot(given.velocity, *given.direction), table);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        Point axis{};
        axis[k] = 1;
        hold(n, axis, given.velocity[k], table);
      }
    }
  }

  // Orthonormal per node, so that removing one direction leaves the others removed. Constraints come first, then what
  // is first in the file.
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
    if (h.table < 0) {
      model.constraints.push_back({h.node, {x, y, z}});
      continue;
    }
    // Of a whole velocity, what is left along d; of a speed along one direction, what gives it that component.
    const PrescribedVelocity& given = scene.prescribed_velocities[h.table];
    const double speed = given.direction ? h.speed / length : dot(given.velocity, d);
    model.prescribed.push_back({h.node, {x, y, z}, static_cast<S>(speed), h.table});
  }
}

template void add_constraints<double>(Model<double>&);
template void add_constraints<float>(Model<float>&);

}  // namespace pinball
