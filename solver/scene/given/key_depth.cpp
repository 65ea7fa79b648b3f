#include "key_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <solver/base/error.hpp>

namespace pinball {

namespace {

/// The place after the string that begins at `begin`; the end of the text where it is not closed.
std::size_t after_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
  const bool lines = text.substr(begin, 3) == three;
  for (std::size_t i = begin + (lines ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (lines ? text.substr(i, 3) == three : text[i] == quote || text[i] == '\n') {
      return i + (lines ? 3 : 1);
    }
  }
  return text.size();
}

[[noreturn]] void fail_at(std::string_view text, std::size_t place, const std::string& path) {
  const std::string_view before = text.substr(0, place);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t column = place - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
  throw InputError(
      fmt::format("{}:{}:{}: expected a key of at most {} parts, got more", path, line, column, most_key_parts));
}

}  // namespace

/// Outside of texts and comments only keys have many dots: numbers and times have one each.
void require_short_keys(const std::string& text, const std::string& path) {
  std::size_t dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = after_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.' && ++dots >= most_key_parts) fail_at(text, i, path);
    if (std::string_view("=\n,[]{}").find(c) != std::string_view::npos) dots = 0;
    ++i;
  }
}

}  // namespace pinball
