#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rigid_case.hpp"

/// Contact of rigid bodies that turn: what sticks to them stays where it is, in all that contact is to keep.
namespace pinball::turning_contact_test {
namespace {

using namespace test;

constexpr double spin = 20, radius = 0.2;

/// A hundredth of steel's stiffness: steps a tenth as many.
Material soft() {
  Material material = elastic_material();
  material.bulk_modulus *= 0.01;
  material.shear_modulus *= 0.01;
  return material;
}

/// A vector turned about an axis at right angles to z, as Rodrigues has it.
Point turned(const Point& v, double angle) {
  const Point axis{0.6, -0.8, 0}, across = cross(axis, v);
  Point there;
  for (std::size_t k = 0; k < 3; ++k)
    there[k] = std::cos(angle) * v[k] + std::sin(angle) * across[k] + (1 - std::cos(angle)) * dot(axis, v) * axis[k];
  return there;
}

/// A block that deforms lies on a rigid plate that turns about z, at `radius` from the axis, and turns with it. The
/// weight comes slowly. All of it is turned by an angle.
Scene turntable(double end, double angle = 0) {
  const auto turn = [angle](const Point& v) { return turned(v, angle); };
  Scene scene = scene_of({block("plate", {6, 6, 1}, 0.1, turn({-0.3, -0.3, -0.1})),
                          block("block", {2, 2, 2}, 0.05, turn({radius - 0.05, -0.05, 0}))},
                         end);
  for (Body& body : scene.bodies) body.axis = turn({0, 0, 1});
  scene.materials = {soft()};
  scene.element.hourglass = HourglassControl::assumed_strain;
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.contact.friction = scene.contact.static_friction = 0.8;
  scene.rigid_bodies = {rigid("plate")};
  scene.rigid_bodies[0].held = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.rigid_bodies[0].held_rotations = {turn({1, 0, 0}), turn({0, 1, 0})};
  scene.rigid_bodies[0].angular_velocity = turn({0, 0, spin});
  InitialVelocity turning;
  turning.nodes.body = "block";
  turning.angular_velocity = turn({0, 0, spin});
  scene.initial_velocities = {turning};
  scene.gravities = {{.acceleration = turn({0, 0, -1000}), .table = {{0, 0.01, 1}, {0.4, 1, 1}}, .bodies = {"block"}}};
  return scene;
}

/// Mean of the places of a body's nodes.
Point middle(const Solver<double>& solver, std::int32_t body) {
  const Model<double>& model = solver.model();
  Point sum{};
  double count = 0;
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    if (model.mesh.body_of_node[n] != body) continue;
    const double* const x = model.nodes.position_of(model.node_of_scene_node[n]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += x[k];
    ++count;
  }
  for (double& x : sum) x /= count;
  return sum;
}

TEST(TurningContact, WhatSticksToATurningPlateStaysWhereItIs) {
  Solver<double> solver(turntable(0.2));  // four radians
  const double momentum = angular_momentum(solver)[2], at_start = middle(solver, 1)[2];
  run(solver);
  const Point at = middle(solver, 1), beside = angular_momentum(solver);
  EXPECT_GT(solver.steps(), 1000);
  EXPECT_NEAR(std::hypot(at[0], at[1]), radius, 1e-4 * radius);
  EXPECT_NEAR(at[2], at_start, 0.02 * at_start);
  EXPECT_NEAR(beside[2], momentum, 1e-9 * momentum);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-6);
}

/// A mobility that rounding puts below zero, where a body is held about axes that are not those of space, let contact
/// do nothing at all.
TEST(TurningContact, ActsHoweverTheAxesLie) {
  Solver<double> as_it_is(turntable(0.01));
  run(as_it_is);
  const Point expected = middle(as_it_is, 1);
  for (const double angle : {0.4, 0.9, 1.6, 2.2}) {
    Solver<double> solver(turntable(0.01, angle));
    run(solver);
    const Point at = turned(middle(solver, 1), -angle);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(at[k], expected[k], 1e-7) << angle;
  }
}

}  // namespace
}  // namespace pinball::turning_contact_test
