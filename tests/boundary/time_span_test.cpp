#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <tests/support/solver_case.hpp>

/// Constraints and prescribed motion that begin and end.
namespace pinball::time_span_test {
namespace {

using namespace test;

NodeSelection bottom() {
  NodeSelection nodes;
  nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  return nodes;
}

Scene flying_block() { return scene_of({block("a", {1, 1, 3}, 0.1, {0, 0, 0}, {0, 0, 5})}, 3e-4, false); }

TEST(FixedConstraint, HoldsFromItsStartToItsEnd) {
  Scene scene = flying_block();
  FixedConstraint fixed;
  fixed.nodes = bottom();
  fixed.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  fixed.when = {1e-4, 2e-4};
  scene.fixed_constraints = {fixed};
  Solver<double> solver(scene);
  while (!solver.at_end()) {
    const Point before = position_of(solver, 0);
    const double time = solver.time();
    solver.step();
    const bool held = time >= 1e-4 && time < 2e-4;
    EXPECT_EQ(position_of(solver, 0)[2] == before[2], held) << time;
  }
  EXPECT_LT(solver.energies().external, 0) << "what it takes to stop them";
  EXPECT_LT(solver.ledger().balance_error_max(), 0.02);
}

TEST(PrescribedVelocity, ActsFromItsStartToItsEndAndOthersMayFollow) {
  Scene scene = flying_block();
  PrescribedVelocity up, down;
  up.nodes = down.nodes = bottom();
  up.velocity = {0, 0, 8};
  up.when = {1e-4, 2e-4};
  down.velocity = {0, 0, -2};
  down.when.start = 2e-4;
  scene.prescribed_velocities = {up, down};
  Solver<double> solver(scene);
  while (!solver.at_end()) {
    const double time = solver.time();
    solver.step();
    const double v = velocity_of(solver, 0)[2];
    if (time < 1e-4) {
      EXPECT_EQ(v, 5);
    } else {
      EXPECT_NEAR(v, time < 2e-4 ? 8 : -2, 1e-12);
    }
  }
  solver.finish();
  EXPECT_GT(solver.energies().external, 0);
}

/// Of body a along x, as far as the time times 7.
PrescribedVelocity pull_of_seven() {
  PrescribedVelocity pull;
  pull.nodes.body = "a";
  pull.direction = Point{1, 0, 0};
  pull.velocity = {1, 0, 0};
  pull.quantity = MotionQuantity::displacement;
  pull.table = {{0, 1}, {0, 7}};
  return pull;
}

/// A way that grows from the first moment on: the nodes have its velocity in the first step, and its work is theirs.
TEST(PrescribedDisplacement, HasItsVelocityFromTheFirstStepOn) {
  Scene scene = flying_block();
  scene.bodies[0].velocity = {};
  const PrescribedVelocity pull = pull_of_seven();
  scene.prescribed_velocities = {pull};
  Solver<double> solver(scene);
  solver.step();
  EXPECT_NEAR(velocity_of(solver, 0)[0], 7, 1e-12);
  EXPECT_NEAR(position_of(solver, 0)[0], 7 * solver.time(), 1e-16);
  run(solver);
  double mass = 0;
  for (const double m : solver.model().node_mass) mass += m;
  EXPECT_NEAR(solver.energies().external, 0.5 * mass * 49, 1e-9 * mass * 49);
}

/// What its curve does between its start and its end is done in full, wherever between two steps these lie; so it goes
/// on where another one ends.
TEST(PrescribedDisplacement, GoesAllOfItsWayWhereverBetweenTwoStepsItBegins) {
  constexpr double begin = 1.037e-4, handed_over = 1.571e-4, end = 2.043e-4;
  const TimeTable table{{0, 1}, {0, 7}};
  const auto way_at = [](const Scene& scene, double time) {
    Solver<double> solver(scene);
    while (solver.time() < time) solver.step();
    return position_of(solver, 0)[0];
  };
  Scene nodes = flying_block();
  nodes.bodies[0].velocity = {};
  PrescribedVelocity pull = pull_of_seven();
  pull.when = {begin, end};
  nodes.prescribed_velocities = {pull};
  EXPECT_NEAR(way_at(nodes, end), 7 * (end - begin), 1e-15);
  nodes.prescribed_velocities = {pull, pull};
  nodes.prescribed_velocities[0].when.end = nodes.prescribed_velocities[1].when.start = handed_over;
  EXPECT_NEAR(way_at(nodes, end), 7 * (end - begin), 1e-15) << "by two, one after the other";

  Scene rigid = flying_block();
  rigid.bodies[0].velocity = {};
  RigidBody& body = rigid.rigid_bodies.emplace_back();
  body.name = "a";
  body.bodies = {"a"};
  RigidMotion& motion = rigid.rigid_motions.emplace_back();
  motion.rigid_body = "a";
  motion.direction = Point{1, 0, 0};
  motion.speed = 1;
  motion.quantity = MotionQuantity::displacement;
  motion.table = table;
  motion.when = {begin, end};
  EXPECT_NEAR(way_at(rigid, end), 7 * (end - begin), 1e-15) << "of a rigid body";
}

/// It is added to the velocity that is there: that of the start, whenever the acceleration begins and ends.
TEST(PrescribedAcceleration, ChangesTheVelocityThatNodesHave) {
  for (const TimeSpan when : {TimeSpan{}, TimeSpan{1e-4, 2e-4}}) {
    Scene scene = flying_block();
    scene.bodies[0].velocity = {3, 0, 5};
    PrescribedVelocity push;
    push.nodes.body = "a";
    push.direction = Point{1, 0, 0};
    push.velocity = {2e4, 0, 0};
    push.quantity = MotionQuantity::acceleration;
    push.when = when;
    scene.prescribed_velocities = {push};
    Solver<double> solver(scene);
    run(solver);
    const double span = when.always() ? 3e-4 : 1e-4, wanted = 3 + 2e4 * span;
    const double within = when.always() ? 1e-12 : 0.7;  // of two steps: none ends when it begins or ends
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
      EXPECT_NEAR(velocity_of(solver, n)[0], wanted, within) << n;
      EXPECT_EQ(velocity_of(solver, n)[2], 5) << n;
    }
  }
}

TEST(InitialVelocity, SpinsAboutAnAxisAndSetsSomeComponents) {
  Scene scene = flying_block();
  InitialVelocity spin, part;
  spin.nodes.body = part.nodes.body = "a";
  spin.velocity = {1, 0, 0};
  spin.angular_velocity = {0, 0, 100};
  spin.centre = {0.1, 0, 7};
  part.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  part.velocity = {9, 9, 9};
  part.components = {false, true, false};
  scene.initial_velocities = {spin, part};
  const Solver<double> solver(scene);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const Point& x = solver.mesh().nodes[n];
    const Point v = velocity_of(solver, n);
    EXPECT_DOUBLE_EQ(v[0], 1 - 100 * x[1]);
    EXPECT_DOUBLE_EQ(v[1], x[2] < 0.01 ? 9 : 100 * (x[0] - 0.1));
    EXPECT_EQ(v[2], 0);
  }
}

