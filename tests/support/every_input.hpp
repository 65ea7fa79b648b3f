#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <solver/formats/deck_reader.hpp>
#include <solver/program/scene_input.hpp>

/// The scenes and decks in data/, for tests over all of them.
namespace pinball::test {

/// Their paths, sorted.
inline std::vector<std::string> every_input() {
  std::vector<std::string> paths;
  const std::filesystem::path data = std::filesystem::path(PINBALL_SOURCE_DIR) / "data";
  for (const auto& folder : {data / "scenes", data / "decks", data / "decks/abaqus"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string path = entry.path().string();
      if (path.ends_with(".toml") || is_any_deck(path)) paths.push_back(path);
    }
  }
  std::ranges::sort(paths);
  return paths;
}

/// One of them; the block of 216,000 elements, all of which do the same, is made of eight times fewer.
inline Scene read_input(const std::string& path) {
  SceneOptions options;
  options.scene = path;
  options.quiet = true;
  if (path.ends_with("cases.k")) options.chosen_case = 1;
  Scene scene = scene_input(options).read();
  for (Body& body : scene.bodies) {
    constexpr std::array<int, 3> many{60, 60, 60}, fewer{30, 30, 30};
    BlockMesh* const block = std::get_if<BlockMesh>(&body.mesh);
    if (block && block->elements == many) block->elements = fewer;
  }
  return scene;
}

/// Of a test whose parameter is a path: "toml_block".
inline std::string name_of_input(const testing::TestParamInfo<std::string>& info) {
  const std::filesystem::path path = info.param;
  return path.extension().string().substr(1) + "_" + path.stem().string();
}

}  // namespace pinball::test
