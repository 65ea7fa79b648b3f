#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/model/look/opposed_motions.hpp>
#include <tests/support/solver_case.hpp>

/// Prescribed velocities that a constraint or an earlier one keeps from acting.
namespace pinball::opposed_motions_test {
namespace {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A bar along x whose right end moves along x.
Scene moved_bar() {
  Scene scene = scene_of({block("bar", {2, 1, 1}, 1, {0, 0, 0})}, 1);
  PrescribedVelocity pull;
  pull.nodes.where = "pull";
  pull.nodes.plane = Plane{{2, 0, 0}, {1, 0, 0}};
  pull.direction = {1, 0, 0};
  pull.velocity = {3, 0, 0};
  scene.prescribed_velocities = {pull};
  return scene;
}

FixedConstraint hold(double x, const std::vector<Point>& directions) {
  FixedConstraint fixed;
  fixed.nodes.where = "clamp";
  fixed.nodes.plane = Plane{{x, 0, 0}, {1, 0, 0}};
  fixed.directions = directions;
  return fixed;
}

std::vector<std::string> opposed(const Scene& scene) { return opposed_motions(scene, build_mesh(scene)); }

TEST(OpposedMotions, ByAConstraintAreNamed) {
  Scene scene = moved_bar();
  EXPECT_THAT(opposed(scene), IsEmpty());
  scene.fixed_constraints = {hold(0, {{1, 0, 0}}), hold(2, {{0, 1, 0}, {0, 0, 1}})};
  EXPECT_THAT(opposed(scene), IsEmpty()) << "at the other end, and in other directions";
  scene.fixed_constraints.push_back(hold(2, {{1, 0, 0}}));
  EXPECT_THAT(opposed(scene),
              ElementsAre(AllOf(HasSubstr("pull: 4 nodes do not move as it says, since clamp holds them"),
                                HasSubstr("node 2 of body bar"))));
  scene.prescribed_velocities[0].table = {{0, 1}, {0, 0}};
  EXPECT_THAT(opposed(scene), IsEmpty()) << "held in either way";
}

/// The second had the speed that it would have if the first did not move: it came out wrong, without a word.
TEST(OpposedMotions, AtAnAngleAreRefused) {
  Scene scene = moved_bar();
  scene.prescribed_velocities.push_back(scene.prescribed_velocities[0]);
  PrescribedVelocity& slanted = scene.prescribed_velocities[1];
  slanted.nodes.where = "slanted";
  slanted.direction = {0.6, 0.8, 0};
  EXPECT_THAT(
      error_of([&] { Solver<double> solver(scene); }),
      HasSubstr("slanted: expected a direction across that of pull, which moves some of its nodes, too; got (0.6, "
                "0.8, 0) and (1, 0, 0)"));
  slanted.direction = {0, 0.6, 0.8};
  EXPECT_NO_THROW(Solver<double>{scene}) << "at right angles";
  slanted.nodes.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  slanted.direction = {0.6, 0.8, 0};
  EXPECT_NO_THROW(Solver<double>{scene}) << "of other nodes";
}

TEST(OpposedMotions, ByDirectionsTogetherAreNamed) {
  Scene scene = moved_bar();
  scene.prescribed_velocities[0].direction = {0.6, 0.8, 0};
  scene.prescribed_velocities[0].velocity = {0.6, 0.8, 0};
  scene.fixed_constraints = {hold(2, {{1, 0, 0}})};
  EXPECT_THAT(opposed(scene), IsEmpty()) << "moves along y with what gives it that component";
  scene.fixed_constraints = {hold(2, {{1, 0, 0}, {0, 1, 0}})};
  EXPECT_THAT(opposed(scene), ElementsAre(HasSubstr("pull: 4 nodes do not move")));
  scene.prescribed_velocities[0].direction.reset();
  scene.prescribed_velocities[0].velocity = {0, 0, 2};
  EXPECT_THAT(opposed(scene), IsEmpty()) << "a whole velocity without a component that is held";
}

TEST(OpposedMotions, ByAnotherAreNamed) {
  Scene scene = moved_bar();
  PrescribedVelocity other = scene.prescribed_velocities[0];
  other.nodes.where = "other";
  other.nodes.box = Box{{2, 0, 0}, {2, 0, 1}};
  scene.prescribed_velocities.push_back(other);
  EXPECT_THAT(opposed(scene), IsEmpty()) << "alike";
  scene.prescribed_velocities[1].velocity = {4, 0, 0};
  EXPECT_THAT(opposed(scene),
              ElementsAre(HasSubstr("other: 2 nodes do not move as it says, since pull comes before it")));
  scene.prescribed_velocities[1].velocity = {3, 0, 0};
  scene.prescribed_velocities[1].table = {{0, 1}, {1, 2}};
  EXPECT_THAT(opposed(scene), ElementsAre(HasSubstr("other: 2 nodes")));
}

TEST(OpposedMotions, AreThoseAtOneTime) {
  Scene scene = moved_bar();
  scene.fixed_constraints = {hold(2, {{1, 0, 0}})};
  scene.fixed_constraints[0].when = {0.5, 1};
  EXPECT_THAT(opposed(scene), ElementsAre(HasSubstr("from time 0.5 on")));
  scene.prescribed_velocities[0].when = {0, 0.5};
  EXPECT_THAT(opposed(scene), IsEmpty());
}

}  // namespace
}  // namespace pinball::opposed_motions_test
