#include <gtest/gtest.h>

#include <solver/step/step_clock.hpp>

/// How long steps are, from what is stable and from what velocities do.
namespace pinball::step_clock_test {
namespace {

/// Steps of 1 until so much of the energy in motion has changed, and the next one where 1.2 is stable.
double step_after(double change, double in_motion, int quiet_steps = 0) {
  TimeSettings settings;
  settings.end = 1e9;
  settings.cfl = 1;
  StepClock clock(settings);
  const auto step = [&](double stable, double changed, double energy) {
    const Due due{0, clock.steps() == 0, false};
    StepBound bound{stable, 0, false};
    bound.cycle_steps = 1;
    clock.choose(due, bound, 0);
    clock.take_change(changed, energy);
    clock.advance(due);
  };
  step(1, 0, 1);
  step(1, change, in_motion);
  for (int n = 0; n < quiet_steps; ++n) step(1, 0, 1);
  step(1.2, 0, 1);
  return clock.dt();
}

/// A step r times as long takes (r^2 - 1)/4 of the energy that has changed, and a thousandth of what is in motion is
/// harmless: for 1.2 a share of 1/110. A share is kept for a while, less a sixteenth of it in each step.
TEST(StepClock, RaisesAStepWhereThatTakesNoEnergy) {
  EXPECT_NEAR(step_after(0, 1), 1.2, 1e-6);
  EXPECT_NEAR(step_after(0, 0), 1.2, 1e-6);
  EXPECT_NEAR(step_after(0.9 / 110, 1), 1.2, 1e-6);
  EXPECT_NEAR(step_after(1.8 / 110, 2), 1.2, 1e-6);
  EXPECT_NEAR(step_after(1.1 / 110, 1), 1, 1e-6);
  EXPECT_NEAR(step_after(1e-9, 0), 1, 1e-6) << "nothing was in motion";
  EXPECT_NEAR(step_after(7, 1), 1, 1e-6);
  // (15/16)^n of a share of 1 is below 1/110 from the 73rd step on.
  EXPECT_NEAR(step_after(7, 1, 71), 1, 1e-6);
  EXPECT_NEAR(step_after(7, 1, 73), 1.2, 1e-6);
}

}  // namespace
}  // namespace pinball::step_clock_test
