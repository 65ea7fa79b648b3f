#pragma once

#include "deck_parts.hpp"

namespace pinball {

/// Of stresses over plastic strains that do not begin at 0. what: the curve.
void tell_first_strain(DeckReport& report, const std::string& what, const DeckCurve& curve);
/// *MAT_012: f: its only line.
void set_isotropic_plastic(const Fields& f, const DeckKeys<Material>& keys);
/// *MAT_098: f: its first line; cards: the next.
void set_simplified_johnson_cook(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys);

/// *MAT_110: the same.
void set_johnson_holmquist(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys);

/// *EOS_... as a value of a key. tension_limit: 0: none [stress].
GivenValue given_state_equation(const DeckStateEquation& equation, double tension_limit);

}  // namespace pinball
