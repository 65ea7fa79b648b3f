#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <kernels/edge_pair.hpp>
#include <tests/support/support.hpp>

namespace pinball::edge_pair_test {
namespace {

using namespace test;
using V = Vec3<double>;

/// Ends of edge 1 and of edge 2.
using Ends = std::array<V, 4>;

EdgePair<double> pair_of(const Ends& x) { return nearest_points(x[0], x[1], x[2], x[3]); }

void expect_same_pair(const EdgePair<double>& pair, const EdgePair<double>& expected, double tolerance) {
  EXPECT_NEAR(pair.s, expected.s, tolerance);
  EXPECT_NEAR(pair.t, expected.t, tolerance);
  EXPECT_VECTOR_NEAR(pair.between, expected.between, tolerance);
  EXPECT_NEAR(pair.sine2, expected.sine2, tolerance);
}

/// Two edges about as long as 1, and their nearest points: their lines are put at a distance from each other.
struct SkewEdges {
  Ends ends;
  EdgePair<double> expected;
};
SkewEdges random_skew_edges(Random& random) {
  V u, v, across;
  double sine2 = 0;
  while (sine2 < 0.05) {
    u = uniform(random, 0.5, 2) * random_direction(random);
    v = uniform(random, 0.5, 2) * random_direction(random);
    across = cross(u, v);
    sine2 = dot(across, across) / (dot(u, u) * dot(v, v));
  }
  const double s = uniform(random, -0.5, 1.5), t = uniform(random, -0.5, 1.5);
  const V between = uniform(random, -1, 1) / norm(across) * across;
  const V at_1 = random_vector(random), at_2 = at_1 - between, a = at_1 - s * u, c = at_2 - t * v;
  return {{a, a + u, c, c + v}, {s, t, between, sine2}};
}

TEST(EdgePair, OfCrossingEdgesMeetsWhereTheyCross) {
  const EdgePair<double> pair = pair_of({V{0, 0, 1}, {4, 0, 1}, {1, -1, 1}, {1, 1, 1}});
  EXPECT_EQ(pair.s, 0.25);
  EXPECT_EQ(pair.t, 0.5);
  EXPECT_EQ(norm(pair.between), 0);
  EXPECT_EQ(pair.sine2, 1);
}

TEST(EdgePair, LiesBeyondTheEndsWhereTheLinesDo) {
  const EdgePair<double> pair = pair_of({V{0, 0, 0}, {2, 0, 0}, {3, 1, -0.5}, {4, 2, -0.5}});
  EXPECT_EQ(pair.s, 1);
  EXPECT_EQ(pair.t, -1);
  EXPECT_EQ(pair.between.x, 0);
  EXPECT_EQ(pair.between.y, 0);
  EXPECT_EQ(pair.between.z, 0.5) << "from edge 2 to edge 1";
  EXPECT_EQ(pair.sine2, 0.5);
}

/// Where they cross is as well known as the angle allows.
TEST(EdgePair, OfNearlyParallelEdgesKeepsItsDigits) {
  for (const double angle : {1e-2, 1e-4, 1e-6}) {
    const V u{1, 0, 0}, v{std::cos(angle), std::sin(angle), 0}, at{0.3, -0.2, 0.7};
    const EdgePair<double> pair =
        pair_of({at - 0.25 * u, at + 0.75 * u, at - 0.5 * v - V{0, 0, 0.1}, at + 0.5 * v - V{0, 0, 0.1}});
    EXPECT_NEAR(pair.s, 0.25, 1e-15 / angle) << angle;
    EXPECT_NEAR(pair.t, 0.5, 1e-15 / angle) << angle;
    EXPECT_NEAR(pair.between.z, 0.1, 1e-15);
    EXPECT_NEAR(pair.sine2, std::pow(std::sin(angle), 2), 1e-14 * angle);
  }
}

TEST(EdgePair, OfPointsThatFaceEachOtherLiesAlongTheirDirection) {
  Random random(11);
  for (int n = 0; n < 500; ++n) {
    const V direction = random_direction(random);
    const V u = random_vector(random), v = random_vector(random), at = random_vector(random);
    if (std::abs(dot(cross(u, v), direction)) < 0.01) continue;
    const double s = uniform(random, -0.5, 1.5), t = uniform(random, -0.5, 1.5), gap = uniform(random, -1, 1);
    const V a = at - s * u, c = at - gap * direction - t * v;
    const EdgePair<double> pair = facing_points(a, a + u, c, c + v, direction);
    EXPECT_NEAR(pair.s, s, 1e-12);
    EXPECT_NEAR(pair.t, t, 1e-12);
    EXPECT_VECTOR_NEAR(pair.between, gap * direction, 1e-12);
  }
}

TEST(EdgePair, OfParallelEdgesIsNowhere) {
  for (const double shift : {-3.0, 0.0, 0.5}) {
    for (const double length : {4.0, -1.0}) {
      const EdgePair<double> pair = pair_of({V{0, 0, 0}, {2, 0, 0}, {shift, 1, 0}, {shift + length, 1, 0}});
      EXPECT_EQ(pair.sine2, 0);
      EXPECT_TRUE(std::isnan(pair.s));
      EXPECT_TRUE(std::isnan(pair.t));
    }
  }
  Random random(3);
  for (int n = 0; n < 500; ++n) {
    const V u = random_direction(random), a = random_vector(random), c = random_vector(random);
    EXPECT_NEAR(pair_of({a, a + u, c, c + uniform(random, 0.5, 2) * u}).sine2, 0, 1e-14);
  }
}

TEST(EdgePair, OfAnEdgeWithoutLengthIsNotANumber) {
  EXPECT_TRUE(std::isnan(pair_of({V{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}}).sine2));
}

TEST(EdgePair, MovesAndTurnsWithItsEdges) {
  Random random(5);
  for (int n = 0; n < 1000; ++n) {
    const SkewEdges edges = random_skew_edges(random);
    const Tensor<double> turn = rotation_matrix(random_direction(random), uniform(random, -3, 3));
    const V way = random_vector(random, 10);
    Ends moved;
    for (std::size_t k = 0; k < 4; ++k) moved[k] = way + turn * edges.ends[k];
    EdgePair<double> expected = pair_of(edges.ends);
    expected.between = turn * expected.between;
    expect_same_pair(pair_of(moved), expected, 1e-12);
  }
}

TEST(EdgePair, TurnsRoundWhenItsEdgesAreSwapped) {
  Random random(7);
  for (int n = 0; n < 1000; ++n) {
    const Ends x = random_skew_edges(random).ends;
    const EdgePair<double> pair = pair_of(x), swapped = pair_of({x[2], x[3], x[0], x[1]});
    expect_same_pair(swapped, {pair.t, pair.s, -1.0 * pair.between, pair.sine2}, 1e-13);
    const EdgePair<double> reversed = pair_of({x[1], x[0], x[2], x[3]});
    expect_same_pair(reversed, {1 - pair.s, pair.t, pair.between, pair.sine2}, 1e-13);
  }
}

template <class T>
class EdgePairs : public testing::Test {};
TYPED_TEST_SUITE(EdgePairs, NumberTypes);

template <class T>
std::vector<EdgePair<double>> pairs_of(const std::vector<Ends>& lanes) {
  const auto points = [&](std::size_t k) { return vector_from_lanes<T>([&](int i) { return lanes[i][k]; }); };
  const EdgePair<T> all = nearest_points(points(0), points(1), points(2), points(3));
  std::vector<EdgePair<double>> pairs;
  for (int i = 0; i < width_of<T>; ++i) {
    const Vec3<ScalarOf<T>> between = lane_of(all.between, i);
    pairs.push_back(
        {lane(all.s, i), lane(all.t, i), {between.x, between.y, between.z}, static_cast<double>(lane(all.sine2, i))});
  }
  return pairs;
}

TYPED_TEST(EdgePairs, AreAtTheDistanceThatTheirLinesWerePut) {
  Random random(11);
  for (int n = 0; n < 500; ++n) {
    std::vector<Ends> lanes;
    std::vector<EdgePair<double>> expected;
    for (int i = 0; i < width_of<TypeParam>; ++i) {
      const SkewEdges edges = random_skew_edges(random);
      lanes.push_back(edges.ends);
      expected.push_back(edges.expected);
    }
    const auto pairs = pairs_of<TypeParam>(lanes);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      expect_same_pair(pairs[i], expected[i], 1000 * epsilon<ScalarOf<TypeParam>>);  // 50 for the angle
    }
  }
}

TYPED_TEST(EdgePairs, DoNotMindParallelOnesInOtherLanes) {
  Random random(13);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Ends& odd : {Ends{V{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {V{nan, 0, 0}, {}, {}, {}}}) {
    for (std::size_t own = 0; own < std::size_t{width_of<TypeParam>}; ++own) {
      std::vector<Ends> lanes;
      for (int i = 0; i < width_of<TypeParam>; ++i) lanes.push_back(random_skew_edges(random).ends);
      lanes[own] = odd;
      const auto pairs = pairs_of<TypeParam>(lanes);
      for (std::size_t i = 0; i < lanes.size(); ++i) {
        if (i == own) {
          EXPECT_FALSE(pairs[i].sine2 > 0);
        } else {
          expect_same_pair(pairs[i], pair_of(lanes[i]), 1000 * epsilon<ScalarOf<TypeParam>>);
        }
      }
    }
  }
}

}  // namespace
}  // namespace pinball::edge_pair_test
