#include <solver/formats/radioss/cards/radioss_rules.hpp>
#include <solver/formats/radioss/layouts/radioss_cards.hpp>
#include <solver/formats/radioss/scan/radioss_names.hpp>
#include <tests/formats/lsdyna/rules_page.hpp>

namespace pinball::test::radioss_rules_test {
namespace {

TEST(RadiossRules, AreThoseOfTheDocumentation) { expect_rows(page_of("\n## Radioss input", ""), radioss_rules()); }

TEST(RadiossRules, TheLongestNameThatFitsCounts) {
  EXPECT_STREQ(radioss_rule_of("MAT/LAW42")->name, "MAT/*");
  EXPECT_STREQ(radioss_rule_of("TH/RWALL")->name, "TH/*");
  EXPECT_STREQ(radioss_rule_of("TH/NODE")->name, "TH/NODE");
  EXPECT_EQ(radioss_rule_of("NOTHING"), nullptr);
  EXPECT_EQ(radioss_name("MAT/LAW2"), "MAT/PLAS_JOHNS");
}

TEST(RadiossRules, EachKeywordThatIsDoneHasItsLines) {
  for (const RadiossRule& rule : radioss_rules()) {
    const bool is_read = rule.treatment == Treatment::done || rule.treatment == Treatment::mesh;
    const std::string name = rule.name;
    if (!is_read || name == "TITLE" || name == "TH/PART" || name == "SUBSET") continue;
    const auto is_of = [&](const RadiossCards& cards) { return cards.keyword == name; };
    EXPECT_TRUE(std::ranges::any_of(radioss_cards(), is_of)) << name;
  }
}

}  // namespace
}  // namespace pinball::test::radioss_rules_test
