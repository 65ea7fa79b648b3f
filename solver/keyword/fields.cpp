#include "fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace pinball {

namespace {

std::string changed(std::string_view text, int (*change)(int)) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(change(static_cast<unsigned char>(c)));
  return result;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A number as from_chars reads it: with an "e" before the exponent.
std::optional<double> read_number(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) return std::nullopt;
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::string lower_case(std::string_view text) { return changed(text, std::tolower); }
std::string upper_case(std::string_view text) { return changed(text, std::toupper); }

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<std::int64_t> deck_integer(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && stop == end && std::abs(static_cast<double>(value)) <= largest_integer) return value;
  const std::optional<double> number = deck_number(text);  // "5." or "1.0E+7"
  if (!number || *number != std::floor(*number) || std::abs(*number) > largest_integer) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

std::optional<double> deck_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  if (text.empty() || !(is_digit(text.front()) || text.front() == '-' || text.front() == '.')) return std::nullopt;
  if (const std::optional<double> plain = read_number(text)) return plain;
  std::string spelled;  // D for E, or no letter at all before the sign of the exponent
  for (const char c : text) {
    const bool exponent_sign = (c == '+' || c == '-') && !spelled.empty() && spelled.back() != 'e';
    if (exponent_sign) spelled += 'e';
    const bool letter = c == 'E' || c == 'D' || c == 'd';
    if (c != '+') spelled += letter ? 'e' : c;
  }
  return read_number(spelled);
}

LineFields::LineFields(const Card& card, const Parameters* parameters)
    : parameters_(parameters), block_(card.block), place_(card.place), log_(card.log), line_(card.text.data()) {}

bool LineFields::cut_at_commas(std::string_view line) {
  if (line.find(',') == std::string_view::npos) return false;
  while (count_ < most_fields) {
    const std::size_t comma = line.find(',');
    add(line.substr(0, comma));
    if (comma == std::string_view::npos) return true;
    line.remove_prefix(comma + 1);
  }
  if (line.find_first_not_of(", \t\r") != std::string_view::npos)
    fail_at(place_, fmt::format("expected at most {} fields between commas, got more", most_fields));
  return true;
}

namespace {

/// Whether a field has anything but its default; 0 is a blank. known: null: nobody says what it is.
bool says_something(std::string_view given, const CardField* known) {
  if (given.empty()) return false;
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
  }
  return 1;
}

}  // namespace

void LineFields::write_down(const CardLayout* layout) const {
  if (log_ == nullptr) return;
  std::uint32_t left = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const CardField* const known = layout != nullptr && i < layout->size() ? &(*layout)[i] : nullptr;
    if ((asked_ >> i & 1U) == 0 && says_something(fields_[i], known)) left |= 1U << i;
  }
  log_->left(line_, left, layout);
}

std::string LineFields::text(std::size_t field) const {
  const std::string_view given = raw(field);
  const bool parameter = parameters_ != nullptr && (given.starts_with('&') || given.starts_with("-&"));
  return parameter ? parameters_->value(given, place_) : std::string(given);
}

std::int64_t LineFields::integer(std::size_t field, std::string_view name,
                                 std::optional<std::int64_t> otherwise) const {
  const std::string_view given = raw(field);
  if (given.empty() && otherwise) return *otherwise;
  if (const std::optional<std::int64_t> number = deck_integer(given)) return *number;
  if (const std::optional<std::int64_t> number = deck_integer(text(field))) return *number;  // of a parameter
  fail_to_read(field, name, "a whole number");
}

double LineFields::number(std::size_t field, std::string_view name, std::optional<double> otherwise) const {
  const std::string_view given = raw(field);
  if (given.empty() && otherwise) return *otherwise;
  if (const std::optional<double> number = deck_number(given)) return *number;
  if (const std::optional<double> number = deck_number(text(field))) return *number;  // of a parameter
  fail_to_read(field, name, "a number");
}

void LineFields::fail(std::string_view name, const std::string& problem) const {
  const std::string keyword = block_ == nullptr ? "" : block_->star_name() + ": ";
  fail_at(place_, fmt::format("{}{}: {}", keyword, name, problem));
}

void LineFields::fail_to_read(std::size_t field, std::string_view name, const std::string& expected) const {
  const std::string_view given = raw(field);
  fail(fmt::format("{} (field {})", name, field + 1),
       fmt::format("expected {}, got {}", expected, given.empty() ? "nothing" : fmt::format("\"{}\"", given)));
}

Fields::Fields(const Card& card, const Parameters& parameters, const CardLayout& layout)
    : LineFields(card, &parameters), layout_(&layout) {
  if (!cut_at_commas(card.text)) cut_columns(card.text);
}

void Fields::cut_columns(std::string_view line) {
  // Nobody knows what columns a tab stands for.
  if (const std::size_t tab = line.find('\t');
      tab != std::string_view::npos && tab + 1 < line.find_last_not_of(" \t") + 1)
    fail_at(place(), "there is a tab in a card of columns: expected blanks, or commas between the fields");
  const bool is_wide = block() != nullptr && block()->wide, is_twenty = block() != nullptr && block()->twenty;
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
  require_bounds(one, static_cast<double>(value));
  return value;
}

double Fields::number(std::size_t field) const {
  const CardField& one = (*layout_)[field];
  const std::string_view given = raw(field);
  if (given.empty() && !one.required) return one.otherwise;
  const std::optional<double> plain = deck_number(given);
  const double value = plain ? *plain : LineFields::number(field, one.name);
  require_bounds(one, value);
  const bool converted = one.dimension != Dimension::none && block() != nullptr && block()->transform != nullptr;
  return converted ? value * factor_of(one.dimension, block()->transform->units) : value;
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
