#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <solver/program/study/grid_convergence.hpp>

namespace pinball::grid_convergence_test {
namespace {

/// Sizes of elements, from fine to coarse.
using Sizes = std::vector<double>;

const std::vector<Sizes> all_sizes{{1, 2, 4}, {1, 1.5, 2.25}, {1, 1.5, 3}, {0.5, 1, 1.2}, {1, 1.2, 3}, {1, 2, 4, 8}};

/// exact + factor h^order on each mesh.
std::vector<MeshValue> power(const Sizes& sizes, double exact, double factor, double order) {
  std::vector<MeshValue> values;
  for (const double h : sizes) values.push_back({h, exact + factor * std::pow(h, order)});
  return values;
}

TEST(GridConvergence, PowersHaveTheirOrderAndLimit) {
  for (const Sizes& sizes : all_sizes) {
    for (const double order : {0.5001, 1.0, 1.79, 1.81, 2.0}) {
      for (const double factor : {0.1, -0.1}) {
        const GridConvergence g = grid_convergence(power(sizes, 3, factor, order));
        EXPECT_EQ(g.verdict, Convergence::monotone);
        EXPECT_NEAR(g.observed_order.value(), order, 1e-9);
        EXPECT_NEAR(g.order, order, 1e-9);
        EXPECT_NEAR(g.extrapolated, 3, 1e-10);
        const double safety = order > 1.8 ? 1.25 : 3;  // the formal order is 2
        EXPECT_EQ(g.safety_factor, safety);
        EXPECT_FALSE(g.order_is_bounded());
        const double fine = 3 + factor * std::pow(sizes[0], order), error = std::abs(fine - 3);
        EXPECT_NEAR(g.index * fine, safety * error, 1e-9);
        EXPECT_NEAR(g.low, fine - safety * error, 1e-9);
        EXPECT_NEAR(g.high, fine + safety * error, 1e-9);
        EXPECT_NEAR(g.extrapolated_error, error / 3, 1e-10);
        const double next = 3 + factor * std::pow(sizes[1], order);
        EXPECT_NEAR(g.approximate_error, std::abs(fine - next) / fine, 1e-12);
        EXPECT_TRUE(g.has_band());
      }
    }
  }
}

TEST(GridConvergence, MeshesMayComeInAnyOrderAndSizeHasAnyUnit) {
  std::vector<MeshValue> values = power({1, 1.5, 3}, 3, 0.1, 1.2);
  std::rotate(values.begin(), values.begin() + 1, values.end());
  for (MeshValue& v : values) v.size *= 1e-5;
  EXPECT_NEAR(grid_convergence(values).observed_order.value(), 1.2, 1e-9);
}

/// The first example of the paper's table 1, with what is printed there, and the iteration that it gives. The order is
/// not the formal one of this program, so that the index has 3 in the place of 1.25.
TEST(GridConvergence, TakesTheFixedPointOfThePaper) {
  const double r21 = 1.5, r32 = 1.333, f1 = 6.063, f2 = 5.972, f3 = 5.863;
  const GridConvergence g = grid_convergence({{1, f1}, {r21, f2}, {r21 * r32, f3}});
  double p = 1;
  for (int i = 0; i < 200; ++i) {
    const double q = std::log((std::pow(r21, p) - 1) / (std::pow(r32, p) - 1));
    p = std::abs(std::log((f3 - f2) / (f2 - f1)) + q) / std::log(r21);
  }
  EXPECT_NEAR(p, 1.53, 0.01);
  EXPECT_NEAR(g.observed_order.value(), p, 1e-9);
  EXPECT_NEAR(g.extrapolated, 6.1685, 2e-3);
  EXPECT_NEAR(g.approximate_error, 0.015, 1e-3);
  EXPECT_NEAR(g.extrapolated_error, 0.017, 1e-3);
  EXPECT_EQ(g.safety_factor, 3);
  EXPECT_NEAR(g.index * 1.25 / g.safety_factor, 0.022, 1e-3);
  EXPECT_EQ(grid_convergence({{1, f1}, {r21, f2}, {r21 * r32, f3}}, 0, 1e-10, p).safety_factor, 1.25);
}

TEST(GridConvergence, OrdersOutOfReasonAreBoundedAndTheBandIsWide) {
  const GridConvergence fast = grid_convergence(power({1, 2, 4}, 3, 0.1, 4));
  EXPECT_EQ(fast.verdict, Convergence::monotone);
  EXPECT_NEAR(fast.observed_order.value(), 4, 1e-9);
  EXPECT_EQ(fast.order, 2);
  EXPECT_EQ(fast.safety_factor, 3);
  EXPECT_TRUE(fast.order_is_bounded());
  const double e21 = 0.1 * (16 - 1), e32 = 0.1 * (256 - 16);
  EXPECT_NEAR(fast.extrapolated, 3.1 - e21 / 3, 1e-9);
  EXPECT_NEAR(fast.high - 3.1, std::max(3 * e21 / 3, 3 * e32 / 3 / 4), 1e-9);

  const GridConvergence slow = grid_convergence(power({1, 2, 4}, 3, 0.1, 0.2));
  EXPECT_NEAR(slow.observed_order.value(), 0.2, 1e-9);
  EXPECT_EQ(slow.order, 0.5);
  EXPECT_EQ(slow.safety_factor, 3);
  EXPECT_TRUE(slow.order_is_bounded());
  EXPECT_NEAR(slow.high - 3.1, 3 * 0.1 * (std::pow(2, 0.2) - 1) / (std::sqrt(2) - 1), 1e-9);
}

TEST(GridConvergence, TwoFineMeshesThatAgreeByChanceKeepTheBandOfTheCoarser) {
  const GridConvergence g = grid_convergence({{1, 5}, {2, 5}, {4, 5.3}});
  EXPECT_EQ(g.verdict, Convergence::monotone);
  EXPECT_EQ(g.observed_order.value(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(g.extrapolated, 5);
  EXPECT_NEAR(g.high - 5, 3 * 0.3 / 3 / 4, 1e-9);
  EXPECT_NEAR(5 - g.low, 3 * 0.3 / 3 / 4, 1e-9);
}

TEST(GridConvergence, OscillatingValuesHaveASpreadAndNoBand) {
  const GridConvergence g = grid_convergence({{1, 5}, {2, 5.2}, {4, 4.9}, {8, 7}});
  EXPECT_EQ(g.verdict, Convergence::oscillating);
  EXPECT_FALSE(g.has_band());
  EXPECT_FALSE(g.observed_order);
  EXPECT_EQ(g.low, 4.9);
  EXPECT_EQ(g.high, 7);
}

TEST(GridConvergence, DifferencesThatDoNotShrinkDiverge) {
  for (const std::vector<MeshValue>& values : std::vector<std::vector<MeshValue>>{
           {{1, 5}, {2, 6}, {4, 6.5}},    // they grow
           {{1, 5}, {2, 6}, {4, 7}},      // as a logarithm
           {{1, 5}, {1.5, 6}, {3, 7.7}},  // smaller by less than the step of the sizes: ln 2 / ln 1.5 = 1.71
           {{1, 5}, {2, 6}, {4, 6}}}) {   // only the finest moves
    const GridConvergence g = grid_convergence(values);
    EXPECT_EQ(g.verdict, Convergence::diverging);
    EXPECT_FALSE(g.has_band());
    EXPECT_FALSE(g.observed_order);
    EXPECT_EQ(g.low, values[0].value);
    EXPECT_EQ(g.high, values[2].value);
  }
  EXPECT_EQ(grid_convergence({{1, 5}, {1.5, 6}, {3, 7.72}}).verdict, Convergence::monotone);
}

TEST(GridConvergence, ConstantToRoundOffOfItsScale) {
  const GridConvergence g = grid_convergence({{1, 5}, {2, 5 + 1e-13}, {4, 5 - 1e-13}});
  EXPECT_EQ(g.verdict, Convergence::constant);
  EXPECT_EQ(g.extrapolated, 5);
  EXPECT_EQ(g.low, 5 - 1e-13);
  EXPECT_TRUE(g.has_band());
  const std::vector<MeshValue> noise{{1, 1e-17}, {2, -3e-17}, {4, 2e-17}};
  EXPECT_EQ(grid_convergence(noise).verdict, Convergence::oscillating);
  EXPECT_EQ(grid_convergence(noise, 20).verdict, Convergence::constant);
  EXPECT_EQ(grid_convergence({{1, 0}, {2, 0}, {4, 0}}).verdict, Convergence::constant);
}

TEST(GridConvergence, RefusesFewerThanThreeMeshes) {
  EXPECT_THROW(grid_convergence({{1, 5}, {2, 6}}), std::invalid_argument);
  EXPECT_THROW(grid_convergence({{1, 5}, {2, 6}, {2, 6}}), std::invalid_argument);
}

/// Distances between meshes are those of curves exact(t) + h^p c(t), of any c whose norm is 0.1.
TEST(GridConvergence, DistancesHaveTheOrderOfThePower) {
  for (const double order : {0.7, 1.0, 2.0}) {
    const std::array<double, 3> h{1, 1.5, 3};
    const auto apart = [&](std::size_t a, std::size_t b) {
      return 0.1 * (std::pow(h[b], order) - std::pow(h[a], order));
    };
    const GridConvergence g = distance_convergence(h, apart(0, 1), apart(1, 2), 2);
    EXPECT_EQ(g.verdict, Convergence::monotone);
    EXPECT_NEAR(g.observed_order.value(), order, 1e-9);
    EXPECT_EQ(g.extrapolated, 0);
    EXPECT_EQ(g.low, 0);
    EXPECT_NEAR(g.high, (order > 1.8 ? 1.25 : 3) * 0.1, 1e-12);
    EXPECT_NEAR(g.extrapolated_error, 0.05, 1e-12);
  }
  EXPECT_EQ(distance_convergence({1, 2, 4}, 1, 1, 2).verdict, Convergence::diverging);
  EXPECT_EQ(distance_convergence({1, 2, 4}, 1e-12, 0, 2).verdict, Convergence::constant);
  EXPECT_EQ(distance_convergence({1, 2, 4}, 0, 1, 2).verdict, Convergence::monotone);
}

}  // namespace
}  // namespace pinball::grid_convergence_test
