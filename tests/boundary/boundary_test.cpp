#include <gtest/gtest.h>

#include <cmath>

#include <solver/base/error.hpp>
#include <tests/support/solver_case.hpp>

/// What acts from outside: each condition holds exactly, and its work closes the energy balance.
namespace pinball::boundary_test {
namespace {

using namespace test;

NodeSelection on_plane(const Point& point, const Point& normal) {
  NodeSelection nodes;
  nodes.plane = Plane{point, normal};
  return nodes;
}

double total_mass(const Solver<double>& solver) {
  double mass = 0;
  for (const double m : solver.model().node_mass) mass += m;
  return mass;
}

TEST(RigidWall, TurnsABlockAroundAndGivesItsMomentum) {
  // A block of 10 elements onto a wall at z = 0, from a small distance; it has bounced when waves have crossed it
  // twice.
  const double h = 0.1, c = std::sqrt(2.1e11 / 7850);
  Scene scene = scene_of({block("a", {1, 1, 10}, h, {0, 0, 1e-3 * h}, {0, 0, -10})}, 1e-5 + 3.0 / c, false);
  scene.materials = {elastic_material("steel", 0.0)};
  scene.rigid_walls = {{"wall", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  Solver<double> solver(scene);
  double deepest = 0, worst = 0;
  bool touched = false;
  while (solver.time() < scene.time.end * (1 - 1e-12)) {
    solver.step();
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
      deepest = std::min(deepest, position_of(solver, n)[2]);
    }
    touched = touched || position_of(solver, 0)[2] < 1e-15;
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  solver.finish();
  EXPECT_TRUE(touched);
  EXPECT_GT(deepest, -1e-15);
  EXPECT_GT(position_of(solver, 0)[2], 1e-4) << "released";
  // What the wall gave is what the momentum has changed by.
  const WallResult& wall = solver.boundary().walls().at(0);
  EXPECT_NEAR(wall.impulse, solver.momentum()[2] + 10 * total_mass(solver), 1e-12 * wall.impulse);
  // Exact for a bar: the velocity is turned. Waves over 10 elements keep a part.
  EXPECT_NEAR(history_row(solver).bodies[0].velocity[2], 10, 0.7);
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(solver.energies().external, 0) << "the impact of the first row of nodes is plastic";
  EXPECT_GT(solver.energies().external, -0.08 * solver.initial_energy());
}

TEST(RigidWall, FromTheFirstStepOnAndAtAnAngle) {
  // The block lies on a wall that is at an angle to its velocity: no friction, so the component along it stays.
  const Point n{0.6, 0, 0.8};
  Body body = block("a", {2, 2, 3}, 0.1, {0, 0, 0}, {3, 4, -10});
  body.axis = n;
  Scene scene = scene_of({body}, 1e-4, false);
  scene.rigid_walls = {{"wall", {{0, 0, 0}, n}, "", "here"}};
  Solver<double> solver(scene);
  const Point before = solver.momentum();
  while (solver.time() < scene.time.end * (1 - 1e-12)) {
    solver.step();
    ASSERT_LT(std::abs(solver.balance_error()), 1e-4);
  }
  solver.finish();
  const Point after = solver.momentum();
  const double impulse = solver.boundary().walls()[0].impulse;
  EXPECT_GT(impulse, 0);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[k], before[k] + impulse * n[k], 1e-11 * impulse);
}

TEST(RigidWall, KeepsConstraintsAndHoldsBothOfTwoWalls) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {-5, 0, -5})}, 1e-4, false);
  scene.rigid_walls = {{"a", {{0, 0, 0}, {1, 0, 0}}, "", "here"}, {"b", {{0, 0, 0}, {0.6, 0, 0.8}}, "a", "here"}};
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}};
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const Point x = position_of(solver, n);
    EXPECT_GT(x[0], -1e-15);
    if (solver.mesh().nodes[n][0] == 0) {
      EXPECT_EQ(x[0], 0.0);
    }
    EXPECT_GT(0.6 * x[0] + 0.8 * x[2], -1e-15);
  }
}

