#include <gmock/gmock.h>

#include <solver/formats/deck/expression.hpp>
#include <solver/scene/given/toml_file.hpp>

#include "abaqus_case.hpp"

/// *PARAMETER of Abaqus input: names between < and >, and the expressions that are their values.
namespace pinball::test::abaqus_parameters_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class AbaqusParametersTest : public AbaqusTest {
 protected:
  static std::string named(const std::string& parameters) {
    return "*PARAMETER\n" + parameters + "*HEADING\nA <cube>\n" + abaqus_cube +
           "** of <nothing>\n*MATERIAL, NAME=<name>\n*DENSITY\n<rho>\n" +
           "*ELASTIC\n <E>, <nu>\n*INITIAL CONDITIONS, TYPE=VELOCITY\ntop, <axis>, -<v>\n" + abaqus_step();
  }
  const std::string all_ =
      " name = 'Steel'  # of the section\n** a comment\n rho = 7.85E-9\n E = 2.1e5\n nu = 3/10.\n axis = 1 + 6/3\n"
      " half_of = E/2\n v = max(0.25, sqrt(half_of/E*2)*2**2)\n";
};

TEST_F(AbaqusParametersTest, StandForTheirValues) {
  const Scene s = scene(named(all_));
  EXPECT_EQ(s.title, "A <cube>");
  EXPECT_EQ(s.materials.at(0).name, "mat_STEEL");
  EXPECT_EQ(s.materials.at(0).density, 7.85e-9);
  EXPECT_DOUBLE_EQ(s.materials.at(0).shear_modulus, 210000. / 2.6);
  EXPECT_EQ(s.initial_velocities.at(0).velocity, (Point{0, 0, -4}));
}

TEST_F(AbaqusParametersTest, GiveTheBitsOfTheirValues) {
  std::string written = named(all_);
  for (const auto& [name, value] : {std::pair{"<name>", "Steel"},
                                    {"<rho>", "7.85E-9"},
                                    {"<E>", "210000"},
                                    {"<nu>", "0.3"},
                                    {"<axis>", "3"},
                                    {"<v>", "4."}})
    written.replace(written.find(name), std::string(name).size(), value);
  const std::string comments = "**\n**\n**\n**\n**\n**\n**\n**\n**\n";  // as many lines
  written.replace(0, written.find("*HEADING"), comments);
  const TranslatedDeck by_name = translate(named(all_)), by_value = translate(written);
  EXPECT_EQ(write_toml(by_name.given->table), write_toml(by_value.given->table));
}

TEST_F(AbaqusParametersTest, AreFoundByTheirNamesAsTheyAreWritten) {
  std::string text = all_;
  text.replace(text.find(" rho ="), 6, " Rho =");
  EXPECT_EQ(error(named(text)), "deck.inp:32: no *PARAMETER before it has the name rho, nearest is Rho");
  EXPECT_THAT(error(named(all_ + "*PARAMETER\n nu = 0.4\n")),
              HasSubstr("deck.inp:11: *PARAMETER: nu has another value in deck.inp:6"));
  EXPECT_THAT(translate(named(all_ + " nu = 0.3\n mu = 1\n")).understood,
              AllOf(Contains(AllOf(HasSubstr("not used: *PARAMETER: mu ("), HasSubstr("deck.inp:11)"))),
                    Not(Contains(HasSubstr(": nu (")))));
  EXPECT_THAT(error("*HEADING\n<E>\n*NODE\n<x, 0., 0.\n"),
              HasSubstr("deck.inp:4: expected the name of a *PARAMETER between < and >, got \"<x, 0., 0."));
}

/// As a program of Python has it, of which public decks make use.
TEST_F(AbaqusParametersTest, OfOneKeywordTheLastValueHolds) {
  const std::string twice = named(all_ + " nu = 0.4\n");
  EXPECT_DOUBLE_EQ(scene(twice).materials.at(0).shear_modulus, 210000. / 2.8);
  EXPECT_THAT(
      translate(twice).understood,
      Contains(AllOf(HasSubstr("*PARAMETER: nu ("), HasSubstr("deck.inp:10) takes"), HasSubstr("deck.inp:6 says"))));
}

TEST_F(AbaqusParametersTest, LinesThatDefineNothingAreErrors) {
  EXPECT_THAT(error(named("rho\n")), HasSubstr("deck.inp:2: *PARAMETER: expected NAME = EXPRESSION, got \"rho\""));
  EXPECT_THAT(error(named("2a = 1\n")), HasSubstr("expected NAME = EXPRESSION"));
  EXPECT_THAT(error(named("a = b\n")), HasSubstr("deck.inp:2: no *PARAMETER before it has the name b"));
  EXPECT_THAT(error(named("a = 1 +\n")), HasSubstr("deck.inp:2: *PARAMETER: a: expected a number"));
  EXPECT_THAT(error(named("a = 1/0.\n")), HasSubstr("*PARAMETER: a: the value is not finite"));
  EXPECT_THAT(error(named("a = 'x'\nb = a + 1\n")), HasSubstr("*PARAMETER: b: expected a number, a is a text"));
  EXPECT_THAT(error(named("a = 'x' + 'y'\n")), HasSubstr("deck.inp:2: *PARAMETER: a: expected a number"))
      << "two texts are not one, x' + 'y";
  std::string dependent = named(all_);
  dependent.insert(dependent.find('\n'), ", DEPENDENT");
  EXPECT_NE(error(dependent), no_error);
}

/// Whole numbers divide in other ways in other versions of Python: that is refused where it matters.
TEST(PythonExpression, FollowsTheRulesOfPython) {
  const auto value_of = [](std::string_view name) {
    return name == "n" ? ExpressionNumber{7, true} : ExpressionNumber{name == "N" ? 0.5 : 0.0};
  };
  const auto value = [&](const char* text) { return evaluate_python(text, value_of); };
  EXPECT_EQ(value("n + N").value, 7.5);
  EXPECT_EQ(value("-n**2").value, -49);
  EXPECT_EQ(value("pow(n, 2) + abs(-3) - int(2.7)").value, 50);
  EXPECT_TRUE(value("pow(n, 2) + abs(-3) - int(2.7)").is_whole);
  EXPECT_FALSE(value("float(n)").is_whole);
  EXPECT_DOUBLE_EQ(value("degrees(radians(30.))").value, 30);
  EXPECT_EQ(value("n/2.").value, 3.5);
  EXPECT_EQ(value("2*n/n").value, 2);
  EXPECT_EQ(value("pow(2, -1)").value, 0.5);
  EXPECT_FALSE(value("pow(2, -1)").is_whole) << "which would be written as 0";
  EXPECT_FALSE(value("max(n, 7.5)").is_whole);
  EXPECT_TRUE(value("min(n, 7.5)").is_whole) << "as Python gives one of them";
  EXPECT_EQ(value("0").value + value("007.").value, 7);
  for (const char* refused : {"n/2", "min(n, 7.5)/2", "010", "n/0", "n^2", "&n", "mod(n, 2)", "nint(2.5)"})
    EXPECT_THROW(value(refused), std::invalid_argument) << refused;
}

}  // namespace
}  // namespace pinball::test::abaqus_parameters_test
