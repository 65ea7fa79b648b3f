#include <gmock/gmock.h>

#include <fstream>

#include <solver/step/report.hpp>
#include <solver/step/solver.hpp>
#include <tests/support/run_hash.hpp>

#include "deck_case.hpp"

/// *ELEMENT_MASS and *ELEMENT_MASS_NODE_SET: masses of nodes.
namespace pinball::test::deck_masses_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::DoubleEq;
using testing::HasSubstr;
using testing::Pointwise;

class DeckMasses : public DeckTest {
 protected:
  const std::string deck_ = cube + elastic + ends + set_of_top, card_ = "*ELEMENT_MASS\n",
                    of_set_ = "*ELEMENT_MASS_NODE_SET\n";
  /// Of each node beside that of its element.
  std::vector<double> masses(const std::string& text) {
    const Model<double> model = build_model<double>(scene(text));
    std::vector<double> of_nodes;
    for (const std::int32_t node : model.node_of_scene_node) of_nodes.push_back(model.point_mass[node]);
    return of_nodes;
  }
};

TEST_F(DeckMasses, AreOfANodeOrOfASetInEqualShares) {
  EXPECT_THAT(masses(deck_ + card_ + "       3       7         2.5E-09       1\n"),
              Pointwise(DoubleEq(), {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.5e-9, 0.0}));
  EXPECT_THAT(masses(deck_ + of_set_ + "4,3,8.E-9\n"),
              Pointwise(DoubleEq(), {0.0, 0.0, 0.0, 0.0, 2e-9, 2e-9, 2e-9, 2e-9}));
  EXPECT_THAT(masses(deck_ + of_set_ + "4,3,8.E-9\n" + card_ + "5,6,1.E-9\n6,6,3.E-9\n7,1,1.E-9\n"),
              Pointwise(DoubleEq(), {1e-9, 0.0, 0.0, 0.0, 2e-9, 6e-9, 2e-9, 2e-9}))
      << "those of one node add up";
}

/// As in all other keywords, and nodes of it that are there get none.
TEST_F(DeckMasses, OfASetThatHasSomethingWrongAreRefused) {
  const std::string wrong = "*SET_NODE_LIST\n7\n1,2,999\n";
  EXPECT_THAT(error(deck_ + wrong + of_set_ + "4,7,8.E-9\n"), HasSubstr("*SET_NODE_LIST: node 999 is not there"));
  EXPECT_THAT(error(deck_ + "*SET_NODE_GENERAL\n7\nNODE,1\nPART,5\n" + of_set_ + "4,7,8.E-9\n"),
              HasSubstr("no part has the number 5"));
  const std::string rigid = "*NODE\n50,9.,9.,9.\n*SET_NODE_LIST\n8\n50,999,1\n*CONSTRAINED_EXTRA_NODES_SET\n1,8\n",
                    law = "*MAT_RIGID\n1,7.85E-9,210000.,0.3\n";
  EXPECT_THAT(error(cube + law + ends + rigid), HasSubstr("*SET_NODE_LIST: node 999 is not there"));
}

TEST_F(DeckMasses, AreTheSameAsInAScene) {
  const std::string moving = "*INITIAL_VELOCITY_NODE\n7,0.,0.,-100.\n";
  const std::string mass = card_ + "3,7,4.E-9\n";
  Scene own = scene(deck_ + moving);
  PointMass point;
  point.nodes.nearest = Point{1, 1, 1};
  point.mass = 4e-9;
  own.point_masses = {point};
  EXPECT_EQ(hash_of<double>(scene(deck_ + moving + mass)), hash_of<double>(own));
  EXPECT_NE(hash_of<double>(scene(deck_ + moving)), hash_of<double>(own));
}

/// In an included file of other units and other numbers.
TEST_F(DeckMasses, AreScaledAndNumberedAsTheirFile) {
  std::ofstream(folder_ / "masses.k") << "*KEYWORD\n*ELEMENT_MASS\n1,6,3.\n*END\n";
  EXPECT_THAT(masses(deck_ + "*INCLUDE_TRANSFORM\nmasses.k\n1,0,0,0,0,0,0\n0\n1.E-9,1.,1.\n\n"),
              Pointwise(DoubleEq(), {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3e-9, 0.0}));
}

TEST_F(DeckMasses, AreInThatOfARigidPart) {
  const std::string rigid = cube + "*MAT_RIGID\n1,7.85E-9,210000.,0.3\n\n\n" + ends + card_ + "3,7,4.E-9\n";
  const Solver<double> solver(scene(rigid));
  const RigidBodyResult body = solver.rigid().results().at(0);
  EXPECT_NEAR(body.mass, 11.85e-9, 1e-20);
  EXPECT_NEAR(body.centre[2], (0.5 * 7.85 + 4) / 11.85, 1e-12);
  std::string given = rigid;
  given.replace(given.find("*PART\ncube\n1,1,1\n"), 17,
                "*PART_INERTIA\ncube\n1,1,1\n0.5,0.5,0.5,1.E-8\n1.,,,1.,,1.\n\n");
  EXPECT_THAT(error(given), AllOf(HasSubstr("*ELEMENT_MASS of nodes of a part with *PART_INERTIA"),
                                  HasSubstr("put the mass into its TM")));
}

TEST_F(DeckMasses, ThatAreWrongAreErrorsOfTheirCard) {
  EXPECT_THAT(error(deck_ + card_ + "3,7,1.E-9\n4,77,1.E-9\n"),
              AllOf(HasSubstr("deck.k:"), HasSubstr("NID"), HasSubstr("node 77 is not there")));
  EXPECT_THAT(error(deck_ + of_set_ + "3,33,1.E-9\n"), HasSubstr("no *SET_NODE with nodes has the number 33"));
  EXPECT_THAT(error(deck_ + card_ + "3,7,-1.E-9\n"),
              AllOf(HasSubstr("MASS"), HasSubstr("expected at least 0, got -1e-09")));
  EXPECT_THAT(error(deck_ + card_ + "3,7,1.E-9\n3,6,1.E-9\n"), HasSubstr("mass 3"));
  EXPECT_THAT(error(deck_ + "*NODE\n9,5.,5.,5.\n" + card_ + "3,9,1.E-9\n"),
              HasSubstr("*ELEMENT_MASS of nodes that no solid has"));
  EXPECT_THAT(error(deck_ + "*ELEMENT_MASS_PART\n1,1.E-9\n"), HasSubstr("*ELEMENT_MASS_PART"));
  EXPECT_THAT(translate(deck_ + card_ + "3,7\n").understood, Contains(HasSubstr("its MASS is 0")));
}

}  // namespace
}  // namespace pinball::test::deck_masses_test