/// A point of the plane that lies far away says the same as one beneath the body, also in single precision.
TEST(RigidWall, MayBeGivenByAPointFarAway) {
  const double slope = 0.5, size = std::hypot(1, slope);
  const auto impulse = [&](double away, auto precision) {
    Scene scene = scene_of({block("a", {4, 4, 4}, 0.25, {0, 0, 0}, {0, 0, -20})}, 1e-3, false);
    scene.rigid_walls = {{"wall", {{away, 0, -0.51 + slope * away}, {-slope / size, 0, 1 / size}}, "", "here"}};
    Solver<decltype(precision)> solver(scene);
    run(solver);
    return solver.boundary().walls().at(0).impulse;
  };
  const double near = impulse(0, 1.0);
  EXPECT_GT(near, 1000);
  for (const double away : {1e2, 1e4, 1e6}) {
    EXPECT_NEAR(impulse(away, 1.0), near, 1e-5 * near) << away;
    EXPECT_NEAR(impulse(away, 1.0F), near, 1e-3 * near) << away;
  }
}

TEST(RigidWall, NodesBehindItAreAnError) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, -0.01})}, 1e-4, false);
  scene.rigid_walls = {{"wall", {{0, 0, 0}, {0, 0, 1}}, "", "scene.toml:7:1: rigid_wall.wall"}};
  EXPECT_EQ(input_error_of(scene),
            "scene.toml:7:1: rigid_wall.wall: expected all nodes on the free side, a node of body a lies 0.01 "
            "behind the plane at the start");
}

TEST(PrescribedVelocity, IsFollowedAndItsWorkIsCounted) {
  // One end of a bar at rest is pulled with a velocity that rises and falls; the table has a kink inside a step.
  Scene scene = scene_of({block("a", {1, 1, 10}, 0.1, {0, 0, 0})}, 1e-3, false);
  PrescribedVelocity pull;
  pull.nodes = on_plane({0, 0, 0}, {0, 0, 1});
  pull.velocity = {1, 0, -2};
  pull.table = {{0, 3.3e-4, 7e-4}, {0, 1, -1}};
  scene.prescribed_velocities = {pull};
  Solver<double> solver(scene);
  double worst = 0;
  while (solver.time() < scene.time.end * (1 - 1e-12)) {
    solver.step();
    const double u = pull.table.integral(solver.time());
    const Point x = position_of(solver, 0);
    ASSERT_NEAR(x[0], u, 1e-15);
    ASSERT_NEAR(x[1], 0.0, 1e-18);
    ASSERT_NEAR(x[2], -2 * u, 1e-15);
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  solver.finish();
  EXPECT_NEAR(velocity_of(solver, 0)[2], 2.0, 1e-12);
  EXPECT_GT(solver.energies().kinetic, 0);
  EXPECT_LT(worst, 1e-3);
}

TEST(PrescribedVelocity, AlongOneDirectionLeavesTheOthersFree) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {0, 7, 0})}, 1e-4, false);
  PrescribedVelocity push;
  push.nodes.body = "a";
  push.direction = Point{0.6, 0, 0.8};
  push.velocity = {3, 0, 4};
  scene.prescribed_velocities = {push};
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const Point v = velocity_of(solver, n);
    EXPECT_NEAR(v[0], 3, 1e-9);
    EXPECT_NEAR(v[1], 7, 1e-9);
    EXPECT_NEAR(v[2], 4, 1e-9);
  }
  EXPECT_NEAR(solver.energies().external, 0.5 * total_mass(solver) * 25, 1e-9);
}

