#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <kernels/boundary/rigid_wall.hpp>
#include <tests/support/solver_case.hpp>

/// Rigid walls and nodes that are held along some directions, or moved as given: the wall moves them along the others
/// alone, and what holds them takes up the rest.
namespace pinball::held_wall_test {
namespace {

using namespace test;

double dot_of(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Of a node that is held along one direction; slides: along that, too.
struct Rubbed {
  WallPlane<double> wall{};
  WallHold<double> hold{};
  double w[3];

  Rubbed(unsigned seed, double friction, bool slides) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto unit = [&](double* a) {
      for (int k = 0; k < 3; ++k) a[k] = number(random);
      const double size = std::sqrt(dot_of(a, a));
      for (int k = 0; k < 3; ++k) a[k] /= size;
    };
    unit(wall.normal);
    unit(hold.held[0]);
    wall.friction = friction;
    const double along = dot_of(wall.normal, hold.held[0]);
    for (int k = 0; k < 3; ++k) hold.free[k] = wall.normal[k] - along * hold.held[0][k];
    for (double& component : w) component = number(random);
    const double given = dot_of(w, hold.held[0]);
    for (int k = 0; k < 3; ++k) w[k] -= (slides ? 0 : given) * hold.held[0][k];
  }
  /// How it goes across the wall after the step.
  std::array<double, 3> slip(const WallRub<double>& rub, double mobility) const {
    double after[3], follows[3];
    across_held(hold, rub.drag, follows);
    const double along = dot_of(follows, hold.free) / dot_of(hold.free, hold.free);
    // What friction does along the free part of the normal the reaction has less, or more.
    for (int k = 0; k < 3; ++k) after[k] = w[k] + mobility * (follows[k] - along * hold.free[k]);
    const double out = dot_of(after, wall.normal);
    return {after[0] - out * wall.normal[0], after[1] - out * wall.normal[1], after[2] - out * wall.normal[2]};
  }
};

TEST(HeldWallNode, IsRubbedAgainstItsWayAsFarAsFrictionGoes) {
  constexpr double needed = 1.7, mobility = 0.3;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const Rubbed of(seed, 0.3, true);
    const WallRub<double> rub = wall_rub_of_held(of.wall, of.hold, needed, of.w, 1e-12, mobility);
    const double free = dot_of(of.hold.free, of.hold.free), size = std::sqrt(dot_of(rub.drag, rub.drag));
    ASSERT_NEAR(rub.reaction * free + dot_of(rub.drag, of.hold.free), needed, 1e-12) << "the gap closes";
    ASSERT_NEAR(dot_of(rub.drag, of.wall.normal), 0, 1e-12 * rub.reaction);
    const std::array<double, 3> slip = of.slip(rub, mobility);
    const double speed = std::sqrt(dot_of(slip.data(), slip.data()));
    ASSERT_NEAR(dot_of(rub.drag, slip.data()), -size * speed, 1e-8 * size) << "against the way";
    if (free > 0.2) {
      ASSERT_NEAR(size, 0.3 * rub.reaction, 1e-12 * size) << seed;
    } else {
      ASSERT_LE(size, 0.3 * rub.reaction * (1 + 1e-12)) << seed << ": less where it would hold itself";
    }
  }
}

TEST(HeldWallNode, IsStoppedWhereNothingMovesItAlongWhatHoldsIt) {
  constexpr double needed = 1.7;
  int stopped = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Rubbed of(seed, 0.3, false);
    // The way along the free part of the normal is that of the wall, here none.
    const double free = dot_of(of.hold.free, of.hold.free), along = dot_of(of.w, of.hold.free) / free;
    for (int k = 0; k < 3; ++k) of.w[k] -= along * of.hold.free[k];
    const double way = std::sqrt(dot_of(of.w, of.w));
    const WallRub<double> rub = wall_rub_of_held(of.wall, of.hold, needed, of.w, 1e-12, 1.0);
    const double size = std::sqrt(dot_of(rub.drag, rub.drag));
    ASSERT_NEAR(rub.reaction, needed / free, 1e-12 * rub.reaction);
    ASSERT_NEAR(size, std::min(way, 0.3 * rub.reaction), 1e-9);
    stopped += way < 0.3 * rub.reaction ? 1 : 0;
    of.wall.friction = std::numeric_limits<double>::infinity();
    const WallRub<double> stuck = wall_rub_of_held(of.wall, of.hold, needed, of.w, 1e-12, 1.0);
    ASSERT_NEAR(std::sqrt(dot_of(stuck.drag, stuck.drag)), way, 1e-12);
  }
  EXPECT_GT(stopped, 50);
  EXPECT_LT(stopped, 280);
}

