#pragma once

#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/reading_log.hpp>
#include <solver/formats/radioss/scan/radioss_deck.hpp>

namespace pinball {

/// From now on it is written down what of the keywords of a deck is read. log has to stay.
void follow_reading(RadiossDeck& deck, ReadingLog& log);

/// Tells which lines, and fields of them, of keywords that are done say something that nobody has read.
void tell_unread(const RadiossDeck& deck, const ReadingLog& log, DeckReport& report);

}  // namespace pinball
