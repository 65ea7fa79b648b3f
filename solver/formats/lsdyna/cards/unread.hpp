#pragma once

#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/reading_log.hpp>
#include <solver/formats/lsdyna/scan/keyword_deck.hpp>

namespace pinball {

/// From now on it is written down what of the keywords of a deck is read, but of nodes and elements, which are many and
/// have few fields. log has to stay.
void follow_reading(KeywordDeck& deck, ReadingLog& log);

/// Tells which fields and lines of keywords that are done say something that nobody has read.
void tell_unread(const KeywordDeck& deck, const ReadingLog& log, DeckReport& report);

}  // namespace pinball
