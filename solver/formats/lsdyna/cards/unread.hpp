#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/reading_log.hpp>
#include <solver/formats/lsdyna/scan/keyword_deck.hpp>

namespace pinball {

/// From now on it is written down what of the keywords of a deck is read, but of nodes and elements, which are many and
/// have few fields. log has to stay.
void follow_reading(KeywordDeck& deck, ReadingLog& log);

/// Tells which fields and lines of keywords that are done say something that nobody has read.
void tell_unread(const KeywordDeck& deck, const ReadingLog& log, DeckReport& report);

/// For the message that nothing has a number: a line of a keyword of this kind ("MAT_") behind its first that begins
/// with it, as if a keyword had several. Empty: there is none. offset: what *INCLUDE_TRANSFORM adds to such numbers.
std::string second_of_keyword(const KeywordDeck& deck, std::string_view kind, std::int64_t number,
                              std::int64_t DeckTransform::*offset);

}  // namespace pinball
