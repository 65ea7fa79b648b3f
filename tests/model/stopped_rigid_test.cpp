#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/model/look/stopped_rigid.hpp>
#include <tests/support/solver_case.hpp>

/// Rigid bodies that begin with velocities which they may not have.
namespace pinball::stopped_rigid_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> stopped(const Scene& scene) { return stopped_rigid_bodies(scene, build_mesh(scene)); }

TEST(StoppedRigidBodies, AreThoseThatMoveAsTheyAreHeld) {
  Scene scene = scene_of({block("a", {2, 2, 1}, 0.1, {0, 0, 0}, {3, 2, 0})}, 1, false);
  EXPECT_THAT(stopped(scene), IsEmpty());
  RigidBody& rigid = scene.rigid_bodies.emplace_back();
  rigid.name = "r";
  rigid.where = "rigid_body.0";
  rigid.bodies = {"a"};
  EXPECT_THAT(stopped(scene), IsEmpty());
  rigid.held = {{0, 0, 1}};
  EXPECT_THAT(stopped(scene), IsEmpty()) << "across it";
  rigid.held = {{0, 0, 1}, {1, 0, 0}};
  EXPECT_THAT(stopped(scene),
              ElementsAre("rigid_body.0: rigid body r is given a velocity of 3 along a direction in which it is held: "
                          "it begins without"));
  rigid.velocity = Point{0, 5, 0};
  EXPECT_THAT(stopped(scene), IsEmpty()) << "its own";
  rigid.held.clear();
  scene.constraints = {{{0, 0, 0}, {0, 1, 0}, ""}};
  EXPECT_THAT(stopped(scene).size(), 1);
  scene.constraints[0].point = {0, 0.15, 0};
  EXPECT_THAT(stopped(scene), IsEmpty()) << "none of its nodes is there";
}

}  // namespace
}  // namespace pinball::stopped_rigid_test
