#pragma once

#include <string>

#include <solver/formats/deck/translated_deck.hpp>
#include <solver/recorded_run.hpp>
#include <solver/scene.hpp>

#include "commands.hpp"

namespace pinball {

/// What was made of a deck, and what of it is ignored.
void print_deck(const TranslatedDeck& deck, const std::string& path);

/// The scene that the command line names, which may be a deck of another program.
struct SceneInput {
  SceneSource source;
  DeckNotes notes;  ///< what print_deck() prints; empty of a scene file

  Scene read() const { return read_scene(source); }
};

/// The file that the command line names, or the scene or deck of that name which comes with the program; the name
/// itself of a deck that is not there. Throws InputError for a scene that is not there.
std::string path_of_scene(const std::string& name);

/// A scene file, the name of a scene, or a deck, of which it prints what was understood and what is ignored. Throws
/// InputError.
SceneInput scene_input(const SceneOptions& options);

}  // namespace pinball
