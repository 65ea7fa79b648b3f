#pragma once

#include <utility>

#include "rigid_case.hpp"

/// Scenes with jointed rigid bodies.
namespace pinball::test {

inline Joint joint_of(JointKind kind, const std::string& first, const std::string& second, const Point& point,
                      std::optional<Point> axis = {}) {
  Joint joint;
  joint.kind = kind;
  joint.bodies = {first, second};
  joint.point = point;
  joint.axis = axis;
  return joint;
}

/// All bodies are rigid ones, under gravity along -z.
inline Scene mechanism(const std::vector<Body>& bodies, const std::vector<Joint>& joints, double end) {
  Scene scene = scene_of(bodies, end, false);
  for (const Body& body : bodies) scene.rigid_bodies.push_back(rigid(body.name));
  scene.gravities = {{.acceleration = {0, 0, -9.81}}};
  scene.joints = joints;
  return scene;
}

inline constexpr double gravity = 9.81;

/// A bar of length 1 along x that is hinged to the ground at its left end, about an axis along y through its middle.
inline const Point hinge{0, 0.05, 0.05};
inline Scene pendulum(double end, JointKind kind = JointKind::revolute) {
  const std::optional<Point> axis = kind == JointKind::spherical ? std::nullopt : std::optional<Point>({0, 1, 0});
  return mechanism({block("bar", {10, 1, 1}, 0.1, {0, 0, 0})}, {joint_of(kind, "bar", ground, hinge, axis)}, end);
}

inline double largest_opening(const Solver<double>& solver) {
  double largest = 0;
  for (const JointResult& joint : solver.rigid().joint_results()) largest = std::max(largest, joint.opening);
  return largest;
}

/// About a point, of all rigid bodies.
inline Point angular_momentum_about(const Point& point, const std::vector<RigidBodyResult>& bodies) {
  Point sum{};
  for (const RigidBodyResult& body : bodies) {
    const Point orbit = cross(minus(body.centre, point), body.velocity);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += body.mass * orbit[k] + body.angular_momentum[k];
  }
  return sum;
}

}  // namespace pinball::test
