#pragma once

#include "radioss_data.hpp"

namespace pinball {

/// /MAT/FOAM_PLAS behind its density.
void set_foam_plas(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys);

/// /EOS/COMPACTION as a value of a key. tension_limit: 0: none [stress].
GivenValue given_compaction(RadiossData& data, const RadiossBlock& block, double tension_limit);

}  // namespace pinball
