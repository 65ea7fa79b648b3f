#pragma once

#include "radioss_data.hpp"

namespace pinball {

/// /MAT/JOHN_HOLM behind its density. IDEL 2 and 3 erode by plastic strain and by damage; 1, of tension, is refused.
void set_john_holm(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys);

}  // namespace pinball
