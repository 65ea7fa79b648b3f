#pragma once

#include <solver/formats/abaqus/scan/abaqus_deck.hpp>
#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/reading_log.hpp>

namespace pinball {

/// From now on it is written down what of the keywords of a deck is read. log has to stay.
void follow_reading(AbaqusDeck& deck, ReadingLog& log);

/// Tells which parameters, data lines and fields of them, of keywords that are done, say something that nobody has
/// read.
void tell_unread(const AbaqusDeck& deck, const ReadingLog& log, DeckReport& report);

}  // namespace pinball
