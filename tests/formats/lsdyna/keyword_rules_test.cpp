#include <algorithm>

#include <solver/formats/lsdyna/cards/keyword_rules.hpp>

#include "rules_page.hpp"

namespace pinball::test::keyword_rules_test {
namespace {

TEST(KeywordRules, AreThoseOfTheDocumentation) { expect_rows(halves_of_page().first, keyword_rules()); }

TEST(KeywordRules, TheLongestNameThatFitsCounts) {
  EXPECT_EQ(rule_of("DATABASE_GLSTAT")->treatment, Treatment::done);
  EXPECT_EQ(rule_of("DATABASE_ABSTAT")->treatment, Treatment::ignored);
  EXPECT_EQ(rule_of("SET_NODE_LIST_GENERATE")->treatment, Treatment::mesh);
  EXPECT_EQ(rule_of("ELEMENT_SOLID_ORTHO"), nullptr);
  EXPECT_EQ(rule_of(keyword_alias("MAT_024"))->name, std::string("MAT_PIECEWISE_LINEAR_PLASTICITY"));
}

/// The page lists, in the paragraph on units, what may stand in an included file of others.
TEST(KeywordRules, ThoseOfOtherUnitsAreInTheDocumentation) {
  const std::string page = halves_of_page().first;
  const std::size_t begin = page.find("Other units."), end = page.find("\n\n", begin);
  ASSERT_NE(begin, std::string::npos);
  const std::string paragraph = page.substr(begin, end - begin);
  std::size_t named = 0;
  for (const KeywordRule& rule : keyword_rules()) {
    if (!rule.in_other_units) continue;
    EXPECT_NE(paragraph.find(fmt::format("`{}`", rule.name)), std::string::npos) << rule.name;
    ++named;
  }
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(paragraph, '`')), 2 * named);
}

}  // namespace
}  // namespace pinball::test::keyword_rules_test
