#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <solver/formats/deck/card_field.hpp>

/// Rows of the pages that show the fields of cards.
namespace pinball::test {

/// "`SFA` = 1 (20 columns)"
inline std::string field_text(const CardField& field) {
  std::string text = fmt::format("`{}`", field.name);
  if (field.type == FieldType::number || field.type == FieldType::whole) {
    if (field.otherwise != 0) text += fmt::format(" = {:g}", field.otherwise);
  } else if (!field.word.empty()) {
    text += fmt::format(" = {}", field.word);
  }
  if (field.width != 10) text += fmt::format(" ({})", field.width);
  return text;
}

inline std::string fields_of(const CardLayout& layout, FieldUse use) {
  std::string text;
  for (const CardField& field : layout) {
    if (!field.name.empty() && field.use == use) text += (text.empty() ? "" : ", ") + field_text(field);
  }
  return text;
}

inline std::string row_of(const std::string& keywords, std::size_t line, const CardLayout& layout) {
  return fmt::format("| {} | {} | {} | {} | {} |\n", keywords, line, fields_of(layout, FieldUse::used),
                     fields_of(layout, FieldUse::reported), fields_of(layout, FieldUse::rejected));
}

/// PINBALL_FIX_PAGES=1 in the environment writes the page of docs anew.
inline void expect_page(const std::string& name, const std::string& expected) {
  const std::string path = PINBALL_SOURCE_DIR "/docs/" + name;
  if (std::getenv("PINBALL_FIX_PAGES") != nullptr) std::ofstream(path) << expected;
  std::ifstream file(path);
  std::ostringstream page;
  page << file.rdbuf();
  EXPECT_EQ(page.str(), expected);
}

}  // namespace pinball::test
