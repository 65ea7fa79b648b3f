#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <solver/base/error.hpp>
#include <solver/formats/radioss/cards/radioss_scene.hpp>
#include <solver/scene.hpp>

namespace pinball::test::radioss_fuzz_test {
namespace {

namespace fs = std::filesystem;

/// A text made worse: characters and lines that go, come twice, or are others.
std::string damaged(std::string text, std::mt19937& random) {
  static const std::string characters = "/,=.\"\n 0123456789eE-+ABxyz\r\t#";
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::size_t changes = 1 + below(4);
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

/// Each is read, or rejected with an InputError that says where; no other exception and no crash.
TEST(RadiossFuzz, DamagedDecksAreReadOrRejected) {
  const fs::path from = PINBALL_SOURCE_DIR "/data/decks/radioss";
  const fs::path folder = fs::temp_directory_path() / ("pinball_radioss_fuzz_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::vector<std::string> decks;
  for (const auto& entry : fs::directory_iterator(from)) {
    if (!entry.path().filename().string().ends_with("_0000.rad")) continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    decks.push_back(text.str());
  }
  ASSERT_FALSE(decks.empty());
  std::sort(decks.begin(), decks.end());  // seeds mean the same everywhere
  const std::string path = (folder / "deck_0000.rad").string();
  std::ofstream((folder / "deck_0001.rad").string()) << "/RUN/deck/1\n0.01\n";
  std::mt19937 random(7);
  int read = 0, rejected = 0;
  for (int round = 0; round < 300; ++round) {
    for (const std::string& deck : decks) {
      const std::string text = damaged(deck, random);
      std::ofstream(path, std::ios::binary) << text;
      try {
        read_scene(translate_radioss(path).source(path));
        ++read;
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()), "");
        ++rejected;
      }
    }
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(rejected, 50);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace pinball::test::radioss_fuzz_test
