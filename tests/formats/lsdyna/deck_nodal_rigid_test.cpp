#include <gmock/gmock.h>

#include <cmath>

#include <solver/simulation.hpp>

#include "deck_case.hpp"

/// *CONSTRAINED_NODAL_RIGID_BODY: nodes of a part that deforms which move as one.
namespace pinball::test::deck_nodal_rigid_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class DeckNodalRigid : public DeckTest {
 protected:
  std::string error_at_start(const std::string& text) {
    const Scene made = scene(text);
    return without_folder(error_of([&] { Simulation{made}; }));
  }
  const std::string deck_ = cube + elastic + ends + set_of_top, card_ = "*CONSTRAINED_NODAL_RIGID_BODY\n",
                    one_ = card_ + "7,0,3\n";
};

TEST_F(DeckNodalRigid, IsARigidBodyOfNodesAlone) {
  const Scene s = scene(deck_ + one_);
  ASSERT_EQ(s.rigid_bodies.size(), 1U);
  EXPECT_EQ(s.rigid_bodies[0].name, "nodal_rigid_body_7");
  EXPECT_THAT(s.rigid_bodies[0].bodies, IsEmpty());
  ASSERT_EQ(s.attached_nodes.size(), 1U);
  EXPECT_EQ(s.attached_nodes[0].rigid_body, "nodal_rigid_body_7");
  EXPECT_EQ(s.attached_nodes[0].nodes.set, "3");
  EXPECT_THAT(build_model<double>(s).rigid.at(0).nodes, ElementsAre(4, 5, 6, 7));
  EXPECT_EQ(scene(deck_ + card_ + "3\n").attached_nodes.at(0).nodes.set, "3") << "without NSID the set of its number";
  EXPECT_EQ(scene(deck_ + "*CONSTRAINED_NODAL_RIGID_BODY_TITLE\nlid\n7,0,3\n").rigid_bodies.size(), 1U);
}

/// One corner of the top of a cube is pushed: its diagonals keep their lengths, and not those of a top that deforms.
TEST_F(DeckNodalRigid, KeepsItsShape) {
  const std::string push = "*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n*LOAD_NODE_POINT\n5,1,1,-400.\n";
  const auto diagonal = [&](const std::string& text) {
    Simulation run(scene(text));
    run.run();
    const ConstArrayView positions = run.positions();
    const std::int32_t a = run.place_of_node()[4], b = run.place_of_node()[6];
    double square = 0;
    for (int k = 0; k < 3; ++k) square += std::pow(positions.number(a, k) - positions.number(b, k), 2);
    return std::sqrt(square);
  };
  EXPECT_NEAR(diagonal(deck_ + one_ + push), std::sqrt(2.), 1e-12);
  EXPECT_GT(std::abs(diagonal(deck_ + push) - std::sqrt(2.)), 1e-6);
}

TEST_F(DeckNodalRigid, IsMovedByItsNumber) {
  const std::string curve = "*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n", card = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n";
  const Scene s = scene(deck_ + one_ + curve + card + "7,3,0,1,-2.\n7,7,0,1,5.\n");
  ASSERT_EQ(s.rigid_motions.size(), 2U);
  EXPECT_EQ(s.rigid_motions[0].rigid_body, "nodal_rigid_body_7");
  EXPECT_EQ(s.rigid_motions[0].direction, (Point{0, 0, 1}));
  EXPECT_EQ(s.rigid_motions[1].axis, (Point{0, 0, 1}));
  EXPECT_EQ(error_at_start(deck_ + one_ + curve + card + "7,3,0,1,-2.\n"), no_error);
  EXPECT_THAT(error(deck_ + one_ + curve + card + "8,3,0,1\n"), HasSubstr("no *PART has the number 8"));
}

TEST_F(DeckNodalRigid, WhatIsNotDoneIsRefused) {
  EXPECT_THAT(error(deck_ + card_ + "7,0,3,0,0,1\n"), HasSubstr("DRFLAG"));
  EXPECT_THAT(error(deck_ + card_ + "7,0,3,0,0,0,7\n"), HasSubstr("RRFLAG"));
  EXPECT_THAT(error(deck_ + card_ + "1,0,3\n"), HasSubstr("PID: expected a number that no *PART has, got 1"));
  EXPECT_THAT(error(deck_ + card_ + "7,0,4\n"), HasSubstr("NSID: no *SET_NODE has the number 4"));
  EXPECT_THAT(error(deck_ + one_ + one_), HasSubstr("nodal rigid body 7 is given twice"));
  EXPECT_THAT(error(deck_ + "*CONSTRAINED_NODAL_RIGID_BODY_SPC\n7,0,3\n1.,7,7\n"),
              HasSubstr("*CONSTRAINED_NODAL_RIGID_BODY_SPC"));
  EXPECT_THAT(error_at_start(deck_ + one_ + "*BOUNDARY_SPC_SET\n3,0,1\n"),
              AllOf(HasSubstr("nodes of the rigid body nodal_rigid_body_7"), HasSubstr("*BOUNDARY_SPC_SET")));
  EXPECT_THAT(translate(deck_ + card_ + "7,2,3,5,1\n").understood,
              Contains(HasSubstr("not used: *CONSTRAINED_NODAL_RIGID_BODY: CID, PNODE, IPRT (")));
}

TEST_F(DeckNodalRigid, OfNodesOfNoSolidIsTold) {
  const TranslatedDeck idle = translate(deck_ + "*NODE\n99,7.,7.,7.\n*SET_NODE_LIST\n9\n99\n" + card_ + "7,0,9\n");
  EXPECT_THAT(idle.understood, Contains(HasSubstr("no solid has one of its nodes")));
  EXPECT_THAT(read_scene(idle.source(path_)).rigid_bodies, IsEmpty());
}

}  // namespace
}  // namespace pinball::test::deck_nodal_rigid_test
