#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <solver/scene.hpp>

#include "toml_text.hpp"

namespace pinball {

/// How a deck is to be understood.
struct DeckOptions {
  std::optional<std::int64_t> chosen_case;  ///< --case: of those of *CASE; none: what belongs to no case
  bool lenient = false;                     ///< --lenient: unknown output and control keywords are ignored, not refused
  /// How the scene names the deck, from which its meshes are read; empty: the file's own name, beside the scene.
  std::string name_in_scene;
};

/// A deck of another program as a scene of this one.
struct TranslatedDeck {
  std::string scene;                    ///< text of a scene file; mesh files are named relative to its folder
  std::vector<std::string> understood;  ///< lines that say what was made of what, and where they differ
  std::vector<std::string> ignored;     ///< keywords that cannot change the answer, with how many and where
  std::vector<TextOrigin> origins;      ///< which lines of the scene are of which cards
  bool contact_said = true;             ///< whether any card says what touches

  /// A message that names lines of the scene, as "NAME:LINE:COLUMN: KEY", with the cards in their place: "deck.k:12:
  /// *MAT_ELASTIC (ro)". name: that by which the scene was read.
  std::string in_cards(const std::string& message, const std::string& name) const;
  /// Of the scene that was read by that name: gives each part, for messages and warnings, the name of its card.
  void name_parts(Scene& read, const std::string& name) const;
};

}  // namespace pinball
