#pragma once

#include <solver/deck/translated_deck.hpp>
#include <solver/scene.hpp>

#include "commands.hpp"

namespace pinball {

/// What was made of a deck, and what of it is ignored.
void print_deck(const TranslatedDeck& deck, const std::string& path);

/// Source of the scene that the command line names: a scene file, the name of a scene, or a deck of another program,
/// of which it prints what was understood and what is ignored. Throws InputError.
SceneSource scene_source(const SceneOptions& options);

}  // namespace pinball
