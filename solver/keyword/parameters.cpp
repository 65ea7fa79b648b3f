#include "parameters.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <solver/base/text_distance.hpp>

#include "expression.hpp"
#include "fields.hpp"

namespace pinball {

namespace {

/// "R vel" or "Rvel": the kind and the name in lower case.
std::pair<char, std::string> kind_and_name(std::string_view declaration, const DeckPlace& place) {
  const std::string lower = lower_case(trimmed(declaration));
  const char kind = lower.empty() ? '\0' : lower[0];
  const std::string name(trimmed(std::string_view(lower).substr(lower.empty() ? 0 : 1)));
  if ((kind != 'r' && kind != 'i' && kind != 'c') || name.empty())
    fail_at(place, fmt::format("expected R, I or C and the name of a parameter, got \"{}\"", declaration));
  return {kind, name};
}

}  // namespace

void Parameters::read(const KeywordBlock& block) {
  Cards cards(block);
  const bool expressions = block.name == "PARAMETER_EXPRESSION";
  std::optional<Card> card = cards.next_filled();
  while (card) {
    if (!expressions) {
      read_values(*card);
      card = cards.next_filled();
      continue;
    }
    const std::string_view text = card->text;
    const std::size_t comma = text.find(',');
    const std::size_t name_end = comma < 10 ? comma : 10;
    const std::string_view declaration = text.substr(0, name_end);
    std::string expression(text.size() > name_end ? text.substr(name_end + (comma < 10 ? 1 : 0)) : std::string_view{});
    const DeckPlace place = card->place;
    // A line whose first ten columns are blank goes on with the expression of the line before.
    while ((card = cards.next_filled()) && trimmed(card->text.substr(0, 10)).empty()) expression += card->text;
    read_expression(declaration, expression, place);
  }
}

void Parameters::read_values(const Card& card) {
  const Fields fields(card, *this);
  for (std::size_t pair = 0; pair < 4; ++pair) {
    if (fields.blank(2 * pair)) continue;
    set(fields.text(2 * pair), fields.text(2 * pair + 1), card.place);
  }
}

void Parameters::set(std::string_view declaration, std::string_view text, const DeckPlace& place) {
  const auto [kind, name] = kind_and_name(declaration, place);
  if (kind == 'c') {
    values_[name] = std::string(text);
    return;
  }
  const std::optional<double> number = deck_number(text);
  if (!number) fail_at(place, fmt::format("parameter {}: expected a number, got \"{}\"", name, text));
  if (kind == 'i') {
    values_[name] = static_cast<std::int64_t>(std::llround(*number));
  } else {
    values_[name] = *number;
  }
}

void Parameters::read_expression(std::string_view declaration, std::string expression, const DeckPlace& place) {
  const auto [kind, name] = kind_and_name(declaration, place);
  if (kind == 'c') {
    values_[name] = std::string(trimmed(expression));
    return;
  }
  try {
    const double value = evaluate_expression(expression, [&](std::string_view other) { return number(other, place); });
    if (!std::isfinite(value)) throw std::invalid_argument("the value is not finite");
    if (kind == 'i') {
      values_[name] = static_cast<std::int64_t>(value);
    } else {
      values_[name] = value;
    }
  } catch (const std::invalid_argument& error) {
    fail_at(place, fmt::format("parameter {}: {}", name, error.what()));
  }
}

const Parameters::Value& Parameters::find(std::string_view name, const DeckPlace& place) const {
  const auto found = values_.find(lower_case(name));
  if (found != values_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [other, value] : values_) known.push_back(other);
  fail_at(place, fmt::format("no parameter is named {}{}", name,
                             known.empty() ? "" : fmt::format(", nearest is {}", nearest(std::string(name), known))));
}

double Parameters::number(std::string_view name, const DeckPlace& place) const {
  const Value& value = find(name, place);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  fail_at(place, fmt::format("parameter {}: expected a number, it is a text", name));
}

std::string Parameters::value(std::string_view reference, const DeckPlace& place) const {
  const bool minus = reference.starts_with('-');
  const std::string_view name = trimmed(reference.substr(minus ? 2 : 1));
  const Value& value = find(name, place);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", minus ? -*whole : *whole);
  const double real = std::get<double>(value);
  return fmt::format("{}", minus ? -real : real);
}

}  // namespace pinball
