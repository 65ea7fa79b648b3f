#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/model/look/passed_walls.hpp>
#include <tests/support/solver_case.hpp>

/// Nodes that are given to go where a rigid wall is.
namespace pinball::passed_walls_test {
namespace {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A bar along x, from 0 to 2, over a wall at x = -1 that looks along x; its right end moves at -1 for 2.
Scene pressed_bar() {
  Scene scene = scene_of({block("bar", {2, 1, 1}, 1, {0, 0, 0})}, 2);
  RigidWall wall;
  wall.where = "wall";
  wall.plane = {{-1, 0, 0}, {1, 0, 0}};
  scene.rigid_walls = {wall};
  PrescribedVelocity push;
  push.nodes.where = "push";
  push.nodes.plane = Plane{{2, 0, 0}, {1, 0, 0}};
  push.direction = {1, 0, 0};
  push.velocity = {-1, 0, 0};
  scene.prescribed_velocities = {push};
  return scene;
}

std::vector<std::string> passed(const Scene& scene) { return passed_walls(scene, build_mesh(scene)); }

TEST(PassedWalls, ByWhatMovesThem) {
  Scene scene = pressed_bar();
  EXPECT_THAT(passed(scene), IsEmpty()) << "it ends at 0";
  scene.prescribed_velocities[0].velocity = {-2, 0, 0};
  EXPECT_THAT(passed(scene), ElementsAre(AllOf(HasSubstr("push: 4 nodes go as it says through wall"),
                                               HasSubstr("1 behind it at time 2"), HasSubstr("of body bar"))));
  scene.prescribed_velocities[0].direction = {0, 1, 0};
  EXPECT_THAT(passed(scene), IsEmpty()) << "along it";
  scene.prescribed_velocities[0].direction = {};
  EXPECT_THAT(passed(scene).size(), 1) << "in all directions";
  scene.prescribed_velocities[0].table = {{0, 1, 2}, {1, 1, -4}};
  EXPECT_THAT(passed(scene), IsEmpty()) << "comes back before";
  scene.prescribed_velocities[0].table = {};
  scene.prescribed_velocities[0].when.end = 1.4;
  EXPECT_THAT(passed(scene), IsEmpty()) << "ends before";
  scene.prescribed_velocities[0].when.end = 3;
  scene.rigid_walls[0].when.start = 1.8;
  EXPECT_THAT(passed(scene), IsEmpty()) << "the wall begins behind them";
}

TEST(PassedWalls, ByAWallThatMoves) {
  Scene scene = pressed_bar();
  scene.rigid_walls[0].speed = 0.6;
  EXPECT_THAT(passed(scene), ElementsAre(HasSubstr("0.2 behind it at time 2")));
  scene.prescribed_velocities.clear();
  EXPECT_THAT(passed(scene), IsEmpty());
  FixedConstraint clamp;
  clamp.nodes.where = "clamp";
  clamp.nodes.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  clamp.directions = {{0, 1, 0}, {0, 0, 1}};
  scene.fixed_constraints = {clamp};
  EXPECT_THAT(passed(scene), IsEmpty()) << "held in other directions";
  scene.fixed_constraints[0].directions = {{1, 0, 0}};
  EXPECT_THAT(passed(scene), ElementsAre(HasSubstr("clamp: 4 nodes go as it holds them through wall")));
}

}  // namespace
}  // namespace pinball::passed_walls_test
