#pragma once

#include <optional>
#include <string>

#include "deck_parts.hpp"

namespace pinball {

/// Laws of an energy, which never yield, beside *MAT_ELASTIC.
enum class DeckEnergy { orthotropic, blatz_ko, mooney_rivlin, hyperelastic, ogden, hill_foam };

/// kind: as of keyword_alias(); nothing: another law.
std::optional<DeckEnergy> energy_of(const std::string& kind);
const CardLayout& layout_of(DeckEnergy energy);
/// With its constants: from the curve of a test they would be fitted. f: its first line; cards: the next.
void set_energy(DeckData& data, DeckEnergy energy, const KeywordBlock& block, const Fields& f, Cards& cards,
                const DeckKeys<Material>& keys);

}  // namespace pinball
