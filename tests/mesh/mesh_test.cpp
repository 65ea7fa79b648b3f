#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include <solver/base/error.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/section.hpp>
#include <tests/support/error_of.hpp>

#include "mesh_counts.hpp"

namespace pinball::mesh_test {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

RoundNosedRodMesh rod(double length, double radius, std::array<int, 2> core, int ring, int layers, int refine = 1,
                      bool half = true) {
  return {length, radius, half, {core[0] * refine, core[1] * refine}, ring * refine, layers * refine};
}

double half_rod_volume(double length, double radius) {
  return 0.5 * pi * radius * radius * (length - radius) + pi * radius * radius * radius / 3.0;
}

TEST(Block, HasTheAskedCountsAndTheExactVolume) {
  const Mesh mesh = generate_block({{4.2, 1.7, 0.2}, {42, 17, 2}});
  EXPECT_EQ(mesh.hexahedra.size(), 1428u);
  EXPECT_EQ(mesh.nodes.size(), 43u * 18 * 3);
  EXPECT_EQ(count_used_nodes(mesh), mesh.nodes.size());
  EXPECT_EQ(count_distinct_points(mesh.nodes), mesh.nodes.size());
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_NEAR(quality.volume, 4.2 * 1.7 * 0.2, 1e-13);
  EXPECT_NEAR(quality.min_scaled_jacobian, 1.0, 1e-12);
  EXPECT_NEAR(quality.min_edge, 0.1, 1e-12);
  EXPECT_NEAR(quality.max_edge, 0.1, 1e-12);
  EXPECT_EQ(quality.inverted, 0);
  EXPECT_EQ(mesh.nodes.front(), (Point{0, 0, 0}));
  EXPECT_EQ(mesh.nodes.back(), (Point{4.2, 1.7, 0.2}));
}

TEST(Block, SectionsHaveElementsOfTheirOwn) {
  BlockMesh settings{{1, 1, 2.5}, {1, 1, 5}};
  settings.sections[2] = {{2, 1}, {0.5, 4}};
  const Mesh mesh = generate_block(settings);
  ASSERT_EQ(mesh.nodes.size(), 24);
  ASSERT_EQ(mesh.hexahedra.size(), 5);
  const double heights[] = {0, 2, 2.125, 2.25, 2.375, 2.5};
  for (std::size_t n = 0; n < 24; ++n) EXPECT_DOUBLE_EQ(mesh.nodes[n][2], heights[n / 4]);
}

TEST(Block, SizesAndElementsAreTheSumsOfSections) {
  const auto error_with = [](double size, int elements, const BlockSection& second) {
    BlockMesh settings{{1, 1, size}, {1, 1, elements}};
    settings.sections[2] = {{0.1, 1}, second};
    return test::error_of([&settings] { generate_block(settings); });
  };
  EXPECT_EQ(error_with(0.3, 5, {0.2, 4}), test::no_error) << "though 0.1 + 0.2 is not the double 0.3";
  EXPECT_EQ(error_with(1, 5, {1.9, 4}), "block mesh: size[2]: expected 2, the sum of its sections, got 1");
  EXPECT_EQ(error_with(0.3, 2, {0.2, 4}), "block mesh: elements[2]: expected 5, the sum of its sections, got 2");
  EXPECT_EQ(error_with(0.1, 1, {0, 0}),
            "block mesh: sections[2]: expected lengths > 0 and integers >= 1, got a length of 0 and elements 0");
}

TEST(Block, RejectsBadSettings) {
  EXPECT_THROW(generate_block({{1, 0, 1}, {1, 1, 1}}), InputError);
  EXPECT_THROW(generate_block({{1, NAN, 1}, {1, 1, 1}}), InputError);
  EXPECT_THROW(generate_block({{1, 1, 1}, {1, 1, 0}}), InputError);
  EXPECT_THROW(generate_block({{1, 1, 1}, {2000, 2000, 2000}}), InputError);
}

TEST(Quality, SeesAnInvertedElement) {
  Mesh mesh = generate_block({{1, 1, 1}, {1, 1, 2}});
  mesh.nodes[11] = {1, 1, -0.5};
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_EQ(quality.inverted, 1);
  EXPECT_LT(quality.min_scaled_jacobian, 0.0);
  EXPECT_EQ(measure_quality({}).inverted, 0);
}

TEST(Quality, VolumeOfATwistedElementIsExact) {
  // Top face turned by a quarter: the section at height z is the square with corners (1 - z) a + z R a, of area
  // 1 - 2 z + 2 z^2.
  const std::array<Point, 8> corners{
      {{-.5, -.5, 0}, {.5, -.5, 0}, {.5, .5, 0}, {-.5, .5, 0}, {.5, -.5, 1}, {.5, .5, 1}, {-.5, .5, 1}, {-.5, -.5, 1}}};
  EXPECT_NEAR(volume_by_quadrature(corners), 2.0 / 3.0, 1e-15);
}

TEST(RoundNosedRod, HasTheAskedCounts) {
  EXPECT_EQ(generate_round_nosed_rod(rod(10, 1, {2, 2}, 1, 41)).hexahedra.size(), 414u);
  EXPECT_EQ(generate_round_nosed_rod(rod(10, 1, {2, 2}, 1, 41, 1, false)).hexahedra.size(), 828u);
  for (const auto& settings : {rod(10, 1, {4, 3}, 2, 30), rod(5, 1, {1, 1}, 1, 7), rod(5, 1, {3, 2}, 4, 9)}) {
    const int p = settings.core[0], q = settings.core[1], b = settings.ring;
    const std::size_t expected = settings.layers * (p * q + (p + 2 * q) * b) + p * q * b;
    const Mesh mesh = generate_round_nosed_rod(settings);
    EXPECT_EQ(mesh.hexahedra.size(), expected);
    EXPECT_EQ(count_used_nodes(mesh), mesh.nodes.size());
    EXPECT_EQ(count_distinct_points(mesh.nodes), mesh.nodes.size());
  }
}

TEST(RoundNosedRod, HasGoodElements) {
  for (const double length : {7.0, 10.0, 20.0})
    for (const int refine : {1, 2, 3, 4, 6}) {
      const RoundNosedRodMesh settings = rod(length, 1, {2, 2}, 1, 41, refine);
      const MeshQuality quality = measure_quality(generate_round_nosed_rod(settings));
      EXPECT_EQ(quality.inverted, 0);
      EXPECT_GT(quality.min_scaled_jacobian, 0.55) << length << " " << refine;
      // Neither the layers nor the ring are squeezed: the shortest edge is near to the even one.
      EXPECT_GT(quality.min_edge, std::min(0.85 * (length - 0.5) / 41, 0.19) / refine) << length << " " << refine;
      EXPECT_LT(quality.max_aspect_ratio, 4.0) << length << " " << refine;
    }
}

TEST(RoundNosedRod, HasValidElementsForUnusualCounts) {
  for (const auto& settings :
       {rod(10, 1, {4, 3}, 2, 30), rod(1, 1, {2, 2}, 1, 2), rod(1, 1, {4, 4}, 2, 4), rod(1.2, 1, {2, 2}, 1, 1),
        rod(10, 1, {1, 1}, 1, 30), rod(10, 1, {8, 2}, 2, 60), rod(10, 1, {3, 3}, 1, 41), rod(10, 1, {2, 2}, 4, 60),
        rod(10, 1, {2, 2}, 1, 3), rod(2, 1, {2, 2}, 1, 1), rod(30, 0.1, {2, 1}, 1, 20)}) {
    const MeshQuality quality = measure_quality(generate_round_nosed_rod(settings));
    EXPECT_EQ(quality.inverted, 0);
    EXPECT_GT(quality.min_scaled_jacobian, 0.4) << settings.core[0] << " " << settings.core[1] << " " << settings.ring
                                                << " " << settings.layers << " " << settings.length;
  }
}

TEST(RoundNosedRod, VolumeConvergesWithSecondOrder) {
  const double length = 5.0, radius = 0.5, exact = half_rod_volume(length, radius);
  double previous = 0.0;
  for (const int refine : {1, 2, 4}) {
    const Mesh mesh = generate_round_nosed_rod(rod(length, radius, {2, 2}, 1, 41, refine));
    const double deficit = 1.0 - measure_quality(mesh).volume / exact;
    EXPECT_GT(deficit, 0.0);
    if (refine > 1) {
      EXPECT_NEAR(std::log2(previous / deficit), 2.0, 0.1);
    }
    previous = deficit;
  }
  EXPECT_LT(previous, 0.0035);
}

/// At the rear, in the way that section.hpp says: seen from the axis, the sides of the core are between straight lines
/// and the circle through its corners, which is as far from the circle of the rod as edges of the ring are to be long.
TEST(RoundNosedRod, HasACoreBetweenARectangleAndACircle) {
  for (const auto& settings : {rod(7, 1.3, {4, 3}, 2, 30), rod(10, 1, {2, 2}, 1, 41), rod(5, 1, {3, 5}, 4, 9)}) {
    const int p = settings.core[0], q = settings.core[1], columns = p + 2 * q;
    const double corner = settings.radius / (1 + core_edge * M_PI / columns * settings.ring);
    const double top_angle = 0.5 * M_PI * p / columns;  // of the corner, from the y axis
    const Mesh mesh = generate_round_nosed_rod(settings);
    for (int column = 0; column <= columns; ++column) {
      const double angle = 0.5 * M_PI * (columns - 2 * column) / columns, x = std::sin(angle), y = std::cos(angle);
      const bool top = std::abs(angle) < top_angle + 1e-9;
      const double straight = corner * (top ? std::cos(top_angle) / y : std::sin(top_angle) / std::abs(x));
      const double expected = (1 - core_bulge) * straight + core_bulge * corner;
      const auto along = [&](const Point& node) {  // all on a ray from the axis, by their distance from it
        return std::abs(node[2] + settings.length) < 1e-12 && std::abs(node[0] * y - node[1] * x) < 1e-12 &&
               node[0] * x + node[1] * y > 0;
      };
      double nearest = 2 * settings.radius;
      for (const Point& node : mesh.nodes) {
        const double r = std::hypot(node[0], node[1]);
        if (along(node) && std::abs(r - expected) < std::abs(nearest - expected)) nearest = r;
      }
      EXPECT_NEAR(nearest, expected, 1e-12) << p << " x " << q << ", column " << column;
    }
  }
}

TEST(RoundNosedRod, NodesLieWithinAndOnTheSurface) {
  const double length = 7.0, radius = 1.3;
  const RoundNosedRodMesh settings = rod(length, radius, {4, 3}, 2, 30);
  const Mesh mesh = generate_round_nosed_rod(settings);
  int on_lateral = 0, on_rear = 0, on_cut = 0, at_tip = 0;
  for (const Point& x : mesh.nodes) {
    const double axial = std::max(0.0, x[2] + radius);
    const double r = std::hypot(x[0], x[1], axial);
    EXPECT_LE(r, radius * (1 + 1e-14));
    EXPECT_GE(x[2], -length);
    EXPECT_GE(x[1], 0.0);
    EXPECT_TRUE(x[1] == 0.0 || x[1] > 0.01);
    if (std::abs(r - radius) < 1e-14) ++on_lateral;
    if (x[2] == -length) ++on_rear;
    if (x[1] == 0.0) ++on_cut;
    if (x[0] == 0.0 && x[1] == 0.0 && std::abs(x[2]) < 1e-15) ++at_tip;
  }
  const int p = 4, q = 3, b = 2, n = 30, columns = p + 2 * q;
  EXPECT_EQ(on_lateral, (n + 1) * (columns + 1) + (p - 1) * q);
  EXPECT_EQ(on_rear, (p + 1) * (q + 1) + b * (columns + 1));
  EXPECT_EQ(on_cut, (n + 1) * (p + 1 + 2 * b) + b * (p - 1));
  EXPECT_EQ(at_tip, 1);
}

void expect_mirror_symmetric(const Mesh& mesh, int axis) {
  std::set<std::array<std::int64_t, 3>> cells;
  const auto cell = [](const Point& x) {
    return std::array<std::int64_t, 3>{std::llround(x[0] * 1e9), std::llround(x[1] * 1e9), std::llround(x[2] * 1e9)};
  };
  for (const Point& x : mesh.nodes) cells.insert(cell(x));
  int missing = 0;
  for (Point x : mesh.nodes) {
    x[axis] = -x[axis];
    // Rounding may fall to either side of a cell's border.
    auto image = cell(x);
    bool found = false;
    for (int a = -1; a <= 1; ++a)
      for (int b = -1; b <= 1; ++b)
        for (int c = -1; c <= 1; ++c) found = found || cells.contains({image[0] + a, image[1] + b, image[2] + c});
    if (!found) ++missing;
  }
  EXPECT_EQ(missing, 0);
}

TEST(RoundNosedRod, IsMirrorSymmetric) {
  for (const auto& core : {std::array{2, 2}, std::array{3, 2}, std::array{4, 3}}) {
    expect_mirror_symmetric(generate_round_nosed_rod(rod(6, 1, core, 2, 17)), 0);
    const Mesh full = generate_round_nosed_rod(rod(6, 1, core, 2, 17, 1, false));
    expect_mirror_symmetric(full, 0);
    expect_mirror_symmetric(full, 1);
    EXPECT_EQ(count_distinct_points(full.nodes), full.nodes.size());
    EXPECT_EQ(measure_quality(full).inverted, 0);
    EXPECT_NEAR(measure_quality(full).volume,
                2 * measure_quality(generate_round_nosed_rod(rod(6, 1, core, 2, 17))).volume, 1e-12);
  }
}

TEST(RoundNosedRod, RejectsBadSettings) {
  EXPECT_THROW(generate_round_nosed_rod(rod(10, 0, {2, 2}, 1, 41)), InputError);
  EXPECT_THROW(generate_round_nosed_rod(rod(0.5, 1, {2, 2}, 1, 41)), InputError);
  EXPECT_THROW(generate_round_nosed_rod(rod(NAN, 1, {2, 2}, 1, 41)), InputError);
  EXPECT_THROW(generate_round_nosed_rod(rod(10, 1, {0, 2}, 1, 41)), InputError);
  EXPECT_THROW(generate_round_nosed_rod(rod(10, 1, {2, 2}, 0, 41)), InputError);
  EXPECT_THROW(generate_round_nosed_rod(rod(10, 1, {2, 2}, 1, 0)), InputError);
  EXPECT_THROW(generate_round_nosed_rod(rod(10, 1, {2, 2}, 1, 41, 2000)), InputError);
}

TEST(Place, TurnsZOntoTheAxisAndKeepsShape) {
  const Mesh original = generate(MeshSettings{rod(6, 1, {2, 2}, 1, 17)});
  const double volume = measure_quality(original).volume;
  for (const Point& axis : {Point{0, 0, 1}, Point{0, 0, -1}, Point{1, 0, 0}, Point{0, -1, 0}, Point{0.6, 0, -0.8},
                            Point{0.36, 0.48, 0.8}, Point{-3, 2, -9}, Point{1e-9, 1e-9, -1}, Point{-0.0, -0.0, -1}}) {
    Mesh mesh = original;
    place(mesh, axis, {1, 2, 3});
    EXPECT_NEAR(measure_quality(mesh).volume, volume, 1e-12);
    const double norm = std::hypot(axis[0], axis[1], axis[2]);
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      const Point x{mesh.nodes[node][0] - 1, mesh.nodes[node][1] - 2, mesh.nodes[node][2] - 3};
      EXPECT_NEAR((x[0] * axis[0] + x[1] * axis[1] + x[2] * axis[2]) / norm, original.nodes[node][2], 1e-13);
    }
  }
}

