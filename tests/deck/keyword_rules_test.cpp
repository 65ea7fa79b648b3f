#include <solver/deck/keyword_rules.hpp>

#include "rules_page.hpp"

namespace pinball::test {
namespace {

TEST(KeywordRules, AreThoseOfTheDocumentation) { expect_rows(halves_of_page().first, keyword_rules()); }

TEST(KeywordRules, TheLongestNameThatFitsCounts) {
  EXPECT_EQ(rule_of("DATABASE_GLSTAT")->treatment, Treatment::done);
  EXPECT_EQ(rule_of("DATABASE_ABSTAT")->treatment, Treatment::ignored);
  EXPECT_EQ(rule_of("SET_NODE_LIST_GENERATE")->treatment, Treatment::mesh);
  EXPECT_EQ(rule_of("ELEMENT_SOLID_ORTHO"), nullptr);
  EXPECT_EQ(rule_of(keyword_alias("MAT_024"))->name, std::string("MAT_PIECEWISE_LINEAR_PLASTICITY"));
}

}  // namespace
}  // namespace pinball::test
