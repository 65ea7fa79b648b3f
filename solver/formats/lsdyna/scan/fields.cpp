#include "fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pinball {

namespace {

/// Whether a field that is not blank has anything but its default; 0 is a blank. known: null: it is none of the card.
bool says_something(std::string_view given, const CardField* known) {
  if (known != nullptr && known->type == FieldType::text && upper_case(given) == known->word) return false;
  const std::optional<double> number = deck_number(given);
  return number != 0.0 && (known == nullptr || number != known->otherwise);
}

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
    : LineFields(card), parameters_(&parameters), block_(card.block), layout_(&layout) {
  if (!cut_at_commas(card.text)) cut_columns(card.text);
}

Fields::~Fields() {
  write_down(layout_, [&](std::size_t i, std::string_view given) {
    return says_something(given, i < layout_->size() ? &(*layout_)[i] : nullptr);
  });
}

std::string Fields::meant(std::string_view given) const {
  const bool parameter = given.starts_with('&') || given.starts_with("-&");
  return parameter ? parameters_->value(given, place()) : std::string(given);
}

std::string Fields::keyword() const { return block_ == nullptr ? "" : block_->star_name() + ": "; }

void Fields::cut_columns(std::string_view line) {
  // Nobody knows what columns a tab stands for.
  if (const std::size_t tab = line.find('\t');
      tab != std::string_view::npos && tab + 1 < line.find_last_not_of(" \t") + 1)
    fail_at(place(), "there is a tab in a card of columns: expected blanks, or commas between the fields");
  const bool is_wide = block_ != nullptr && block_->wide, is_twenty = block_ != nullptr && block_->twenty;
  // Behind the last field that the manual has there are up to eight of the same columns.
  for (const std::size_t most = std::max<std::size_t>(layout_->size(), 8); !line.empty() && count_ < most;) {
    const CardField& field = count_ < layout_->size() ? (*layout_)[count_] : layout::gap;
    const std::size_t length = std::min(field.columns_of(is_wide, is_twenty), line.size());
    add(line.substr(0, length));
    line.remove_prefix(length);
  }
}

std::size_t Fields::place_of(std::string_view name) const {
  const std::size_t place = layout_->find(name);
  if (place == layout_->size()) throw std::logic_error(fmt::format("no field of this card is named {}", name));
  return place;
}

std::int64_t Fields::integer(std::size_t field) const {
  const CardField& one = (*layout_)[field];
  const std::string_view given = raw(field);
  if (given.empty() && !one.required) return static_cast<std::int64_t>(one.otherwise);
  const std::optional<std::int64_t> plain = deck_integer(given);
  const std::int64_t value = plain ? *plain : LineFields::integer(field, one.name);
  require_bounds(one, value);
  return value;
}

double Fields::number(std::size_t field) const {
  const CardField& one = (*layout_)[field];
  const std::string_view given = raw(field);
  if (given.empty() && !one.required) return one.otherwise;
  const std::optional<double> plain = deck_number(given);
  const double value = plain ? *plain : LineFields::number(field, one.name);
  require_bounds(one, value);
  const bool converted = one.dimension != Dimension::none && block_ != nullptr && block_->transform != nullptr;
  return converted ? value * factor_of(one.dimension, block_->transform->units) : value;
}

Point Fields::point(std::string_view first) const {
  const std::size_t at = place_of(first);
  return {number(at), number(at + 1), number(at + 2)};
}

void Fields::require_bounds(const CardField& one, double value) const {
  if (value >= one.least && value <= one.most) return;
  fail(one.name, std::isinf(one.most) ? fmt::format("expected at least {}, got {}", one.least, value)
                                      : fmt::format("expected {} to {}, got {}", one.least, one.most, value));
}

}  // namespace pinball
