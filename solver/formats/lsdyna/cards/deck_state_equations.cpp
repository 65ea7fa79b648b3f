#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/lsdyna/layouts/definition_cards.hpp>

#include "deck_data.hpp"
#include "keyword_rules.hpp"

/// What parts and others name by number: equations of state, *EOS_..., and what of all that nothing names.
namespace pinball {

namespace {

bool is_grueneisen(const KeywordBlock& block) { return keyword_alias(block.name) == "EOS_GRUNEISEN"; }

const CardLayout& layout_of_state_equation(const KeywordBlock& block) {
  return is_grueneisen(block) ? layout::grueneisen : layout::linear_polynomial;
}

Card head_of_state_equation(const KeywordBlock& block, Cards& cards) {
  if (block.title) cards.next();
  return cards.require("the constants of the equation of state");
}

}  // namespace

/// Its number; those that are not read are refused by the rules.
void DeckData::number_state_equation(const KeywordBlock& block) {
  if (!is_grueneisen(block) && keyword_alias(block.name) != "EOS_LINEAR_POLYNOMIAL") return;
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
  const Card more = cards.next_or_blank();
  fields(more, is_grueneisen(block) ? layout::grueneisen_volume : layout::linear_polynomial_state);
  DeckStateEquation equation{{}, {block.star_name(), head.place}};
  EquationOfStateSettings& settings = equation.settings;
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
                fmt::format("*PART with EOSID {}, which no *EOS_... has that is read", first->state_equation),
                "give an *EOS_GRUNEISEN or *EOS_LINEAR_POLYNOMIAL", first->solids);
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
