#pragma once

#include <solver/keyword/keyword_deck.hpp>
#include <solver/keyword/reading_log.hpp>

#include "deck_report.hpp"

namespace pinball {

/// From now on it is written down what of the keywords of a deck is read, but of nodes and elements, which are many and
/// have few fields. log has to stay.
void follow_reading(KeywordDeck& deck, ReadingLog& log);

/// Tells which fields and lines of keywords that are done say something that nobody has read.
void tell_unread(const KeywordDeck& deck, const ReadingLog& log, DeckReport& report);

/// "field 3", "fields 3 and 5": of these bits.
std::string fields_text(std::uint32_t fields);

}  // namespace pinball
