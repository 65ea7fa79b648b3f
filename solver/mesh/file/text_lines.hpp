#pragma once

#include <cstddef>
#include <string_view>

namespace pinball {

/// Takes the first line off a text, without its end. False: there is none left.
inline bool next_line(std::string_view& text, std::string_view& line) {
  if (text.empty()) return false;
  const std::size_t end = text.find('\n');
  line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return true;
}

}  // namespace pinball
