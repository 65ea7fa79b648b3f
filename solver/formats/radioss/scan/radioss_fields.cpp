#include "radioss_fields.hpp"

#include <algorithm>

namespace pinball {

namespace {

/// Whether a tab may be a column as any other, as it is in OpenRadioss: no field then has two words, or a part of one.
bool tabs_are_columns(std::string_view line, const CardLayout& layout) {
  constexpr const char* blanks = " \t";
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  for (std::size_t i = 0; i < layout.size() && !line.empty(); ++i) {
    const std::size_t length = std::min<std::size_t>(layout[i].width, line.size());
    if (length < line.size() && !is_blank(line[length - 1]) && !is_blank(line[length])) return false;
    std::string_view field = line.substr(0, length);
    field.remove_prefix(std::min(field.find_first_not_of(blanks), field.size()));
    const std::size_t behind = field.find_first_of(blanks);
    if (behind != std::string_view::npos && field.find_first_not_of(blanks, behind) != std::string_view::npos)
      return false;
    line.remove_prefix(length);
  }
  return line.find_first_not_of(blanks) == std::string_view::npos;
}

}  // namespace

RadiossFields::RadiossFields(const DataLine& line, const RadiossBlock& block, const CardLayout& layout)
    : LayoutFields(line, layout), block_(&block) {
  if (block.engine) {
    cut_at_blanks(line.text);
  } else {
    cut_columns(line.text);
  }
}

/// What stands behind the last field is one more.
void RadiossFields::cut_columns(std::string_view line) {
  if (!tabs_are_columns(line, layout())) require_no_tab(line);
  for (std::size_t i = 0; i < layout().size() && !line.empty(); ++i) {
    const std::size_t length = std::min<std::size_t>(layout()[i].width, line.size());
    add(line.substr(0, length));
    line.remove_prefix(length);
  }
  if (!line.empty()) add(line);
}

void RadiossFields::cut_at_blanks(std::string_view line) {
  while (count_ < most_fields) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return;
    line.remove_prefix(first);
    const std::string_view field = line.substr(0, line.find_first_of(" \t"));
    add(field);
    line.remove_prefix(field.size());
  }
}

}  // namespace pinball
