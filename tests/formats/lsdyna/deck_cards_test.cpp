#include <gmock/gmock.h>

#include <algorithm>

#include <tests/formats/ten_nodes_case.hpp>

#include "deck_case.hpp"

/// What cards say beyond their fields: how often they stand, in which order, and with which lines.
namespace pinball::test::deck_cards_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class DeckCards : public DeckTest {
 protected:
  Scene scene_with(const std::string& more) { return scene(cube + elastic + ends + set_of_top + more); }
  std::vector<std::string> told(const std::string& more) {
    return translate(cube + elastic + ends + set_of_top + more).understood;
  }
};

TEST_F(DeckCards, AKeywordOfWallsHasAsManyAsItsCards) {
  const auto walls = scene_with("*RIGIDWALL_PLANAR\n3\n0,0,-1,0,0,0\n\n0,0,3,0,0,2,0.25\n\n\n").rigid_walls;
  ASSERT_EQ(walls.size(), 2U);
  EXPECT_EQ(walls[1].name, "wall_1");
  EXPECT_EQ(walls[1].plane.point[2], 3);
  EXPECT_EQ(walls[1].friction, 0.25);
  const Scene finite = scene_with(
      "*RIGIDWALL_PLANAR_FINITE_MOVING_ID\n1,floor\n0\n0,0,-1,0,0,0\n1,0,-1,2,3\n1,5\n2,roof\n0\n0,0,3,0,0,2\n1,0,3,4,"
      "5\n2,6\n");
  ASSERT_EQ(finite.rigid_walls.size(), 2U);
  EXPECT_EQ(finite.rigid_walls[1].mass, 2);
  EXPECT_THAT(error(cube + elastic + ends + "*RIGIDWALL_PLANAR\n0\n0,0,-1,0,0,0\n3\n"),
              HasSubstr("expected the plane of the wall"));
}

TEST_F(DeckCards, ATitleMayBeTheNameOfAPartWithoutOne) {
  std::string titled = cube;
  titled.replace(titled.find("cube\n"), 4, "part_2");
  const Scene two = scene(titled + elastic + ends + "*NODE\n" + square_lines(11, 2) +
                          "*ELEMENT_SOLID\n11,2,5,6,7,8,11,12,13,14\n*PART\n\n2,1,1\n");
  ASSERT_EQ(two.bodies.size(), 2U);
  EXPECT_EQ(two.bodies[0].name, "part_2");
  EXPECT_EQ(two.bodies[1].name, "part_2_2");
}

/// All six factors are 1 where none is given; one of a rotation leaves the others at 0.
TEST_F(DeckCards, DampingOfRotationsAloneDampsNothing) {
  EXPECT_EQ(scene_with("*DAMPING_GLOBAL\n0,5.\n").damping.mass, 5);
  EXPECT_EQ(scene_with("*DAMPING_GLOBAL\n0,5.,2.,2.,2.,1.,1.,1.\n").damping.mass, 10);
  const std::string turning = "*DAMPING_GLOBAL\n0,5.,0,0,0,0,0,1.\n";
  EXPECT_EQ(scene_with(turning).damping.mass, 0);
  EXPECT_THAT(told(turning), Contains(HasSubstr("*DAMPING_GLOBAL: VALDMP")));
}

TEST_F(DeckCards, APartThatNothingUsesRefusesNothing) {
  const std::string unused = "*PART\nshell\n9,9,9,9,9\n*SECTION_SHELL\n9,2\n*MAT_NULL\n9,1.\n*EOS_IDEAL_GAS\n9\n";
  EXPECT_EQ(error(cube + elastic + ends + unused), no_error);
  std::string with_state = cube;
  with_state.replace(with_state.find("\n1,1,1\n"), 7, "\n1,1,1,9\n");
  EXPECT_THAT(error(with_state + elastic + ends + "*EOS_IDEAL_GAS\n9\n"),
              testing::AllOf(HasSubstr("equation of state (EOSID)"), HasSubstr("*EOS_IDEAL_GAS")));
}

/// Two decks in one file, say: the program that they are for reads to the first *END, too.
TEST_F(DeckCards, WhatStandsBehindTheEndIsTold) {
  const std::string deck = cube + elastic + ends + "*END\n";
  const auto told = testing::Contains(HasSubstr("what stands behind *END"));
  EXPECT_THAT(translate(deck + "$ end\n\n  \r\n").understood, testing::Not(told));
  EXPECT_THAT(translate(deck + "$ end\n*CONTROL_TERMINATION\n7.\n").understood, told);
}

