#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <solver/base/error.hpp>
#include <solver/formats/radioss/cards/radioss_scene.hpp>
#include <solver/scene.hpp>
#include <tests/support/damaged_text.hpp>

namespace pinball::test::radioss_fuzz_test {
namespace {

namespace fs = std::filesystem;

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
  for (int round = 0; round < 600; ++round) {
    for (const std::string& deck : decks) {
      const std::string text = damaged(deck, "/#", random);
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
