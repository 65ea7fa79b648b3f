#include <solver/formats/abaqus/cards/abaqus_rules.hpp>
#include <tests/formats/lsdyna/rules_page.hpp>

namespace pinball::test::abaqus_rules_test {
namespace {

TEST(AbaqusRules, AreThoseOfTheDocumentation) { expect_rows(halves_of_page().second, abaqus_rules()); }

TEST(AbaqusRules, AreFoundWithoutBlanks) {
  EXPECT_STREQ(abaqus_rule_of("SOLIDSECTION")->name, "SOLID SECTION");
  EXPECT_STREQ(abaqus_rule_of("CONTACTCONTROLSASSIGNMENT")->name, "CONTACT CONTROLS*");
  EXPECT_EQ(abaqus_rule_of("SHELLSECTION"), nullptr);
}

}  // namespace
}  // namespace pinball::test::abaqus_rules_test
