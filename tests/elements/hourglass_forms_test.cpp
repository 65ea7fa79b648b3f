#include <gtest/gtest.h>

#include <cmath>

#include <tests/support/solver_case.hpp>

/// Each form of hourglass control, from the first step on, which has no length yet.
namespace pinball::hourglass_forms_test {
namespace {

using namespace test;

/// Largest error of the energy balance of an impact, over the energy that is there.
double balance_error(HourglassControl form, double cfl) {
  Scene scene = scene_of(
      {block("lower", {3, 3, 3}, 0.1, {0, 0, 0}), block("upper", {2, 2, 2}, 0.1, {0.03, 0.05, 0.301}, {0, 0, -20})},
      2e-4);
  scene.element.hourglass = form;
  scene.element.hourglass_coefficient = default_hourglass_coefficient(form);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.time.cfl = cfl;
  Solver<double> solver(scene);
  double worst = 0;
  while (!solver.at_end()) {
    solver.step();
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  EXPECT_GT(solver.energies().internal, 0);
  return worst;
}

TEST(HourglassForms, ThatStoreEnergyBalanceItInAnImpact) {
  for (const HourglassControl form : {HourglassControl::stiffness, HourglassControl::assumed_strain}) {
    EXPECT_LT(balance_error(form, 0.9), 1e-4);
  }
}

TEST(HourglassForms, ViscousForcesBalanceTheEnergyOfAnImpactAsStepsBecomeShort) {
  const double whole = balance_error(HourglassControl::viscous, 0.9);
  const double half = balance_error(HourglassControl::viscous, 0.45);
  const double quarter = balance_error(HourglassControl::viscous, 0.225);
  EXPECT_LT(whole, 0.015);  // their work lags by half a step, and they do not go into the stable step
  EXPECT_LT(half, 0.5 * whole);
  EXPECT_LT(quarter, 0.5 * half);
}

}  // namespace
}  // namespace pinball::hourglass_forms_test
