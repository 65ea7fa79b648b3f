#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/lsdyna/layouts/definition_cards.hpp>

#include "deck_data.hpp"
#include "keyword_rules.hpp"
#include "unread.hpp"

/// What parts and others name by number: equations of state, *EOS_..., and what of all that nothing names.
namespace pinball {

namespace {

bool is_grueneisen(const KeywordBlock& block) { return keyword_alias(block.name) == "EOS_GRUNEISEN"; }
bool is_compaction(const KeywordBlock& block) { return keyword_alias(block.name) == "EOS_TABULATED_COMPACTION"; }
bool is_tabulated(const KeywordBlock& block) {
  return keyword_alias(block.name) == "EOS_TABULATED" || is_compaction(block);
}
bool is_read(const KeywordBlock& block) {
  return is_grueneisen(block) || is_tabulated(block) || keyword_alias(block.name) == "EOS_LINEAR_POLYNOMIAL";
}

const CardLayout& layout_of_state_equation(const KeywordBlock& block) {
  if (is_tabulated(block)) return layout::tabulated_state;
  return is_grueneisen(block) ? layout::grueneisen : layout::linear_polynomial;
}

/// The ten numbers of two cards of a table.
std::vector<double> ten_of(const Fields& first, const Fields& second) {
  std::vector<double> all;
  for (const Fields* card : {&first, &second}) {
    for (std::size_t i = 0; i < 5; ++i) all.push_back(card->number(i));
  }
  return all;
}

/// EV, C, T and, where it crushes, K: ten places, of which those behind the last point are 0. Pressure is C + GAMA T E.
void read_points(const DeckData& data, const KeywordBlock& block, Cards& cards, double gamma,
                 EquationOfStateSettings& settings) {
  const Card strains = cards.require("EV1 to EV5"), more_strains = cards.next_or_blank(),
             pressures = cards.require("C1 to C5"), more_pressures = cards.next_or_blank(),
             factors = cards.next_or_blank(), more_factors = cards.next_or_blank();
  const Fields ev1 = data.fields(strains, layout::table_strains),
               ev2 = data.fields(more_strains, layout::table_strains_more),
               c1 = data.fields(pressures, layout::table_pressures),
               c2 = data.fields(more_pressures, layout::table_pressures_more),
               t1 = data.fields(factors, layout::table_factors),
               t2 = data.fields(more_factors, layout::table_factors_more);
  settings.form = EquationOfStateForm::tabulated;
  settings.volume_strain = ten_of(ev1, ev2);
  settings.pressure = ten_of(c1, c2);
  settings.energy_factor = ten_of(t1, t2);
  if (is_compaction(block)) {
    const Card moduli = cards.require("K1 to K5"), more_moduli = cards.next_or_blank();
    settings.unloading_modulus =
        ten_of(data.fields(moduli, layout::table_moduli), data.fields(more_moduli, layout::table_moduli_more));
  }
  const std::vector<double>& strain = settings.volume_strain;
  const bool rises = strain[1] > strain[0];
  std::size_t count = 1;
  while (count < strain.size() && (rises ? strain[count] > strain[count - 1] : strain[count] < strain[count - 1]))
    ++count;
  for (std::size_t i = count; i < strain.size(); ++i) {
    if (strain[i] != 0 || settings.pressure[i] != 0 || settings.energy_factor[i] != 0)
      (count < 5 ? ev1 : ev2)
          .fail(fmt::format("EV{}", count + 1), fmt::format("expected rising or falling strains, and 0 behind the last "
                                                            "point, got {} behind {}",
                                                            strain[count], strain[count - 1]));
  }
  for (std::vector<double>* values : {&settings.volume_strain, &settings.pressure, &settings.energy_factor})
    values->resize(count);
  if (is_compaction(block)) settings.unloading_modulus.resize(count);
  const bool has_energy = std::ranges::any_of(settings.energy_factor, [](double one) { return one != 0; });
  if (!has_energy && gamma != 0) data.report.unused(ev1.place(), block.star_name() + ": GAMA", "T is 0");
  if (has_energy && gamma == 0) data.report.unused(ev1.place(), block.star_name() + ": T1 to T10", "GAMA is 0");
  if (!has_energy || gamma == 0) settings.energy_factor.clear();
  for (double& factor : settings.energy_factor) factor *= gamma;
}

Card head_of_state_equation(const KeywordBlock& block, Cards& cards) {
  if (block.title) cards.next();
  return cards.require("the constants of the equation of state");
}

}  // namespace

/// Its number; those that are not read are refused by the rules.
void DeckData::number_state_equation(const KeywordBlock& block) {
  if (!is_read(block)) return;
  Cards cards(block);
  const Card head = head_of_state_equation(block, cards);
  const std::int64_t id =
      fields(head, layout_of_state_equation(block)).integer("EOSID") + offset_of(block, &DeckTransform::material);
  give_once(block, fmt::format("equation of state {}", id), head.place);
  state_equation_blocks_[id] = &block;
}

void DeckData::tell_unused_state_equations() {
  for (const auto& [id, block] : state_equation_blocks_) {
    if (std::ranges::find(parts, id, &DeckPart::state_equation) != parts.end()) continue;
    report.unused(block->place,
                  fmt::format("{}, equation of state {}, which no part with solids has", block->star_name(), id));
    if (block->log != nullptr) block->log->done(block);
  }
}

void DeckData::define(const KeywordBlock& block, const std::string& kind, std::int64_t id, const DeckPlace& place) {
  give_once(block, fmt::format("{} {}", kind, id), place);
  definitions_.add(kind, id, block.star_name(), place);
}

void DeckData::tell_unused_definitions() {
  for (const auto& [id, part] : all_parts_) {
    if (find_part(id) == nullptr) report.unused(part.place, "*PART without solids");
  }
  for (const DeckPart& part : parts) {
    definitions_.name("section", part.section);
    definitions_.name("hourglass control", part.hourglass);
  }
  definitions_.tell_unused(report);
}

DeckStateEquation DeckData::read_state_equation(const KeywordBlock& block) const {
  Cards cards(block);
  const Card head = head_of_state_equation(block, cards);
  const Fields f = fields(head, layout_of_state_equation(block));
  DeckStateEquation equation{{}, {block.star_name(), head.place}};
  EquationOfStateSettings& settings = equation.settings;
  if (is_tabulated(block)) {
    read_points(*this, block, cards, f.number("GAMA"), settings);
    return equation;
  }
  const Card more = cards.next_or_blank();
  fields(more, is_grueneisen(block) ? layout::grueneisen_volume : layout::linear_polynomial_state);
  if (is_grueneisen(block)) {
    settings.sound_speed = f.number("C");
    settings.slopes = {f.number("S1"), f.number("S2"), f.number("S3")};
    settings.gamma = f.number("GAMAO");
    settings.gamma_slope = f.number("A");
  } else {
    settings.form = EquationOfStateForm::polynomial;
    for (const char* name : {"C0", "C1", "C2", "C3", "C4", "C5", "C6"}) settings.coefficients.push_back(f.number(name));
  }
  return equation;
}

std::optional<DeckStateEquation> DeckData::state_equation_of(std::int64_t material, const std::string& keyword) {
  const DeckPart* first = nullptr;
  for (const DeckPart& part : parts) {
    if (part.material != material) continue;
    if (part.state_equation == 0) {
      report.reject(part.place, fmt::format("{} without an equation of state", keyword), "give the part an EOSID",
                    part.solids);
      return std::nullopt;
    }
    if (first != nullptr && first->state_equation != part.state_equation) {
      report.reject(part.place, "one material with several equations of state", "give each its own *MAT_...",
                    part.solids);
      return std::nullopt;
    }
    first = first == nullptr ? &part : first;
  }
  if (first == nullptr) return std::nullopt;
  const auto found = state_equation_blocks_.find(first->state_equation);
  if (found != state_equation_blocks_.end()) return read_state_equation(*found->second);
  report.reject(first->place,
                fmt::format("*PART with EOSID {}, which no *EOS_... has that is read{}", first->state_equation,
                            second_of_keyword(deck, "EOS_", first->state_equation, &DeckTransform::material)),
                "give an *EOS_GRUNEISEN, *EOS_LINEAR_POLYNOMIAL, *EOS_TABULATED or *EOS_TABULATED_COMPACTION",
                first->solids);
  return std::nullopt;
}

void DeckData::reject_state_equations(std::int64_t material, const std::string& keyword) {
  for (const DeckPart& part : parts) {
    if (part.material != material || part.state_equation == 0) continue;
    report.reject(part.place, fmt::format("*PART with an equation of state (EOSID) and {}", keyword),
                  "leave it 0: this material has a bulk modulus", part.solids);
  }
}

}  // namespace pinball
