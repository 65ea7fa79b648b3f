#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <solver/base/error.hpp>
#include <solver/formats/deck/expression.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <solver/formats/lsdyna/scan/keyword_deck.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

namespace pinball::test::keyword_deck_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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

constexpr CardLayout some{layout::whole("MID").always().from(0, 2), layout::number("RO"), layout::number("E", 7),
                          layout::number("PR").always(), layout::number("MORE", 1)};

TEST(DeckFields, AreColumnsOrStandBetweenCommas) {
  const Parameters none;
  const DeckPlace place{std::make_shared<const std::string>("a.k"), 3};
  const Card columns{"         1 1.862E+01-1.170E+00      0.22", place};
  EXPECT_EQ(Fields(columns, none, some).integer("MID"), 1);
  EXPECT_EQ(Fields(columns, none, some).number("E"), -1.17);
  const Card commas{"1, 18.62 ,,0.22", place};
  EXPECT_EQ(Fields(commas, none, some).number("RO"), 18.62);
  EXPECT_EQ(Fields(commas, none, some).number("E"), 7.0);
  EXPECT_EQ(Fields(commas, none, some).number("PR"), 0.22);
  EXPECT_EQ(Fields(commas, none, some).number("MORE"), 1.0);
}

TEST(DeckFields, AnErrorNamesFileLineFieldAndText) {
  const Parameters none;
  const DeckPlace place{std::make_shared<const std::string>("a.k"), 3};
  const Card card{"         1      oops", place};
  EXPECT_EQ(error_of([&] { Fields(card, none, some).number("RO"); }),
            "a.k:3: RO (field 2): expected a number, got \"oops\"");
  EXPECT_EQ(error_of([&] { Fields(card, none, some).number("PR"); }),
            "a.k:3: PR (field 4): expected a number, got nothing");
  const Card spilled{"         1     1.0E-3", place}, apart{"         1     1.0E- 3", place};
  EXPECT_EQ(
      error_of([&] { Fields(spilled, none, some).number("RO"); }),
      "a.k:3: RO (field 2): expected a number, got \"1.0E-\" of 1.0E-3, which goes on behind the columns of the field");
  EXPECT_EQ(error_of([&] { Fields(apart, none, some).number("RO"); }),
            "a.k:3: RO (field 2): expected a number, got \"1.0E-\"");
  EXPECT_EQ(error_of([&] {
              Fields(Card{" ,1", place}, none, some).integer("MID");
            }),
            "a.k:3: MID (field 1): expected a whole number, got nothing");
  EXPECT_EQ(error_of([&] {
              Fields(Card{"3", place}, none, some).integer("MID");
            }),
            "a.k:3: MID: expected 0 to 2, got 3");
}

TEST(DeckNumber, AWholeNumberBeyondAllMeshesIsNone) {
  EXPECT_EQ(deck_integer("9000000000000000"), 9000000000000000);
  EXPECT_FALSE(deck_integer("9223372036854775807"));
}

TEST(DeckFields, ATabBetweenColumnsIsRefused) {
  const Parameters none;
  const DeckPlace place{std::make_shared<const std::string>("a.k"), 3};
  EXPECT_EQ(error_of([&] {
              Fields(Card{"         1\t 7.85", place}, none, some);
            }),
            "a.k:3: there is a tab in a card of columns: expected blanks, or commas between the fields");
  EXPECT_EQ(Fields(Card{"         1 \t ", place}, none, some).integer("MID"), 1) << "behind the last field";
  EXPECT_EQ(Fields(Card{"1,\t2", place}, none, some).number("RO"), 2);
}

