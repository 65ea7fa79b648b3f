#include "given_directions.hpp"

#include <fmt/format.h>

#include <cmath>

#include <solver/base/error.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

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

bool NodeDirections::add(const GivenDirection& given) {
  Point direction = given.direction;
  const double length = make_orthogonal(direction, basis_);
  if (length < 1e-6) return false;
  basis_.push_back(direction);
  double speed = 0;
  if (!given.held) {
    // Of a whole velocity, what is left along the direction; of a speed along one, what gives it that component.
    const PrescribedVelocity& motion = scene_->prescribed_velocities[given.table];
    if (motion.direction) require_across(given);
    speed = motion.direction ? given.speed / length : dot(motion.velocity, direction);
  }
  all_.push_back({direction, speed, &given});
  return true;
}

/// What a motion before it gives it already would have to be taken off its speed, at each time.
void NodeDirections::require_across(const GivenDirection& given) const {
  for (const Own& before : all_) {
    if (before.given->held || std::abs(dot(given.direction, before.direction)) < 1e-6) continue;
    throw InputError(fmt::format(
        "{}: expected a direction across that of {}, which moves some of its nodes, too; got ({:.6g}, {:.6g}, "
        "{:.6g}) and ({:.6g}, {:.6g}, {:.6g}): give both along one pair of axes",
        scene_->prescribed_velocities[given.table].nodes.where,
        scene_->prescribed_velocities[before.given->table].nodes.where, given.direction[0], given.direction[1],
        given.direction[2], before.direction[0], before.direction[1], before.direction[2]));
  }
}

void NodeDirections::clear() {
  basis_.clear();
  all_.clear();
}

std::vector<GivenDirection> given_directions(const Scene& scene, const ModelMesh& mesh) {
  const double tolerance = 1e-9 * mesh_size(mesh);
  std::vector<GivenDirection> directions;
  std::int32_t constraint = 0;
  const auto hold = [&](std::int32_t node, const Point& direction, const TimeSpan& when) {
    directions.push_back({node, direction, 0, constraint, true, when});
  };
  const auto move = [&](std::int32_t node, const Point& direction, double speed, std::int32_t table) {
    directions.push_back({node, direction, speed, table, false, scene.prescribed_velocities[table].when});
  };
  for (const PlaneConstraint& plane : scene.constraints) {
    const NodeSelection nodes = nodes_of(plane);  // none may lie on a plane, but a set is meant to have some
    for (const std::int32_t n : plane.set.empty() ? matching_nodes(mesh, nodes) : select_nodes(mesh, nodes))
      hold(n, plane.normal, {});
    ++constraint;
  }
  for (const FixedConstraint& fixed : scene.fixed_constraints) {
    for (const std::int32_t n : select_nodes(mesh, fixed.nodes)) {
      const Point& place = mesh.nodes[n];
      for (const Point& d : directions_at(fixed, place, tolerance)) hold(n, d, fixed.when);
    }
    ++constraint;
  }
  for (std::size_t t = 0; t < scene.prescribed_velocities.size(); ++t) {
    const PrescribedVelocity& given = scene.prescribed_velocities[t];
    for (const std::int32_t n : select_nodes(mesh, given.nodes)) {
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

}  // namespace pinball
