#pragma once

#include "radioss_data.hpp"

namespace pinball {

/// /MAT/OGDEN behind its density. With the exponents 2 and -2 its energy is that of Mooney and Rivlin, A = mu/2 and
/// B = -mu/2, and of 2 alone that of neo-Hookean materials; of volumes each has its own. Else it is `ogden`.
void set_ogden(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys);
/// /MAT/VISC_HYP behind its density, without viscosity: `ogden` of whole stretches.
void set_visc_hyp(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys);

}  // namespace pinball
