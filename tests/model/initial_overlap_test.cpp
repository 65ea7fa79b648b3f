#include <gtest/gtest.h>

#include <solver/model/initial_overlap.hpp>
#include <tests/support/solver_case.hpp>

namespace pinball {
namespace {

using namespace test;

InitialOverlap overlap(const Point& corner, const std::array<int, 3>& elements = {2, 2, 2}, double h = 1) {
  return find_initial_overlap(
      build_mesh(scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}), block("b", elements, h, corner)}, 1)));
}

TEST(InitialOverlap, BodiesApartOrTouchingHaveNone) {
  EXPECT_EQ(overlap({0, 0, 2.5}).points, 0);
  EXPECT_EQ(overlap({0, 0, 2}).points, 0);
  EXPECT_EQ(overlap({0.3, 0.4, 1.95}).points, 0);  // a twentieth of an element: the facets of curved surfaces
}

TEST(InitialOverlap, IsNamed) {
  const InitialOverlap found = overlap({0.3, 0.4, 1.5});
  EXPECT_EQ(found.first, "a");
  EXPECT_EQ(found.second, "b");
  EXPECT_GT(found.points, 0);
}

TEST(InitialOverlap, OfTheSamePlaceAndOfABodyInsideAnother) {
  EXPECT_GE(overlap({0, 0, 0}).points, 2 * 8);  // at least the centres of all elements
  EXPECT_GT(overlap({0, 0, 0.5}).points, 0);    // where nodes and centres lie on faces
  EXPECT_GT(overlap({0.4, 0.4, 0.4}, {1, 1, 1}, 0.2).points, 0);
  EXPECT_GT(overlap({-4, -4, -4}, {1, 1, 1}, 10).points, 0);
}

TEST(InitialOverlap, ScenesOfTheRepositoryHaveNone) {
  for (const char* name : {"rod_plate", "rod_oblique", "two_blocks", "two_bars", "sphere_sphere", "taylor_plate"}) {
    EXPECT_EQ(find_initial_overlap(build_mesh(read_scene(find_scene(name)))).points, 0) << name;
  }
}

}  // namespace
}  // namespace pinball