TEST_F(DeckCards, TetrahedraHaveFormsOfTheirOwn) {
  std::string tetrahedra = cube + elastic + ends;
  const auto at = tetrahedra.find("*ELEMENT_SOLID");
  tetrahedra = tetrahedra.substr(0, at) + "*ELEMENT_SOLID\n1,1,1,2,4,5,5,5,5,5\n" +
               tetrahedra.substr(tetrahedra.find('*', at + 1));
  EXPECT_EQ(error(tetrahedra), no_error);
  EXPECT_THAT(translate(tetrahedra).understood,
              Contains(HasSubstr("1 tetrahedron with volumes averaged over nodes, as ELFORM 13")));
}

TEST_F(DeckCards, WedgesHaveFormsOfTheirOwn) {
  const auto deck = [](const std::string& form, const std::string& nodes) {
    return "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n5,1,0,1\n6,0,1,1\n*ELEMENT_SOLID\n1,1\n" + nodes +
           "\n*PART\none\n1,1,1\n*SECTION_SOLID\n1," + form + "\n" + elastic + ends;
  };
  for (const char* form : {"15", "115", "1"}) {
    EXPECT_EQ(error(deck(form, "1,2,3,3,4,5,6,6")), no_error);
    EXPECT_THAT(translate(deck(form, "1,2,3,3,4,5,6,6")).understood,
                Contains(HasSubstr("1 wedge with volumes averaged over nodes")));
  }
  EXPECT_THAT(error(deck("15", "1,2,3,3,4,4,4,4")), HasSubstr("*SECTION_SOLID with ELFORM 15"));
}

TEST_F(DeckCards, TetrahedraOfTenNodesHaveFormsOfTheirOwn) {
  const auto deck = [](const std::string& form, const std::string& more = "") {
    return "*NODE\n" + ten_nodes_lines(",") + "*ELEMENT_SOLID\n1,1\n" + joined(keyword_ten_nodes[0], ",") + "\n2,1\n" +
           joined(keyword_ten_nodes[1], ",") + "\n*PART\ntwo\n1,1,1\n*SECTION_SOLID\n1," + form + "\n" + more +
           elastic + ends;
  };
  for (const char* form : {"16", "17", "1"}) {
    EXPECT_EQ(error(deck(form)), no_error);
    EXPECT_EQ(error_in_cards(deck(form)), no_error);
    EXPECT_THAT(translate(deck(form)).understood,
                testing::IsSupersetOf({HasSubstr("2 tetrahedra of ten nodes, each as eight of four nodes"),
                                       HasSubstr("16 tetrahedra with volumes averaged over nodes, as ELFORM 13")}));
  }
  EXPECT_THAT(error(deck("13")), HasSubstr("*SECTION_SOLID with ELFORM 13 (16 elements, first in deck.k:24): give 16"));
  std::string of_cube = cube + elastic + ends;
  of_cube.replace(of_cube.find("*SECTION_SOLID\n1,1"), 18, "*SECTION_SOLID\n1,16");
  EXPECT_THAT(error(of_cube), HasSubstr("*SECTION_SOLID with ELFORM 16 (deck.k:"));
  EXPECT_EQ(scene(deck("16", "*DATABASE_HISTORY_SOLID\n2\n")).probes.size(), 1u);
  // A face is pressed on its four triangles; what is one of them already stays so.
  const std::string pressed = "*DEFINE_CURVE\n1\n0,1\n1,1\n*LOAD_SEGMENT\n1,1.,0,1,3,2,2\n1,1.,0,2,25,24,24\n";
  const Scene s = scene(deck("16", pressed));
  EXPECT_THAT(s.pressures.at(0).corners,
              ElementsAre(ElementsAre(1, 13, 12, 12), ElementsAre(13, 3, 23, 23), ElementsAre(12, 23, 2, 2),
                          ElementsAre(13, 23, 12, 12), ElementsAre(2, 25, 24, 24)));
  EXPECT_EQ(error_in_cards(deck("16", pressed)), no_error);
}

TEST_F(DeckCards, FacesWhoseNormalPointsInwardsAreTold) {
  const std::string curve = "*DEFINE_CURVE\n1\n0,1\n1,1\n";
  const auto reversed =
      Contains(testing::AllOf(HasSubstr("*LOAD_SEGMENT"), HasSubstr("of 1 face ("), HasSubstr("would pull")));
  EXPECT_THAT(told(curve + "*LOAD_SEGMENT\n1,1.,0,5,6,7,8\n1,1.,0,1,4,3,2\n"), Not(reversed));
  EXPECT_THAT(told(curve + "*LOAD_SEGMENT\n1,1.,0,5,6,7,8\n1,1.,0,1,2,3,4\n"), reversed);
  EXPECT_THAT(told(curve + "*LOAD_SEGMENT_SET\n9,1\n*SET_SEGMENT\n9\n5,6,7,8\n8,7,3,4\n"), Not(reversed));
  EXPECT_THAT(told(curve + "*LOAD_SEGMENT_SET\n9,1\n*SET_SEGMENT\n9\n5,6,7,8\n4,3,7,8\n"), reversed);
}

