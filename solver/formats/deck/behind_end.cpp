#include "behind_end.hpp"

#include <algorithm>

#include "number_text.hpp"

namespace pinball {

std::optional<DeckPlace> first_behind_end(std::string_view rest, DeckPlace place, std::string_view end,
                                          std::string_view comments) {
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    ++place.line;
    const std::string_view text = trimmed(line);
    if (!text.empty() && text != end && comments.find(text.front()) == std::string_view::npos) return place;
  }
  return std::nullopt;
}

}  // namespace pinball
