#include <fmt/format.h>
#include <gmock/gmock.h>

#include "deck_case.hpp"

/// What no card may say, where it says so, and by the line that does: numbers below zero, times that go back.
namespace pinball::test::deck_bounds_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class DeckBounds : public DeckTest {
 protected:
  /// Of a keyword whose first card is line 23.
  std::string error_of_card(const std::string& keyword, const std::string& card) {
    return error(cube + elastic + ends + keyword + "\n" + card + "\n");
  }
};

TEST_F(DeckBounds, CoefficientsOfElementsAreNotBelowZero) {
  const struct {
    const char *keyword, *card, *field;
  } cases[] = {{"*CONTROL_HOURGLASS", "4,-0.5", "QH"},       {"*CONTROL_BULK_VISCOSITY", "-0.5", "Q1"},
               {"*CONTROL_BULK_VISCOSITY", "1.,-0.5", "Q2"}, {"*HOURGLASS", "1,4,-0.5", "QM"},
               {"*HOURGLASS", "1,4,0.1,0,-0.5", "Q1"},       {"*HOURGLASS", "1,4,0.1,0,1.5,-0.5", "Q2"}};
  for (const auto& [keyword, card, field] : cases) {
    EXPECT_EQ(error_of_card(keyword, card),
              fmt::format("deck.k:23: {}: {}: expected at least 0, got -0.5", keyword, field));
  }
}

TEST_F(DeckBounds, WhatEndsBeforeTheRunIsRefused) {
  const std::string curve = "*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n", none = ": DEATH: expected at least 0, got -1";
  EXPECT_EQ(error_of_card("*BOUNDARY_PRESCRIBED_MOTION_NODE", "1,1,0,1,1.,0,-1.\n" + curve),
            "deck.k:23: *BOUNDARY_PRESCRIBED_MOTION_NODE" + none);
  EXPECT_EQ(error_of_card("*BOUNDARY_SPC_NODE_BIRTH_DEATH", "1,0,1,1,1\n0.,-1."),
            "deck.k:24: *BOUNDARY_SPC_NODE_BIRTH_DEATH" + none);
  EXPECT_EQ(error_of_card("*RIGIDWALL_PLANAR", "0,0,0,0.,0.,-1.\n0.,0.,-1.,0.,0.,1."),
            "deck.k:23: *RIGIDWALL_PLANAR" + none);
  EXPECT_EQ(error(cube + elastic + "*CONTROL_TERMINATION\n1.E-6,-5\n"),
            "deck.k:21: *CONTROL_TERMINATION: ENDCYC: expected at least 0, got -5");
}

TEST_F(DeckBounds, CurvesOfTimeAreNamedByTheirOwnLine) {
  const std::string motion = "*BOUNDARY_PRESCRIBED_MOTION_SET\n3,3,0,9,1.\n";
  const auto deck = [&](const std::string& points) {
    return cube + elastic + ends + set_of_top + "*DEFINE_CURVE\n9\n" + points + motion;
  };
  EXPECT_EQ(error(deck("0.,0.\n1.E-7,1.\n1.E-7,2.\n")),
            "deck.k:26: *DEFINE_CURVE 9: expected times that increase, got 1e-07 after 1e-07");
  EXPECT_EQ(error(deck("1.,0.\n0.,1.\n")), "deck.k:26: *DEFINE_CURVE 9: expected times that increase, got 0 after 1");
  EXPECT_THAT(translate(deck("0.,0.\n1.E-7,1.\n")).understood,
              Contains(HasSubstr("deck.k:26): behind its last point, at 1e-07, it keeps the value 1")));
}

