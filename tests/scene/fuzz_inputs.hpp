#pragma once

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

/// Texts made worse at random, for the fuzzer of the readers.
namespace pinball::test {

using Random = std::mt19937_64;

inline std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

inline std::string file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What stands in the place of a number, a word or between two.
inline const std::string& nasty(Random& random) {
  static const std::vector<std::string> all{"0",
                                            "-1",
                                            "1",
                                            "2",
                                            "1000000",
                                            "2147483647",
                                            "2147483648",
                                            "-2147483649",
                                            "9223372036854775807",
                                            "-9223372036854775808",
                                            "99999999999999999999",
                                            "1e-308",
                                            "1e308",
                                            "-1e308",
                                            "1e-320",
                                            "1e999",
                                            "nan",
                                            "-inf",
                                            "inf",
                                            "true",
                                            "[]",
                                            "[[]]",
                                            "{}",
                                            "''",
                                            "\"\\u0000\"",
                                            "1979-05-27",
                                            "0x7fffffffffffffff",
                                            "[1, 1, 1]",
                                            "[1000000, 1000000, 1000000]",
                                            "[1, [1, 2], 3]",
                                            "\xff\xfe",
                                            "\n",
                                            "[body]",
                                            "$EndNodes",
                                            "$Elements",
                                            "$Nodes",
                                            "\"",
                                            "#"};
  return all[below(random, all.size())];
}

struct Span {
  std::size_t begin, size;
};

/// The words or the lines of a text.
inline std::vector<Span> pieces(const std::string& text, const char* separators) {
  std::vector<Span> found;
  for (std::size_t at = 0; (at = text.find_first_not_of(separators, at)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    found.push_back({at, end - at});
    at = end;
  }
  return found;
}

/// One change of a text.
inline std::string changed(std::string text, Random& random) {
  if (text.empty()) return nasty(random);
  const auto words = pieces(text, " \t\r\n,=[]{}"), lines = pieces(text, "\n");
  if (words.empty()) return text + nasty(random);
  const Span word = words[below(random, words.size())], line = lines[below(random, lines.size())];
  const Span other = lines[below(random, lines.size())];
  switch (below(random, 10)) {
    case 0:  // a bit
      text[below(random, text.size())] ^= static_cast<char>(1 << below(random, 8));
      return text;
    case 1:  // a byte
      text[below(random, text.size())] = static_cast<char>(random());
      return text;
    case 2:
      return text.substr(0, below(random, text.size()));
    case 3:  // a line twice
      return text.insert(other.begin, text.substr(line.begin, line.size) + '\n');
    case 4:
      return text.erase(line.begin, line.size);
    case 5:  // a word in the place of another
      return text.replace(word.begin, word.size, text.substr(words[below(random, words.size())].begin, word.size));
    case 6: {  // deep nesting
      const std::size_t depth = std::array<std::size_t, 3>{3, 300, 20000}[below(random, 3)];
      const bool closed = below(random, 2) == 0;
      return text.replace(word.begin, word.size, std::string(depth, '[') + std::string(closed ? depth : 0, ']'));
    }
    case 7:  // a very long word
      return text.replace(word.begin, word.size, std::string(100000, text[word.begin]));
    default:  // by far the most fruitful
      return text.replace(word.begin, word.size, nasty(random));
  }
}

/// A text with one to four changes.
inline std::string mutated(std::string text, Random& random) {
  for (std::size_t i = 0, n = 1 + below(random, 4); i < n; ++i) text = changed(std::move(text), random);
  return text;
}

}  // namespace pinball::test
