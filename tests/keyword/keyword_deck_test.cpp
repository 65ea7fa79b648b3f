#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <solver/base/error.hpp>
#include <solver/keyword/expression.hpp>
#include <solver/keyword/fields.hpp>
#include <solver/keyword/keyword_deck.hpp>

namespace pinball::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<std::string> names_of(const KeywordDeck& deck) {
  std::vector<std::string> names;
  for (const KeywordBlock& block : deck.blocks) names.push_back(block.star_name());
  return names;
}

TEST(DeckNumber, ReadsWhatDecksWrite) {
  EXPECT_EQ(deck_number("7.34000-4"), 7.34e-4);
  EXPECT_EQ(deck_number("-1.5+3"), -1500.0);
  EXPECT_EQ(deck_number("1.D-3"), 1e-3);
  EXPECT_EQ(deck_number("1.0E+7"), 1e7);
  EXPECT_EQ(deck_number("+5"), 5.0);
  EXPECT_EQ(deck_number(".5"), 0.5);
  for (const char* wrong : {"", "x", "1.5.2", "1 2", "nan", "inf", "1e999", "--1", "1e"}) {
    EXPECT_FALSE(deck_number(wrong)) << wrong;
  }
}

TEST(DeckNumber, ReadsWholeNumbers) {
  EXPECT_EQ(deck_integer("12"), 12);
  EXPECT_EQ(deck_integer("-3"), -3);
  EXPECT_EQ(deck_integer("5."), 5);
  EXPECT_EQ(deck_integer("+7"), 7);
  for (const char* wrong : {"", "5.5", "x", "1e300"}) EXPECT_FALSE(deck_integer(wrong)) << wrong;
}

TEST(DeckFields, AreColumnsOrStandBetweenCommas) {
  const Parameters none;
  const DeckPlace place{std::make_shared<const std::string>("a.k"), 3};
  const Card columns{"         1 1.862E+01-1.170E+00      0.22", place};
  EXPECT_EQ(Fields(columns, none).integer(0, "mid"), 1);
  EXPECT_EQ(Fields(columns, none).number(2, "e"), -1.17);
  const Card commas{"1, 18.62 ,,0.22", place};
  EXPECT_EQ(Fields(commas, none).number(1, "ro"), 18.62);
  EXPECT_EQ(Fields(commas, none).number(2, "e", 7.0), 7.0);
  EXPECT_EQ(Fields(commas, none).number(3, "pr"), 0.22);
  EXPECT_EQ(Fields(commas, none).number(9, "more", 1.0), 1.0);
}

TEST(DeckFields, AnErrorNamesFileLineFieldAndText) {
  const Parameters none;
  const DeckPlace place{std::make_shared<const std::string>("a.k"), 3};
  const Card card{"         1      oops", place};
  EXPECT_EQ(error_of([&] { Fields(card, none).number(1, "ro"); }),
            "a.k:3: ro (field 2): expected a number, got \"oops\"");
  EXPECT_EQ(error_of([&] { Fields(card, none).integer(2, "mid"); }),
            "a.k:3: mid (field 3): expected a whole number, got nothing");
}

TEST(DeckExpression, FollowsTheRulesOfArithmetic) {
  const auto value_of = [](std::string_view name) { return name == "a" ? 3.0 : 0.0; };
  EXPECT_EQ(evaluate_expression("1 + 2*a", value_of), 7.0);
  EXPECT_EQ(evaluate_expression("-a**2", value_of), -9.0);
  EXPECT_EQ(evaluate_expression("2^3^2", value_of), 512.0);
  EXPECT_EQ(evaluate_expression("(1+&a)/2 - max(1, 4, 2)", value_of), -2.0);
  EXPECT_DOUBLE_EQ(evaluate_expression("sin(pi/2) + sqrt(16) + mod(7,4)", value_of), 8.0);
  for (const char* wrong : {"", "1+", "(1", "1 2", "f(1)", "sqrt()", "sqrt(1,2)", "*3"}) {
    EXPECT_THROW(evaluate_expression(wrong, value_of), std::invalid_argument) << wrong;
  }
  EXPECT_THROW(evaluate_expression(std::string(100000, '('), value_of), std::invalid_argument);
}

TEST(KeywordDeck, KnowsNamesOptionsAndComments) {
  const KeywordDeck deck = parse_keyword_deck(
      "$ a comment\n*keyword\n*Set_Node_List_Title\n$\nname\n  1\r\n*ELEMENT_SOLID (ten nodes "
      "format)\n*NODE%\n*END\n*GARBAGE\n",
      "a.k");
  EXPECT_THAT(names_of(deck), ElementsAre("*SET_NODE_LIST_TITLE", "*ELEMENT_SOLID", "*NODE"));
  EXPECT_TRUE(deck.blocks[0].title);
  EXPECT_TRUE(deck.blocks[2].wide);
  EXPECT_EQ(deck.blocks[0].place.text(), "a.k:3");
  Cards cards(deck.blocks[0]);
  EXPECT_EQ(cards.next()->text, "name");
  const auto number = cards.next();
  EXPECT_EQ(number->text, "  1");
  EXPECT_EQ(number->place.line, 6);
  EXPECT_FALSE(cards.next());
}

