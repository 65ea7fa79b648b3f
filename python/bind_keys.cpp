#include "bind_keys.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pinball::python {

namespace {

/// Of T, L and M, in words.
std::string_view in_words(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> words{{{"T", "time"},
                                                                                 {"L", "length"},
                                                                                 {"M", "mass"},
                                                                                 {"L/T", "length/time"},
                                                                                 {"T/L", "time/length"},
                                                                                 {"1/T", "1/time"},
                                                                                 {"L/T^2", "length/time^2"},
                                                                                 {"M/L^3", "mass/length^3"},
                                                                                 {"M L/T^2", "force"},
                                                                                 {"M/(L T^2)", "stress"}}};
  const auto found = std::find_if(words.begin(), words.end(), [unit](const auto& one) { return one.first == unit; });
  return found == words.end() ? unit : found->second;
}

}  // namespace

std::string text_of_key(const schema::AnyKey& key, std::string_view none) {
  std::string text = key.meaning;
  std::erase(text, '`');
  if (!none.empty()) text += "; " + std::string(none) + ": " + key.about.otherwise;
  if (*key.about.unit) text += " [" + std::string(in_words(key.about.unit)) + "]";
  return text;
}

}  // namespace pinball::python
