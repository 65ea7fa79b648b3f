#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "deck_case.hpp"

/// Files of *INCLUDE_TRANSFORM: what goes along with a transformation, and which numbers get which offset.
namespace pinball::test::transformed_files_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class TransformedFile : public DeckTest {
 protected:
  /// A deck that has these cards in a file which is turned, or moved, and more of its own.
  std::string deck(const std::string& cards, const std::string& transformation, const std::string& own = "") {
    std::ofstream(folder_ / "more.k") << "*KEYWORD\n" << cards << "*END\n";
    return cube + elastic + ends + set_of_top + own + "*DEFINE_TRANSFORMATION\n7\n" + transformation +
           "*INCLUDE_TRANSFORM\nmore.k\n\n\n\n7\n";
  }
};

const std::string turned = "ROTATE,0.,0.,1.,0.,0.,0.,90.\n", moved = "TRANSL,5.,0.,0.\n", kept = "TRANSL,0.,0.,0.\n";

TEST_F(TransformedFile, WhatHasDirectionsIsRefusedWhereItIsTurned) {
  for (const std::string cards :
       {"*DEFINE_VECTOR\n4,0.,0.,0.,1.,0.,0.\n", "*DEFINE_COORDINATE_VECTOR\n4,1.,0.,0.,0.,1.,0.\n",
        "*DEFINE_COORDINATE_SYSTEM\n4,0.,0.,0.,1.,0.,0.\n0.,1.,0.\n", "*INITIAL_VELOCITY\n3\n1.,0.,0.\n",
        "*INITIAL_VELOCITY_NODE\n5,1.,0.,0.\n", "*INITIAL_VELOCITY_SET\n3\n1.,0.,0.\n"}) {
    const std::string name = cards.substr(0, cards.find('\n'));
    EXPECT_THAT(error(deck(cards, turned)), HasSubstr(name + " in a file that is transformed (more.k:2)")) << cards;
    EXPECT_EQ(error(deck(cards, moved)), no_error) << cards;
  }
}

TEST_F(TransformedFile, WhatHasPlacesIsRefusedWhereItIsMoved) {
  for (const std::string cards : {"*DEFINE_BOX\n7,0.,1.,0.,1.,0.,1.\n", "*RIGIDWALL_PLANAR\n0\n0.,0.,-1.,0.,0.,0.,0.\n",
                                  "*INITIAL_VELOCITY_GENERATION\n1,2,3.,0.,0.,0.\n0.,0.,0.,0.,0.,1.\n"}) {
    const std::string name = cards.substr(0, cards.find('\n'));
    for (const std::string& transformation : {turned, moved}) {
      EXPECT_THAT(error(deck(cards, transformation)), HasSubstr(name + " in a file that is transformed (more.k:2)"));
    }
    EXPECT_EQ(error(deck(cards, kept)), no_error) << cards;
  }
}

TEST_F(TransformedFile, AxesStayThoseOfTheDeckWhichIsReported) {
  const auto told = [&](const std::string& transformation) {
    return translate(deck("*BOUNDARY_SPC_SET\n3,0,1,0,0\n", transformation)).understood;
  };
  EXPECT_THAT(told(turned), Contains(AllOf(HasSubstr("*BOUNDARY_SPC_SET ("), HasSubstr("does not turn"))));
  EXPECT_THAT(told(moved), Not(Contains(HasSubstr("does not turn"))));
}

TEST_F(TransformedFile, TheOrderOfItsCardsIsReported) {
  const auto told = [&](const std::string& transformation) {
    return translate(deck("*SET_NODE_LIST\n9\n1\n", transformation)).understood;
  };
  EXPECT_THAT(told(turned + moved), Contains(HasSubstr("its 2 cards act one after the other, the first one first")));
  EXPECT_THAT(told(turned), Not(Contains(HasSubstr("one after the other"))));
}

/// IDFOFF of curves and tables, IDDOFF of all else that is defined, IDMOFF also of equations of state.
TEST_F(TransformedFile, CurvesHaveTheOffsetOfFunctions) {
  const auto with = [&](const std::string& cards, const std::string& offsets, const std::string& own) {
    std::ofstream(folder_ / "more.k") << "*KEYWORD\n" << cards << "*END\n";
    return cube + elastic + ends + set_of_top + "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n" + own +
           "*INCLUDE_TRANSFORM\nmore.k\n" + offsets + "\n\n\n\n";
  };
  const std::string curve = "*DEFINE_CURVE\n5\n0.,7.\n1.,7.\n", load = "*LOAD_NODE_POINT\n5,1,5\n",
                    of_both = "0,0,0,0,0,20,10", of_define = "0,0,0,0,0,0,10";
  const Scene inside = scene(with(curve + load, of_both, ""));
  EXPECT_EQ(inside.loads.at(0).table.factors.at(0), 7);
  const Scene outside = scene(with(curve, of_both, "*LOAD_NODE_POINT\n5,1,25\n"));
  EXPECT_EQ(outside.loads.at(0).table.factors.at(0), 7);
  EXPECT_THAT(error(with(curve, of_define, "")), HasSubstr("curve or table 5 is given twice"));
  const std::string vector = "*DEFINE_VECTOR\n4,0.,0.,0.,0.,1.,0.\n",
                    motion = "*BOUNDARY_PRESCRIBED_MOTION_SET\n3,4,0,5,1.,14\n";
  EXPECT_EQ(scene(with(vector, of_both, motion)).prescribed_velocities.at(0).direction, (Point{0, 1, 0}));
  const std::string state = "*EOS_GRUNEISEN\n3,4.E6\n";
  EXPECT_THAT(translate(with(state, "0,0,0,100", "")).understood, Contains(HasSubstr("equation of state 103")));
}

