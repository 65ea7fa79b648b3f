#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include <solver/deck/keyword_rules.hpp>

namespace pinball::test {
namespace {

TEST(KeywordRules, AreThoseOfTheDocumentation) {
  std::ifstream file(PINBALL_SOURCE_DIR "/docs/decks.md");
  std::ostringstream page;
  page << file.rdbuf();
  static const char* const words[] = {"done", "mesh", "ignored", "refused"};
  std::size_t rows = 0;
  for (const KeywordRule& rule : keyword_rules()) {
    const std::string row =
        fmt::format("| `{}` | {} | {} |", rule.name, words[static_cast<int>(rule.treatment)], rule.remark);
    EXPECT_NE(page.str().find(row), std::string::npos) << row;
    ++rows;
  }
  std::size_t shown = 0;
  for (std::size_t at = page.str().find("\n| `"); at != std::string::npos; at = page.str().find("\n| `", at + 1))
    ++shown;
  EXPECT_EQ(shown, rows);
}

TEST(KeywordRules, TheLongestNameThatFitsCounts) {
  EXPECT_EQ(rule_of("DATABASE_GLSTAT")->treatment, Treatment::done);
  EXPECT_EQ(rule_of("DATABASE_ABSTAT")->treatment, Treatment::ignored);
  EXPECT_EQ(rule_of("SET_NODE_LIST_GENERATE")->treatment, Treatment::mesh);
  EXPECT_EQ(rule_of("ELEMENT_SOLID_ORTHO"), nullptr);
  EXPECT_EQ(rule_of(keyword_alias("MAT_024"))->name, std::string("MAT_PIECEWISE_LINEAR_PLASTICITY"));
}

TEST(KeywordRules, NoNameStandsTwice) {
  std::set<std::string> names;
  for (const KeywordRule& rule : keyword_rules()) EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
}

}  // namespace
}  // namespace pinball::test
