#pragma once

#include <string_view>

#include "deck_place.hpp"

namespace pinball {

/// Throws InputError for a line that would be a keyword but for the blanks before its mark ('*' or '/'), such as "
/// *NODE": to the program a deck is written for it is data of the keyword before, and what it has is lost without a
/// word. Titles that begin with the mark stay what they are, unless they are one word in capitals that is the first of
/// a keyword.
void refuse_indented_keyword(std::string_view line, char mark, const DeckPlace& place);

}  // namespace pinball
