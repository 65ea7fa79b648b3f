#pragma once

#include "radioss_data.hpp"

namespace pinball {

/// /EOS/GRUNEISEN, /EOS/POLYNOMIAL, /EOS/LINEAR or /EOS/COMPACTION(2) as a value of a key. tension_limit: 0: none
/// [stress].
GivenValue given_radioss_state(RadiossData& data, const RadiossBlock& block, double tension_limit);

/// /MAT/DPRAG behind its density: a pressure over mu by a function, from which it comes back with moduli from Kt to B.
void set_dprag(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys);

/// /MAT/DPRAG1 behind its density: a polynomial of mu with B; or, with one more line alone, the pressure of `state`, or
/// where that is null of a constant bulk modulus.
void set_dprag1(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const RadiossBlock* state,
                const DeckKeys<Material>& keys);

}  // namespace pinball
