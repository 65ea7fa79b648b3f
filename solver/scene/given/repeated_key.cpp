#include "repeated_key.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace pinball {

namespace {

constexpr int most_tries = 200;  // each parses the text up to the error

std::vector<std::string> lines_until(const std::string& text, std::size_t count) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; lines.size() < count && begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

bool is_valid(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) (text += line) += '\n';
  try {
    static_cast<void>(toml::parse(text));
    return true;
  } catch (const toml::parse_error&) {
    return false;
  }
}

/// The last part of what stands in quotes in the parser's message.
std::string repeated_name(std::string_view message) {
  const std::size_t end = message.rfind('\''), begin = message.rfind('\'', end - 1);
  if (end == std::string_view::npos || begin == std::string_view::npos || begin == end) return {};
  const std::string_view name = message.substr(begin + 1, end - begin - 1);
  return std::string(name.substr(name.rfind('.') + 1));  // npos + 1 is 0
}

}  // namespace

/// It is the nearest line before, with the name in it, without which the text up to the error is valid. The line of the
/// error may be the first of several, of which the others are left out: then none is found.
std::int64_t line_of_first(const std::string& text, const toml::parse_error& error) {
  if (error.description().find("cannot redefine") == std::string_view::npos) return 0;
  const std::string name = repeated_name(error.description());
  const std::size_t last = error.source().begin.line;
  if (name.empty() || last == 0) return 0;
  std::vector<std::string> lines = lines_until(text, last);
  int tries = 0;
  for (std::size_t i = lines.size() - 1; i-- > 0 && tries < most_tries;) {
    if (lines[i].find(name) == std::string::npos) continue;
    ++tries;
    std::string line;
    line.swap(lines[i]);
    if (is_valid(lines)) return static_cast<std::int64_t>(i) + 1;
    line.swap(lines[i]);
  }
  return 0;
}

}  // namespace pinball
