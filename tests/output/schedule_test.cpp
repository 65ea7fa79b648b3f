#include <gtest/gtest.h>

#include <limits>

#include <solver/output/recorder.hpp>

/// When output is due.
namespace pinball::schedule_test {
namespace {

/// How many of `steps` equal steps to time 1, and the start, have output.
int outputs(Schedule schedule, int steps) {
  int count = 0;
  for (int i = 0; i <= steps; ++i) {
    const double time = static_cast<double>(i) / steps;
    if (!schedule.due(time)) continue;
    ++count;
    schedule.passed(time);
  }
  return count;
}

TEST(Schedule, AnIntervalGivesAsManyAsFit) {
  EXPECT_EQ(outputs({0.1, {}}, 1000), 11);
  EXPECT_EQ(outputs({1.0, {}}, 1000), 2);
  EXPECT_EQ(outputs({0.0, {}}, 1000), 0);
  EXPECT_EQ(outputs({-0.0, {}}, 1000), 0);
  EXPECT_EQ(outputs({1e300, {}}, 1000), 1);
}

TEST(Schedule, AnIntervalShorterThanAStepMeansEveryStep) {
  for (const double interval : {1e-3, 1e-4, 1e-20, 1e-300, 1e-310, std::numeric_limits<double>::denorm_min()}) {
    EXPECT_EQ(outputs({interval, {}}, 1000), 1001) << interval;
  }
}

TEST(Schedule, TimesMayComeInAnyOrderTwiceAndAfterTheEnd) {
  EXPECT_EQ(outputs({0, {0.5, 0.25, 0.25, 7, 0.75}}, 1000), 3);
  EXPECT_EQ(outputs({0, {0.2501, 0.2502}}, 1000), 1);  // within one step
}

/// Sums of steps end beside time.end by round-off.
TEST(Schedule, TheEndIsReached) {
  Schedule schedule(0, {0.3});
  EXPECT_FALSE(schedule.due(0.2999));
  EXPECT_TRUE(schedule.due(0.3 - 1e-16));
  schedule.passed(0.3 - 1e-16);
  EXPECT_FALSE(schedule.due(0.3));
}

}  // namespace
}  // namespace pinball::schedule_test
