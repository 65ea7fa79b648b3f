#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <solver/formats/lsdyna/cards/keyword_scene.hpp>
#include <solver/scene.hpp>
#include <solver/simulation.hpp>

/// The decks in data/decks.
namespace pinball::test {

inline std::string own_deck(const std::string& name) { return PINBALL_SOURCE_DIR "/data/decks/" + name; }

inline Scene scene_of_deck(const std::string& path, const DeckOptions& options = {}) {
  return read_scene(translate_deck(path, options).source(path));
}

inline Simulation run_deck(const std::string& name, const DeckOptions& options = {}) {
  Simulation simulation(scene_of_deck(own_deck(name), options));
  simulation.run();
  return simulation;
}

inline std::vector<std::string> all_own_decks() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(own_deck(""))) {
    if (entry.path().extension() == ".k") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace pinball::test
