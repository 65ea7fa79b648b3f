#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>

/// Rules of keywords against the tables of docs/decks.md.
namespace pinball::test {

/// The page up to what is said of Abaqus, and from there on.
inline std::pair<std::string, std::string> halves_of_page() {
  std::ifstream file(PINBALL_SOURCE_DIR "/docs/decks.md");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string page = text.str();
  const std::size_t abaqus = page.find("\n## Abaqus input");
  EXPECT_NE(abaqus, std::string::npos);
  return {page.substr(0, abaqus), abaqus < page.size() ? page.substr(abaqus) : ""};
}

/// Every rule is a row of the page, every row a rule, and no name stands twice.
template <class Rules>
void expect_rows(const std::string& page, const Rules& rules) {
  static const char* const words[] = {"done", "mesh", "ignored", "refused"};
  std::set<std::string> names;
  for (const auto& rule : rules) {
    const std::string row =
        fmt::format("| `{}` | {} | {} |", rule.name, words[static_cast<int>(rule.treatment)], rule.remark);
    EXPECT_NE(page.find(row), std::string::npos) << row;
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
  }
  std::size_t shown = 0;
  for (std::size_t at = page.find("\n| `"); at != std::string::npos; at = page.find("\n| `", at + 1)) ++shown;
  EXPECT_EQ(shown, rules.size());
}

}  // namespace pinball::test