TEST(Load, GivesItsImpulseAndItsWork) {
  Scene scene = scene_of({block("a", {3, 2, 2}, 0.1, {0, 0, 0})}, 1e-3, false);
  NodalLoad load;
  load.nodes = on_plane({0.3, 0, 0}, {1, 0, 0});
  load.force = {1e4, -2e4, 0};
  load.table = {{0, 5e-4, 1e-3}, {0, 1, 0}};
  scene.loads = {load};
  Solver<double> solver(scene);
  const double worst = worst_balance_of_run(solver);
  // The trapezoidal rule misses the kink of the table by a step.
  EXPECT_NEAR(solver.momentum()[0], 1e4 * 5e-4, 1e-2);
  EXPECT_NEAR(solver.momentum()[1], -2e4 * 5e-4, 1e-2);
  EXPECT_LT(worst, 1e-3);
}

TEST(Load, IsSharedByMass) {
  // On a face of 2 x 2 elements the middle carries a quarter, edges an eighth, corners a sixteenth: uniform pressure.
  Scene scene = scene_of({block("a", {2, 2, 1}, 0.1, {0, 0, 0})}, 1e-5, false);
  NodalLoad load;
  load.nodes = on_plane({0, 0, 0.1}, {0, 0, 1});
  load.force = {0, 0, 1e4};
  scene.loads = {load};
  Solver<double> solver(scene);
  solver.step();
  for (std::size_t n = 9; n < 18; ++n) EXPECT_NEAR(velocity_of(solver, n)[2], velocity_of(solver, 9)[2], 1e-15);
  EXPECT_GT(velocity_of(solver, 9)[2], 0);
}

TEST(FixedConstraint, InACylindricalFrame) {
  // A block about the z axis: no circumferential motion, whatever turns it.
  Scene scene = scene_of({block("a", {4, 4, 2}, 0.1, {-0.2, -0.2, 0}, {1, 2, 3})}, 1e-4, false);
  scene.bodies[0].angular_velocity = {0, 0, 100};
  FixedConstraint fixed;
  fixed.nodes.body = "a";
  fixed.frame = Frame::cylindrical;
  fixed.axis = {{0, 0, 5}, {0, 0, 1}};
  fixed.directions = {{0, 1, 0}};
  scene.fixed_constraints = {fixed};
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const Point &x = solver.mesh().nodes[n], v = velocity_of(solver, n);
    EXPECT_NEAR(x[0] * v[1] - x[1] * v[0], 0, 1e-13);
    if (std::hypot(x[0], x[1]) < 1e-9) {
      EXPECT_EQ(std::hypot(v[0], v[1]), 0.0) << "on the axis";
    }
    EXPECT_NE(v[2], 0.0);
  }
}

/// Between the axes of the frame: of a turned direction the sign of each component shows.
TEST(FixedConstraint, HoldsObliqueDirectionsOfACylindricalFrame) {
  Scene scene = scene_of({block("a", {3, 3, 2}, 0.1, {-0.15, -0.15, 0}, {1, 2, 3})}, 3e-5, false);
  scene.bodies[0].angular_velocity = {0, 0, 100};
  FixedConstraint fixed;
  fixed.nodes.body = "a";
  fixed.frame = Frame::cylindrical;
  fixed.axis = {{0, 0, 5}, {0, 0, 1}};
  fixed.directions = {{0.48, 0.64, 0.6}};
  scene.fixed_constraints = {fixed};
  Solver<double> solver(scene);
  run(solver);
  double across = 0;
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const Point &x = solver.mesh().nodes[n], v = velocity_of(solver, n);
    const double r = std::hypot(x[0], x[1]);
    const double radial = (x[0] * v[0] + x[1] * v[1]) / r, circumferential = (x[0] * v[1] - x[1] * v[0]) / r;
    EXPECT_NEAR(0.48 * radial + 0.64 * circumferential + 0.6 * v[2], 0, 1e-12);
    across = std::max(across, std::abs(0.48 * radial - 0.64 * circumferential + 0.6 * v[2]));
  }
  EXPECT_GT(across, 0.1);
}

