#pragma once

#include <string>

#include <solver/formats/deck/translated_deck.hpp>

namespace pinball {

/// Throws InputError: "FILE:LINE: ..." for what is wrong, and one message with every keyword that cannot be done, how
/// many there are and where the first is.
TranslatedDeck translate_deck(const std::string& path, const DeckOptions& options = {});

/// The same for the text of a deck, which was read from the path.
TranslatedDeck translate_deck_text(std::string text, const std::string& path, const DeckOptions& options);

}  // namespace pinball
