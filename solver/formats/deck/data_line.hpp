#pragma once

#include <string_view>

#include "deck_place.hpp"
#include "reading_log.hpp"

namespace pinball {

/// One line of data of a deck.
struct DataLine {
  std::string_view text;  ///< without the end of the line
  DeckPlace place;
  ReadingLog* log = nullptr;  ///< where it is written down what of it is read; null: nowhere

  bool blank() const { return text.find_first_not_of(" \t") == std::string_view::npos; }
};

}  // namespace pinball