TEST_F(DeckCards, FacesOfAllCardsAreToldInOneLine) {
  const auto lines = told(
      "*DEFINE_CURVE\n1\n0,1\n1,1\n*LOAD_SEGMENT\n1,1.,0,1,2,3,4\n*LOAD_SEGMENT\n1,1.,0,8,7,6,5\n1,2.,0,1,2,3,4\n");
  EXPECT_EQ(std::ranges::count_if(lines, [](const std::string& line) { return line.find("would pull") != line.npos; }),
            1);
  EXPECT_THAT(lines, Contains(HasSubstr("*LOAD_SEGMENT: the order of N1 to N4 of 3 faces (")));
}

TEST_F(DeckCards, AConstraintOfNoDirectionIsToldSo) {
  const auto lines = told("*BOUNDARY_SPC_NODE\n1,0,0,0,0,0,0,0\n2,0,0,0,0,0,0,0\n3,0,1\n");
  EXPECT_THAT(lines, Contains(testing::AllOf(HasSubstr("not used: *BOUNDARY_SPC_NODE (2 times, first in "),
                                             HasSubstr("it holds no direction of a node of a solid"))));
  EXPECT_THAT(lines, Not(Contains(HasSubstr("NID"))));
}

TEST_F(DeckCards, ARangeOfPartsMayHaveNumbersWithoutAny) {
  const std::string touching = "*SET_PART_LIST_GENERATE\n5\n7,9,1,3\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n5,0,2,0\n\n\n";
  EXPECT_THAT(told(touching),
              Contains(testing::AllOf(HasSubstr("not used: *SET_PART_LIST_GENERATE: B1BEG to B1END, 7 to 9"),
                                      HasSubstr("no part with solids has a number in between"))));
  EXPECT_EQ(scene_with(touching).contact.method, ContactMethod::pinball);
  EXPECT_THAT(error(cube + elastic + ends +
                    "*SET_PART_LIST_GENERATE\n5\n7,9\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n5,0,2,0\n\n\n"),
              HasSubstr("with a side that has no parts with solids"))
      << "a set of none is refused where it is used";
}

TEST_F(DeckCards, ElementsOfUsersAreRefusedInOneSentence) {
  std::string of_users = cube;
  const std::size_t at = of_users.find("*SECTION_SOLID"), end = of_users.find('*', at + 1);
  of_users.replace(at, end - at, "*SECTION_SOLID\n1,101\n2,0,0,0,9,0\n0.1,0.2,0.3,1.\n0.1,0.2,0.3,1.\n1.\n2.\n2,1\n");
  EXPECT_EQ(error(of_users + elastic + ends),
            "deck.k: cannot be run, for this version has not:\n"
            "  *SECTION_SOLID with ELFORM 101 (deck.k:15): an element that users have written: give 1 or 2");
}

TEST_F(DeckCards, FormsOfFullIntegrationHaveAssumedStrains) {
  for (const char* form : {"2", "-1", "-2", "3", "18"}) {
    std::string deck = cube;
    deck.replace(deck.find("*SECTION_SOLID\n1,1"), 18, std::string("*SECTION_SOLID\n1,") + form);
    EXPECT_EQ(scene(deck + elastic + ends).element.hourglass, HourglassControl::assumed_strain) << form;
    EXPECT_THAT(translate(deck + elastic + ends).understood,
                Contains(HasSubstr(std::string("ELFORM ") + form + ", full integration: elements of assumed strain")));
  }
}

TEST_F(DeckCards, MaterialsThatAreRefusedAreThere) {
  EXPECT_THAT(error(cube + "*MAT_SOIL_AND_FOAM\n1,1.\n" + ends), testing::Not(HasSubstr("has the number")));
}

