#include <gmock/gmock.h>

#include "abaqus_case.hpp"

/// Rigid bodies of Abaqus input: what their reference nodes may have, and what is refused.
namespace pinball::test::abaqus_rigid_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The cube of the other tests, with a reference node in its centre and one beside it.
const std::string points = "*NODE\n21, 0.5, 0.5, 0.5\n22, 3., 0.5, 0.5\n",
                  at_centre = abaqus_cube + points + "*RIGID BODY, REF NODE=21, ELSET=Cube\n" + abaqus_steel,
                  beside = abaqus_cube + points + "*RIGID BODY, REF NODE=22, ELSET=Cube\n" + abaqus_steel;

class AbaqusRigid : public AbaqusTest {
 protected:
  RigidBody body_of(const std::string& text) { return scene(text).rigid_bodies.at(0); }
  std::string error_in_model(const std::string& text) {
    const Scene made = scene(text);
    return without_folder(error_of([&] { build_model<double>(made); }));
  }
};

TEST_F(AbaqusRigid, HoldsItsReferenceNode) {
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_THAT(body_of(at_centre + abaqus_step()).bodies, ElementsAre("Cube"));
  const RigidBody fixed = body_of(at_centre + "*BOUNDARY\n21, ENCASTRE\n" + abaqus_step());
  EXPECT_THAT(fixed.held, ElementsAre(x, y, z));
  EXPECT_THAT(fixed.held_rotations, ElementsAre(x, y, z));
  const RigidBody symmetric = body_of(at_centre + "*BOUNDARY\n21, XSYMM\n" + abaqus_step());
  EXPECT_THAT(symmetric.held, ElementsAre(x));
  EXPECT_THAT(symmetric.held_rotations, ElementsAre(y, z));
  const RigidBody lines = body_of(at_centre + "*BOUNDARY\n21, 2, 4\n" + abaqus_step("*BOUNDARY\n21, 6, 6\n"));
  EXPECT_THAT(lines.held, ElementsAre(y, z));
  EXPECT_THAT(lines.held_rotations, ElementsAre(x, z));
}

TEST_F(AbaqusRigid, MovesItsReferenceNode) {
  const Scene s = scene(at_centre + "*AMPLITUDE, NAME=A\n0., 0., 1e-6, 1.\n" +
                        abaqus_step("*BOUNDARY, TYPE=VELOCITY, AMPLITUDE=A\n21, 3, 3, 5.\n21, 5, 5, 7.\n"));
  ASSERT_EQ(s.rigid_motions.size(), 2U);
  EXPECT_EQ(s.rigid_motions[0].rigid_body, "Cube");
  EXPECT_EQ(s.rigid_motions[0].direction.value(), (Point{0, 0, 1}));
  EXPECT_THAT(s.rigid_motions[0].table.factors, ElementsAre(0., 5.));
  EXPECT_EQ(s.rigid_motions[1].axis.value(), (Point{0, 1, 0}));
  EXPECT_THAT(s.rigid_motions[1].table.factors, ElementsAre(0., 7.));
  EXPECT_THAT(error(at_centre + "*AMPLITUDE, NAME=A\n0., 0., 1e-6, 1.\n" +
                    abaqus_step("*BOUNDARY, AMPLITUDE=A\n21, 5, 6, 7.\n")),
              HasSubstr("*BOUNDARY of angles of a rigid body about several axes"));
}

/// What is held until a step ends, or from a later one on, is a motion without a speed.
TEST_F(AbaqusRigid, IsHeldForAWhile) {
  const std::string step = "*STEP\n*DYNAMIC, EXPLICIT\n, 1.0E-6\n";
  const Scene s =
      scene(at_centre + "*BOUNDARY\n21, 1, 2\n" + abaqus_step() + step + "*BOUNDARY, OP=NEW\n21, 4\n*END STEP\n");
  EXPECT_TRUE(s.rigid_bodies.at(0).held.empty());
  ASSERT_EQ(s.rigid_motions.size(), 3U);
  EXPECT_EQ(s.rigid_motions[0].when.end, 1e-6);
  EXPECT_EQ(s.rigid_motions[0].speed, 0);
  EXPECT_EQ(s.rigid_motions[2].axis.value(), (Point{1, 0, 0}));
  EXPECT_EQ(s.rigid_motions[2].when.start, 1e-6);
}

