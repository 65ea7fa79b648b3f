#pragma once

#include "deck_data.hpp"

namespace pinball {

/// What a deck has beside what can be read of it.
struct UnreadKeywords {
  std::vector<KeywordBlock> of_parts;  ///< materials, sections and equations of state that are not there
  bool of_mesh = false;                ///< whether any of it would make another mesh
};

/// Takes out of the deck what is ignored or refused, which goes to the report, and what only parts that have it would
/// need. lenient: --lenient.
UnreadKeywords sort_keywords(KeywordDeck& deck, bool lenient, DeckReport& report);

/// Refuses what parts with solids have, and tells the others as not used. data: null: nobody knows what parts have, so
/// that all are refused.
void reject_of_parts(const std::vector<KeywordBlock>& blocks, const DeckData* data, DeckReport& report);

}  // namespace pinball
