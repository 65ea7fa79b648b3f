#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <solver/scene_rules.hpp>

#include "joint_case.hpp"

/// Rigid bodies of nodes on one line, or of one node: nothing turns them about it.
namespace pinball::slender_rigid_test {
namespace {

using namespace test;

constexpr double h = 0.05;

/// Along the axis k, and along those behind it.
Point along(std::size_t k, double first, double second, double third) {
  Point p{};
  p[k] = first;
  p[(k + 1) % 3] = second;
  p[(k + 2) % 3] = third;
  return p;
}

/// A cube whose lowest edge along axis k is rigid, or its corner alone; it turns, and forces bend it.
Scene cube_with_edge(std::size_t k, bool edge = true) {
  Scene scene = scene_of({block("cube", {2, 2, 2}, h, {0.3, 0.3, 0.3})}, 5e-3, false);
  scene.materials = {elastic_material("steel", 0.3)};
  scene.bodies[0].angular_velocity = along(k, 20, 60, -40);
  scene.rigid_bodies = {RigidBody{.name = "edge"}};
  AttachedNodes nodes{"edge", {}};
  nodes.nodes.body = "cube";
  if (edge)
    nodes.nodes.line = Line{{0.3, 0.3, 0.3}, along(k, 1, 0, 0)};
  else
    nodes.nodes.nearest = Point{0.3, 0.3, 0.3};
  scene.attached_nodes = {nodes};
  NodalLoad low, high;
  low.nodes.nearest = Point{0.3, 0.3, 0.3};
  low.force = along(k, 3e4, 2e5, -1e5);
  high.nodes.nearest = Point{0.4, 0.4, 0.4};
  high.force = along(k, -1e5, 1e5, 3e5);
  scene.loads = {low, high};
  return scene;
}

TEST(SlenderRigid, AnEdgeTurnsTheSameAlongEachAxis) {
  std::vector<RigidBodyResult> found;
  for (const std::size_t k : {0U, 1U, 2U}) {
    Solver<double> solver(checked_scene(cube_with_edge(k)));
    EXPECT_NEAR(solver.rigid().results()[0].inertia[k][k], 0, 1e-15);
    run(solver);
    EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-3);
    found.push_back(solver.rigid().results()[0]);
    const FieldSnapshot now = snapshot(solver);
    const Point &begin = now.position[0], &end = now.position[std::array{2, 6, 18}[k]];
    EXPECT_NEAR(norm(minus(end, begin)), 2 * h, 1e-13);
    EXPECT_GT(std::abs(end[(k + 1) % 3] - begin[(k + 1) % 3]), 0.1 * h) << "which turns";
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(found[k].velocity[(k + i) % 3], found[0].velocity[i], 1e-9 * norm(found[0].velocity));
      EXPECT_NEAR(found[k].angular_velocity[(k + i) % 3], found[0].angular_velocity[i],
                  1e-9 * norm(found[0].angular_velocity));
    }
  }
}

TEST(SlenderRigid, OneNodeMovesAsWithout) {
  Scene plain = cube_with_edge(0, false);
  Solver<double> of_node(checked_scene(plain));
  plain.rigid_bodies.clear();
  plain.attached_nodes.clear();
  Solver<double> without(plain);
  run(of_node);
  run(without);
  const FieldSnapshot found = snapshot(of_node), expected = snapshot(without);
  for (std::size_t n = 0; n < expected.position.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found.position[n][k], expected.position[n][k], 1e-12) << n;
  }
}

/// A spin about the line moves no node of it, and one of the cube that is not about it turns the line with it.
TEST(SlenderRigid, HasNoSpinAboutItsLine) {
  Scene scene = cube_with_edge(2);
  scene.loads.clear();
  scene.bodies[0].angular_velocity = {10, 20, 30};
  Solver<double> of_cube(checked_scene(scene));
  const Point found = of_cube.rigid().results()[0].angular_velocity;
  EXPECT_NEAR(found[0], 10, 1e-10);
  EXPECT_NEAR(found[1], 20, 1e-10);
  EXPECT_NEAR(found[2], 0, 1e-10);
  scene.bodies[0].angular_velocity = {};
  scene.rigid_bodies[0].angular_velocity = {10, 20, 30};
  Solver<double> given(checked_scene(scene));
  EXPECT_NEAR(given.rigid().results()[0].angular_velocity[1], 20, 1e-10);
  EXPECT_NEAR(given.rigid().results()[0].angular_velocity[2], 0, 1e-10);
}

TEST(SlenderRigid, WhatActsByMomentsAboutTheLineIsRefused) {
  const auto refused = [](const Scene& scene) {
    return error_of([&] { const Solver<double> solver(checked_scene(scene)); });
  };
  const auto on_line = testing::HasSubstr("a rigid body whose nodes are on one line or in one point, edge");
  Scene held = cube_with_edge(0);
  held.rigid_bodies[0].held_rotations = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(refused(held), no_error);
  held.rigid_bodies[0].held_rotations.pop_back();
  EXPECT_THAT(refused(held), on_line);
  Scene turned = cube_with_edge(0);
  turned.rigid_motions = {{.rigid_body = "edge", .axis = Point{0, 1, 0}, .angular_speed = 5}};
  EXPECT_THAT(refused(turned), on_line);
  Scene joined = cube_with_edge(0);
  joined.joints = {joint_of(JointKind::spherical, "edge", ground, {0.3, 0.3, 0.3})};
  EXPECT_THAT(refused(joined), on_line);
}

}  // namespace
}  // namespace pinball::slender_rigid_test
