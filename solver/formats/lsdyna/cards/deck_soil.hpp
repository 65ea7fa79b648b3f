#pragma once

#include "deck_parts.hpp"

namespace pinball {

/// *MAT_005 and *MAT_014 behind its first card, f.
void set_soil(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards, const DeckKeys<Material>& keys);

}  // namespace pinball
