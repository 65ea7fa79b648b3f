#include <gtest/gtest.h>

#include <cmath>

#include <solver/boundary/force_factor.hpp>
#include <tests/support/solver_case.hpp>

/// Forces whose tables change within a step: what they give is their impulse.
namespace pinball::force_factor_test {
namespace {

using namespace test;

/// A peak of 1 that is 2e-9 wide, far less than a step, at a time that is none of a step.
const TimeTable pulse = {{0, 5.01e-5, 5.0101e-5, 5.0102e-5, 1}, {0, 0, 1, 0, 0}};
constexpr double impulse_of_pulse = 1e-9;

TEST(ForceFactor, IsTheValueWhereTheTableIsStraight) {
  const TimeTable table = {{0, 1, 3}, {0, 4, 2}};
  EXPECT_EQ(force_factor(table, 0.5, {0.2, 0.3}), table.value(0.5));
  EXPECT_EQ(force_factor(table, 1, {0, 0}), 4);
  EXPECT_EQ(force_factor({}, 1, {0.2, 0.3}), 1);
  EXPECT_EQ(force_factor(table, 5, {0.2, 0.3}), 2);
}

TEST(ForceFactor, IsTheMeanOverTheStepWhereItIsNot) {
  const TimeTable table = {{0, 1, 3}, {0, 4, 2}};
  // from 0.9 to 1.1: 3.6, 4, 3.9
  EXPECT_NEAR(force_factor(table, 1, {0.2, 0.2}), (0.1 * 3.8 + 0.1 * 3.95) / 0.2, 1e-14);
  EXPECT_NEAR(force_factor(pulse, 5e-5, {1e-6, 1e-6}), impulse_of_pulse / 1e-6, 1e-12);
  EXPECT_NEAR(force_factor(pulse, 5.1e-5, {1e-6, 1e-6}), 0, 1e-14) << "that was in the step before";
}

TEST(ForceFactor, OfAForceThatBeginsWithinAStepIsThatOfItsPart) {
  EXPECT_EQ(force_factor({}, 0.7, 0.5, {0.2, 0.2}), 0);
  EXPECT_NEAR(force_factor({}, 0.55, 0.5, {0.2, 0.2}), 0.25, 1e-14);
  EXPECT_NEAR(force_factor({}, 0.45, 0.5, {0.2, 0.2}), 0.75, 1e-14);
  EXPECT_EQ(force_factor({}, 0.4, 0.5, {0.2, 0.2}), 1);
  EXPECT_EQ(force_factor({}, 0, 0, {0, 0.2}), 1) << "from the beginning";
}

TEST(ForceFactor, PulsesShorterThanAStepGiveTheirImpulse) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0})}, 1e-4, false);
  NodalLoad load;
  load.nodes.body = "a";
  load.force = {1e9, 0, 0};
  load.table = pulse;
  Pressure pressure;
  pressure.name = "p";
  pressure.faces.plane = Plane{{0, 0, 0}, {0, 1, 0}};
  pressure.pressure = 1e11;
  pressure.table = pulse;
  const double mass = 7850 * 1e-3;
  scene.loads = {load};
  scene.pressures = {pressure};
  scene.gravities = {{{0, 0, -1e9 / mass}, pulse, {}, ""}};
  Solver<double> solver(scene);
  run(solver);
  const Point momentum = solver.momentum();
  EXPECT_NEAR(momentum[0], 1, 1e-9);
  EXPECT_NEAR(momentum[1], 1, 1e-3) << "the face has been pressed on before";
  EXPECT_NEAR(momentum[2], -1, 1e-9);
}

}  // namespace
}  // namespace pinball::force_factor_test