TEST(FixedConstraint, HoldsALineAndTheNearestNode) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {1, 2, 3})}, 1e-4, false);
  FixedConstraint line, point;
  line.nodes.line = Line{{0, 0, 7}, {0, 0, 1}};
  line.directions = {{1, 0, 0}, {0.6, 0.8, 0}};
  point.nodes.nearest = Point{0.19, 0.21, 0.2};
  point.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.fixed_constraints = {line, point};
  Solver<double> solver(scene);
  run(solver);
  int held = 0;
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const Point &start = solver.mesh().nodes[n], x = position_of(solver, n);
    if (start[0] == 0 && start[1] == 0) {
      EXPECT_EQ(x[0], start[0]);
      EXPECT_NEAR(x[1], start[1], 1e-18);
      EXPECT_NE(x[2], start[2]);
    }
    held += x == start;
  }
  EXPECT_EQ(held, 1);
}

TEST(InitialVelocity, ReplacesThatOfTheBody) {
  Scene scene = scene_of({block("a", {2, 1, 1}, 0.1, {0, 0, 0}, {1, 2, 3})}, 1e-4, false);
  InitialVelocity initial;
  initial.nodes.box = Box{{0.05, -1, -1}, {0.15, 1, 1}};
  initial.velocity = {-4, 0, 0};
  scene.initial_velocities = {initial};
  const Solver<double> solver(scene);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const bool middle = std::abs(solver.mesh().nodes[n][0] - 0.1) < 1e-12;
    EXPECT_EQ(velocity_of(solver, n), (middle ? Point{-4, 0, 0} : Point{1, 2, 3}));
  }
}

TEST(Damping, SlowsARigidBodyExponentially) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {10, 0, 0})}, 1e-3, false);
  scene.damping.mass = 1000;
  Solver<double> solver(scene);
  run(solver);
  EXPECT_NEAR(velocity_of(solver, 0)[0], 10 * std::exp(-1.0), 0.1);
  EXPECT_LT(std::abs(solver.balance_error()), 1e-12);
}

TEST(Probe, WatchesTheNearestNodeAndElement) {
  Scene scene =
      scene_of({block("a", {4, 1, 1}, 0.1, {0, 0, 0}, {1, 2, 3}), block("b", {1, 1, 1}, 0.1, {9, 0, 0})}, 1e-4, false);
  scene.materials = {plastic_material("steel", 1e8, 0)};
  Probe tip, element;
  tip.name = "tip";
  tip.point = {5, 0.02, 0.08};
  tip.body = "a";
  tip.quantities = probe_quantities(ProbeKind::node);
  element.name = "e";
  element.kind = ProbeKind::element;
  element.point = {0.29, 0, 0};
  element.quantities = probe_quantities(ProbeKind::element);
  scene.probes = {tip, element};
  scene.rigid_walls = {{"w", {{-1, 0, 0}, {1, 0, 0}}, "", "here"}};
  Solver<double> solver(scene);
  EXPECT_EQ(more_columns(solver),
            (std::vector<std::string>{"w_force", "w_impulse", "tip_position_x", "tip_position_y", "tip_position_z",
                                      "tip_displacement_x", "tip_displacement_y", "tip_displacement_z",
                                      "tip_velocity_x", "tip_velocity_y", "tip_velocity_z", "e_stress_xx",
                                      "e_stress_yy", "e_stress_zz", "e_stress_xy", "e_stress_yz", "e_stress_zx",
                                      "e_effective_stress", "e_plastic_strain"}));
  // A stress of its own for the third element.
  const std::int64_t slot = solver.model().slot_of_element[2];
  const double stress[6] = {3e6, 0, 0, 4e6, 0, 0};
  ElementStore& elements = solver.change_model().elements;
  for (int c = 0; c < 6; ++c) elements.stress[elements.at(slot, c, 6)] = stress[c];
  solver.step();
  solver.step();
  const HistoryRow row = history_row(solver);
  ASSERT_EQ(row.more.size(), more_columns(solver).size());
  EXPECT_NEAR(row.more[2], 0.4 + row.time, 1e-9) << "at the time of the row, one step behind the positions";
  EXPECT_DOUBLE_EQ(row.more[3], 2 * row.time);
  EXPECT_EQ(row.more[7], row.more[4] - 0.1);
  const auto s = stress_of(solver, 2);
  for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(row.more[11 + c], s[c]);
  const double direct = std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2);
  EXPECT_DOUBLE_EQ(row.more[17], std::sqrt(direct / 2 + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])));
  RunSummary summary;
  fill_summary(solver, summary);
  ASSERT_EQ(summary.probes.size(), 2u);
  EXPECT_EQ(summary.probes[0].body, "a");
  EXPECT_EQ(summary.probes[0].point, (Point{0.4, 0, 0.1}));
  EXPECT_EQ(summary.probes[1].number, 2);
  EXPECT_EQ(summary.probes[1].values[0].quantity, "stress_xx");
  EXPECT_EQ(summary.probes[1].values[0].value, row.more[11]);
}

