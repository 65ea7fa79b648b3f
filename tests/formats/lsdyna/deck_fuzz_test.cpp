#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "deck_trial.hpp"
#include "own_deck.hpp"

namespace pinball::test::deck_fuzz_test {
namespace {

namespace fs = std::filesystem;

/// Small decks of data/decks, damaged in ways that follow from a seed.
class Damaged {
 public:
  explicit Damaged(std::uint32_t seed) : random_(seed) {
    for (const std::string& name : all_own_decks()) {
      std::ifstream file(own_deck(name));
      std::ostringstream text;
      text << file.rdbuf();
      if (text.str().size() < 20000) decks_.push_back(text.str());
    }
  }

  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
  template <class Items>
  const auto& one_of(const Items& items) {
    return items[below(std::size(items))];
  }

  std::string next() {
    std::string text = one_of(decks_);
    for (std::size_t times = 1 + below(3); times > 0; --times) damage(text);
    return text;
  }

 private:
  static std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }

  void damage(std::string& text) {
    if (text.empty()) return;
    std::vector<std::string> lines = lines_of(text);
    switch (below(8)) {
      case 0:
        text[below(text.size())] = static_cast<char>(below(256));
        return;
      case 1:
        text.resize(below(text.size()));
        return;
      case 2:
        std::swap(lines[below(lines.size())], lines[below(lines.size())]);
        break;
      case 3:
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())), one_of(lines));
        break;
      case 4:
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())));
        break;
      case 5:
        replace_number(text);
        return;
      case 6:  // a keyword of another deck
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())), keyword());
        break;
      default:
        lines[below(lines.size())] += one_of(endings_);
    }
    text.clear();
    for (const std::string& line : lines) text += line + '\n';
  }

  void replace_number(std::string& text) {
    const std::size_t first = text.find_first_of("0123456789", below(text.size()));
    if (first == std::string::npos) return;
    const std::size_t end = text.find_first_not_of("0123456789.E+-", first);
    text.replace(first, end - first, one_of(extremes_));
  }

  std::string keyword() {
    const std::vector<std::string> lines = lines_of(one_of(decks_));
    for (std::size_t i = below(lines.size()); i < lines.size(); ++i) {
      if (lines[i].starts_with('*')) return lines[i];
    }
    return "*NODE";
  }

  std::mt19937 random_;
  std::vector<std::string> decks_;
  static constexpr const char* extremes_[] = {"0",
                                              "-1",
                                              "1e308",
                                              "-1e308",
                                              "1e-320",
                                              "2147483648",
                                              "1e999",
                                              "1.5.2",
                                              "&nowhere",
                                              "nan",
                                              "9223372036854775807",
                                              "4e15"};
  static constexpr const char* endings_[] = {"_TITLE", "_ID", "%", "+", ",", "\t1", "\r", " &x", " CID=2"};
};

/// Whatever is done to a deck, it is read or refused with an InputError, and soon.
TEST(DeckFuzz, ADamagedDeckIsReadOrRefused) {
  const fs::path folder = fs::temp_directory_path() / ("pinball_deck_fuzz_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  fs::copy(own_deck("parts"), folder / "parts", fs::copy_options::recursive);
  const std::string path = (folder / "deck.k").string();
  Damaged damaged(20261122);
  int read = 0, refused = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string text = damaged.next();
    std::ofstream(path, std::ios::binary) << text;
    const auto begin = std::chrono::steady_clock::now();
    TrialEnd end{};
    ASSERT_NO_THROW(end = try_deck(path)) << text;
    ++(end == TrialEnd::model ? read : refused);
    ASSERT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20)) << text;
  }
  EXPECT_GT(read, 150) << "the damage must leave some decks that are read";
  EXPECT_GT(refused, 150);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace pinball::test::deck_fuzz_test
