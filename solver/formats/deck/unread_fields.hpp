#pragma once

#include <string>

#include "deck_report.hpp"
#include "reading_log.hpp"

namespace pinball {

/// Tells the fields of a line by their names, those of one remark together: what the card says and nobody has asked
/// for. keyword: for messages.
void tell_unread_fields(const std::string& keyword, const DeckPlace& place, const ReadingLog::Left& left,
                        DeckReport& report);

}  // namespace pinball
