#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include <solver/base/error.hpp>
#include <solver/base/faces.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/quality.hpp>

#include "mesh_counts.hpp"

/// Cylinders and spheres.
namespace pinball::mesh_round_test {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

CylinderMesh cylinder(Section section, int core = 4, int ring = 2, int layers = 3) {
  return {.radius = 2, .length = 5, .section = section, .core = core, .ring = ring, .layers = layers};
}

CylinderMesh cylinder_wedge(double angle, int radial, int layers) {
  return {.radius = 2, .length = 5, .section = Section::wedge, .angle = angle, .radial = radial, .layers = layers};
}

SphereMesh sphere(Section section, int core = 4, int ring = 2, double grading = 1) {
  return {.radius = 3, .section = section, .core = {core, core}, .ring = ring, .grading = grading};
}

SphereMesh sphere_wedge(double angle, std::array<int, 2> core, int ring, double grading = 1) {
  return {.radius = 5, .section = Section::wedge, .angle = angle, .core = core, .ring = ring, .grading = grading};
}

/// Every node is used, none is there twice, and the surface of the mesh is one closed sheet around the volume.
void expect_sound(const Mesh& mesh) {
  EXPECT_EQ(count_used_nodes(mesh), mesh.nodes.size());
  EXPECT_EQ(count_distinct_points(mesh.nodes), mesh.nodes.size());
  EXPECT_EQ(measure_quality(mesh).inverted, 0);
  const auto neighbours = face_neighbours(mesh.hexahedra);
  Point sum{};
  std::set<std::int32_t> nodes;
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  int faces = 0;
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e)
    for (int f = 0; f < 6; ++f) {
      if (neighbours[e][f] != -1) continue;
      ++faces;
      Point x[4];
      for (int i = 0; i < 4; ++i) {
        const std::int32_t a = mesh.hexahedra[e][face_nodes[f][i]], b = mesh.hexahedra[e][face_nodes[f][(i + 1) % 4]];
        x[i] = mesh.nodes[a];
        nodes.insert(a);
        if (a != b) edges.insert({std::min(a, b), std::max(a, b)});
      }
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum[i] += 0.5 * ((x[2][j] - x[0][j]) * (x[3][k] - x[1][k]) - (x[2][k] - x[0][k]) * (x[3][j] - x[1][j]));
      }
    }
  for (const double component : sum) EXPECT_NEAR(component, 0.0, 1e-12);
  EXPECT_EQ(static_cast<int>(nodes.size()) - static_cast<int>(edges.size()) + faces, 2);
}

TEST(Cylinder, HasTheDocumentedCounts) {
  EXPECT_EQ(generate_cylinder(cylinder(Section::full)).hexahedra.size(), 3u * (16 + 4 * 4 * 2));
  EXPECT_EQ(generate_cylinder(cylinder(Section::half)).hexahedra.size(), 3u * (8 + 8 * 2));
  EXPECT_EQ(generate_cylinder(cylinder(Section::quarter)).hexahedra.size(), 3u * (4 + 4 * 2));
  EXPECT_EQ(generate_cylinder(cylinder_wedge(10, 7, 9)).hexahedra.size(), 63u);
}

TEST(Cylinder, IsSound) {
  for (const Section section : {Section::full, Section::half, Section::quarter})
    for (const int core : {2, 4, 6})
      for (const int ring : {1, 3}) expect_sound(generate_cylinder(cylinder(section, core, ring)));
  expect_sound(generate_cylinder(cylinder(Section::full, 3, 2)));
  expect_sound(generate_cylinder(cylinder_wedge(10, 4, 3)));
  expect_sound(generate_cylinder(cylinder_wedge(60, 1, 1)));
  for (const int refine : {1, 2, 4}) {
    const MeshQuality q = measure_quality(generate_cylinder(cylinder(Section::full, 4 * refine, 2 * refine, refine)));
    EXPECT_GT(q.min_scaled_jacobian, 0.65) << refine;
  }
}