TEST_F(AbaqusRigid, BeginsWithTheVelocityOfItsReferenceNode) {
  const std::string thrown = "*INITIAL CONDITIONS, TYPE=VELOCITY\n22, 1, 3.\n22, 6, 2.\n";
  const RigidBody body = body_of(beside + thrown + abaqus_step());
  EXPECT_NEAR(norm(minus(body.velocity.value(), {3, -5, 0})), 0, 1e-12);
  EXPECT_EQ(body.angular_velocity.value(), (Point{0, 0, 2}));
  const std::string all =
      "*NSET, NSET=All\n1, 2, 3, 4, 5, 6, 7, 8, 21\n*INITIAL CONDITIONS, TYPE=VELOCITY\nAll, 1, 3.\n";
  EXPECT_EQ(body_of(at_centre + all + abaqus_step()).velocity.value(), (Point{3, 0, 0}));
  EXPECT_THAT(error(at_centre + "*INITIAL CONDITIONS, TYPE=VELOCITY\ntop, 1, 3.\n" + abaqus_step()),
              HasSubstr("*INITIAL CONDITIONS of nodes of a rigid body"));
}

TEST_F(AbaqusRigid, MayBeginWithASpinAboutAnyAxis) {
  const std::string spin = "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\n22, 2., 3.\n0.5, 0.5, 0., 0.5, 0.5, 1.\n";
  const RigidBody body = body_of(beside + spin + abaqus_step());
  EXPECT_NEAR(norm(minus(body.velocity.value(), {3, 0, 0})), 0, 1e-12) << "the axis is through its centre";
  EXPECT_EQ(body.angular_velocity.value(), (Point{0, 0, 2}));
  EXPECT_THAT(error(beside + spin + "*INITIAL CONDITIONS, TYPE=VELOCITY\n22, 1, 3.\n" + abaqus_step()),
              HasSubstr("TYPE=ROTATING VELOCITY of nodes with another velocity"));
}

TEST_F(AbaqusRigid, IsRefusedWhereItTurnsAboutAnotherPoint) {
  const auto with = [&](const std::string& line) {
    return error(beside + "*BOUNDARY\n22, " + line + "\n" + abaqus_step());
  };
  const auto refused = HasSubstr("*RIGID BODY that is held or moved at a point that is not its centre");
  EXPECT_THAT(with("PINNED"), refused);
  EXPECT_THAT(with("2, 5"), refused);
  EXPECT_EQ(with("1, 6"), no_error);
  EXPECT_EQ(with("4, 5"), no_error) << "nothing is held along";
  EXPECT_EQ(with("YSYMM"), no_error) << "it turns about the direction that is held";
  EXPECT_EQ(error(beside + "*BOUNDARY\n22, 1, 3\n22, 5, 6\n" + abaqus_step()), no_error)
      << "the axis goes through both";
  std::string moved_there = beside;
  moved_there.replace(moved_there.find("REF NODE=22"), 11, "REF NODE=22, POSITION=CENTER OF MASS");
  EXPECT_EQ(error(moved_there + "*BOUNDARY\n22, PINNED\n" + abaqus_step()), no_error);
}

TEST_F(AbaqusRigid, RefusesByNameWhatIsNotThere) {
  EXPECT_THAT(error(at_centre + abaqus_step("*CLOAD\n21, 1, 5.\n")), HasSubstr("*CLOAD of the reference node"));
  EXPECT_THAT(error(at_centre + "*NSET, NSET=Both\n1, 21\n*BOUNDARY\nBoth, 1\n" + abaqus_step()),
              HasSubstr("*BOUNDARY of a reference node of a rigid body and of other nodes"));
  EXPECT_THAT(error_in_model(at_centre + "*BOUNDARY\ntop, 1\n" + abaqus_step()), HasSubstr("rigid_body.held"));
  EXPECT_THAT(error(abaqus_cube + points + "*RIGID BODY, REF NODE=top, ELSET=Cube\n" + abaqus_steel + abaqus_step()),
              HasSubstr("expected one reference node, got 4"));
}

}  // namespace
}  // namespace pinball::test::abaqus_rigid_test
