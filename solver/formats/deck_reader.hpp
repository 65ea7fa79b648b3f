#pragma once

#include <string>

#include <solver/formats/deck/translated_deck.hpp>

/// Decks of other programs, whichever.
namespace pinball {

/// Whether a path is that of a deck by its ending: .k, .key, .dyn, .inp, .rad.
bool is_any_deck(const std::string& path);

/// Whether the file of a deck is no more than a mesh, for bodies of scenes and for decks that include it: it says
/// nothing of how long to run and includes nothing. Throws InputError for one that cannot be read.
bool is_mesh_alone(const std::string& path);

/// The deck as a scene; its file is read once. Throws InputError, also for a scene, or the deck of another program, by
/// the name of a deck.
TranslatedDeck translate_any_deck(const std::string& path, const DeckOptions& options);

}  // namespace pinball