TEST(Place, IsTheShortestRotation) {
  // The normal of the plane of z and the axis stays where it is.
  Mesh mesh;
  mesh.nodes = {{-0.8, 0.6, 0}};
  place(mesh, Point{0.48, 0.64, -0.6}, {});
  EXPECT_NEAR(mesh.nodes[0][0], -0.8, 1e-15);
  EXPECT_NEAR(mesh.nodes[0][1], 0.6, 1e-15);
  EXPECT_NEAR(mesh.nodes[0][2], 0.0, 1e-15);
}

TEST(Place, KeepsTheCutInItsPlane) {
  const Mesh original = generate_round_nosed_rod(rod(6, 1, {2, 2}, 1, 17));
  for (const Point& axis : {Point{0.6, 0, -0.8}, Point{-0.6, -0.0, 0.8}, Point{0, 0, -1}, Point{1, 0, 0}}) {
    Mesh mesh = original;
    place(mesh, axis, {0.3, 0, 0.7});
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
      EXPECT_EQ(mesh.nodes[node][1], original.nodes[node][1]);
  }
}

TEST(Place, RejectsAnAxisWithoutDirection) {
  Mesh mesh;
  const Point nowhere{0, 0, 0}, undefined{NAN, 0, 1};
  EXPECT_THROW(place(mesh, nowhere, {}), InputError);
  EXPECT_THROW(place(mesh, undefined, {}), InputError);
}

}  // namespace
}  // namespace pinball::mesh_test
