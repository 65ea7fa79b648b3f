#pragma once

#include <string>

#include <solver/formats/deck/translated_deck.hpp>

namespace pinball {

/// Radioss input as a scene: the starter's file NAME_0000.rad and, beside it, the engine's file NAME_0001.rad. Throws
/// InputError with all keywords that are not done, or for what is wrong with one.
TranslatedDeck translate_radioss(const std::string& path, const DeckOptions& options = {});

/// The same of the text of the starter's file; path: for which it stands.
TranslatedDeck translate_radioss_text(std::string text, const std::string& path, const DeckOptions& options = {});

}  // namespace pinball
