#pragma once

#include "deck_parts.hpp"

namespace pinball {

/// *MAT_027, with its constants: from the curve of a test they would be fitted. f: its first line; cards: the next.
void set_rubber(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys);
/// *MAT_077_O
void set_ogden(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards,
               const DeckKeys<Material>& keys);
/// *MAT_002
void set_orthotropic(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys);

}  // namespace pinball
