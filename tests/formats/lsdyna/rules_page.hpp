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

/// The page from a heading on, or from its begin, up to another one, or to its end.
inline std::string page_of(const std::string& from, const std::string& to) {
  std::ifstream file(PINBALL_SOURCE_DIR "/docs/decks.md");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string page = text.str();
  const std::size_t begin = from.empty() ? 0 : page.find(from), end = to.empty() ? page.size() : page.find(to);
  EXPECT_NE(begin, std::string::npos) << from;
  EXPECT_NE(end, std::string::npos) << to;
  return begin < page.size() && end <= page.size() ? page.substr(begin, end - begin) : "";
}

/// What the page says of LS-DYNA, and what of Abaqus.
inline std::pair<std::string, std::string> halves_of_page() {
  return {page_of("", "\n## Abaqus input"), page_of("\n## Abaqus input", "\n## Radioss input")};
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