TEST(Gravity, OfSomeBodiesLeavesTheOthersAlone) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}), block("b", {2, 2, 2}, 0.1, {1, 0, 0})}, 1e-3, false);
  scene.gravities = {{{0, 0, -10}, {}, {"b"}}};
  Solver<double> solver(scene);
  const double worst = worst_balance_of_run(solver);
  EXPECT_EQ(history_row(solver).bodies[0].velocity[2], 0);
  EXPECT_NEAR(history_row(solver).bodies[1].velocity[2], -10e-3, 1e-12);
  EXPECT_NEAR(solver.energies().external, solver.energies().kinetic, 1e-9 * solver.energies().kinetic);
  EXPECT_LT(worst, 1e-9);
}

/// Impulses of contact see which nodes are held now: a plate that is released gives way.
TEST(TimeSpan, IsKnownToContact) {
  const auto way = [](double end, bool held) {
    Scene scene = scene_of(
        {block("a", {2, 2, 1}, 0.1, {0, 0, 0}, {0, 0, 0}), block("b", {2, 2, 1}, 0.1, {0, 0, 0.101}, {0, 0, -10})},
        4e-4);
    scene.contact.enforcement = Enforcement::lagrange;
    scene.contact.gap = ContactGap::face;
    FixedConstraint fixed;
    fixed.nodes.body = "a";
    fixed.directions = {{0, 0, 1}};
    fixed.when.end = end;
    if (held) scene.fixed_constraints = {fixed};
    Solver<double> solver(scene);
    run(solver);
    return std::pair{position_of(solver, 0)[2], history_row(solver).bodies[1].velocity[2]};
  };
  const auto free = way(1, false), released = way(5e-5, true), held = way(1, true);
  EXPECT_NEAR(released.first, free.first, 1e-3 * std::abs(free.first)) << "released before they meet";
  EXPECT_NEAR(released.second, free.second, 1e-3 * std::abs(free.second) + 1e-6);
  EXPECT_EQ(held.first, 0);
  EXPECT_GT(held.second, 2);
}

/// A wall that has not begun holds nothing of what touches something else beside it.
TEST(TimeSpan, OfAWallIsKnownToContact) {
  const auto velocities = [](double start) {
    Scene scene = scene_of(
        {block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {-3, 0, 0}), block("b", {2, 2, 2}, 0.1, {0, 0, 0.2}, {-6, 0, -10})},
        4e-4);
    scene.contact.enforcement = Enforcement::lagrange;
    scene.contact.gap = ContactGap::face;
    scene.contact.friction = 0.5;
    RigidWall& wall = scene.rigid_walls.emplace_back();
    wall.plane = {{0, 0, 0}, {1, 0, 0}};
    wall.when.start = start;
    if (start < 0) scene.rigid_walls.clear();
    Solver<double> solver(scene);
    run(solver);
    const auto& bodies = history_row(solver).bodies;
    return std::array{bodies[0].velocity, bodies[1].velocity};
  };
  const auto without = velocities(-1), to_come = velocities(1), there = velocities(0);
  for (std::size_t b = 0; b < 2; ++b) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(to_come[b][k], without[b][k], 1e-9) << b << ", " << k;
    EXPECT_LT(without[b][0], -3);
    EXPECT_GT(there[b][0], -1);
  }
}

}  // namespace
}  // namespace pinball::time_span_test
