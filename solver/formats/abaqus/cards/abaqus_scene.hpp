#pragma once

#include <string>

#include <solver/formats/deck/translated_deck.hpp>

namespace pinball {

/// Abaqus input as a scene. Throws InputError: "FILE:LINE: ..." for what is wrong, and one message with every keyword
/// that cannot be done, how many there are and where the first is.
TranslatedDeck translate_abaqus(const std::string& path, const DeckOptions& options = {});

/// The same for a text that was read from the path.
TranslatedDeck translate_abaqus_text(std::string text, const std::string& path, const DeckOptions& options);

}  // namespace pinball
