#include "momentum_error.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <solver/base/point.hpp>

namespace pinball {

namespace {

/// An orthonormal basis of the directions in which something acts from outside.
std::vector<Point> directions_acted_on(const Scene& scene) {
  std::vector<Point> basis;
  const auto add = [&basis](Point direction) {
    const double before = std::sqrt(dot(direction, direction));
    if (make_orthogonal(direction, basis) > 1e-6 * before) basis.push_back(direction);
  };
  const auto add_all = [&add] {
    for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}) add(axis);
  };
  for (const PlaneConstraint& plane : scene.constraints) add(plane.normal);
  for (const RigidWall& wall : scene.rigid_walls) {
    add(wall.plane.normal);
    if (wall.friction > 0 || !wall.sliding) add_all();
  }
  for (const NodalLoad& load : scene.loads) add(load.force);
  if (!scene.pressures.empty()) add_all();
  for (const Gravity& gravity : scene.gravities) add(gravity.acceleration);
  for (const FixedConstraint& fixed : scene.fixed_constraints) {
    if (fixed.frame == Frame::cylindrical) add_all();  // they turn with the place
    for (const Point& direction : fixed.directions) add(direction);
  }
  for (const PrescribedVelocity& given : scene.prescribed_velocities) {
    if (given.direction) add(*given.direction);
    if (!given.direction) add_all();
  }
  struct Coefficients {
    Point sum{};  ///< along which momentum goes outside
    double size = 0;
  };
  std::map<std::string, Coefficients> equations;
  for (const EquationTerm& term : scene.equation_terms) {
    Coefficients& of_name = equations[term.name];
    for (std::size_t k = 0; k < 3; ++k) of_name.sum[k] += term.factor * term.direction[k];
    of_name.size += std::abs(term.factor);
  }
  for (const auto& [name, of_name] : equations) {
    if (norm(of_name.sum) > 1e-9 * of_name.size) add(of_name.sum);
  }
  for (const RigidBody& rigid : scene.rigid_bodies) {
    for (const Point& direction : rigid.held) add(direction);
  }
  for (const RigidMotion& given : scene.rigid_motions) {
    if (given.direction) add(*given.direction);
  }
  for (const Joint& joint : scene.joints) {
    if (std::ranges::find(joint.bodies, ground) != joint.bodies.end()) add_all();
  }
  if (scene.damping.mass > 0) add_all();
  return basis;
}

}  // namespace

double initial_mass(const RunSummary& summary) {
  double mass = summary.point_mass;
  for (const BodyResult& body : summary.bodies) mass += body.mass_initial;
  return mass;
}

std::optional<double> momentum_error(const Scene& scene, const RunSummary& summary) {
  const std::vector<Point> acted_on = directions_acted_on(scene);
  const double largest = std::sqrt(2 * initial_mass(summary) * summary.initial_total);
  if (acted_on.size() == 3 || !(largest > 0)) return std::nullopt;
  Point change = minus(summary.momentum_final, summary.momentum_initial);
  return make_orthogonal(change, acted_on) / largest;
}

}  // namespace pinball