constexpr double h = 0.1;

Scene cube() { return scene_of({block("a", {2, 2, 2}, h, {0, 0, 0})}, 2e-3, false); }

Scene cube_held_in_height() {
  Scene scene = cube();
  FixedConstraint held;
  held.name = "held";
  held.nodes.body = "a";
  held.directions = {{0, 0, 1}};
  scene.fixed_constraints = {held};
  return scene;
}

ForceResult force_of(const Solver<double>& solver, const std::string& name) {
  for (const ForceResult& force : solver.boundary().forces(solver.model())) {
    if (force.name == name) return force;
  }
  return {};
}

Point place_of(const Solver<double>& solver, std::size_t n) {
  const double* x = solver.model().nodes.position_of(solver.model().node_of_scene_node[n]);
  return {x[0], x[1], x[2]};
}

/// A cube that is drawn over a floor by all of its nodes: none may lag behind, and the hand feels the friction.
TEST(WallsOfHeldNodes, RubWhatDrawsThem) {
  for (const bool sliding : {true, false}) {
    Scene scene = cube();
    scene.bodies[0].velocity = {5, 0, 0};
    scene.gravities = {{{0, 0, -1e4}, {{0, 1e-3}, {0, 1}}, {}}};
    PrescribedVelocity hand;
    hand.name = "hand";
    hand.nodes.body = "a";
    hand.direction = Point{1, 0, 0};
    hand.velocity = {5, 0, 0};
    scene.prescribed_velocities = {hand};
    scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
    scene.rigid_walls[0].friction = 0.3;
    scene.rigid_walls[0].sliding = sliding;
    Solver<double> solver(scene);
    double impulse = 0;
    run_to_end(solver, [&] {
      const double floor = solver.boundary().walls()[0].force;
      if (sliding) {
        ASSERT_NEAR(force_of(solver, "hand").force[0], 0.3 * floor, 1e-5 * floor) << "sideways they hardly go";
      }
      impulse += floor * solver.dt();
    });
    EXPECT_GT(impulse, 0);
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n)
      EXPECT_NEAR(place_of(solver, n)[0] - solver.mesh().nodes[n][0], 5 * solver.time(), 1e-12);
    EXPECT_LT(std::abs(solver.balance_error()), 1e-6);
  }
}

/// A slope that moves under nodes that are held in height pushes them aside and rubs, and lifts none.
TEST(WallsOfHeldNodes, LeaveThemWhereTheyAreHeld) {
  for (const double friction : {0.0, 0.05, 0.2}) {
    Scene scene = cube_held_in_height();
    const double s = std::sqrt(0.5);
    scene.rigid_walls = {{"slope", {{-1e-6, 0, 0}, {s, 0, s}}, "", "here"}};
    scene.rigid_walls[0].friction = friction;
    scene.rigid_walls[0].speed = 20;
    Solver<double> solver(scene);
    double worst = 0;
    run_to_end(solver, [&] { worst = std::max(worst, std::abs(solver.balance_error())); });
    EXPECT_GT(solver.boundary().walls()[0].impulse, 0);
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n)
      EXPECT_EQ(place_of(solver, n)[2], solver.mesh().nodes[n][2]) << friction;
    EXPECT_LT(worst, 1e-3) << friction;
  }
}

/// 100 kN press a cube that is held in height onto a slope, which presses it upwards as hard: into what holds it.
TEST(WallsOfHeldNodes, AreFeltByWhatHoldsThem) {
  Scene scene = cube_held_in_height();
  scene.time.end = 3e-2;
  scene.damping.mass = 2000;
  const double s = std::sqrt(0.5);
  scene.rigid_walls = {{"slope", {{2 * h, 0, 0}, {-s, 0, s}}, "", "here"}};
  scene.rigid_walls[0].nodes.box = Box{{1.9 * h, -h, -0.1 * h}, {2.1 * h, 3 * h, 0.1 * h}};
  NodalLoad load;
  load.nodes.body = "a";
  load.force = {1e5, 0, 0};
  scene.loads = {load};
  Solver<double> solver(scene);
  run_to_end(solver, [] {});
  EXPECT_NEAR(solver.boundary().walls()[0].force, 1e5 / s, 1.0);
  EXPECT_NEAR(force_of(solver, "held").force[2], -1e5, 1.0);
}

}  // namespace
}  // namespace pinball::held_wall_test
