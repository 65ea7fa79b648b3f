#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <solver/base/error.hpp>
#include <solver/deck/translated_deck.hpp>
#include <solver/scene.hpp>

/// Decks of a few cards, written to a file of their own.
namespace pinball::test {

/// A cube of 1 mm of elastic steel, nodes 1 to 8, element 10, part 1.
inline const std::string cube = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
*ELEMENT_SOLID
10,1,1,2,3,4,5,6,7,8
*PART
cube
1,1,1
*SECTION_SOLID
1,1
)";
inline const std::string elastic = "*MAT_ELASTIC\n1,7.85E-9,210000.,0.3\n";
inline const std::string ends = "*CONTROL_TERMINATION\n1.0E-6\n";
inline const std::string set_of_top = "*SET_NODE_LIST\n3\n5,6,7,8\n";

class DeckTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / fmt::format("pinball_deck_{}_{}", test->name(), ::getpid());
    std::filesystem::create_directories(folder_);
    path_ = (folder_ / "deck.k").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  TranslatedDeck translate(const std::string& text, const DeckOptions& options = {}) {
    std::ofstream(path_) << "*KEYWORD\n" << text << "*END\n";
    return translate_deck(path_, options);
  }
  Scene scene(const std::string& text, const DeckOptions& options = {}) {
    return read_scene(SceneSource{path_, translate(text, options).scene, {}});
  }
  /// The text of the error without the folder; "no error" if there is none.
  std::string error(const std::string& text, const DeckOptions& options = {}) {
    try {
      scene(text, options);
    } catch (const InputError& problem) {
      std::string message = problem.what();
      const std::string prefix = folder_.string() + "/";
      for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix))
        message.erase(at, prefix.size());
      return message;
    }
    return "no error";
  }

  std::filesystem::path folder_;
  std::string path_;
};

}  // namespace pinball::test
