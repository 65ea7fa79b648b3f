#include <gtest/gtest.h>

#include <cmath>

#include <solver/model/unseen_balls.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/solver_case.hpp>

namespace pinball::unseen_balls_test {
namespace {

using namespace test;

std::optional<UnseenBalls> unseen(const Scene& scene) { return find_unseen_balls(scene, build_mesh(scene)); }

double depth(const Scene& scene) {
  const std::optional<UnseenBalls> found = unseen(scene);
  return found ? found->depth : 0.0;
}

/// A block of so many elements of another length along z.
Body column(const std::string& name, const std::array<int, 3>& elements, double length, double z) {
  Body body = block(name, elements, 1, {0, 0, z});
  body.mesh = BlockMesh{{1.0 * elements[0], 1.0 * elements[1], length * elements[2]}, elements};
  return body;
}

/// Two blocks, one above the other, of elements 1 x 1 x a.
Scene two_columns(double a) {
  return scene_of({column("a", {4, 4, 3}, a, 0), column("b", {4, 4, 3}, a, 3 * a + 0.5)}, 1);
}

/// Depth over the thickness at which two balls of elements 1 x 1 x a overlap, half a diagonal apart.
double depth_of(double a) {
  const double reach2 = std::pow(6 * a / M_PI, 2.0 / 3);
  return reach2 > 0.5 ? 1 - std::sqrt(reach2 - 0.5) / a : 1.0;
}

TEST(UnseenBalls, AreFewAmongNearCubes) {
  for (const double a : {0.3, 0.5, 1.0, 1.5}) EXPECT_EQ(depth(two_columns(a)), 0) << a;
}

TEST(UnseenBalls, LongElementsMeetTooLateAndFlatOnesNever) {
  for (const double a : {2.0, 3.0, 4.0, 8.0}) EXPECT_NEAR(depth(two_columns(a)), depth_of(a), 1e-12) << a;
  EXPECT_NEAR(depth_of(2), 0.303, 1e-3);
  EXPECT_EQ(depth(two_columns(0.125)), 1) << "balls of 0.31 pass between others that are 1 apart";
  const std::optional<UnseenBalls> found = unseen(two_columns(3));
  ASSERT_TRUE(found);
  EXPECT_LT(found->first, 48);
  EXPECT_GE(found->second, 48);
}

TEST(UnseenBalls, AreLookedForOnlyWhereTheGapIsTheirs) {
  Scene scene = two_columns(5);
  scene.contact.enforcement = Enforcement::lagrange;
  EXPECT_GT(depth(scene), 0.5) << "impulses between balls";
  scene.contact.gap = ContactGap::face;
  EXPECT_EQ(depth(scene), 0);
  scene = two_columns(5);
  scene.contact.method = ContactMethod::slideline;
  EXPECT_EQ(depth(scene), 0);
}

TEST(UnseenBalls, LargerRadiiSeeMore) {
  Scene scene = two_columns(3);
  scene.contact.radius_factor = 2;
  EXPECT_EQ(depth(scene), 0);
}

/// A cube above the middle node of larger elements.
double cube_on_coarse(double ratio, int elements) {
  const double edge = 1 / ratio;
  return depth(
      scene_of({block("floor", {4, 4, 4}, 1, {0, 0, 0}),
                block("cube", {elements, elements, elements}, edge / elements, {2 - edge / 2, 2 - edge / 2, 4.5})},
               1));
}

TEST(UnseenBalls, ASmallBodyComesDownBetweenLargeOnes) {
  const double r = std::cbrt(3 / (4 * M_PI));
  const auto exact = [r](double s) {
    const double square = r * r * (1 + s) * (1 + s) - 0.5;
    return square > 0 ? 1 - std::sqrt(square) / (0.5 * (1 + s)) : 1.0;
  };
  EXPECT_EQ(cube_on_coarse(2, 1), 0);
  for (const double ratio : {4.0, 7.0}) EXPECT_NEAR(cube_on_coarse(ratio, 1), exact(1 / ratio), 1e-12) << ratio;
  EXPECT_EQ(cube_on_coarse(9, 1), 1) << "never";
  EXPECT_LT(cube_on_coarse(0.5, 8), 1e-12) << "a large body of small elements meets the balls";
}

TEST(UnseenBalls, FacesThatLookAwayAndBetweenPlanesOfSymmetryDoNotCount) {
  // The last layer of b, far from a, is of long elements.
  Body b = block("b", {4, 4, 2}, 1, {0, 0, 4.5});
  BlockMesh mesh{{4, 4, 6}, {4, 4, 2}};
  mesh.sections[2] = {{1, 1}, {5, 1}};
  b.mesh = mesh;
  const Scene graded = scene_of({block("a", {4, 4, 4}, 1, {0, 0, 0}), b}, 1);
  EXPECT_EQ(depth(graded), 0);
  Scene turned = graded;
  turned.bodies[0].position = {0, 0, 11};
  EXPECT_GT(depth(turned), 0.4);
  // Bars one element wide between planes of symmetry: nothing is beside anything.
  Scene bars = scene_of({column("a", {1, 1, 3}, 1.35, 0), column("b", {1, 1, 3}, 1.35, 4.5)}, 1);
  bars.contact.radius_factor = 0.9;
  const double apart = depth(bars);
  EXPECT_GT(apart, 0.25);
  const auto mirror_at = [&](std::size_t k, double at) {
    PlaneConstraint plane;
    plane.point[k] = at;
    plane.normal[k] = 1;
    bars.constraints.push_back(plane);
  };
  for (std::size_t k = 0; k < 2; ++k) mirror_at(k, 0.0);
  EXPECT_EQ(depth(bars), apart) << "one plane in a direction has elements beside it";
  for (std::size_t k = 0; k < 2; ++k) mirror_at(k, 1.0);
  EXPECT_EQ(depth(bars), 0);
}

TEST(UnseenBalls, AStripOfFlatElementsFoldsThroughItself) {
  Scene strip = scene_of({column("strip", {20, 4, 1}, 0.125, 0)}, 1);
  const std::optional<UnseenBalls> found = unseen(strip);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, found->second);
  EXPECT_EQ(found->depth, 1);
  strip.contact.self = false;
  EXPECT_FALSE(unseen(strip));
  EXPECT_FALSE(unseen(scene_of({column("long", {4, 4, 4}, 5, 0)}, 1))) << "ends that cannot meet";
}

TEST(UnseenBalls, ScenesOfTheRepositoryHaveNone) {
  for (const char* name : {"rod_plate", "rod_oblique", "two_blocks", "two_bars", "sphere_sphere"}) {
    Scene scene = read_scene(find_scene(name));
    complete_scene(scene);
    EXPECT_FALSE(unseen(scene)) << name;
  }
}

}  // namespace
}  // namespace pinball::unseen_balls_test
