#include <fmt/format.h>

#include <solver/formats/deck/deck_stresses.hpp>
#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_keys.hpp"

namespace pinball {

namespace {

void set_stress(const RadiossFields& normal, const RadiossFields& shear, DeckStress& own) {
  own.stress = normal.point(normal.name(normal.name(0) == "brick_ID" ? 1 : 0));
  own.shear_stress = shear.point(shear.name(0));
}

/// In the axes of an element that turns with it there would be others: which these are, is said.
void read_stresses(RadiossData& data, const RadiossBlock& block, DeckStresses& stresses) {
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const DataLine second = lines.require("sigma_xy, sigma_yz, sigma_zx");
    const RadiossFields f(*line, block, radioss::stress_normal), shear(second, block, radioss::stress_shear);
    DeckStress& own = stresses.of(f.integer("brick_ID"));
    own.card = card_of(block, line->place);
    set_stress(f, shear, own);
  }
  data.report.understood(fmt::format("{} ({}): along x, y and z", block.title, block.place.text()));
}

void read_plastic_strains(const RadiossBlock& block, DeckStresses& stresses) {
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, radioss::stress_plastic);
    DeckStress& own = stresses.of(f.integer("brick_ID"));
    own.card = card_of(block, line->place);
    own.plastic_strain = f.number("eps_p");
  }
}

/// Elements of eight or four nodes with one point: energy and density, two lines of stresses, plastic strain.
void read_full(RadiossData& data, const RadiossBlock& block, DeckStresses& stresses) {
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, radioss::stress_full);
    const std::int64_t nodes = f.integer("Isolnod"), form = f.integer("Isolid");
    if (f.integer("Nb_integr") != 1 || (nodes != 8 && nodes != 4) || form == 14) {
      return data.report.reject(line->place,
                                "/INIBRI/STRS_FGLO of several points, or of other elements than BRICK and "
                                "TETRA4",
                                "Nb_integr 1, with Isolnod 8 or 4");
    }
    const DataLine energy = lines.require("Eint and RHO"), normal = lines.require("sigma_1, sigma_2, sigma_3"),
                   shear = lines.require("sigma_12, sigma_23, sigma_31"), plastic = lines.require("Epsilon_p");
    const RadiossFields e(energy, block, radioss::stress_full_energy), s(normal, block, radioss::stress_full_normal),
        t(shear, block, radioss::stress_shear), p(plastic, block, radioss::stress_full_plastic);
    DeckStress& own = stresses.of(f.integer("brick_ID"));
    own.card = card_of(block, line->place);
    set_stress(s, t, own);
    own.plastic_strain = p.number("Epsilon_p");
  }
}

}  // namespace

void translate_radioss_stresses(RadiossData& data, DeckScene& scene) {
  DeckStresses stresses;
  for (const RadiossBlock& block : data.deck.blocks) {
    if (block.name == "INIBRI/STRESS") read_stresses(data, block, stresses);
    if (block.name == "INIBRI/EPSP") read_plastic_strains(block, stresses);
    if (block.name == "INIBRI/STRS_FGLO") read_full(data, block, stresses);
  }
  stresses.write(scene);
}

}  // namespace pinball
