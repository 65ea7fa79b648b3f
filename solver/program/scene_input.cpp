#include "scene_input.hpp"

#include <fmt/core.h>

#include <fstream>

#include <solver/base/error.hpp>
#include <solver/deck/translated_deck.hpp>

namespace pinball {

namespace {

/// A scene whose text begins as a deck does, and the other way round.
void require_scene(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line.front() == '$' || line.front() == '\r') continue;
    if (line.front() != '*') return;
    throw InputError(path + ": expected a scene, this is a deck of keywords: name it .k, .key or .dyn");
  }
}

}  // namespace

void print_deck(const TranslatedDeck& deck, const std::string& path) {
  fmt::print("{}, as this program understands it:\n", path);
  for (const std::string& line : deck.understood) fmt::print("  {}\n", line);
  if (!deck.ignored.empty()) fmt::print("  ignored, since it cannot change the answer:\n");
  for (const std::string& line : deck.ignored) fmt::print("    {}\n", line);
}

SceneSource scene_source(const SceneOptions& options) {
  if (!is_deck(options.scene)) {
    if (options.chosen_case || options.lenient) {
      throw InputError(options.scene + ": --case and --lenient are for decks (.k, .key, .dyn)");
    }
    const std::string path = find_scene(options.scene);
    require_scene(path);
    return read_scene_source(path, options.overrides);
  }
  const TranslatedDeck deck = translate_deck(options.scene, {options.chosen_case, options.lenient, ""});
  if (!options.quiet) print_deck(deck, options.scene);
  // The name is that of the deck; lines in messages are those of the scene.
  return {options.scene + " as a scene", deck.scene, options.overrides};
}

}  // namespace pinball
