#include "translated_deck.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "deck_scene.hpp"

namespace pinball {

TranslatedDeck given_deck(DeckScene&& scene, const std::string& path, bool contact_said) {
  const std::string name = std::filesystem::path(path).filename().string();
  auto given = std::make_shared<GivenScene>();
  given->table = scene.take(fmt::format("{} as this program understands it.", name));
  given->contact_said = contact_said;
  return {std::move(given)};
}

}  // namespace pinball
