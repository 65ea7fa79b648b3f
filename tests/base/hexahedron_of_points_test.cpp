#include <gtest/gtest.h>

#include <random>

#include <solver/base/hexahedron_of_points.hpp>
#include <solver/mesh/quality.hpp>

namespace pinball::hexahedron_of_points_test {
namespace {

std::array<Point, 8> box(const Point& size) {
  return {{{0, 0, 0},
           {size[0], 0, 0},
           {size[0], size[1], 0},
           {0, size[1], 0},
           {0, 0, size[2]},
           {size[0], 0, size[2]},
           {size[0], size[1], size[2]},
           {0, size[1], size[2]}}};
}

TEST(HexahedronOfPoints, VolumeOfABoxIsTheProductOfItsEdges) {
  EXPECT_NEAR(hexahedron_volume(box({2, 3, 0.5})), 3, 1e-15);
  EXPECT_NEAR(hexahedron_volume(box({2, 3, -0.5})), -3, 1e-15);  // inside out
}

TEST(HexahedronOfPoints, VolumeOfADistortedHexahedronIsThatOfQuadrature) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  for (int trial = 0; trial < 100; ++trial) {
    std::array<Point, 8> corners = box({1, 1, 1});
    for (Point& corner : corners) {
      for (double& x : corner) x += shift(random);
    }
    EXPECT_NEAR(hexahedron_volume(corners), volume_by_quadrature(corners), 1e-15);
  }
}

TEST(HexahedronOfPoints, ConstantModeIsTheMeanOfTheCorners) {
  EXPECT_EQ(to_point(modes_of(box({2, 4, 6})).constant), (Point{1, 2, 3}));
  EXPECT_EQ(to_point(to_vector({1, 2, 3})), (Point{1, 2, 3}));
}

}  // namespace
}  // namespace pinball::hexahedron_of_points_test
