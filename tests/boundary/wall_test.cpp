#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <solver/output/history.hpp>
#include <solver/step/report.hpp>
#include <tests/support/solver_case.hpp>

/// Rigid walls that move, end, or take some nodes alone.
namespace pinball::wall_test {
namespace {

using namespace test;

double total_mass(const Solver<double>& solver) {
  double mass = 0;
  for (const double m : solver.model().node_mass) mass += m;
  return mass;
}

/// A block that flies along -z at 10 m/s, close above z = 0.
Scene falling_block(double end = 3e-4) {
  Scene scene = scene_of({block("a", {2, 2, 4}, 0.1, {0, 0, 1e-5}, {0, 0, -10})}, end, false);
  RigidWall wall;
  wall.name = "wall";
  wall.plane = {{0, 0, 0}, {0, 0, 1}};
  wall.where = "here";
  scene.rigid_walls = {wall};
  return scene;
}

const WallResult& wall_of(const Solver<double>& solver) { return solver.boundary().walls().at(0); }

/// The force of each step, over the time in which it changes velocities, is the impulse, and that what the block has
/// got; a wall that stands has no velocity.
TEST(StandingWall, HasTheForceOfEachStep) {
  Solver<double> solver(falling_block());
  const double before = solver.momentum()[2];
  double sum = 0, largest = 0, dt_before = 0;
  while (!solver.at_end()) {
    EXPECT_EQ(wall_of(solver).velocity, 0);
    solver.step();
    sum += wall_of(solver).force * 0.5 * (dt_before + solver.dt());
    largest = std::max(largest, wall_of(solver).force);
    dt_before = solver.dt();
    EXPECT_NEAR(wall_of(solver).impulse, sum, 1e-12 * std::abs(before));
    EXPECT_NEAR(solver.momentum()[2] - before, sum, 1e-11 * std::abs(before));
  }
  EXPECT_GT(sum, std::abs(before)) << "it is thrown back";
  EXPECT_EQ(wall_of(solver).force_max, largest);
}

/// In the step in which they meet, the first row of nodes and the wall come to one velocity.
TEST(MovingWall, MeetsNodesAsInAPlasticImpact) {
  Scene scene = falling_block();
  scene.rigid_walls[0].mass = 50;
  Solver<double> solver(scene);
  double row = 0;
  for (std::size_t n = 0; n < 9; ++n) row += solver.model().node_mass[solver.model().node_of_scene_node[n]];
  const double whole = total_mass(solver);
  const double gap = 1e-5;
  while (wall_of(solver).impulse == 0 && !solver.at_end()) solver.step();
  // The step in which they meet: all end up at one place, after which the row would be behind.
  const double place = wall_of(solver).displacement;
  for (std::size_t n = 0; n < 9; ++n) EXPECT_NEAR(position_of(solver, n)[2], place, 1e-16);
  EXPECT_LT(place, gap);
  solver.step();  // now they move together, but for what the row behind them does within a step
  EXPECT_NEAR(wall_of(solver).velocity, velocity_of(solver, 0)[2], 1e-9);
  while (!solver.at_end()) {
    solver.step();
    const double momentum_of_all = solver.momentum()[2] + 50 * wall_of(solver).velocity;
    EXPECT_NEAR(momentum_of_all, -10 * whole, 1e-11 * 10 * whole);
    EXPECT_LT(std::abs(solver.balance_error()), 5e-2);
  }
  solver.finish();
  EXPECT_NEAR(solver.momentum()[2] + 50 * wall_of(solver).velocity, -10 * whole, 1e-11 * 10 * whole);
  EXPECT_LT(wall_of(solver).velocity, -10 * row / (50 + row)) << "pushed on";
  EXPECT_GT(wall_of(solver).displacement / scene.time.end, -20);
}

TEST(MovingWall, OfGreatMassIsAWallThatKeepsItsSpeed) {
  Scene heavy = falling_block(), given = heavy;
  heavy.rigid_walls[0].mass = 1e15;
  heavy.rigid_walls[0].speed = given.rigid_walls[0].speed = 3;
  Solver<double> a(heavy), b(given);
  run(a);
  run(b);
  EXPECT_NEAR(wall_of(a).displacement, 3 * heavy.time.end, 1e-12);
  EXPECT_NEAR(wall_of(b).displacement, 3 * heavy.time.end, 1e-12);
  EXPECT_NEAR(wall_of(a).impulse, wall_of(b).impulse, 1e-9 * wall_of(b).impulse);
  EXPECT_GT(wall_of(b).impulse, 12 * total_mass(b)) << "pushed off";
}

TEST(MovingWall, FollowsItsTable) {
  Scene scene = falling_block();
  scene.bodies[0].velocity = {};
  scene.rigid_walls[0].speed = 2;
  scene.rigid_walls[0].table = {{0, 1e-4, 2e-4}, {0, 1, 0}};
  Solver<double> solver(scene);
  while (!solver.at_end()) {
    solver.step();
    EXPECT_NEAR(wall_of(solver).displacement, 2 * scene.rigid_walls[0].table.integral(solver.time()), 1e-15);
    for (std::size_t n = 0; n < 9; ++n) EXPECT_GT(position_of(solver, n)[2], wall_of(solver).displacement - 1e-15);
  }
  EXPECT_GT(wall_of(solver).impulse, 0);
}

/// Of a wall that moves a row of the history had the place of one step later: nodes seemed to stand before it.
TEST(MovingWall, IsInTheRowsOfTheHistoryWhereItIsAtTheirTimes) {
  Scene scene = falling_block();
  scene.rigid_walls[0].speed = 3;
  scene.rigid_walls[0].when.end = 2e-4;
  Solver<double> solver(scene);
  const std::vector<std::string> names = history_column_names({"a"}, more_columns(solver));
  const auto column = static_cast<std::size_t>(std::ranges::find(names, "wall_displacement") - names.begin());
  ASSERT_LT(column, names.size());
  while (!solver.at_end()) {
    solver.step();
    const HistoryRow row = history_row(solver);
    EXPECT_NEAR(history_numbers(row)[column], row.time < 2e-4 ? 3 * row.time : wall_of(solver).displacement, 1e-15);
  }
  EXPECT_EQ(wall_of(solver).velocity, 0) << "it has ended";
}

TEST(MovingWall, PassesAStandingOneOnlyIfNothingHoldsIt) {
  Scene scene = falling_block();
  scene.rigid_walls[0].mass = 1e-6;  // as if there were none
  Solver<double> solver(scene);
  run(solver);
  EXPECT_NEAR(solver.momentum()[2], -10 * total_mass(solver), 1e-4 * total_mass(solver));
}

TEST(FiniteWall, StopsWhatIsAboveItsRectangle) {
  Scene scene = falling_block();
  scene.bodies.push_back(block("b", {2, 2, 4}, 0.1, {1, 0, 1e-5}, {0, 0, -10}));
  scene.rigid_walls[0].plane.point = {0.9, -0.1, 0};
  scene.rigid_walls[0].edge = Point{0, 1, 0};
  scene.rigid_walls[0].size = {0.5, 1};  // y from -0.1 to 0.4, and z x y = -x: x from -0.1 to 0.9
  Solver<double> solver(scene);
  run(solver);
  EXPECT_GT(history_row(solver).bodies[0].velocity[2], 0);
  EXPECT_NEAR(history_row(solver).bodies[1].velocity[2], -10, 1e-12);
}

TEST(FiniteWall, LeavesAloneWhatHasGonePast) {
  Scene scene = falling_block(1e-3);
  scene.bodies[0].velocity = {1000, 0, -10};
  scene.bodies[0].position = {-0.6, 0, 1e-3};
  scene.rigid_walls[0].edge = Point{1, 0, 0};  // gets beneath the block when that is below already
  scene.rigid_walls[0].plane.point = {0, -1, 0};
  scene.rigid_walls[0].size = {10, 10};
  Solver<double> solver(scene);
  run(solver);
  EXPECT_EQ(wall_of(solver).impulse, 0);
}

/// Rounding of places puts nodes behind a wall, which is not past it.
TEST(RigidWall, WithAnEndHoldsBodiesFarFromTheOriginInSinglePrecision) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {250, 175, 75 + 1e-4}, {0, 0, -10})}, 1e-3, false);
  const Point normal{0.3, -0.1, std::sqrt(0.9)};
  scene.rigid_walls = {{"floor", {{250, 175.3, 75}, normal}, "", "here"}};
  scene.rigid_walls[0].when.end = 1;
  scene.bodies[0].velocity = {-3, 1, -10 * normal[2]};
  scene.gravities = {{{-3e3, 1e3, -1e4 * normal[2]}, {}, {}}};
  scene.damping.mass = 4000;
  Solver<float> solver(scene);
  run(solver);
  for (std::int64_t n = 0; n < solver.model().nodes.count; ++n) {
    const float* x = solver.model().nodes.position_of(n);
    EXPECT_GT((x[0] - 250) * normal[0] + (x[1] - 175.3) * normal[1] + (x[2] - 75) * normal[2], -1e-3);
  }
}

