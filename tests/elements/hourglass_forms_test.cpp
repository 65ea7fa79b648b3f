#include <gtest/gtest.h>

#include <cmath>

#include <tests/support/solver_case.hpp>

/// Each form of hourglass control, from the first step on, which has no length yet.
namespace pinball::hourglass_forms_test {
namespace {

using namespace test;

/// Largest error of the energy balance of an impact, over the energy that is there.
double balance_error(HourglassControl form) {
  Scene scene = scene_of(
      {block("lower", {3, 3, 3}, 0.1, {0, 0, 0}), block("upper", {2, 2, 2}, 0.1, {0.03, 0.05, 0.301}, {0, 0, -20})},
      2e-4);
  scene.element.hourglass = form;
  scene.element.hourglass_coefficient = default_hourglass_coefficient(form);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  Solver<double> solver(scene);
  double worst = 0;
  while (!solver.at_end()) {
    solver.step();
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  EXPECT_GT(solver.energies().internal, 0);
  return worst;
}

TEST(HourglassForms, BalanceTheEnergyOfAnImpact) {
  for (const HourglassControl form :
       {HourglassControl::viscous, HourglassControl::stiffness, HourglassControl::assumed_strain}) {
    EXPECT_LT(balance_error(form), 1e-4) << int(form);
  }
}

/// Modes that turn round from step to step: what a viscous force takes is not that of the velocity before it alone.
TEST(HourglassForms, BalanceTheEnergyOfModesThatAreNoise) {
  for (const std::array<int, 3>& elements : {std::array{8, 1, 1}, std::array{6, 6, 1}, std::array{4, 4, 4}}) {
    for (const HourglassControl form :
         {HourglassControl::viscous, HourglassControl::stiffness, HourglassControl::assumed_strain}) {
      Scene scene = scene_of({block("a", elements, 0.1, {0, 0, 0})}, 5e-4, false);
      scene.bodies[0].velocity_noise = 10;
      scene.element.hourglass = form;
      scene.element.hourglass_coefficient = default_hourglass_coefficient(form);
      Solver<double> solver(scene);
      EXPECT_LT(worst_balance_of_run(solver), 1e-3) << int(form);
    }
  }
}

TEST(HourglassForms, StoreWhatAnyOfTheBodiesNeeds) {
  const auto numbers = [](HourglassControl form) {
    Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1e-4, false);
    scene.element.hourglass = form;
    scene.element.hourglass_coefficient = default_hourglass_coefficient(form);
    Solver<double> solver(scene);
    solver.step();
    return solver.model().elements.hourglass_state.size() / solver.model().elements.slots;
  };
  EXPECT_EQ(numbers(HourglassControl::none), 0);
  EXPECT_EQ(numbers(HourglassControl::viscous), 12);
  EXPECT_EQ(numbers(HourglassControl::assumed_strain), 12);
}

}  // namespace
}  // namespace pinball::hourglass_forms_test
