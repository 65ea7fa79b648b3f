#include <gtest/gtest.h>

#include <cmath>

#include <tests/support/solver_case.hpp>

/// Each form of hourglass control, from the first step on, which has no length yet.
namespace pinball {
namespace {

using namespace test;

class HourglassForms : public testing::TestWithParam<HourglassControl> {};
INSTANTIATE_TEST_SUITE_P(All, HourglassForms,
                         testing::Values(HourglassControl::viscous, HourglassControl::stiffness,
                                         HourglassControl::assumed_strain));

TEST_P(HourglassForms, BalanceTheEnergyOfAnImpact) {
  Scene scene = scene_of(
      {block("lower", {3, 3, 3}, 0.1, {0, 0, 0}), block("upper", {2, 2, 2}, 0.1, {0.03, 0.05, 0.301}, {0, 0, -20})},
      2e-4);
  scene.element.hourglass = GetParam();
  scene.element.hourglass_coefficient = default_hourglass_coefficient(GetParam());
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  Solver<double> solver(scene);
  double worst = 0;
  while (!solver.at_end()) {
    solver.step();
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  EXPECT_LT(worst, 0.03);  // the viscous form does not go into the stable step: 1 %
  EXPECT_GT(solver.energies().internal, 0);
}

}  // namespace
}  // namespace pinball