TEST(RigidWall, ActsFromItsStartToItsEnd) {
  Scene late = falling_block();
  late.rigid_walls[0].when.start = 1e-4;
  Solver<double> passed(late);
  run(passed);
  EXPECT_EQ(wall_of(passed).impulse, 0) << "they are behind it then";

  Scene ended = falling_block();
  ended.bodies[0].velocity = {};
  ended.gravities = {{{0, 0, -1e5}, {}, {}}};
  ended.rigid_walls[0].when.end = 2e-4;
  Solver<double> solver(ended);
  while (solver.force_time() < 1.9e-4) solver.step();
  const double impulse = wall_of(solver).impulse;
  EXPECT_GT(impulse, 0);
  EXPECT_GT(position_of(solver, 0)[2], -1e-15);
  run(solver);
  EXPECT_LT(position_of(solver, 0)[2], -1e-5);
  EXPECT_EQ(wall_of(solver).force, 0);
}

TEST(RigidWall, WithoutSlidingHoldsNodesWhereTheyTouch) {
  Scene scene = falling_block(1e-4);
  scene.bodies[0].velocity = {30, 0, -10};
  scene.rigid_walls[0].sliding = false;
  Solver<double> solver(scene);
  while (wall_of(solver).impulse == 0) solver.step();
  const Point touched = position_of(solver, 4);
  solver.step();
  solver.step();
  EXPECT_NEAR(position_of(solver, 4)[0], touched[0], 1e-15);
  EXPECT_GT(position_of(solver, 40)[0], touched[0]);
}