TEST(DeckExpression, FollowsTheRulesOfArithmetic) {
  const auto value_of = [](std::string_view name) { return ExpressionNumber{name == "a" ? 3.0 : 0.0}; };
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

/// As in Fortran: a division of whole numbers leaves out the rest.
TEST(DeckExpression, DividesWholeNumbersWithoutTheRest) {
  const auto value = [](std::string_view text) {
    return evaluate_expression(text, [](std::string_view name) {
      return name == "n" ? ExpressionNumber{7, true} : ExpressionNumber{7};
    });
  };
  EXPECT_EQ(value("2/5"), 0.0);
  EXPECT_EQ(value("2.0/5"), 0.4);
  EXPECT_EQ(value("2/5."), 0.4);
  EXPECT_EQ(value("(0-7)/2"), -3.0);
  EXPECT_EQ(value("3*7/2 + 1.0"), 11.0);
  EXPECT_EQ(value("n/2"), 3.0);
  EXPECT_EQ(value("a/2"), 3.5);
  for (const char* whole : {"nint(6.6)", "mod(15,8)", "max(7,4)", "abs(0-7)", "sign(7,1)", "int(7.9)", "7**1"})
    EXPECT_EQ(value(std::string(whole) + "/2"), 3.0) << whole;
  for (const char* real : {"sqrt(49)", "float(7)", "aint(7.5)", "mod(15.,8)", "7e0", "7**1."})
    EXPECT_EQ(value(std::string(real) + "/2"), 3.5) << real;
  EXPECT_EQ(value("10.**-3"), 1e-3);
  EXPECT_THROW(value("10**-3"), std::invalid_argument) << "0 in Fortran";
}

TEST(DeckExpression, TakesManyTermsAndNumbersOfAllForms) {
  const auto none = [](std::string_view) { return ExpressionNumber{}; };
  std::string terms;
  for (int i = 0; i < 100'000; ++i) terms += "1+";
  EXPECT_EQ(evaluate_expression(terms + "1", none), 100'001.0);
  EXPECT_THROW(evaluate_expression(terms, none), std::invalid_argument);
  EXPECT_EQ(evaluate_expression("1e2+1.5E-1-.25+2.", none), 101.9);
  EXPECT_EQ(evaluate_expression("1e+2*2-1", none), 199.0);
  EXPECT_THROW(evaluate_expression("1e", none), std::invalid_argument);
  EXPECT_THROW(evaluate_expression("1..2", none), std::invalid_argument);
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

TEST(KeywordDeck, ReadsLinesOfAllSystems) {
  const std::string unix_lines = "*KEYWORD\n*TITLE\na\n*PART\nb\n  1";
  const KeywordDeck expected = parse_keyword_deck(unix_lines, "a.k");
  for (const std::string end : {"\r\n", "\r", "\r\r\n"}) {
    std::string text = "\xEF\xBB\xBF" + unix_lines;
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + end.size()))
      text.replace(at, 1, end);
    const KeywordDeck deck = parse_keyword_deck(text, "a.k");
    ASSERT_EQ(names_of(deck), names_of(expected));
    Cards cards(deck.blocks[1]);
    EXPECT_EQ(cards.next()->text, "b");
    const auto last = cards.next();
    ASSERT_TRUE(last);
    EXPECT_EQ(last->text, "  1");
    EXPECT_EQ(last->place.line, 6);
  }
}

TEST(KeywordDeck, AKeywordMayHaveOtherColumnsThanItsFile) {
  const auto wide = [](const std::string& text) {
    std::vector<bool> all;
    for (const KeywordBlock& block : parse_keyword_deck(text, "a.k").blocks) all.push_back(block.wide);
    return all;
  };
  EXPECT_THAT(wide("*KEYWORD 2000000 I10=Y\n*NODE\n*NODE-\n*keyword_id\nproject\n*NODE\n"),
              ElementsAre(true, false, true));
  EXPECT_THAT(wide("*KEYWORD\n*NODE%\n*NODE \n"), ElementsAre(true, false));
  EXPECT_THAT(wide("*KEYWORD I10 =\tY\n*NODE\n"), ElementsAre(true)) << "blanks mean nothing";
}

TEST(KeywordDeck, CardsOfTwentyColumnsAreThoseOfTheFileOrOfAKeyword) {
  const auto twenty = [](const std::string& text) {
    std::vector<bool> all;
    for (const KeywordBlock& block : parse_keyword_deck(text, "a.k").blocks) all.push_back(block.twenty);
    return all;
  };
  EXPECT_THAT(twenty("*KEYWORD LONG=Y\n*NODE\n*NODE-\n*NODE -\n"), ElementsAre(true, false, false));
  EXPECT_THAT(twenty("*KEYWORD LONG = Y\n*NODE\n"), ElementsAre(true));
  EXPECT_THAT(twenty("*KEYWORD LONG=K\n*NODE\n*NODE+\n*NODE +\n"), ElementsAre(false, true, true));
  const KeywordDeck deck = parse_keyword_deck("*KEYWORD LONG=Y\n*PARAMETER\nR speed             300.0\n*NODE\n", "a.k");
  EXPECT_EQ(deck.parameters.value("&speed", deck.blocks[0].place), "300");
  const KeywordDeck named = parse_keyword_deck(
      "*KEYWORD LONG=Y\n*PARAMETER_EXPRESSION\nR speed_of_the_ball 2 +\n                    3\n*NODE\n", "a.k");
  EXPECT_EQ(named.parameters.value("&speed_of_the_ball", named.blocks[0].place), "5");
  EXPECT_EQ(error_of([] { parse_keyword_deck("*KEYWORD LONG=X\n", "a.k"); }),
            "a.k:1: *KEYWORD: expected LONG=Y, LONG=S or LONG=K, got \"LONG=X\"");
}

TEST(KeywordDeck, WhatIsNoDeckIsSaidToBeNone) {
  EXPECT_EQ(error_of([] { parse_keyword_deck("[time]\nend = 1\n", "a.k"); }),
            "a.k:1: expected a keyword such as *KEYWORD, got \"[time]\"");
}

TEST(KeywordDeck, AKeywordBehindBlanksIsRefusedAndNotReadAsData) {
  const auto error = [](const std::string& text) { return error_of([&] { parse_keyword_deck(text, "a.k"); }); };
  EXPECT_EQ(error("*KEYWORD\n*SET_NODE_LIST\n         1\n *BOUNDARY_SPC_SET\n"),
            "a.k:4: a keyword begins in the first column, and blanks stand before *BOUNDARY_SPC_SET");
  EXPECT_EQ(error("\t*KEYWORD\n*NODE\n"),
            "a.k:1: a keyword begins in the first column, and blanks stand before *KEYWORD");
  EXPECT_EQ(error("*KEYWORD\n*NODE\n *END\r\n"),
            "a.k:3: a keyword begins in the first column, and blanks stand before *END");
  EXPECT_EQ(error("*PART\n *PART of a bumper\n*PART\n *** rod\n*PART\n *ROD\n*PART\n *part\n"), "no error") << "titles";
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
  const Card card{"&parts,-&speed,&speed", place};
  EXPECT_EQ(Fields(card, deck.parameters, some).number("RO"), -300.0);
  EXPECT_EQ(Fields(card, deck.parameters, some).integer("MID"), 2);
}

TEST(KeywordDeck, AnExpressionOfWholeParametersIsWhole) {
  const KeywordDeck deck = parse_keyword_deck(
      "*PARAMETER\nI count, 7, R length, 7\n*PARAMETER_EXPRESSION\nR part,count/2\nR size,length/2\n", "a.k");
  const DeckPlace place{std::make_shared<const std::string>("a.k"), 1};
  EXPECT_EQ(deck.parameters.value("&part", place), "3");
  EXPECT_EQ(deck.parameters.value("&size", place), "3.5");
}

TEST(KeywordDeck, AnExpressionThatFailsIsNamedWithItsPlace) {
  EXPECT_THAT(error_of([] { parse_keyword_deck("*PARAMETER_EXPRESSION\nR a,1/0\n", "a.k"); }),
              HasSubstr("a.k:2: parameter a: the value is not finite"));
}

TEST(KeywordDeck, AnExpressionMayStandBehindAComma) {
  const KeywordDeck deck =
      parse_keyword_deck("*PARAMETER_EXPRESSION\nR averylongname, max(2,3)\nR    short max(4,5)\n", "a.k");
  const DeckPlace place{std::make_shared<const std::string>("a.k"), 1};
  EXPECT_EQ(deck.parameters.value("&averylongname", place), "3");
  EXPECT_EQ(deck.parameters.value("&short", place), "5");
}

TEST(KeywordDeck, AParameterHasOneValueInAllOfTheDeck) {
  const auto value = [](const std::string& text) {
    const DeckPlace place{std::make_shared<const std::string>("a.k"), 1};
    return parse_keyword_deck(text, "a.k").parameters.value("&a", place);
  };
  EXPECT_EQ(value("*PARAMETER\nRa,1\n*PARAMETER\nRa,2\n"), "1") << "as LS-DYNA has it by default";
  EXPECT_THAT(parse_keyword_deck("*PARAMETER\nRa,1\n*PARAMETER\nRa,2\n", "a.k").parameters.notes(),
              ElementsAre("a.k:4: parameter a has another value in a.k:2, which holds"));
  EXPECT_EQ(value("*PARAMETER_LOCAL\nRa,1\n*PARAMETER_MUTABLE\nRa,1\n"), "1");
  EXPECT_THAT(error_of([&] { value("*PARAMETER\nRa,1\n*PARAMETER_LOCAL\nRa,2\n"); }), HasSubstr("a.k:4: parameter a"));
  EXPECT_THAT(error_of([&] { value("*PARAMETER_DUPLICATION\n2\n*PARAMETER\nRa,1\n*PARAMETER\nRa,2\n"); }),
              HasSubstr("DFLAG 2 is not read"));
  EXPECT_THAT(error_of([&] { value("*PARAMETER\nIa,1e300\n"); }), HasSubstr("expected a smaller whole number"));
  for (const char* const text : {"fast", "1..2", "300mm"}) {
    for (const char kind : {'R', 'I'}) {
      EXPECT_EQ(error_of([&] { value(std::string("*PARAMETER\n") + kind + "a," + text + '\n'); }),
                std::string("a.k:2: parameter a: expected a number, got \"") + text + '"');
    }
  }
  for (const char* const declaration : {"Xa", "R", "7"}) {
    EXPECT_THAT(error_of([&] { value(std::string("*PARAMETER\n") + declaration + ",1\n"); }),
                HasSubstr("expected R, I or C and the name of a parameter, got"))
        << declaration;
  }
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

class IncludingDeck : public test::FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    std::filesystem::create_directories(folder_ / "parts");
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
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

TEST_F(IncludingDeck, LooksBesideTheIncludingFileAndBesideTheDeck) {
  write("main.k", "*KEYWORD I10=Y\n*INCLUDE\nparts\\inner.k\n*INCLUDE-\nother.k\n");
  write("parts/inner.k", "*INCLUDE\nbeside.k\nother.k\n");
  write("parts/beside.k", "*NODE\n");
  write("other.k", "*PART\n");
  const KeywordDeck deck = read_keyword_deck(path("main.k"));
  EXPECT_THAT(names_of(deck), ElementsAre("*NODE", "*PART", "*PART"));
  EXPECT_TRUE(deck.blocks[0].wide) << "columns are those of the including file";
  EXPECT_FALSE(deck.blocks[2].wide);
}

TEST_F(IncludingDeck, FilesThatIncludeEachOtherTwiceAreStopped) {
  for (int i = 0; i < 40; ++i) write(fmt::format("{}.k", i), fmt::format("*INCLUDE\n{0}.k\n{0}.k\n", i + 1));
  write("40.k", "*NODE\n");
  EXPECT_THAT(error_of([&] { read_keyword_deck(path("0.k")); }), HasSubstr("includes more than 10000 files"));
}

TEST_F(IncludingDeck, FoldersPipesAndDevicesAreNoFiles) {
  std::filesystem::remove(path("pipe"));
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const char* name : {"pipe", "/dev/zero", "/dev/null"}) {
    write("main.k", fmt::format("*KEYWORD\n*INCLUDE\n{}\n", name));
    EXPECT_THAT(error_of([&] { read_keyword_deck(path("main.k")); }),
                testing::AllOf(HasSubstr("main.k:3: *INCLUDE"), HasSubstr("expected a file, got a pipe or a device")))
        << name;
  }
  EXPECT_THAT(error_of([&] { read_keyword_deck(path("pipe")); }), HasSubstr("expected a file, got a pipe"));
  EXPECT_THAT(error_of([&] { read_keyword_deck(path(".")); }), HasSubstr("expected a file, got a folder"));
}

TEST_F(IncludingDeck, AFileThatIsMissingOrIncludesItselfIsAnErrorWithItsPlace) {
  write("main.k", "*KEYWORD\n*INCLUDE\nnone.k\n");
  EXPECT_THAT(error_of([&] { read_keyword_deck(path("main.k")); }), HasSubstr("main.k:3: *INCLUDE"));
  write("self.k", "*KEYWORD\n*INCLUDE\nself.k\n");
  EXPECT_THAT(error_of([&] { read_keyword_deck(path("self.k")); }), HasSubstr("the file includes itself"));
  EXPECT_THAT(error_of([&] { read_keyword_deck(path("absent.k")); }), HasSubstr("absent.k: no such file"));
}

}  // namespace
}  // namespace pinball::test::keyword_deck_test
