#include <fmt/format.h>
#include <gtest/gtest.h>

#include <solver/formats/lsdyna/layouts/keyword_cards.hpp>

#include "fields_page.hpp"

/// docs/cards.md shows the table of cards. PINBALL_FIX_PAGES=1 in the environment writes it anew.
namespace pinball::test::cards_page_test {
namespace {

std::string page_text() {
  std::string text =
      "# Fields of the cards of LS-DYNA decks\n\n"
      "All cards that are read, by the table that reads them (`solver/formats/lsdyna/layouts/`);\n"
      "`tests/formats/lsdyna/cards_page_test.cpp` makes this page. Behind a field stands its default "
      "where that is not 0 or blank,\n"
      "in parentheses how many columns it has where those are not 10. What a card says other than the "
      "default of a field that is\n"
      "not used is reported by the name of the field, with the reason, and of one that is refused it ends "
      "the program with all else\n"
      "that is refused. `tests/formats/lsdyna/every_field_test.cpp` sets each field to something else:"
      " the scene or the mesh\n"
      "changes, or a sentence names it.\n"
      "\n"
      "| keyword | line | used | reported | refused |\n|---|---|---|---|---|\n";
  const auto& table = keyword_cards();
  for (std::size_t first = 0, next = 0; first < table.size(); first = next) {
    std::string keywords;
    for (next = first; next < table.size() && table[next].lines == table[first].lines; ++next) {
      const std::string form = table[next].form.empty() ? "" : fmt::format(" ({})", table[next].form);
      keywords += fmt::format("{}`{}`{}", next == first ? "" : ", ", table[next].keyword, form);
    }
    for (std::size_t line = 0; line < table[first].lines.size(); ++line) {
      const CardLayout* layout = table[first].lines[line];
      if (layout == nullptr) continue;
      text += row_of(keywords, line + 1, *layout);
      keywords.clear();
    }
  }
  return text;
}

TEST(KeywordCards, AreThoseOfThePage) { expect_page("cards.md", page_text()); }

}  // namespace
}  // namespace pinball::test::cards_page_test
