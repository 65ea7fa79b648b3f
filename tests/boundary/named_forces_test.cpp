#include <gtest/gtest.h>

#include <utility>

#include <solver/scene_rules.hpp>
#include <tests/elements/thin_section.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

/// Forces of constraints, prescribed velocities and accelerations by name.
namespace pinball::named_forces_test {
namespace {

using namespace test;

constexpr double g = 9.81;
constexpr double weight = 7850 * 0.2 * 0.2 * 0.4 * g;

/// A column of 2 x 2 x 4 elements that gravity pulls down.
Scene column(double end = 1e-4) {
  Scene scene = scene_of({block("a", {2, 2, 4}, 0.1, {0, 0, 0})}, end, false);
  scene.gravities = {{{0, 0, -g}, {}, {}, "weight"}};
  return scene;
}

FixedConstraint held(const std::string& name, const NodeSelection& nodes, const std::vector<Point>& directions) {
  FixedConstraint fixed;
  fixed.name = name;
  fixed.nodes = nodes;
  fixed.directions = directions;
  return fixed;
}

NodeSelection bottom() {
  NodeSelection nodes;
  nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  return nodes;
}

NodeSelection all_of(const std::string& body) {
  NodeSelection nodes;
  nodes.body = body;
  return nodes;
}

std::vector<ForceResult> forces_of(const Solver<double>& solver) { return solver.boundary().forces(solver.model()); }

void expect_force(const ForceResult& result, const std::string& name, const Point& force, double tolerance) {
  EXPECT_EQ(result.name, name);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(result.force[k], force[k], tolerance) << name << " " << k;
}

TEST(NamedForces, ABodyThatIsHeldAltogetherWeighsWhatItWeighs) {
  Scene scene = column();
  scene.fixed_constraints = {held("hand", all_of("a"), {{0, 0, 1}})};
  Solver<double> solver(scene);
  for (int step = 0; step < 5; ++step) {
    solver.step();
    const std::vector<ForceResult> forces = forces_of(solver);
    ASSERT_EQ(forces.size(), 2U);
    expect_force(forces[0], "hand", {0, 0, weight}, 1e-12 * weight);
    expect_force(forces[1], "weight", {0, 0, -weight}, 1e-12 * weight);
  }
}

/// At the start a floor carries the nodes that are on it, an eighth of the mass; from then on what does not go into
/// momentum.
TEST(NamedForces, WhatAFloorAndGravityDoIsTheChangeOfMomentum) {
  Scene scene = column(2e-3);
  scene.constraints = {{{0, 0, 0}, {0, 0, 1}, "", "", 0, "", "floor"}};
  Solver<double> solver(scene);
  solver.step();
  expect_force(forces_of(solver)[0], "floor", {0, 0, weight / 8}, 1e-12 * weight);
  Point before = solver.momentum();
  double largest = 0;
  while (!solver.at_end()) {
    solver.step();
    const double dt = 0.5 * (solver.clock().dt_before() + solver.dt());
    const Point after = solver.momentum();
    const std::vector<ForceResult> forces = forces_of(solver);
    EXPECT_NEAR(after[2] - before[2], dt * (forces[0].force[2] + forces[1].force[2]), 1e-12 * weight * dt);
    largest = std::max(largest, forces[0].force[2]);
    before = after;
  }
  EXPECT_GT(largest, 1.5 * weight) << "a column that is let go swings to twice its weight";
}

/// Large elements give the impulse of a cycle in one of its steps: in that the force is many times the mean.
TEST(NamedForces, OfConstraintsAreMeansOfTheStepsOfACycle) {
  for (const bool subcycling : {false, true}) {
    Scene scene = bar_with_thin_section(4e-3);
    scene.time.subcycling = subcycling;
    scene.bodies[0].velocity = {-5, 0, 0};
    scene.constraints = {{{0, 0, 0}, {1, 0, 0}, "", "", 0, "", "support"}};
    Solver<double> solver(scene);
    solver.step();
    const Point before = solver.momentum();
    double impulse = 0;
    std::int64_t steps = solver.steps(), longest_cycle = 0;
    while (!solver.at_end()) {
      solver.step();
      const std::int64_t cycle = solver.steps() - std::exchange(steps, solver.steps());
      impulse += static_cast<double>(cycle) * solver.dt() * forces_of(solver)[0].force[0];
      longest_cycle = std::max(longest_cycle, cycle);
    }
    EXPECT_EQ(longest_cycle > 1, subcycling);
    const double change = solver.momentum()[0] - before[0];
    EXPECT_NEAR(impulse, change, 0.01 * change) << subcycling;
  }
}

/// A pulse that is shorter than a step, before the last one of its cycle.
const TimeTable short_pulse{{0, 1e-3, 1.001e-3, 1.002e-3}, {0, 0, 1, 0}};

/// With subcycling, the momentum along x in the end is the integral of the force that is told where cycles end.
template <class ForceOf>
void expect_impulse_of_cycles(Scene scene, const ForceOf& force_of) {
  scene.time.subcycling = true;
  Solver<double> solver(scene);
  solver.step();
  double impulse = 0;
  std::int64_t steps = solver.steps(), longest_cycle = 0;
  while (!solver.at_end()) {
    solver.step();
    const std::int64_t cycle = solver.steps() - std::exchange(steps, solver.steps());
    impulse += static_cast<double>(cycle) * solver.dt() * force_of(solver)[0];
    longest_cycle = std::max(longest_cycle, cycle);
  }
  EXPECT_GT(longest_cycle, 1);
  EXPECT_GT(solver.momentum()[0], 0);
  EXPECT_NEAR(impulse, solver.momentum()[0], 1e-6 * solver.momentum()[0]);
}

TEST(NamedForces, OfGravityAreMeansOfTheStepsOfACycle) {
  for (const bool of_bodies : {false, true}) {
    SCOPED_TRACE(of_bodies);
    Scene scene = bar_with_thin_section(4e-3);
    Gravity pulse{.acceleration = {100, 0, 0}, .table = short_pulse, .name = "pulse"};
    if (of_bodies) pulse.bodies = {scene.bodies[0].name};
    scene.gravities = {pulse};
    expect_impulse_of_cycles(scene, [](const Solver<double>& solver) { return forces_of(solver)[0].force; });
  }
}

TEST(NamedForces, OfPressuresAreMeansOfTheStepsOfACycle) {
  Scene scene = bar_with_thin_section(4e-3);
  Pressure pulse;
  pulse.name = "pulse";
  pulse.pressure = 1e4;
  pulse.faces.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  pulse.table = short_pulse;
  scene.pressures = {pulse};
  expect_impulse_of_cycles(scene, [](const Solver<double>& solver) { return solver.boundary().pressures()[0].force; });
}

TEST(NamedForces, OfPrescribedMotionIsMassTimesAcceleration) {
  Scene scene = column();
  PrescribedVelocity motion;
  motion.name = "motion";
  motion.nodes = all_of("a");
  motion.velocity = {300, 0, -20};
  motion.quantity = MotionQuantity::acceleration;
  scene.prescribed_velocities = {motion};
  Solver<double> solver(scene);
  const double mass = weight / g;
  while (!solver.at_end()) {
    solver.step();
    expect_force(forces_of(solver)[0], "motion", {300 * mass, 0, (g - 20) * mass}, 1e-9 * 300 * mass);
  }
}

TEST(NamedForces, StoppingMovingNodesTakesTheirMomentum) {
  Scene scene = column();
  scene.gravities.clear();
  scene.bodies[0].velocity = {5, 0, 0};
  scene.fixed_constraints = {held("stop", all_of("a"), {{1, 0, 0}})};
  Solver<double> solver(scene);
  solver.step();
  const double impulse = forces_of(solver)[0].force[0] * 0.5 * solver.dt();
  EXPECT_NEAR(impulse, -5 * weight / g, 1e-12 * weight);
  solver.step();
  EXPECT_EQ(forces_of(solver)[0].force[0], 0);
}

/// What one table holds already is not the other's; a table without a name has no column.
TEST(NamedForces, ThoseOfOneNameAreOneSumAndChangeNothing) {
  Scene scene = column();
  scene.fixed_constraints = {held("all", bottom(), {{0, 0, 1}}), held("all", all_of("a"), {{0, 0, 1}}),
                             held("", all_of("a"), {{1, 0, 0}})};
  Solver<double> solver(scene);
  solver.step();
  ASSERT_EQ(forces_of(solver).size(), 2U);
  expect_force(forces_of(solver)[0], "all", {0, 0, weight}, 1e-12 * weight);
  Scene without = pressed_blocks(1e-4), with = without;
  with.constraints[0].name = "plane";
  with.prescribed_velocities[0].name = "push";
  Solver<double> a(without), b(with);
  run(a);
  run(b);
  EXPECT_EQ(state_hash(a.model()), state_hash(b.model()));
  EXPECT_EQ(more_columns(b).size(), more_columns(a).size() + 6);
}

TEST(NamedForces, GravityOfSomeBodiesPullsAtTheirMass) {
  Scene scene = scene_of({block("a", {2, 2, 4}, 0.1, {0, 0, 0}), block("b", {1, 1, 1}, 0.1, {1, 0, 0})}, 1e-4, false);
  scene.gravities = {{{0, 0, -g}, {{0, 1e-4}, {1, 3}}, {"a"}, "of_a"}};
  Solver<double> solver(scene);
  solver.step();
  expect_force(forces_of(solver)[0], "of_a", {0, 0, -weight}, 1e-12 * weight);
  run(solver);
  expect_force(forces_of(solver)[0], "of_a", {0, 0, -3 * weight}, 1e-9 * weight);
}

TEST(NamedForces, AreInTheRowsOfARunThatGoesOn) {
  Scene scene = pressed_blocks(2e-4);
  scene.constraints[0].name = "plane";
  scene.prescribed_velocities[0].name = "push";
  Solver<double> whole(scene), rest(scene);
  while (whole.time() < 1e-4) whole.step();
  const StateBytes state = test::saved(whole);
  test::load(rest, state);
  for (int step = 0; step < 3; ++step) {
    whole.step();
    rest.step();
    EXPECT_EQ(history_row(whole).more, history_row(rest).more);
  }
  EXPECT_GT(std::abs(forces_of(whole)[1].force[2]), 0);
}

TEST(NamedForces, NameThatGivesColumnsOfAnotherIsRefused) {
  Scene scene = column();
  scene.bodies.push_back(block("b", {1, 1, 1}, 0.1, {1, 0, 0}));
  const auto error = [&scene] { return error_of([&scene] { checked_scene(scene); }); };
  EXPECT_EQ(error(), "no error");
  scene.gravities[0].name = "b_contact";
  EXPECT_EQ(error(),
            "gravity.0.name: \"b_contact\" would give its columns of history.csv the names of those of a body");
  Pressure pressure;
  pressure.name = "air";
  pressure.faces = all_of("b");
  scene.pressures = {pressure};
  scene.gravities[0].name = "air";
  EXPECT_EQ(error(), "gravity.0.name: expected a name that no pressure and no contact pair has, got \"air\"");
}

}  // namespace
}  // namespace pinball::named_forces_test
