#include <gtest/gtest.h>

#include <solver/formats/radioss/layouts/radioss_cards.hpp>
#include <tests/formats/lsdyna/fields_page.hpp>

/// docs/radioss_cards.md shows the table of cards. PINBALL_FIX_PAGES=1 in the environment writes it anew.
namespace pinball::test::radioss_page_test {
namespace {

std::string page_text() {
  std::string text =
      "# Fields of the keywords of Radioss input\n\n"
      "All lines that are read, by the table that reads them (`solver/formats/radioss/layouts/`);\n"
      "`tests/formats/radioss/radioss_page_test.cpp` makes this page. Behind a field stands its default where that is "
      "not 0 or\n"
      "blank, in parentheses how many columns it has where those are not 10. What a line says other than the default "
      "of "
      "a field\n"
      "that is not used is reported by the name of the field, with the reason, and of one that is refused it ends the "
      "program with\n"
      "all else that is refused. `tests/formats/radioss/radioss_every_field_test.cpp` sets each field to something "
      "else: the scene\n"
      "or the mesh changes, or a sentence names it. A title that stands before the lines is not counted.\n"
      "\n"
      "| keyword | line | used | reported | refused |\n|---|---|---|---|---|\n";
  const auto& table = radioss_cards();
  for (std::size_t first = 0, next = 0; first < table.size(); first = next) {
    std::string keywords;
    for (next = first; next < table.size() && table[next].lines == table[first].lines; ++next)
      keywords += (next == first ? "`" : ", `") + table[next].keyword + "`";
    for (std::size_t line = 0; line < table[first].lines.size(); ++line) {
      text += row_of(keywords, line + 1, *table[first].lines[line]);
      keywords.clear();
    }
  }
  return text;
}

TEST(RadiossCards, AreThoseOfThePage) { expect_page("radioss_cards.md", page_text()); }

}  // namespace
}  // namespace pinball::test::radioss_page_test
