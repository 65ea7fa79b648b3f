#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <solver/base/hexahedron_of_points.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/shapes/wedges.hpp>

/// Wedges among hexahedra, and the order of their nodes.
namespace pinball::wedges_test {
namespace {

double volume_of(const Corners8& corners, const std::vector<Point>& nodes) {
  std::array<Point, 8> x;
  for (std::size_t i = 0; i < 8; ++i) x[i] = nodes[corners[i]];
  return volume_by_quadrature(x);
}

/// All ways to list the same wedge: each node of a triangle third, either triangle first.
std::vector<Corners8> ways_of(const Corners8& w) {
  const int a[] = {w[0], w[1], w[2]}, b[] = {w[4], w[5], w[6]};
  std::vector<Corners8> ways;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    ways.push_back(wedge(a[i], a[j], a[k], b[i], b[j], b[k]));
    ways.push_back(wedge(b[k], b[j], b[i], a[k], a[j], a[i]));
  }
  return ways;
}

/// A prism over a triangle, turned in space.
std::vector<Point> prism(const Point& a, const Point& b, const Point& c) {
  std::vector<Point> nodes{a, b, c, a, b, c};
  for (std::size_t i = 3; i < 6; ++i) nodes[i][2] += 2;
  for (Point& x : nodes) x = {0.6 * x[0] - 0.8 * x[2], x[1] + 7, 0.8 * x[0] + 0.6 * x[2]};
  return nodes;
}

TEST(Wedges, AreFoundWhicheverEdgesAreCollapsed) {
  const std::vector<Point> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  // Two parallel edges of a face, each as its first end.
  const int edges[12][4] = {{0, 1, 3, 2}, {0, 1, 4, 5}, {3, 2, 7, 6}, {4, 5, 7, 6}, {0, 3, 1, 2}, {0, 3, 4, 7},
                            {1, 2, 5, 6}, {4, 7, 5, 6}, {0, 4, 1, 5}, {0, 4, 3, 7}, {1, 5, 2, 6}, {3, 7, 2, 6}};
  for (const auto& e : edges) {
    Corners8 corners{0, 1, 2, 3, 4, 5, 6, 7};
    corners[e[1]] = e[0];
    corners[e[3]] = e[2];
    const auto found = as_wedge(corners);
    ASSERT_TRUE(found);
    EXPECT_EQ(shape_of(*found), SolidShape::wedge);
    EXPECT_EQ(worked_as(corners), WorkedShape::wedge);
    EXPECT_NEAR(volume_of(*found, cube), 0.5, 1e-15);
    Corners8 sorted = corners, others = *found;
    std::ranges::sort(sorted);
    std::ranges::sort(others);
    EXPECT_EQ(sorted, others);
  }
}

TEST(Wedges, AreNoOtherHexahedraOfSixNodes) {
  for (const Corners8& corners :
       {Corners8{0, 1, 2, 2, 3, 4, 4, 5}, Corners8{0, 1, 2, 2, 3, 4, 5, 3}, Corners8{0, 1, 2, 2, 2, 3, 4, 5}}) {
    ASSERT_EQ(different_nodes(corners), 6u);
    EXPECT_FALSE(as_wedge(corners));
    EXPECT_EQ(worked_as(corners), WorkedShape::hexahedron);
  }
  EXPECT_FALSE(as_wedge(pyramid(0, 1, 2, 3, 4)));
  EXPECT_FALSE(as_wedge({0, 1, 2, 3, 4, 5, 6, 7}));
}

/// With any numbers of the nodes.
TEST(Wedges, AreTurnedTheSameWayHoweverTheyAreListed) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> away(-0.2, 0.2);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Point> nodes = prism({0, 0, 0}, {1.3, 0, 0}, {0.4, 0.9, 0});
    for (Point& x : nodes) x = {x[0] + away(random), x[1] + away(random), x[2] + away(random)};
    if (trial % 2 == 0) nodes = prism({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0});
    std::array<std::int32_t, 6> number{0, 1, 2, 3, 4, 5};
    std::ranges::shuffle(number, random);
    std::vector<Point> placed(6);
    for (std::size_t i = 0; i < 6; ++i) placed[number[i]] = nodes[i];
    const std::vector<Corners8> ways = ways_of(wedge(number[0], number[1], number[2], number[3], number[4], number[5]));
    const Corners8 first = turned_wedge(ways[0], placed);
    EXPECT_THAT(ways, testing::Contains(first));
    EXPECT_GT(volume_of(first, placed), 0);
    for (const Corners8& way : ways) EXPECT_EQ(turned_wedge(way, placed), first);
  }
}

TEST(Wedges, HaveTheirRightAngleThird) {
  const Corners8 given = wedge(0, 1, 2, 3, 4, 5);
  EXPECT_EQ(turned_wedge(given, prism({0, 0, 0}, {1, 0, 0}, {0, 1, 0})), wedge(1, 2, 0, 4, 5, 3));
  EXPECT_EQ(turned_wedge(given, prism({1, 0, 0}, {0, 1, 0}, {0, 0, 0})), wedge(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(turned_wedge(given, prism({0, 0, 0}, {4, 0, 0}, {2, 5, 0})), given) << "two sides of a length";
  EXPECT_EQ(turned_wedge(given, prism({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0})), wedge(1, 2, 0, 4, 5, 3))
      << "the lowest number, where all are";
}

TEST(Wedges, HaveASixthAtEachNode) {
  using testing::Each;
  using testing::ElementsAre;
  const double sixth = 1.0 / 6;
  EXPECT_THAT(corner_shares(WorkedShape::wedge, wedge(3, 1, 2, 9, 4, 5)),
              ElementsAre(sixth, sixth, sixth, 0, sixth, sixth, sixth, 0));
  EXPECT_THAT(corner_shares(WorkedShape::wedge, {0, 1, 2, 3, 4, 4, 5, 5}),
              ElementsAre(sixth, sixth, sixth, sixth, sixth, 0, sixth, 0));
  for (const WorkedShape shape : {WorkedShape::hexahedron, WorkedShape::tetrahedron})
    EXPECT_THAT(corner_shares(shape, tetrahedron(0, 1, 2, 3)), Each(1.0 / 8));
}

}  // namespace
}  // namespace pinball::wedges_test