TEST(KeywordDeck, RefusesLongCards) {
  EXPECT_EQ(error_of([] { parse_keyword_deck("*KEYWORD LONG=Y\n", "a.k"); }),
            "a.k:1: *KEYWORD LONG=Y: cards of twenty columns are not read");
  EXPECT_THAT(error_of([] { parse_keyword_deck("*KEYWORD\n*NODE+\n", "a.k"); }), HasSubstr("a.k:2: *NODE+"));
}

TEST(KeywordDeck, WhatIsNoDeckIsSaidToBeNone) {
  EXPECT_EQ(error_of([] { parse_keyword_deck("[time]\nend = 1\n", "a.k"); }),
            "a.k:1: expected a keyword such as *KEYWORD, got \"[time]\"");
}

TEST(KeywordDeck, ParametersStandForNumbersAndTexts) {
  const KeywordDeck deck = parse_keyword_deck(
      "*PARAMETER\nR speed        300.0I parts            2\nC name,bar\n*PARAMETER_EXPRESSION\nR energy,0.5*speed**2\n"
      "R     long speed\n          +1\n*NODE\n",
      "a.k");
  const DeckPlace place{std::make_shared<const std::string>("a.k"), 1};
  EXPECT_EQ(deck.parameters.value("&speed", place), "300");
  EXPECT_EQ(deck.parameters.value("-&SPEED", place), "-300");
  EXPECT_EQ(deck.parameters.value("&parts", place), "2");
  EXPECT_EQ(deck.parameters.value("&name", place), "bar");
  EXPECT_EQ(deck.parameters.value("&energy", place), "45000");
  EXPECT_EQ(deck.parameters.value("&long", place), "301");
  EXPECT_THAT(error_of([&] { deck.parameters.value("&sped", place); }),
              HasSubstr("a.k:1: no parameter is named sped, nearest is speed"));
  const Card card{"&speed,-&speed,&parts", place};
  EXPECT_EQ(Fields(card, deck.parameters).number(1, "v"), -300.0);
  EXPECT_EQ(Fields(card, deck.parameters).integer(2, "n"), 2);
}

TEST(KeywordDeck, AnExpressionThatFailsIsNamedWithItsPlace) {
  EXPECT_THAT(error_of([] { parse_keyword_deck("*PARAMETER_EXPRESSION\nR a,1/0\n", "a.k"); }),
              HasSubstr("a.k:2: parameter a: the value is not finite"));
}

const char* const cases = R"(*KEYWORD
*TITLE
all
*TITLE CID=1
one
*CASE_BEGIN_2
*NODE
*CASE_END_2
*CASE
       101 NAME

1
*PART
)";

TEST(KeywordDeck, ACaseBringsItsKeywordsAndLeavesOutThoseOfOthers) {
  EXPECT_THAT(names_of(parse_keyword_deck(cases, "a.k")), ElementsAre("*TITLE", "*PART"));
  EXPECT_EQ(parse_keyword_deck(cases, "a.k").left_out_of_case, 2u);
  EXPECT_THAT(names_of(parse_keyword_deck(cases, "a.k", 1)), ElementsAre("*TITLE", "*PART", "*TITLE"));
  EXPECT_THAT(names_of(parse_keyword_deck(cases, "a.k", 101)), ElementsAre("*TITLE", "*PART", "*TITLE"));
  EXPECT_THAT(names_of(parse_keyword_deck(cases, "a.k", 2)), ElementsAre("*TITLE", "*PART", "*NODE"));
  EXPECT_EQ(error_of([] { parse_keyword_deck(cases, "a.k", 7); }), "a.k: --case 7: it has 101, 1, 2");
}

class IncludingDeck : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_ / "parts");
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(IncludingDeck, ReadsFilesWhereTheyAreNamed) {
  write("main.k", "*KEYWORD\n*PART\n*INCLUDE_PATH\nparts\n*INCLUDE\nmesh.k\nother +\n.k\n*TITLE\n*END\n");
  write("parts/mesh.k", "*NODE\n*END\n*GARBAGE\n");
  write("other.k", "*ELEMENT_SOLID\n");
  const KeywordDeck deck = read_keyword_deck(path("main.k"));
  EXPECT_THAT(names_of(deck), ElementsAre("*PART", "*NODE", "*ELEMENT_SOLID", "*TITLE"));
  EXPECT_EQ(deck.files.size(), 3u);
  EXPECT_EQ(deck.blocks[1].place.text(), path("parts/mesh.k") + ":1");
}

TEST_F(IncludingDeck, AFileThatIsMissingOrIncludesItselfIsAnErrorWithItsPlace) {
  write("main.k", "*KEYWORD\n*INCLUDE\nnone.k\n");
  EXPECT_THAT(error_of([&] { read_keyword_deck(path("main.k")); }), HasSubstr("main.k:3: *INCLUDE"));
  write("self.k", "*KEYWORD\n*INCLUDE\nself.k\n");
  EXPECT_THAT(error_of([&] { read_keyword_deck(path("self.k")); }), HasSubstr("the file includes itself"));
  EXPECT_THAT(error_of([&] { read_keyword_deck(path("absent.k")); }), HasSubstr("absent.k: no such file"));
}

}  // namespace
}  // namespace pinball::test
