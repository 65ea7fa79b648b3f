#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <kernels/contact_row.hpp>

namespace pinball::contact_row_test {
namespace {

TEST(ContactRow, BallsAgreeWithThePenaltyWhereTheyOverlap) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3<double> d{number(random), number(random), number(random)};
    Vec3<double> n1{number(random), number(random), number(random)}, n2 = -1.0 * n1;
    n1 = (1 / std::sqrt(dot(n1, n1))) * n1;
    n2 = (1 / std::sqrt(dot(n2, n2))) * n2;
    const double reach = 1.2;
    const Penetration<double> p = penetration(d, reach, n1, n2);
    const ContactRow row = pinball_row(d, reach, n1, n2);
    if (!p.active) continue;
    ASSERT_EQ(row.nodes1, 8);
    EXPECT_NEAR(row.depth, p.depth, 1e-14);
    EXPECT_NEAR(row.direction.x, p.gradient.x, 1e-12);
    EXPECT_NEAR(row.direction.y, p.gradient.y, 1e-12);
    EXPECT_NEAR(row.direction.z, p.gradient.z, 1e-12);
  }
}

TEST(ContactRow, OpenGapOfBallsIsNegative) {
  const ContactRow row = pinball_row({0, 0, 1.5}, 1.2, {0, 0, -1}, {0, 0, 1});
  ASSERT_EQ(row.nodes1, 8);
  EXPECT_NEAR(row.depth, -0.3, 1e-15);
}

}  // namespace
}  // namespace pinball::contact_row_test
