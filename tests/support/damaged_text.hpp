#pragma once

#include <algorithm>
#include <random>
#include <string>

namespace pinball::test {

/// A text made worse: characters and lines that go, come twice, or are others. signs: what keywords begin with.
inline std::string damaged(std::string text, const std::string& signs, std::mt19937& random) {
  const std::string characters = signs + std::string(",=.\"\n 0123456789eE-+ABxyz\r\t");
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::size_t changes = 1 + below(6);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = below(text.size());
    const std::size_t line = text.rfind('\n', at) == std::string::npos ? 0 : text.rfind('\n', at) + 1;
    const std::size_t length = std::min(text.find('\n', at), text.size() - 1) - line + 1;
    switch (below(5)) {
      case 0:
        text[at] = characters[below(characters.size())];
        break;
      case 1:
        text.insert(at, 1, characters[below(characters.size())]);
        break;
      case 2:
        text.erase(at, 1 + below(4));
        break;
      case 3:
        text.erase(line, length);
        break;
      default:
        text.insert(line, text.substr(line, length));
    }
  }
  return text;
}

}  // namespace pinball::test