TEST(PrescribedVelocity, PushesThroughContactByImpulses) {
  // A moved block pushes a free one: what contact takes from the moved nodes is part of the work from outside.
  for (const Enforcement enforcement : {Enforcement::projection, Enforcement::lagrange}) {
    Scene scene = scene_of({block("a", {2, 2, 4}, 0.1, {0, 0, 0}, {0, 0, 10}),
                            block("b", {2, 2, 4}, 0.1, {0, 0, 0.4 + 0.1 * touching_gap + 1e-4}, {0, 0, 0})},
                           1e-3);
    scene.contact.enforcement = enforcement;
    PrescribedVelocity push;
    push.nodes.body = "a";
    push.velocity = {0, 0, 10};
    scene.prescribed_velocities = {push};
    scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}};
    scene.time.cfl = 0.45;  // fast modes, which a change of the step changes the energy of, hardly arise
    Solver<double> solver(scene);
    const double worst = worst_balance_of_run(solver);
    EXPECT_NEAR(velocity_of(solver, 0)[2], 10, 1e-11);
    EXPECT_NEAR(position_of(solver, 0)[2], 10 * scene.time.end, 1e-14);
    // From a rigid body the free one bounces off with twice the velocity, less what its vibration keeps.
    EXPECT_GT(history_row(solver).bodies[1].velocity[2], 15);
    EXPECT_LT(history_row(solver).bodies[1].velocity[2], 20.5);
    EXPECT_GT(solver.energies().external, 0);
    EXPECT_LT(worst, 2e-5);
  }
}

TEST(NodeSelection, WithoutNodesIsAnErrorThatNamesIt) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0})}, 1e-4, false);
  NodalLoad load;
  load.nodes = on_plane({0.05, 0, 0}, {1, 0, 0});
  load.nodes.where = "scene.toml:7:1: load.0";
  load.nodes.body = "a";
  scene.loads = {load};
  EXPECT_EQ(input_error_of(scene),
            "scene.toml:7:1: load.0: expected at least one node, there is none on the plane through (0.05, 0, 0) "
            "with normal (1, 0, 0), of body a");
}

TEST(TimeTable, IsLinearBetweenItsTimesAndConstantOutside) {
  const TimeTable table{{1, 2, 4}, {3, 5, 1}};
  EXPECT_EQ(table.value(0), 3);
  EXPECT_EQ(table.value(1), 3);
  EXPECT_EQ(table.value(1.5), 4);
  EXPECT_EQ(table.value(3), 3);
  EXPECT_EQ(table.value(5), 1);
  EXPECT_EQ(table.integral(0), 0);
  EXPECT_EQ(table.integral(1), 3);
  EXPECT_DOUBLE_EQ(table.integral(1.5), 3 + 1.75);
  EXPECT_DOUBLE_EQ(table.integral(4), 3 + 4 + 6);
  EXPECT_DOUBLE_EQ(table.integral(5), 14);
  const TimeTable none;
  EXPECT_EQ(none.value(7), 1);
  EXPECT_EQ(none.integral(7), 7);
  // A table that begins before time 0 counts from 0.
  EXPECT_DOUBLE_EQ((TimeTable{{-2, 2}, {0, 4}}).integral(2), 6);
}

}  // namespace
}  // namespace pinball::boundary_test
