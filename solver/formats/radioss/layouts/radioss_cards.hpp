#pragma once

#include <string>
#include <vector>

#include <solver/formats/deck/card_field.hpp>

namespace pinball {

/// The lines of a keyword of Radioss input, in their order; the last may stand many times where the manual says so.
struct RadiossCards {
  std::string keyword;                   ///< "MAT/ELAST"
  bool titled = false;                   ///< whether a title stands before them
  std::vector<const CardLayout*> lines;  ///< null: a title
};

/// All keywords whose lines are read by layouts, in the order of docs/radioss_cards.md.
const std::vector<RadiossCards>& radioss_cards();

}  // namespace pinball
