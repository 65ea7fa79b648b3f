#include "fields.hpp"

#include <algorithm>

namespace pinball {

namespace {

double factor_of(Dimension dimension, const DeckUnits& units) {
  switch (dimension) {
    case Dimension::none:
      return 1;
    case Dimension::mass:
      return units.mass;
    case Dimension::time:
      return units.time;
    case Dimension::length:
      return units.length;
    case Dimension::density:
      return units.density();
    case Dimension::stress:
      return units.stress();
    case Dimension::rate:
      return units.rate();
    case Dimension::velocity:
      return units.velocity();
    case Dimension::specific_heat:
      return units.specific_heat();
  }
  return 1;
}

}  // namespace

Fields::Fields(const Card& card, const Parameters& parameters, const CardLayout& layout)
    : LayoutFields(card, layout), parameters_(&parameters), block_(card.block) {
  if (!cut_at_commas(card.text)) cut_columns(card.text);
}

std::string Fields::meant(std::string_view given) const {
  const bool parameter = given.starts_with('&') || given.starts_with("-&");
  return parameter ? parameters_->value(given, place()) : std::string(given);
}

std::string Fields::keyword() const { return block_ == nullptr ? "" : block_->star_name() + ": "; }

double Fields::factor(Dimension dimension) const {
  const bool converted = block_ != nullptr && block_->transform != nullptr;
  return converted ? factor_of(dimension, block_->transform->units) : 1;
}

void Fields::cut_columns(std::string_view line) {
  require_no_tab(line);
  const bool is_wide = block_ != nullptr && block_->wide, is_twenty = block_ != nullptr && block_->twenty;
  // Behind the last field that the manual has there are up to eight of the same columns.
  for (const std::size_t most = std::max<std::size_t>(layout().size(), 8); !line.empty() && count_ < most;) {
    const CardField& field = count_ < layout().size() ? layout()[count_] : layout::gap;
    const std::size_t length = std::min(field.columns_of(is_wide, is_twenty), line.size());
    add(line.substr(0, length));
    line.remove_prefix(length);
  }
}

}  // namespace pinball
