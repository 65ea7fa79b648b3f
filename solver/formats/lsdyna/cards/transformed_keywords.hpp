#pragma once

#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/lsdyna/scan/keyword_deck.hpp>

namespace pinball {

/// Of files that *INCLUDE_TRANSFORM moves or turns (TRANID) nodes alone go along. What else has places or directions in
/// such a file is refused where it would have to go along, too; directions of the axes stay those of the deck, which is
/// reported, and so is the order of several cards of one transformation. Throws InputError where the transformation of
/// a file is not defined.
void reject_transformed(const KeywordDeck& deck, DeckReport& report);

}  // namespace pinball
