#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/step/marked_times.hpp>
#include <solver/step/step_clock.hpp>
#include <tests/support/solver_case.hpp>

/// What begins or ends at the time of a step does so there, whatever sums of steps are rounded by.
namespace pinball::marked_times_test {
namespace {

using namespace test;
using testing::ElementsAre;

TEST(MarkedTimes, AreThoseAtWhichAnythingBeginsOrEnds) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0})}, 1, false);
  EXPECT_THAT(marked_times(scene), ElementsAre());
  scene.fixed_constraints.emplace_back().when = {0.1, 0.2};
  scene.prescribed_velocities.emplace_back().when = {-1, 0.3};
  scene.rigid_motions.emplace_back().when.start = 0.4;
  scene.rigid_walls.emplace_back().when.start = 0.5;
  scene.pressures.emplace_back().start = 0.6;
  scene.contact_pairs.emplace_back().end = 0.7;
  scene.tied_contacts.emplace_back().start = 0.8;
  scene.materials[0].erosion.emplace().time = 0.9;
  EXPECT_THAT(marked_times(scene), ElementsAre(0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9));
}

/// Of steps of a tenth up to 1: how many tenths the time is to the last digit.
int exact_tenths(const std::vector<double>& marks) {
  TimeSettings settings;
  settings.end = 1;
  settings.cfl = 1;
  StepClock clock(settings);
  clock.mark(marks);
  int exact = 0;
  for (int step = 1; step < 10; ++step) {
    const Due due{0, clock.steps() == 0, false};
    StepBound bound{0.1, 0, false};
    bound.cycle_steps = 1;
    clock.choose(due, bound, 0);
    clock.advance(due);
    EXPECT_NEAR(clock.time(), 0.1 * step, 1e-12);
    exact += clock.time() == step / 10.0 ? 1 : 0;
  }
  return exact;
}

TEST(MarkedTimes, AreReachedToTheLastDigit) {
  EXPECT_EQ(exact_tenths({0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}), 9);
  EXPECT_LT(exact_tenths({}), 9) << "then this test finds nothing";
  EXPECT_EQ(exact_tenths({0.1 + 1e-6, 0.25, 0.35, 0.9 - 1e-6}), exact_tenths({})) << "none of them is a time of a step";
}

/// A constraint that is to begin at the time of any step, which hosts and people find by dividing.
TEST(MarkedTimes, LetAConstraintBeginAtTheTimeOfAnyStep) {
  Scene scene = scene_of({block("a", {1, 1, 3}, 0.1, {0, 0, 0})}, 1e-3, false);
  const auto run_of = [](const Scene& one, double start) {
    Solver<double> solver(one);
    bool found = false;
    while (!solver.at_end()) {
      solver.step();
      found = found || solver.time() == start;
    }
    return std::pair{solver.steps(), found};
  };
  const std::int64_t steps = run_of(scene, 0).first;
  ASSERT_GT(steps, 30);
  FixedConstraint& fixed = scene.fixed_constraints.emplace_back();
  fixed.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  fixed.directions = {{0, 0, 1}};
  for (std::int64_t step = 1; step < steps; ++step) {
    fixed.when.start = scene.time.end * static_cast<double>(step) / static_cast<double>(steps);
    EXPECT_TRUE(run_of(scene, fixed.when.start).second) << step;
  }
}

}  // namespace
}  // namespace pinball::marked_times_test
