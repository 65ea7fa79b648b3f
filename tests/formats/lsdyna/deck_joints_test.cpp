#include <gmock/gmock.h>

#include <fstream>

#include <solver/simulation.hpp>

#include "deck_case.hpp"

/// *CONSTRAINED_JOINT_...: what they become, and what is refused of them.
namespace pinball::test::deck_joints_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two rigid cubes of 1 mm that meet in a face, each with nodes of its own, and one that deforms; node 99 is an extra
/// one of part 2 where nodes 5 and 11 are.
const std::string cubes =
    "*NODE\n" + square_lines(1, 0) + square_lines(5, 1) + square_lines(11, 1) + square_lines(15, 2) +
    square_lines(21, 5) + square_lines(25, 6) +
    "99,0.,0.,1.\n*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,2,11,12,13,14,15,16,17,18\n3,3,21,22,23,24,25,26,27,28\n"
    "*SECTION_SOLID\n1,1\n" +
    elastic + ends +
    "*PART\nlower\n1,1,2\n*PART\nupper\n2,1,2\n*PART\nsoft\n3,1,1\n*MAT_RIGID\n2,7.85E-9,210000.,0.3\n\n\n"
    "*CONSTRAINED_EXTRA_NODES_NODE\n2,99\n";

class DeckJoints : public DeckTest {};

TEST_F(DeckJoints, AreThoseOfTheScene) {
  const Scene s =
      scene(cubes +
            "*CONSTRAINED_JOINT_SPHERICAL\n5,11\n5,99\n*CONSTRAINED_JOINT_REVOLUTE_ID\n7,the hinge\n5,11,6,12\n"
            "*CONSTRAINED_JOINT_CYLINDRICAL\n15,5,11,1\n*CONSTRAINED_JOINT_TRANSLATIONAL\n5,11,6,12\n"
            "*CONSTRAINED_JOINT_UNIVERSAL\n5,11,6,14\n*CONSTRAINED_JOINT_LOCKING\n11,5\n");
  ASSERT_EQ(s.joints.size(), 7U);
  const Point corner{0, 0, 1}, x{1, 0, 0}, y{0, 1, 0};
  EXPECT_EQ(s.joints[0].kind, JointKind::spherical);
  EXPECT_THAT(s.joints[0].bodies, ElementsAre("lower", "upper"));
  EXPECT_EQ(s.joints[0].point.value(), corner);
  EXPECT_THAT(s.joints[1].bodies, ElementsAre("lower", "upper")) << "by an extra node";
  EXPECT_EQ(s.joints[2].name, "joint_7");
  EXPECT_EQ(s.joints[2].kind, JointKind::revolute);
  EXPECT_EQ(s.joints[2].axis.value(), x);
  EXPECT_EQ(s.joints[3].kind, JointKind::cylindrical);
  EXPECT_EQ(s.joints[3].axis.value(), (Point{0, 0, -1}));
  EXPECT_EQ(s.joints[4].kind, JointKind::translational);
  EXPECT_EQ(s.joints[5].second_axis.value(), y);
  EXPECT_THAT(s.joints[6].bodies, ElementsAre("upper", "lower"));
}

TEST_F(DeckJoints, MoveThePartsTogether) {
  Simulation s(scene(cubes + "*CONSTRAINED_JOINT_REVOLUTE\n5,11,6,12,0,0,1.,0.5\n*DEFINE_CURVE\n1\n0.,1.E6\n1.,1.E6\n"
                             "*LOAD_NODE_POINT\n18,2,1\n"));
  s.run();
  const RunSummary summary = s.summary();
  EXPECT_GT(summary.rigid_bodies[0].velocity[1], 0) << "that the joint pulls along";
  EXPECT_LT(summary.joints.at(0).opening, 1e-12);
  EXPECT_THAT(translate(cubes + "*CONSTRAINED_JOINT_REVOLUTE\n5,11,6,12,7,13,2.,0.5\n").understood,
              AllOf(Contains(HasSubstr("RPS")), Contains(HasSubstr("DAMP")), Contains(HasSubstr("N5"))));
}

TEST_F(DeckJoints, ThatAreNoneAreRefused) {
  const std::string ball = "*CONSTRAINED_JOINT_SPHERICAL\n", hinge = "*CONSTRAINED_JOINT_REVOLUTE\n",
                    sleeve = "*CONSTRAINED_JOINT_CYLINDRICAL\n";
  EXPECT_THAT(error(cubes + ball + "5,77\n"), HasSubstr("N2: node 77 is not there"));
  EXPECT_THAT(error(cubes + ball + "5,21\n"), HasSubstr("N2: node 21 is of no rigid part"));
  EXPECT_THAT(error(cubes + ball + "5,6\n"), HasSubstr("expected a node of another rigid part than 1"));
  EXPECT_THAT(error(cubes + ball + "5,12\n"), HasSubstr("N2: expected it where N1 is, it is 1 away"));
  EXPECT_THAT(error(cubes + hinge + "5,11,12,6\n"), HasSubstr("expected one part on a side"));
  EXPECT_THAT(error(cubes + hinge + "5,11,5,11\n"), HasSubstr("N3: expected it away from N1"));
  EXPECT_THAT(error(cubes + sleeve + "5,11,6,14\n"),
              HasSubstr("N4: expected it on the axis of N1 and N3, it is 1 off"));
  EXPECT_THAT(error(cubes + "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n1,1,2\n"),
              HasSubstr("*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED"));
  EXPECT_THAT(error(cubes + "*CONSTRAINED_JOINT_REVOLUTE_ID\n7\n5,11,6,12\n*CONSTRAINED_JOINT_LOCKING_ID\n7\n5,11\n"),
              HasSubstr("joint 7 is given twice"));
}

}  // namespace
}  // namespace pinball::test::deck_joints_test
