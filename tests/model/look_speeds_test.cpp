#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <solver/model/model.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/solver_case.hpp>

/// The speeds of impacts that are expected, from which the first steps follow.
namespace pinball::look_speeds_test {
namespace {

using namespace test;

Look look(Scene scene) {
  complete_scene(scene);
  const ModelMesh mesh = build_mesh(scene);
  return look_at(scene, mesh);
}

/// A noise of 2 is one along each axis.
TEST(LookAtSpeeds, OfABodyAtAWallHaveItsNoise) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 1, {0, 0, 4}, {0, 0, -10})}, 1);
  scene.rigid_walls.emplace_back().plane = {{0, 0, 0}, {0, 0, 1}};
  EXPECT_DOUBLE_EQ(look(scene).closing_speed, 10);
  EXPECT_DOUBLE_EQ(look(scene).impact_speed, 10);
  scene.bodies[0].velocity_noise = 2;
  EXPECT_DOUBLE_EQ(look(scene).closing_speed, 10 + 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(look(scene).impact_speed, 10 + 2 * std::sqrt(3.0));
  scene.bodies[0].position = {0, 0, 40};
  EXPECT_EQ(look(scene).closing_speed, 0) << "it does not come to it in time";
}

/// Of two free bodies each takes half of the speed at which they meet, one that is held the other one's.
TEST(LookAtSpeeds, OfTwoBodiesAreThoseOfTheirImpact) {
  Scene scene =
      scene_of({block("a", {3, 3, 3}, 1, {0, 0, 0}, {0, 0, 6}), block("b", {3, 3, 3}, 1, {0, 0, 4}, {0, 0, -4})}, 1);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  EXPECT_DOUBLE_EQ(look(scene).closing_speed, 10);
  EXPECT_DOUBLE_EQ(look(scene).impact_speed, 5);
  scene.fixed_constraints = {{{.body = "b"}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  scene.bodies[1].velocity = {};
  EXPECT_DOUBLE_EQ(look(scene).closing_speed, 6);
  EXPECT_DOUBLE_EQ(look(scene).impact_speed, 6);
}

/// A block that lies askew above a wall: its box reaches further than its nodes.
TEST(LookAtSpeeds, AtAWallAreOfWhatReachesItsNodes) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 1, {0, 0, 4}, {-6, 0, -8})}, 0.3);
  scene.bodies[0].axis = Point{0.6, 0, 0.8};
  const ModelMesh mesh = build_mesh(scene);
  double lowest = 1e9;
  for (const Point& x : mesh.nodes) lowest = std::min(lowest, 0.6 * x[0] + 0.8 * x[2]);
  for (const double beyond : {-0.01, 0.01}) {  // of the way of 10 x 0.3
    const double at = lowest - 3 - beyond;
    scene.rigid_walls.clear();
    scene.rigid_walls.emplace_back().plane = {{0.6 * at, 0, 0.8 * at}, {0.6, 0, 0.8}};
    EXPECT_DOUBLE_EQ(look(scene).closing_speed, beyond < 0 ? 10 : 0);
  }
}

}  // namespace
}  // namespace pinball::look_speeds_test