TEST(Cylinder, VolumeIsThatOfChords) {
  for (const int core : {2, 4, 8}) {
    const double step = pi / (2 * core), exact = pi * 4 * 5;
    for (const Section section : {Section::full, Section::half, Section::quarter}) {
      const double part = section == Section::full ? 1 : section == Section::half ? 0.5 : 0.25;
      const double volume = measure_quality(generate_cylinder(cylinder(section, core))).volume;
      EXPECT_NEAR(volume, part * exact * std::sin(step) / step, 1e-12 * exact);
      EXPECT_NEAR(1 - std::sin(step) / step, 0.41 / (core * core), 0.1 / (core * core));
    }
  }
  EXPECT_NEAR(measure_quality(generate_cylinder(cylinder_wedge(10, 3, 2))).volume, 0.5 * 4 * std::sin(pi / 18) * 5,
              1e-12);
}

TEST(Sphere, HasTheDocumentedCounts) {
  EXPECT_EQ(generate_sphere(sphere(Section::full)).hexahedra.size(), 64u + 6 * 16 * 2);
  EXPECT_EQ(generate_sphere(sphere(Section::half)).hexahedra.size(), 32u + 3 * 16 * 2);
  EXPECT_EQ(generate_sphere(sphere(Section::quarter)).hexahedra.size(), 16u + 48);
  // The report's figure 12: ten degrees in 499 elements, a prime number.
  EXPECT_EQ(generate_sphere(sphere_wedge(10, {11, 17}, 8)).hexahedra.size(), 499u);
  EXPECT_EQ(generate_sphere(sphere_wedge(10, {8, 17}, 11)).hexahedra.size(), 499u);
}

TEST(Sphere, IsSound) {
  for (const double grading : {1.0, 0.2})
    for (const Section section : {Section::full, Section::half, Section::quarter})
      for (const int core : {2, 4, 6})
        for (const int ring : {1, 3}) expect_sound(generate_sphere(sphere(section, core, ring, grading)));
  expect_sound(generate_sphere(sphere(Section::full, 1, 1)));
  expect_sound(generate_sphere(sphere(Section::full, 5, 2)));
  for (const double grading : {1.0, 0.1}) {
    expect_sound(generate_sphere(sphere_wedge(10, {11, 17}, 8, grading)));
    expect_sound(generate_sphere(sphere_wedge(1, {4, 8}, 4, grading)));
  }
  expect_sound(generate_sphere(sphere_wedge(60, {1, 1}, 1)));
}

TEST(Sphere, GradingKeepsTheShapeOfElements) {
  for (const int core : {4, 8, 16}) {
    EXPECT_GT(measure_quality(generate_sphere(sphere(Section::full, core, core / 2))).min_scaled_jacobian, 0.5) << core;
    EXPECT_GT(measure_quality(generate_sphere(sphere(Section::full, core, core / 2, 0.25))).min_scaled_jacobian, 0.3)
        << core;
  }
  // Of the section alone: the wedge's edge has the sine of its angle.
  EXPECT_NEAR(measure_quality(generate_sphere(sphere_wedge(10, {11, 17}, 8, 0.2))).min_scaled_jacobian,
              std::sin(pi / 18), 0.1 * std::sin(pi / 18));
}

TEST(Sphere, GradingMakesThePoleFine) {
  const auto pole_edge = [](const Mesh& mesh, double radius, double pole) {  // distance of the pole's nearest node
    double nearest = 1e30;
    for (const Point& x : mesh.nodes) {
      const double d = std::hypot(x[0], x[1], x[2] - pole * radius);
      if (d > 1e-9) nearest = std::min(nearest, d);
    }
    return nearest;
  };
  const double even = pole_edge(generate_sphere(sphere(Section::full, 16, 8)), 3, -1);
  const Mesh graded = generate_sphere(sphere(Section::full, 16, 8, 0.25));
  EXPECT_NEAR(pole_edge(graded, 3, -1) / even, 0.25, 0.02);
  EXPECT_NEAR(pole_edge(graded, 3, 1) / even, 4, 0.8);
}