TEST_F(DeckCards, SensorsEndNoRun) {
  const std::string sensors = "*SENSOR_DEFINE_NODE_SET\n1,1,0,Y,,ACC,AVG\n*SENSOR_SWITCH\n1,,1,GT,7.0\n";
  EXPECT_THAT(translate(cube + elastic + ends + "*TERMINATION_NODE\n5,1,2.\n*CONTROL_STRUCTURED\n").ignored,
              testing::IsSupersetOf({HasSubstr("*TERMINATION_NODE ("), HasSubstr("*CONTROL_STRUCTURED (")}));
  EXPECT_THAT(translate(cube + elastic + ends + sensors + "*TERMINATION_SENSOR\n1\n").ignored,
              testing::IsSupersetOf({HasSubstr("*TERMINATION_SENSOR ("), HasSubstr("*SENSOR_SWITCH ("),
                                     HasSubstr("*SENSOR_DEFINE_NODE_SET (")}));
  EXPECT_THAT(error(cube + elastic + ends + sensors + "*SENSOR_CONTROL\n1\n"), HasSubstr("*SENSOR_CONTROL"));
}

/// As preprocessors write it, with its defaults.
TEST_F(DeckCards, RelaxationThatIsOffIsNone) {
  const std::string card = "*CONTROL_DYNAMIC_RELAXATION\n250,0.001,0.995,";
  EXPECT_EQ(error(cube + elastic + ends + card + ",,0,0.04,0\n"), no_error);
  EXPECT_EQ(error(cube + elastic + ends + card + ",,0,0.04,-999\n"), no_error);
  EXPECT_THAT(error(cube + elastic + ends + card + ",,0,0.04,1\n"),
              HasSubstr("*CONTROL_DYNAMIC_RELAXATION with IDRFLG 1 (deck.k:"));
  EXPECT_THAT(translate(cube + elastic + ends + card + "1.,0.5\n").understood,
              Contains(testing::AllOf(HasSubstr("DRTERM"), HasSubstr("nothing relaxes before the run"))));
}

TEST_F(DeckCards, CurvesByOtherMeansAreRefusedWhereSomethingNamesThem) {
  const std::string curve = "*DEFINE_CURVE_FUNCTION\n7\n2.*TIME\n", load = "*LOAD_NODE_POINT\n5,3,7\n";
  EXPECT_THAT(translate(cube + elastic + ends + curve).ignored, Contains(HasSubstr("*DEFINE_CURVE_FUNCTION (")));
  EXPECT_THAT(error(cube + elastic + ends + curve + load), HasSubstr("no *DEFINE_CURVE has the number 7"));
}

/// A solid has another corner of its triangle twice than the card.
TEST_F(DeckCards, TrianglesWhoseNormalPointsInwardsAreTold) {
  std::string wedge = cube;
  wedge.replace(wedge.find("10,1,1,2,3,4,5,6,7,8"), 20, "10,1,1,1,2,3,5,5,6,7");
  const auto of = [&](const std::string& corners) {
    return translate(wedge + elastic + ends + "*DEFINE_CURVE\n1\n0,1\n1,1\n*LOAD_SEGMENT\n1,1.,0," + corners + '\n')
        .understood;
  };
  const auto reversed = Contains(HasSubstr("*LOAD_SEGMENT: the order of N1 to N4 of 1 face ("));
  EXPECT_THAT(of("5,6,7"), Not(reversed));
  EXPECT_THAT(of("7,6,5"), reversed);
  EXPECT_THAT(of("1,2,3,3"), reversed);
}

