#include <gtest/gtest.h>

#include <cmath>

#include <solver/program/study/time_curve.hpp>

namespace pinball::time_curve_test {
namespace {

TEST(TimeCurve, DistanceIsTheRootOfTheMeanSquare) {
  const TimeCurve ramp{{0, 1, 3}, {0, 1, 3}}, zero{{0, 3}, {0, 0}};
  EXPECT_DOUBLE_EQ(distance(ramp, zero), std::sqrt(3));  // (1/3) * integral of t^2 over 0 to 3
  EXPECT_DOUBLE_EQ(norm(ramp), std::sqrt(3));
  EXPECT_EQ(distance(ramp, ramp), 0);
}

TEST(TimeCurve, RowsAtOtherTimesAreTheSameCurve) {
  const TimeCurve coarse{{0, 2, 4}, {0, 4, 0}}, fine{{0, 0.5, 1.9, 2, 3.3, 4}, {0, 1, 3.8, 4, 1.4, 0}};
  EXPECT_NEAR(distance(coarse, fine), 0, 1e-15);
  EXPECT_NEAR(distance(fine, coarse), 0, 1e-15);
}

TEST(TimeCurve, OnlyTheRangeOfBothCounts) {
  const TimeCurve a{{0, 1, 2}, {1, 1, 1}}, longer{{0, 1, 2, 3}, {0, 0, 0, 100}};
  EXPECT_DOUBLE_EQ(distance(a, longer), 1);
  EXPECT_EQ(distance(a, {}), 0);
  EXPECT_EQ(distance(a, {{5, 6}, {1, 1}}), 0);
}

TEST(TimeCurve, GoesOnBeyondTheFineOne) {
  const TimeCurve further = beyond({{0, 1}, {1, 2}}, {{0, 1}, {3, 3}}, 0.5);
  EXPECT_DOUBLE_EQ(further.values[0], 0);
  EXPECT_DOUBLE_EQ(further.values[1], 1.5);
  EXPECT_DOUBLE_EQ(mean_of({{{0, 1}, {1, 2}}, {{0, 0.5, 1}, {3, 3, 4}}}).values[1], 3);
}

}  // namespace
}  // namespace pinball::time_curve_test
