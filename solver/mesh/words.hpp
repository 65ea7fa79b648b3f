#pragma once

#include <algorithm>
#include <string_view>

namespace pinball {

/// visit(word) for the words of a text that has a blank between each two. Not std::views::split: Clang 14 cannot read
/// it in the library of GCC 12.
template <class Visit>
void for_words(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    visit(word);
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
}

}  // namespace pinball
