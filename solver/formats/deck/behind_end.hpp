#pragma once

#include <optional>
#include <string_view>

#include "deck_place.hpp"

namespace pinball {

/// The first line that says something behind the keyword that ends a file, of which nothing is read: a second deck,
/// say, that was appended to the first. rest: what is behind the line at `place`. end: the keyword, which may stand
/// there again. comments: what lines of no meaning begin with.
std::optional<DeckPlace> first_behind_end(std::string_view rest, DeckPlace place, std::string_view end,
                                          std::string_view comments);

}  // namespace pinball