/// Contacts of a file have the numbers of all that has no offset of its own: IDROFF.
TEST_F(TransformedFile, ContactsOfTwoFilesHaveNumbersOfTheirOwn) {
  std::ofstream(folder_ / "more.k") << "*KEYWORD\n*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n3\n0\n\n\n*END\n";
  const std::string head = cube + elastic + ends, file = "*INCLUDE_TRANSFORM\nmore.k\n\n";
  EXPECT_EQ(error(head + file + "100\n\n\n" + file + "200\n\n\n"), no_error);
  EXPECT_THAT(error(head + file + "100\n\n\n" + file + "100\n\n\n"), HasSubstr("contact 103 is given twice"));
}

class LoadedDeck : public DeckTest {};

/// Outside of its points a curve keeps its values: where the run needs that, it is reported.
TEST_F(LoadedDeck, CurvesThatDoNotReachTheEndAreReported) {
  const auto told = [&](const std::string& points, const std::string& load = "*LOAD_NODE_POINT\n5,1,5\n") {
    return translate(cube + elastic + ends + set_of_top + "*DEFINE_CURVE\n5\n" + points + load).understood;
  };
  const auto behind = Contains(HasSubstr("behind its last point, at 5e-07, it keeps the value 2")),
             before = Contains(HasSubstr("before its first point, at 1e-07, it keeps the value 3"));
  EXPECT_THAT(told("0.,0.\n5.E-7,2.\n"), behind);
  EXPECT_THAT(told("1.E-7,3.\n1.,0.\n"), before);
  EXPECT_THAT(told("0.,1.\n1.E-6,2.\n"), Not(Contains(HasSubstr("it keeps"))));
  EXPECT_THAT(told("1.E-7,0.\n5.E-7,0.\n"), Not(Contains(HasSubstr("it keeps")))) << "0 on both sides";
  const std::string motion = "*BOUNDARY_PRESCRIBED_MOTION_SET\n3,1,0,5,1.,0,";
  EXPECT_THAT(told("0.,0.\n5.E-7,2.\n", motion + "4.E-7\n"), Not(Contains(HasSubstr("it keeps")))) << "DEATH";
  EXPECT_THAT(told("0.,0.\n5.E-7,2.\n", motion + "6.E-7\n"), behind);
  EXPECT_THAT(told("0.,0.\n5.E-7,2.\n", motion + "0.,5.E-7\n"), Not(Contains(HasSubstr("it keeps")))) << "BIRTH";
  EXPECT_THAT(told("1.E-7,3.\n1.,0.\n", motion + "0.,5.E-7\n"), before) << "of the curve's own time";
}

TEST_F(LoadedDeck, YieldStressesThatDoNotBeginAtStrainZeroAreReported) {
  const auto told = [&](const std::string& first) {
    return translate(cube + ends +
                     "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.85E-9,210000.,0.3\n0,0,5\n*DEFINE_CURVE\n5\n" + first +
                     ",400.\n0.2,500.\n")
        .understood;
  };
  EXPECT_THAT(told("0.05"), Contains(HasSubstr("before its first plastic strain, 0.05, it keeps the stress 400")));
  EXPECT_THAT(told("0."), Not(Contains(HasSubstr("before its first plastic strain"))));
}

TEST_F(LoadedDeck, PressuresThatArriveBeforeTheStartAreAnError) {
  const std::string curve = "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n", face = ",5,6,7,8\n";
  EXPECT_EQ(error(cube + elastic + ends + curve + "*LOAD_SEGMENT\n5,1.,0." + face), no_error);
  EXPECT_THAT(error(cube + elastic + ends + curve + "*LOAD_SEGMENT\n5,1.,-0.5" + face),
              HasSubstr("*LOAD_SEGMENT: AT: expected at least 0, got -0.5"));
}

/// Of all nodes but a set: bodies that are in it as a whole have only its velocity.
TEST_F(LoadedDeck, VelocityOfAllNodesMayLeaveOutAWholeBody) {
  const std::string all = "*SET_NODE_LIST\n9\n1,2,3,4,5,6,7,8\n*INITIAL_VELOCITY\n0,9\n1.,0.,0.\n2.,0.,0.\n";
  const Scene s = scene(cube + elastic + ends + all);
  ASSERT_EQ(s.initial_velocities.size(), 1u);
  EXPECT_EQ(s.initial_velocities[0].velocity[0], 2);
}

}  // namespace
}  // namespace pinball::test::transformed_files_test
