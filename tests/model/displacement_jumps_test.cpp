#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/model/look/displacement_jumps.hpp>
#include <tests/support/solver_case.hpp>

/// Prescribed displacements that are not 0 where they begin.
namespace pinball::displacement_jumps_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(DisplacementJumps, AreNamedWithWhatIsNotMade) {
  Scene scene = scene_of({block("bar", {2, 1, 1}, 1, {0, 0, 0})}, 1);
  PrescribedVelocity pull;
  pull.nodes.where = "pull";
  pull.nodes.body = "bar";
  pull.direction = {1, 0, 0};
  pull.velocity = {3, 0, 0};
  pull.quantity = MotionQuantity::displacement;
  pull.table = {{0, 1}, {0, 2}};
  scene.prescribed_velocities = {pull};
  EXPECT_THAT(displacement_jumps(scene), IsEmpty());
  scene.prescribed_velocities[0].when.start = 0.25;
  EXPECT_THAT(displacement_jumps(scene), ElementsAre(HasSubstr("pull: its displacement is 1.5 where it begins, at "
                                                               "time 0.25")));
  scene.prescribed_velocities[0].quantity = MotionQuantity::velocity;
  EXPECT_THAT(displacement_jumps(scene), IsEmpty());
  RigidMotion turn;
  turn.where = "turn";
  turn.axis = {0, 0, 1};
  turn.angular_speed = -2;
  turn.quantity = MotionQuantity::displacement;
  turn.table = {{0, 1}, {1, 2}};
  scene.rigid_motions = {turn};
  EXPECT_THAT(displacement_jumps(scene), ElementsAre(HasSubstr("turn: its displacement is 2 where it begins")));
}

}  // namespace
}  // namespace pinball::displacement_jumps_test