TEST_F(DeckCards, ASecondLineOfWhatIsRefusedIsNoOtherCard) {
  const std::string curve = "*DEFINE_CURVE\n1\n0,1\n1,1\n";
  EXPECT_THAT(
      error(cube + elastic + ends + curve + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,9,0,1\n0.5,0.5\n5,1,4,1\n0.5\n"),
      testing::AllOf(HasSubstr("with DOF 9"), HasSubstr("with VAD 4"), Not(HasSubstr("besides"))));
}

TEST_F(DeckCards, ThatTheLastInitialVelocityCountsIsTold) {
  const std::string generated = "*INITIAL_VELOCITY_GENERATION\n1,2,0.,1.\n\n",
                    of_node = "*INITIAL_VELOCITY_NODE\n1,2.\n";
  const auto is_told = Contains(HasSubstr("the last one in the deck counts"));
  EXPECT_THAT(told(generated + "*INITIAL_VELOCITY\n\n0.,0.,2.\n"), is_told);
  EXPECT_THAT(told(of_node + of_node), Not(is_told));
}

TEST_F(DeckCards, VelocitiesOfNodesCountBeforeThoseOfSets) {
  const std::string of_all = "*INITIAL_VELOCITY\n\n0.,0.,2.\n", of_node = "*INITIAL_VELOCITY_NODE\n3,0.,7.,0.\n";
  for (const std::string& both : {of_all + of_node, of_node + of_all}) {
    const auto model = build_model<double>(scene(cube + elastic + ends + both));
    for (std::size_t n = 0; n < 8; ++n) {
      const double* v = model.nodes.velocity_of(model.node_of_scene_node[n]);
      const Point expected = n == 2 ? Point{0, 7, 0} : Point{0, 0, 2};
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(v[k], expected[k]) << both;
    }
  }
}

TEST_F(DeckCards, TheWidthOfColumnsMayStandBehindABlank) {
  std::string wide = "*NODE %\n";
  for (int i = 1; i <= 8; ++i) {
    const int corner = (i - 1) % 4;
    wide += fmt::format("{:10d}{:16d}{:16d}{:16d}\n", i, corner == 1 || corner == 2 ? 1 : 0, corner >= 2 ? 1 : 0,
                        i > 4 ? 1 : 0);
  }
  const std::string rest = cube.substr(cube.find("*ELEMENT"));
  EXPECT_DOUBLE_EQ(build_model<double>(scene(wide + rest + elastic + ends)).element_mass[0], 7.85e-9);
}

/// Fields between blanks are in the wrong columns: "1 1 1 0.12" is no set, also where nobody would ask for it.
TEST_F(DeckCards, WhatIsNoNumberIsAnErrorAlsoWhereItIsNotUsed) {
  const std::string curve = "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n";
  EXPECT_THAT(error(cube + elastic + ends + curve + "*LOAD_NODE_SET\n1 1 1 0.125\n"),
              HasSubstr("deck.k:27: *LOAD_NODE_SET: NSID: expected a number, got \"1 1 1 0.12\""));
  EXPECT_THAT(error(cube + elastic + ends + "*CONTROL_CONTACT\n0.1,x\n"),
              HasSubstr("*CONTROL_CONTACT: RWPNAL: expected a number, got \"x\""));
}

TEST_F(DeckCards, WhatNothingNamesIsReportedOnceForEachKeyword) {
  const std::string unnamed =
      "*DEFINE_CURVE\n7\n0.,1.\n1.,1.\n*DEFINE_CURVE\n8\n0.,1.\n1.,1.\n*DEFINE_VECTOR\n7,0,0,0,1,0,0\n"
      "*DEFINE_COORDINATE_VECTOR\n7,1,0,0,0,1,0\n*SECTION_SOLID\n7,1\n*PART\nempty\n7,1,1\n";
  const auto lines = translate(cube + elastic + ends + unnamed).understood;
  const auto told = [&](const std::string& what) {
    return testing::Matches(Contains(HasSubstr("not used: " + what)))(lines);
  };
  EXPECT_TRUE(told("*DEFINE_CURVE that nothing of what is read names (2 times, first in "));
  for (const char* keyword : {"*DEFINE_VECTOR", "*DEFINE_COORDINATE_VECTOR", "*SECTION_SOLID"})
    EXPECT_TRUE(told(std::string(keyword) + " that nothing of what is read names")) << keyword;
  EXPECT_TRUE(told("*PART without solids"));
  const std::string named = "*LOAD_NODE_SET\n3,1,7,1.\n*DEFINE_CURVE\n7\n0.,1.\n1.,1.\n";
  EXPECT_THAT(translate(cube + elastic + ends + set_of_top + named).understood, Not(Contains(HasSubstr("not used"))));
}

TEST_F(DeckCards, OfSeveralVelocitiesOfANodeTheLastOneCounts) {
  for (const std::string first : {"-7.", "-9."}) {
    const std::string last = first == "-7." ? "-9." : "-7.";
    const std::string cards = "*INITIAL_VELOCITY_NODE\n5,0.,0.," + first + "\n5,0.,0.," + last + "\n";
    const Scene s = scene(cube + elastic + ends + cards);
    ASSERT_EQ(s.initial_velocities.size(), 1U);
    EXPECT_EQ(s.initial_velocities[0].velocity[2], std::stod(last));
    EXPECT_THAT(translate(cube + elastic + ends + cards).understood,
                Contains(HasSubstr("not used: *INITIAL_VELOCITY_NODE of a node that has another one behind it")));
  }
}

TEST_F(DeckCards, ALastNumberThatNoStepHitsIsReported) {
  const auto generated = [](const char* numbers) {
    return fmt::format("*SET_NODE_LIST_GENERATE_INCREMENT\n9\n{}\n", numbers);
  };
  EXPECT_THAT(told(generated("1,8,3")), Contains(HasSubstr("): from 1 in steps of 3 it ends at 7, 8 is not hit")));
  for (const char* numbers : {"1,7,3", "1,8,1", "5,5,3"})
    EXPECT_THAT(told(generated(numbers)), Not(Contains(HasSubstr("is not hit")))) << numbers;
}

}  // namespace
}  // namespace pinball::test::deck_cards_test
