#pragma once

#include <optional>

#include <solver/base/error.hpp>
#include <solver/formats/deck/translated_deck.hpp>
#include <solver/recorded_run.hpp>
#include <solver/scene.hpp>

#include "commands.hpp"

namespace pinball {

/// What was made of a deck, and what of it is ignored.
void print_deck(const TranslatedDeck& deck, const std::string& path);

/// The scene that the command line names, and the deck of another program that it may be made of.
struct SceneInput {
  SceneSource source;
  std::optional<TranslatedDeck> deck;

  /// What is told of its parts, such as warnings, names the cards of the deck, too.
  Scene read() const;
  /// What print_deck() prints, and where the cards are; empty of a scene file.
  DeckNotes notes() const;

  /// Does something with the scene. InputError of it names the cards of the deck in place of lines of its scene.
  template <class Act>
  auto with_places(const Act& act) const {
    try {
      return act();
    } catch (const InputError& error) {
      if (!deck) throw;
      throw InputError(deck->in_cards(error.what(), source.path));
    }
  }
};

/// A scene file, the name of a scene, or a deck, of which it prints what was understood and what is ignored. Throws
/// InputError.
SceneInput scene_input(const SceneOptions& options);

}  // namespace pinball
