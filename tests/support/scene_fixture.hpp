#pragma once

#include <fstream>
#include <string>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/scene.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

/// Scenes of a few lines, written to a file of their own, and the errors that reading them gives.
namespace pinball::test {

// Lines 1 to 14; tests change single lines of it, or add lines from 15 on.
inline const std::vector<std::string> minimal{
    "units = \"SI\"",                                                       // 1
    "[time]",                                                               // 2
    "end = 1.0",                                                            // 3
    "[[material]]",                                                         // 4
    "name = \"copper\"",                                                    // 5
    "model = \"von_mises\"",                                                // 6
    "density = 8930",                                                       // 7
    "bulk_modulus = 143e9",                                                 // 8
    "shear_modulus = 44e9",                                                 // 9
    "yield_stress = 4e8",                                                   // 10
    "[[body]]",                                                             // 11
    "name = \"bar\"",                                                       // 12
    "material = \"copper\"",                                                // 13
    "mesh = { type = \"block\", size = [1, 2, 3], elements = [2, 3, 4] }",  // 14
};

class SceneTest : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    file_ = (folder_ / "scene.toml").string();
  }

  Scene read(const std::vector<std::string>& lines, const SceneOverrides& overrides = {}) {
    std::ofstream file(file_);
    for (const auto& line : lines) file << line << '\n';
    file.close();
    return read_scene(file_, overrides);
  }

  /// The minimal scene with one line replaced (from 1), or with lines added at its end.
  static std::vector<std::string> with(std::size_t line, const std::string& text) {
    auto lines = minimal;
    lines.at(line - 1) = text;
    return lines;
  }
  static std::vector<std::string> with(const std::vector<std::string>& more) {
    auto lines = minimal;
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
  }

  /// The error's text with the file's name cut off; "no error" if there is none.
  std::string error(const std::vector<std::string>& lines, const SceneOverrides& overrides = {}) {
    const std::string text = error_of([&] { read(lines, overrides); });
    return text.starts_with(file_) ? text.substr(file_.size() + 1) : text;
  }
  std::string set_error(const std::string& key_value) { return error(minimal, {.set = {key_value}}); }

  std::string file_;
};

}  // namespace pinball::test
