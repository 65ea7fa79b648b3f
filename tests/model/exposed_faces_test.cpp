#include <gtest/gtest.h>

#include <bit>

#include <solver/base/faces.hpp>
#include <solver/model/exposed_faces.hpp>
#include <tests/support/solver_case.hpp>

namespace pinball::exposed_faces_test {
namespace {

using namespace test;

std::vector<std::uint8_t> exposed_of(const Scene& scene, const std::vector<PlaneConstraint>& planes) {
  const ModelMesh mesh = build_mesh(scene);
  return find_exposed_faces(mesh, planes, face_neighbours(mesh.hexahedra));
}

int count(const std::vector<std::uint8_t>& exposed) {
  int sum = 0;
  for (const std::uint8_t faces : exposed) sum += std::popcount(faces);
  return sum;
}

PlaneConstraint across_y(double y, double tolerance = 0) {
  PlaneConstraint plane;
  plane.point = {0, y, 0};
  plane.normal = {0, 1, 0};
  plane.tolerance = tolerance;
  return plane;
}

TEST(ExposedFaces, AreNotThoseInAPlaneOfSymmetry) {
  const Scene scene = scene_of({block("a", {3, 2, 2}, 1, {0, 0, 0})}, 1);
  EXPECT_EQ(count(exposed_of(scene, {})), 2 * (6 + 4 + 6));
  EXPECT_EQ(count(exposed_of(scene, {across_y(0)})), 2 * (6 + 4 + 6) - 6);
  EXPECT_EQ(count(exposed_of(scene, {across_y(1)})), 2 * (6 + 4 + 6)) << "inside";
}

/// Whether two planes hold the two sides, or one with a tolerance that takes in both.
TEST(ExposedFaces, OfALayerInPlaneStrainAreThoseAcrossIt) {
  const Scene scene = scene_of({block("a", {3, 1, 2}, 1, {0, 0, 0})}, 1);
  const std::vector<std::uint8_t> expected = exposed_of(scene, {across_y(0), across_y(1)});
  EXPECT_EQ(count(expected), 2 * (3 + 2));
  EXPECT_EQ(exposed_of(scene, {across_y(0, 1)}), expected);
}

/// What it is for: bodies of such a layer do not go through each other.
TEST(ExposedFaces, OfALayerInPlaneStrainAreStruck) {
  const auto speed_of_the_struck = [](const std::vector<PlaneConstraint>& planes) {
    Scene scene =
        scene_of({block("a", {2, 1, 2}, 1, {0, 0, 0}), block("b", {2, 1, 2}, 1, {0.3, 0, 2.01}, {0, 0, -50})}, 4e-3);
    scene.contact.enforcement = Enforcement::lagrange;
    scene.contact.gap = ContactGap::face;
    scene.constraints = planes;
    Solver<double> solver(scene);
    run_to_end(solver);
    double speed = 0;  // of the body that was struck
    for (std::size_t n = 0; n < solver.mesh().nodes.size() / 2; ++n) speed += velocity_of(solver, n)[2];
    return speed / (solver.mesh().nodes.size() / 2);
  };
  const double expected = speed_of_the_struck({across_y(0), across_y(1)});
  EXPECT_LT(expected, -25);
  EXPECT_NEAR(speed_of_the_struck({across_y(0, 1)}), expected, 1e-6);
}

}  // namespace
}  // namespace pinball::exposed_faces_test
