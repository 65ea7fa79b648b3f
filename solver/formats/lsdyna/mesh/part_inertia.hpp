#pragma once

#include <solver/formats/lsdyna/layouts/rigid_cards.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <solver/formats/lsdyna/scan/keyword_block.hpp>

namespace pinball {

/// Takes the cards that *PART_INERTIA has behind that of *PART, of which none of the fields counts as read.
inline void pass_inertia(Cards& cards, const Parameters& parameters) {
  Card first = cards.next_or_blank();
  first.log = nullptr;
  const bool in_system = Fields(first, parameters, layout::part_inertia).integer("IRCS") == 1;
  for (int i = 0; i < (in_system ? 3 : 2); ++i) cards.next_or_blank();
}

}  // namespace pinball
