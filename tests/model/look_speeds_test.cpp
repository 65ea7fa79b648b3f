#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

/// Turned about x, as `axis` turns bodies.
class Turned {
 public:
  explicit Turned(double angle) : cosine_(std::cos(angle)), sine_(std::sin(angle)) {}
  Point of(const Point& x) const { return {x[0], cosine_ * x[1] - sine_ * x[2], sine_ * x[1] + cosine_ * x[2]}; }
  std::array<Point, 3> of_rows(const std::array<Point, 3>& rows) const {  // R A R^T
    std::array<Point, 3> right;
    for (std::size_t i = 0; i < 3; ++i) right[i] = of(rows[i]);
    std::array<Point, 3> all;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point column = of({right[0][k], right[1][k], right[2][k]});
      for (std::size_t i = 0; i < 3; ++i) all[i][k] = column[i];
    }
    return all;
  }

 private:
  double cosine_, sine_;
};

Scene turned_impact(double angle, bool stretched, bool pushed) {
  const Turned turned(angle);
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}),
                          block("b", {3, 3, 3}, 0.1, turned.of({0.05, 0.03, 0.32}), turned.of({0, -60, -100}))},
                         1e-3);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  for (Body& body : scene.bodies) body.axis = turned.of({0, 0, 1});
  if (stretched) scene.bodies[1].velocity_gradient = turned.of_rows({{{0, 300, 0}, {100, 200, 0}, {0, 0, 250}}});
  if (pushed) {
    PrescribedVelocity& top = scene.prescribed_velocities.emplace_back();
    top.nodes.body = "b";
    top.nodes.plane = Plane{turned.of({0.05, 0.03, 0.62}), turned.of({0, 0, 1})};
    top.direction = turned.of({0, 0, 1});
    top.velocity = turned.of({0, 0, -200});
  }
  return scene;
}

TEST(LookAtSpeeds, OfTwoBodiesTurnWithTheScene) {
  for (const bool stretched : {false, true}) {
    for (const bool pushed : {false, true}) {
      const double expected = look(turned_impact(0, stretched, pushed)).closing_speed;
      EXPECT_GT(expected, pushed ? 208.8 : 116.6);
      EXPECT_LT(expected, (pushed ? 208.9 : 116.7) + (stretched ? 150 : 0));
      for (const double angle : {0.3, 0.5, 0.25 * M_PI, 1.2}) {
        EXPECT_NEAR(look(turned_impact(angle, stretched, pushed)).closing_speed, expected, 1e-9 * expected)
            << angle << stretched << pushed;
      }
    }
  }
}

/// What gains speed until it meets the other: boxes of bodies that lie askew meet earlier.
TEST(LookAtSpeeds, OfWhatIsAcceleratedTurnWithTheScene) {
  for (const bool by_weight : {true, false}) {
    const auto closing_speed = [&](double angle) {
      const Turned turned(angle);
      Scene scene = turned_impact(angle, false, false);
      scene.bodies[1].velocity = {};
      if (by_weight) {
        scene.gravities = {{turned.of({0, 0, -4e5}), {}, {"b"}}};
      } else {
        Pressure& pressure = scene.pressures.emplace_back();
        pressure.faces.body = "b";
        pressure.faces.plane = Plane{turned.of({0.05, 0.03, 0.62}), turned.of({0, 0, 1})};
        pressure.pressure = 1e9;
      }
      return look(scene).closing_speed;
    };
    const double expected = closing_speed(0), fallen = std::sqrt(2 * (by_weight ? 4e5 : 1e9 / (0.3 * 7850)) * 0.02);
    EXPECT_NEAR(expected, fallen, 0.1 * fallen) << "through the gap, and at most one time further";
    for (const double angle : {0.3, 0.5, 0.25 * M_PI, 1.2})
      EXPECT_NEAR(closing_speed(angle), expected, 1e-9 * expected) << angle << by_weight;
  }
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
