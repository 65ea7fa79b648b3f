#pragma once

#include <string>
#include <vector>

#include <solver/formats/deck/card_field.hpp>

namespace pinball {

/// The lines of a keyword, in their order; the last may stand many times where the manual says so.
struct KeywordCards {
  std::string keyword;                   ///< without star
  std::string form;                      ///< where a keyword has several: which one; else empty
  std::vector<const CardLayout*> lines;  ///< null: a title, or the name of a file
};

/// All cards that are read, by the layouts that read them, in the order of docs/cards.md.
const std::vector<KeywordCards>& keyword_cards();

}  // namespace pinball