/// Nodes that may not move along a direction are stopped along the wall's as far as that lets them, and stay with it,
/// whatever the angle between both.
TEST(RigidWall, LeavesNodesWithTheDirectionInWhichTheyAreHeld) {
  for (const double cosine : {0.1, 0.25, 0.7}) {
    Scene scene = falling_block(1e-4);
    const Point held{std::sqrt(1 - cosine * cosine), 0, cosine};
    for (std::size_t k = 0; k < 3; ++k) scene.bodies[0].velocity[k] = 10 * (cosine * held[k] - (k == 2 ? 1 : 0));
    FixedConstraint rail;
    rail.nodes.body = "a";
    rail.directions = {held};
    scene.fixed_constraints = {rail};
    Solver<double> solver(scene);
    run(solver);
    EXPECT_GT(wall_of(solver).force, 0) << cosine;
    for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
      EXPECT_NEAR(dot(velocity_of(solver, n), held), 0, 1e-9) << cosine;
      EXPECT_GT(position_of(solver, n)[2], -1e-9) << cosine;
    }
  }
}

TEST(RigidWall, TakesTheNodesOfASelectionAlone) {
  Scene scene = falling_block();
  scene.rigid_walls[0].nodes.box = Box{{0.05, 0.05, -1}, {0.15, 0.15, 1}};
  Solver<double> solver(scene);
  while (!solver.at_end()) solver.step();
  EXPECT_GT(position_of(solver, 4)[2], -1e-15) << "the middle of the face";
  EXPECT_LT(position_of(solver, 0)[2], -1e-5);
}

/// What text files of meshes leave of a plane: some nodes are a little behind it. That is no error, and no kick.
TEST(RigidWall, StandsBackForNodesThatRoundingHasPutBehind) {
  Scene scene = falling_block(1e-5);
  scene.bodies[0].velocity = {};
  scene.bodies[0].position = {0, 0, -5e-7};
  Solver<double> solver(scene);
  run(solver);
  EXPECT_EQ(wall_of(solver).impulse, 0);
  EXPECT_EQ(solver.energies().kinetic, 0);
  scene.bodies[0].position = {0, 0, -5e-3};
  EXPECT_NE(input_error_of(scene), no_error);
}

}  // namespace
}  // namespace pinball::wall_test