/// OFFA of a curve of time: it is zero up to 0.999 of that.
TEST_F(DeckBounds, CurvesThatAreMovedToLaterTimesBeginWithZero) {
  const std::string rest = "\n0.,10.\n1.E-6,20.\n*BOUNDARY_PRESCRIBED_MOTION_SET\n3,3,0,9,1.\n";
  const auto deck = [&](const std::string& fields) {
    return cube + elastic + ends + set_of_top + "*DEFINE_CURVE\n9,0," + fields + rest;
  };
  const auto table = [&](const std::string& fields) { return scene(deck(fields)).prescribed_velocities.at(0).table; };
  const TimeTable moved = table("2.,1.,2.5E-7");
  EXPECT_THAT(moved.times, ElementsAre(0.0, DoubleEq(0.999 * 5e-7), 5e-7, DoubleEq(2.5e-6)));
  EXPECT_THAT(moved.factors, ElementsAre(0.0, 0.0, 10.0, 20.0));
  EXPECT_THAT(translate(deck("1.,1.,5.E-7")).understood,
              AllOf(Contains(HasSubstr("deck.k:26): OFFA: it is 0 up to 0.999 of 5e-07")),
                    Not(Contains(HasSubstr("before its first point")))));
  EXPECT_THAT(table("1.,1.,-5.E-7").factors, ElementsAre(10.0, 20.0));
  EXPECT_THAT(table("1.,1.,5.E-7,0.,1").factors, ElementsAre(10.0, 20.0)) << "DATTYP 1";
  EXPECT_THAT(translate(deck("1.,1.,5.E-7,0.,1")).understood, Contains(HasSubstr("before its first point")));
}

TEST_F(DeckBounds, IntervalsBelowZeroAreReported) {
  for (const char* keyword : {"*DATABASE_GLSTAT", "*DATABASE_BINARY_D3PLOT"}) {
    const std::string told = fmt::format("{}: DT", keyword), deck = cube + elastic + ends + keyword;
    EXPECT_THAT(translate(deck + "\n-1.E-7\n").understood, Contains(HasSubstr(told))) << keyword;
    EXPECT_THAT(translate(deck + "\n1.E-7\n").understood, Not(Contains(HasSubstr(told)))) << keyword;
    EXPECT_THAT(translate(deck + "\n0.\n").understood, Not(Contains(HasSubstr(told)))) << keyword;
  }
}

/// It would be taken for the line of the number, and what it says be lost.
TEST_F(DeckBounds, ACardInThePlaceOfANumberOrTitleIsNotLost) {
  const std::string alone = ": expected a card behind the line of its number or title";
  const struct {
    const char *keyword, *card;
  } cases[] = {{"*BOUNDARY_SPC_NODE_ID", "1,0,1,1,1"},
               {"*BOUNDARY_SPC_SET_ID", "3,0,1,1,1"},
               {"*BOUNDARY_PRESCRIBED_MOTION_NODE_ID", "1,1,0,1,1."},
               {"*LOAD_NODE_POINT_ID", "1,1,1,1."},
               {"*LOAD_SEGMENT_SET_ID", "1,1,1."},
               {"*CONSTRAINED_JOINT_SPHERICAL_ID", "1,2"},
               {"*SECTION_SOLID_TITLE", "2,1"},
               {"*HOURGLASS_TITLE", "2,4"},
               {"*DEFINE_BOX_TITLE", "2,0.,1.,0.,1.,0.,1."}};
  for (const auto& [keyword, card] : cases)
    EXPECT_EQ(error_of_card(keyword, card), fmt::format("deck.k:23: {}{}", keyword, alone));
  EXPECT_EQ(error_of_card("*BOUNDARY_SPC_NODE_ID", "7,one\n1,0,1,1,1\n8,two"),
            "deck.k:25: *BOUNDARY_SPC_NODE_ID" + alone);
  const std::string two = "*BOUNDARY_SPC_NODE_ID\n7,one\n1,0,1,1,1\n\n2,0,1,0,0\n\n";
  EXPECT_EQ(scene(cube + elastic + ends + two).fixed_constraints.size(), 2U) << "blank lines at the end say nothing";
}

TEST_F(DeckBounds, ACaseThatListsNothingIsTold) {
  const std::string begin = cube + elastic + ends + "*CASE_BEGIN_7\n*INITIAL_VELOCITY\n0\n1.\n*CASE_END_7\n*CASE\n7\n";
  DeckOptions seven;
  seven.chosen_case = 7;
  const auto empty = Contains(EndsWith("; the chosen *CASE lists no numbers (SCID, from its third line on)"));
  EXPECT_THAT(translate(begin + "7\n", seven).understood, empty) << "the second line is a command";
  const TranslatedDeck taken = translate(begin + "\n7\n", seven);
  EXPECT_THAT(taken.understood, Not(empty));
  EXPECT_EQ(read_scene(taken.source(path_)).initial_velocities.size(), 1U);
}

}  // namespace
}  // namespace pinball::test::deck_bounds_test
