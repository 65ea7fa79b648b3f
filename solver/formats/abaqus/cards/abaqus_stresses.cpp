#include <fmt/format.h>

#include <array>

#include <solver/formats/deck/deck_stresses.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// Sections whose stresses are along other axes than x, y and z.
void reject_turned(AbaqusData& data, const std::vector<std::int32_t>& elements, const DeckPlace& place) {
  for (const std::int32_t e : elements) {
    const auto number = static_cast<std::size_t>(data.mesh.file.part[e]);
    if (number >= data.mesh.sections.size()) continue;  // of rigid elements
    const AbaqusBlock* section = data.mesh.sections[number].block;
    if (section == nullptr || !section->has("ORIENTATION")) continue;
    return data.report.reject(place, "*INITIAL CONDITIONS, TYPE=STRESS of a section with an ORIENTATION",
                              "give them along x, y and z, of a section without");
  }
}

/// TYPE=STRESS: 11, 22, 33, 12, 13, 23. A point of integration in front of them, as CalculiX has it, is refused.
void read_stresses(AbaqusData& data, const AbaqusBlock& block, DeckStresses& stresses) {
  DataLines lines(block);
  while (const auto card = lines.next()) {
    const DataFields f(*card);
    if (!f.blank(7)) {
      data.report.reject(card->place, "*INITIAL CONDITIONS, TYPE=STRESS of single points of integration",
                         "give elements one stress each: 11, 22, 33, 12, 13, 23");
      for (std::size_t i = 1; i < 7; ++i) f.text(i);
      continue;
    }
    std::array<double, 6> s;
    for (std::size_t i = 0; i < 6; ++i) s[i] = f.number(i + 1, "stress", 0.0);
    const std::vector<std::int32_t> elements = data.elements(f.text(0), card->place);
    reject_turned(data, elements, card->place);
    for (const std::int32_t e : elements) {
      DeckStress& own = stresses.of(data.mesh.file.element_ids[e]);
      own.stress = {s[0], s[1], s[2]};
      own.shear_stress = {s[3], s[5], s[4]};
      own.card = card_of(block, card->place);
    }
  }
}

/// TYPE=HARDENING: the plastic strain; a back stress behind it is refused.
void read_hardening(AbaqusData& data, const AbaqusBlock& block, DeckStresses& stresses) {
  DataLines lines(block);
  while (const auto card = lines.next()) {
    const DataFields f(*card);
    const double strain = f.number(1, "equivalent plastic strain");
    bool has_back_stress = false;
    for (std::size_t i = 2; i < 8; ++i) has_back_stress |= f.number(i, "back stress", 0.0) != 0;
    if (has_back_stress) data.report.reject(card->place, "*INITIAL CONDITIONS, TYPE=HARDENING with a back stress");
    for (const std::int32_t e : data.elements(f.text(0), card->place)) {
      DeckStress& own = stresses.of(data.mesh.file.element_ids[e]);
      own.plastic_strain = strain;
      own.card = card_of(block, card->place);
    }
  }
}

}  // namespace

void translate_abaqus_initial_stresses(AbaqusData& data, DeckScene& scene) {
  DeckStresses stresses;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "INITIALCONDITIONS") continue;
    if (block.option("TYPE") == "STRESS") read_stresses(data, block, stresses);
    if (block.option("TYPE") == "HARDENING") read_hardening(data, block, stresses);
  }
  stresses.write(scene);
}

}  // namespace pinball
