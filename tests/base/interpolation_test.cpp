#include <gtest/gtest.h>

#include <vector>

#include <solver/base/interpolation.hpp>

namespace pinball::interpolation_test {
namespace {

TEST(Interpolate, IsLinearBetweenPointsAndConstantOutside) {
  const std::vector<double> x{1, 2, 4}, y{10, 20, 0};
  EXPECT_EQ(interpolate(x, y, 0), 10);
  EXPECT_EQ(interpolate(x, y, 1.5), 15);
  EXPECT_EQ(interpolate(x, y, 3), 10);
  EXPECT_EQ(interpolate(x, y, 5), 0);
  EXPECT_EQ(interpolate({1, 1, 2}, {3, 4, 5}, 1), 4) << "the last of two at one place";
}

}  // namespace
}  // namespace pinball::interpolation_test
