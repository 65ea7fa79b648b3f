#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include <kernels/stable_time_step.hpp>
#include <kernels/wedge.hpp>

/// The wedge among hexahedra, against sums over its six nodes.
namespace pinball::wedge_test {
namespace {

using Nodes = std::array<Vec3<double>, 6>;

void to_corners(const Nodes& nodes, Vec3<double> (&corner)[8]) {
  for (int i = 0; i < 6; ++i) corner[wedge_corner(i)] = nodes[i];
  corner[3] = corner[2];
  corner[7] = corner[6];
}

HexahedronModes<double> modes_of(const Nodes& nodes) {
  Vec3<double> corner[8];
  to_corners(nodes, corner);
  return to_modes(corner);
}

double volume(const Nodes& nodes) {
  const HexahedronModes<double> x = modes_of(nodes);
  return hexahedron_volume(uniform_gradient(x), x);
}

double& component(Vec3<double>& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

/// B of a node, the derivatives of the volume: it is linear in each coordinate of a node.
Vec3<double> gradient(const Nodes& nodes, int i) {
  Vec3<double> b{};
  for (int k = 0; k < 3; ++k) {
    Nodes to = nodes, from = nodes;
    component(to[i], k) += 0.5;
    component(from[i], k) -= 0.5;
    component(b, k) = volume(to) - volume(from);
  }
  return b;
}

Nodes prism(double size, std::mt19937& random) {
  std::uniform_real_distribution<double> away(-size, size);
  Nodes nodes{{{0, 0, 0}, {1.2, 0.1, 0}, {0.3, 0.9, 0}, {0, 0, 0.7}, {1.2, 0.1, 0.7}, {0.3, 0.9, 0.7}}};
  for (Vec3<double>& x : nodes) x = x + Vec3<double>{away(random), away(random), away(random)};
  return nodes;
}

TEST(Wedge, HasTheGradientSquareOfItsSixNodes) {
  std::mt19937 random(7);
  for (const double size : {0.0, 0.1, 0.2}) {
    for (int trial = 0; trial < 20; ++trial) {
      const Nodes nodes = prism(size, random);
      Symmetric<double> expected{};
      for (int i = 0; i < 6; ++i) add_square(gradient(nodes, i), expected);
      expected = 0.75 * expected;
      const UniformGradient<double> b = uniform_gradient(modes_of(nodes));
      const Symmetric<double> found = wedge_gradient_square(b, gradient_square(b));
      for (const auto part : {&Symmetric<double>::xx, &Symmetric<double>::yy, &Symmetric<double>::zz,
                              &Symmetric<double>::xy, &Symmetric<double>::yz, &Symmetric<double>::zx})
        EXPECT_NEAR(found.*part, expected.*part, 1e-14);
    }
  }
}

/// The nodes of a prism's triangles are alike, which its eight corners are not.
TEST(Wedge, HasOneGradientSquareHoweverItsNodesAreTurned) {
  std::mt19937 random(7);
  const Nodes nodes = prism(0.2, random);
  const Nodes turned{nodes[1], nodes[2], nodes[0], nodes[4], nodes[5], nodes[3]};
  const auto square_of = [](const Nodes& of, bool as_wedge) {
    const UniformGradient<double> b = uniform_gradient(modes_of(of));
    const Symmetric<double> corners = gradient_square(b);
    return as_wedge ? wedge_gradient_square(b, corners) : corners;
  };
  const Symmetric<double> one = square_of(nodes, true), other = square_of(turned, true);
  EXPECT_NEAR(one.xx, other.xx, 1e-14);
  EXPECT_NEAR(one.xy, other.xy, 1e-14);
  EXPECT_NEAR(largest_principal_value(one), largest_principal_value(other), 1e-14);
  EXPECT_GT(std::abs(square_of(nodes, false).xx - square_of(turned, false).xx), 0.01);
}

/// A prism whose triangles have equal sides, of side and height 1: sums by hand.
TEST(Wedge, HasTheSumsOfARegularPrism) {
  const double a = std::sqrt(0.75), area = a / 2;
  const Nodes nodes{{{0, 0, 0}, {1, 0, 0}, {0.5, a, 0}, {0, 0, 1}, {1, 0, 1}, {0.5, a, 1}}};
  const UniformGradient<double> b = uniform_gradient(modes_of(nodes));
  const Symmetric<double> square = wedge_gradient_square(b, gradient_square(b));
  // Two nodes at +-a/4 along x, the third at 0, below and above; along z a third of the area each.
  EXPECT_NEAR(square.xx, 0.75 * 4 * a * a / 16, 1e-15);
  EXPECT_NEAR(square.yy, square.xx, 1e-15);
  EXPECT_NEAR(square.zz, 0.75 * 6 * area * area / 9, 1e-15);
  EXPECT_NEAR(square.xy, 0, 1e-15);
}

}  // namespace
}  // namespace pinball::wedge_test
