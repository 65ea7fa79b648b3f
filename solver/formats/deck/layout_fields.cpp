#include "layout_fields.hpp"

#include <fmt/format.h>

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

}  // namespace

std::size_t LayoutFields::place_of(std::string_view name) const {
  const std::size_t place = layout_->find(name);
  if (place == layout_->size()) throw std::logic_error(fmt::format("no field of this card is named {}", name));
  return place;
}

void LayoutFields::write_down_unread() const {
  write_down(layout_, [&](std::size_t i, std::string_view given) {
    return says_something(given, i < layout_->size() ? &(*layout_)[i] : nullptr);
  });
}

void LayoutFields::require_no_tab(std::string_view line) const {
  if (const std::size_t tab = line.find('\t');
      tab != std::string_view::npos && tab + 1 < line.find_last_not_of(" \t") + 1)
    fail_at(place(), "there is a tab in a card of columns: expected blanks, or commas between the fields");
}

std::int64_t LayoutFields::integer(std::size_t field) const {
  const CardField& one = (*layout_)[field];
  const std::string_view given = raw(field);
  if (given.empty() && !one.required) return static_cast<std::int64_t>(one.otherwise);
  const std::optional<std::int64_t> plain = deck_integer(given);
  const std::int64_t value = plain ? *plain : LineFields::integer(field, one.name);
  require_bounds(one, value);
  return value;
}

double LayoutFields::number(std::size_t field) const {
  const CardField& one = (*layout_)[field];
  const std::string_view given = raw(field);
  if (given.empty() && !one.required) return one.otherwise;
  const std::optional<double> plain = deck_number(given);
  const double value = plain ? *plain : LineFields::number(field, one.name);
  require_bounds(one, value);
  return one.dimension != Dimension::none ? value * factor(one.dimension) : value;
}

Point LayoutFields::point(std::string_view first) const {
  const std::size_t at = place_of(first);
  return {number(at), number(at + 1), number(at + 2)};
}

void LayoutFields::require_bounds(const CardField& one, double value) const {
  if (value >= one.least && value <= one.most) return;
  fail(one.name, std::isinf(one.most) ? fmt::format("expected at least {}, got {}", one.least, value)
                                      : fmt::format("expected {} to {}, got {}", one.least, one.most, value));
}

}  // namespace pinball