TEST(Sphere, VolumeConvergesWithSecondOrder) {
  const auto expect_second_order = [](const auto& deficit) {
    const double coarse = deficit(2), fine = deficit(4);
    EXPECT_GT(fine, 0);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
  };
  const double exact = 4 * pi / 3 * 27;
  for (const double grading : {1.0, 0.5})
    for (const Section section : {Section::full, Section::half, Section::quarter}) {
      const double part = section == Section::full ? 1 : section == Section::half ? 0.5 : 0.25;
      expect_second_order([&](int refine) {
        const Mesh mesh = generate_sphere(sphere(section, 4 * refine, 2 * refine, grading));
        return 1 - measure_quality(mesh).volume / (part * exact);
      });
    }
  const double sector = 2.0 / 3 * 125 * std::sin(pi / 18);
  expect_second_order([&](int refine) {
    return 1 - measure_quality(generate_sphere(sphere_wedge(10, {4 * refine, 8 * refine}, 4 * refine, 0.5))).volume /
                   sector;
  });
}

TEST(Sphere, NodesLieWhereTheyShould) {
  for (const double grading : {1.0, 0.3}) {
    const Mesh quarter = generate_sphere(sphere(Section::quarter, 4, 2, grading));
    int surface = 0, on_x = 0, on_y = 0, on_axis = 0;
    for (const Point& x : quarter.nodes) {
      EXPECT_LE(std::hypot(x[0], x[1], x[2]), 3 * (1 + 1e-14));
      EXPECT_GE(x[0], 0.0);
      EXPECT_GE(x[1], 0.0);
      surface += std::abs(std::hypot(x[0], x[1], x[2]) - 3) < 1e-13;
      on_x += x[0] == 0.0;
      on_y += x[1] == 0.0;
      on_axis += x[0] == 0.0 && x[1] == 0.0;
    }
    EXPECT_EQ(surface, 9 + 9 + 3 * 5);  // two faces of 3 x 3 points, and two of their sides on the 3 planes between
    EXPECT_EQ(on_x, 15 + 2 * (2 * 3 + 3));
    EXPECT_EQ(on_y, on_x);
    EXPECT_EQ(on_axis, 5 + 2 * 2);
    const Mesh wedge = generate_sphere(sphere_wedge(10, {4, 6}, 3, grading));
    int axis = 0;
    for (const Point& x : wedge.nodes) {
      const double r = std::hypot(x[0], x[1]);
      axis += r == 0.0;
      EXPECT_TRUE(x[1] == 0.0 || std::abs(x[1] / x[0] - std::tan(pi / 18)) < 1e-13);
    }
    EXPECT_EQ(axis, 7 + 2 * 3);
  }
}

TEST(RoundMeshes, RejectBadSettings) {
  EXPECT_THROW(generate_cylinder(cylinder(Section::half, 3)), InputError);
  EXPECT_THROW(generate_cylinder(cylinder(Section::full, 0)), InputError);
  EXPECT_THROW(generate_cylinder(cylinder(Section::full, 4, 0)), InputError);
  EXPECT_THROW(generate_cylinder(cylinder(Section::full, 4, 1, 0)), InputError);
  EXPECT_THROW(generate_cylinder(cylinder(Section::full, 40000, 1, 1)), InputError);
  EXPECT_THROW(generate_cylinder(cylinder_wedge(0, 4, 3)), InputError);
  EXPECT_THROW(generate_cylinder(cylinder_wedge(61, 4, 3)), InputError);
  EXPECT_THROW(generate_cylinder(cylinder_wedge(NAN, 4, 3)), InputError);
  EXPECT_THROW(generate_sphere(sphere(Section::quarter, 5)), InputError);
  EXPECT_THROW(generate_sphere(sphere(Section::full, 4, 2, 0)), InputError);
  EXPECT_THROW(generate_sphere(sphere(Section::full, 4, 2, 1.1)), InputError);
  EXPECT_THROW(generate_sphere(sphere(Section::full, 2000)), InputError);
  EXPECT_THROW(generate_sphere(sphere_wedge(90, {4, 4}, 2)), InputError);
  SphereMesh flat = sphere(Section::full);
  flat.radius = 0;
  EXPECT_THROW(generate_sphere(flat), InputError);
}

}  // namespace
}  // namespace pinball::mesh_round_test
