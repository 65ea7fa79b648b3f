#include <gtest/gtest.h>

#include <cmath>

#include <tests/support/solver_case.hpp>

/// Prescribed displacements and accelerations, forces on each node, gravity.
namespace pinball::motion_test {
namespace {

using namespace test;

Scene pulled_bar(MotionQuantity quantity, const TimeTable& table) {
  Scene scene = scene_of({block("a", {1, 1, 10}, 0.1, {0, 0, 0})}, 1e-3, false);
  PrescribedVelocity pull;
  pull.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  pull.velocity = {1, 0, -2};
  pull.table = table;
  pull.quantity = quantity;
  scene.prescribed_velocities = {pull};
  return scene;
}

/// Largest difference of the first node's way along x from what is expected of it.
template <class Expected>
double largest_error(const Scene& scene, const Expected& expected) {
  Solver<double> solver(scene);
  double worst = 0;
  while (solver.time() < scene.time.end * (1 - 1e-12)) {
    solver.step();
    worst = std::max(worst, std::abs(position_of(solver, 0)[0] - expected(solver.time())));
    worst = std::max(worst, std::abs(position_of(solver, 0)[2] + 2 * expected(solver.time())));
    EXPECT_LT(std::abs(solver.balance_error()), 2e-3);
  }
  return worst;
}

TEST(PrescribedDisplacement, IsThatOfTheTableAtAllTimes) {
  const TimeTable table{{0, 3.3e-4, 7e-4}, {0, 1e-4, -1e-4}};
  EXPECT_LT(largest_error(pulled_bar(MotionQuantity::displacement, table), [&](double t) { return table.value(t); }),
            1e-17);
}

TEST(PrescribedAcceleration, IsIntegratedTwice) {
  const TimeTable table{{0, 4e-4, 8e-4}, {0, 1e3, 0}};
  // By parts: a = 1e3 t/4e-4 up to 4e-4, and falls to 0 in as long.
  const auto expected = [](double t) {
    const double T = 4e-4, a = 1e3;
    if (t <= T) return a * t * t * t / (6 * T);
    const double s = std::min(t, 2 * T) - T;
    const double x = a * T * T / 6 + a * T / 2 * s + a * s * s / 2 - a * s * s * s / (6 * T);
    return x + a * T * std::max(0.0, t - 2 * T);
  };
  EXPECT_LT(largest_error(pulled_bar(MotionQuantity::acceleration, table), expected), 1e-16);
}

TEST(TimeTable, IntegratesTwice) {
  const TimeTable ramp{{0, 2}, {0, 4}};  // 2 t, and 4 from 2 on
  EXPECT_DOUBLE_EQ(ramp.second_integral(2), 8.0 / 3);
  EXPECT_DOUBLE_EQ(ramp.second_integral(3), 8.0 / 3 + 4 + 2);
  EXPECT_DOUBLE_EQ(TimeTable{}.second_integral(3), 4.5);
  EXPECT_DOUBLE_EQ((TimeTable{{-2, 2}, {0, 4}}).second_integral(1), 2.0 / 2 + 1.0 / 6);
}

TEST(Load, OnEachNodeIsTheWholeForce) {
  Scene scene = scene_of({block("a", {2, 2, 1}, 0.1, {0, 0, 0})}, 1e-4, false);
  NodalLoad load;
  load.nodes.plane = Plane{{0, 0, 0.1}, {0, 0, 1}};
  load.force = {0, 0, 1e3};
  load.each = true;
  scene.loads = {load};
  Solver<double> solver(scene);
  run(solver);
  EXPECT_NEAR(solver.momentum()[2], 9 * 1e3 * 1e-4, 1e-12);
}

TEST(Gravity, MovesBodiesAsTheyFallAndItsWorkIsTheirEnergy) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {3, 0, 0})}, 1e-3, false);
  scene.gravities = {{{0, 0, -9.81}, {}}, {{0, 4.0, 0}, {{0, 1e-3}, {0, 1}}}};
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const Point v = velocity_of(solver, n);
    EXPECT_NEAR(v[0], 3, 1e-12);
    EXPECT_NEAR(v[1], 4.0 * 1e-3 / 2, 1e-7) << "the trapezoidal rule of a line is exact but for the last step";
    EXPECT_NEAR(v[2], -9.81e-3, 1e-12);
  }
  EXPECT_NEAR(solver.energies().external, solver.energies().kinetic - solver.initial_energy(),
              1e-9 * solver.energies().kinetic);
}

/// Of all bodies or of some, along every axis and with the factor of its time: a free body has the integral of it all.
TEST(Gravity, ActsOnItsBodiesAloneAlongEveryAxisAsItsTableSays) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}), block("b", {2, 2, 2}, 0.1, {1, 0, 0})}, 1e-3, false);
  const Point of_all{7, -5, 3}, of_b{-11, 13, 17};
  scene.gravities = {{of_all, {{0, 1e-3}, {2, 2}}}, {of_b, {{0, 5e-4, 1e-3}, {0.5, 0.5, 0.5}}, {"b"}}};
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const bool second = solver.mesh().body_of_node[n] == 1;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(velocity_of(solver, n)[k], 1e-3 * (2 * of_all[k] + (second ? 0.5 * of_b[k] : 0.0)), 1e-12) << n;
    }
  }
  EXPECT_NEAR(solver.energies().external, solver.energies().kinetic, 1e-9 * solver.energies().kinetic);
}

TEST(Gravity, HasTheSameBitsWithTilesAtRestAndWithout) {
  Scene scene = scene_of({block("a", {4, 4, 4}, 0.1, {0, 0, 1e-6})}, 1e-3, false);
  scene.gravities = {{{0, 0, -9.81}, {}}};
  scene.rigid_walls = {{"wall", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  Solver<double> resting(scene);
  run(resting);
  scene.skip.resting = false;
  Solver<double> worked(scene);
  run(worked);
  EXPECT_EQ(state_hash(resting.model()), state_hash(worked.model()));
}

}  // namespace
}  // namespace pinball::motion_test
