#pragma once

#include "deck_parts.hpp"

namespace pinball {

/// *MAT_063: its first card, f, but for the elasticity.
void set_crushable_foam(DeckData& data, const KeywordBlock& block, const Fields& f, const DeckKeys<Material>& keys);

}  // namespace pinball
