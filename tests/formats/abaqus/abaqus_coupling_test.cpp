#include <gmock/gmock.h>

#include <solver/simulation.hpp>

#include "abaqus_case.hpp"

/// *COUPLING with *KINEMATIC: nodes of a part that deforms which move as one with a reference node.
namespace pinball::test::abaqus_coupling_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AbaqusCoupling : public AbaqusTest {
 protected:
  /// The top of a cube and a node in its middle.
  static std::string deck(const std::string& kinematic, const std::string& step = "", const char* z = "1.",
                          const std::string& more = "") {
    return abaqus_cube + "*NODE, NSET=RP\n99, 0.5, 0.5, " + z + "\n" +
           "*SURFACE, TYPE=NODE, NAME=lid\ntop\n*SURFACE, TYPE=ELEMENT, NAME=face\nCube, S2\n" +
           "*COUPLING, CONSTRAINT NAME=One, REF NODE=RP, SURFACE=lid\n" + kinematic + more + abaqus_steel +
           abaqus_step(step);
  }
  std::string error_at_start(const std::string& text) {
    const Scene made = scene(text);
    return without_folder(test::error_of([&] { Simulation{made}; }));
  }
};

TEST_F(AbaqusCoupling, IsARigidBodyOfNodesAlone) {
  for (const char* kinematic :
       {"*KINEMATIC\n", "*KINEMATIC\n1, 3\n", "*KINEMATIC\n1\n2\n3\n4\n", "*KINEMATIC\n1, 6\n"}) {
    const Scene s = scene(deck(kinematic));
    ASSERT_EQ(s.rigid_bodies.size(), 1U) << kinematic;
    EXPECT_EQ(s.rigid_bodies[0].name, "coupling_ONE");
    EXPECT_THAT(s.rigid_bodies[0].bodies, IsEmpty());
    EXPECT_EQ(s.attached_nodes.at(0).rigid_body, "coupling_ONE");
    EXPECT_THAT(build_model<double>(s).rigid.at(0).nodes, ElementsAre(4, 5, 6, 7));
  }
  std::string of_face = deck("*KINEMATIC\n");
  of_face.replace(of_face.find("SURFACE=lid"), 11, "SURFACE=face");
  EXPECT_THAT(build_model<double>(scene(of_face)).rigid.at(0).nodes, ElementsAre(4, 5, 6, 7));
}

TEST_F(AbaqusCoupling, ItsReferenceNodeHoldsAndMovesIt) {
  const Scene held = scene(deck("*KINEMATIC\n", "*BOUNDARY\nRP, 1, 2\nRP, 4, 6\n"));
  EXPECT_THAT(held.rigid_bodies.at(0).held, ElementsAre(Point{1, 0, 0}, Point{0, 1, 0}));
  EXPECT_EQ(held.rigid_bodies.at(0).held_rotations.size(), 3U);
  const std::string moving = "*BOUNDARY, TYPE=VELOCITY\nRP, 3, 3, -2.\n";
  const Scene moved = scene(deck("*KINEMATIC\n", moving));
  EXPECT_EQ(moved.rigid_motions.at(0).rigid_body, "coupling_ONE");
  EXPECT_EQ(moved.rigid_motions.at(0).direction, (Point{0, 0, 1}));
  EXPECT_EQ(error_at_start(deck("*KINEMATIC\n", moving)), no_error);
  EXPECT_THAT(error(deck("*KINEMATIC\n", "*BOUNDARY, TYPE=VELOCITY\nRP, 1, 1, -2.\n", "1.5")),
              HasSubstr("*COUPLING that is held or moved at a point that is not its centre"));
}

TEST_F(AbaqusCoupling, WhatIsNotDoneIsRefused) {
  EXPECT_THAT(error(deck("")), HasSubstr("*COUPLING without *KINEMATIC"));
  EXPECT_THAT(error(deck("*DISTRIBUTING\n")), HasSubstr("*DISTRIBUTING"));
  EXPECT_THAT(error(deck("*KINEMATIC\n1, 2\n")), HasSubstr("*KINEMATIC of some directions"));
  EXPECT_THAT(
      error(deck("*KINEMATIC\n", "", "1.", "*COUPLING, CONSTRAINT NAME=Two, REF NODE=RP, SURFACE=face\n*KINEMATIC\n")),
      HasSubstr("*COUPLING with the reference node of another one"));
  std::string own = deck("*KINEMATIC\n");
  own.replace(own.find("REF NODE=RP"), 11, "REF NODE=5");
  EXPECT_THAT(error(own), HasSubstr("*COUPLING with a reference node that an element has"));
  EXPECT_THAT(error_at_start(deck("*KINEMATIC\n", "*BOUNDARY\ntop, 1, 1\n")),
              HasSubstr("nodes of the rigid body coupling_ONE"));
  EXPECT_THAT(error(deck("*KINEMATIC\n", "*CLOAD\nRP, 3, 5.\n")), HasSubstr("*CLOAD of the reference node"));
  EXPECT_THAT(translate(deck("*KINEMATIC\n")).understood,
              Contains(AllOf(HasSubstr("*COUPLING ("), HasSubstr("the nodes of lid move as one"))));
}

}  // namespace
}  // namespace pinball::test::abaqus_coupling_test
