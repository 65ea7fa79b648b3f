#include "parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <solver/base/text_distance.hpp>
#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>

#include "fields.hpp"
#include "keyword_scanner.hpp"

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

/// So many columns, or up to a comma that is not one between the arguments of a function.
std::size_t end_of_declaration(std::string_view text, std::size_t columns) {
  const std::size_t comma = text.find(',');
  const bool free = comma != std::string_view::npos && text.find('(') > comma;
  return free ? comma : std::min(columns, text.size());
}

}  // namespace

void Parameters::read(const KeywordBlock& block) {
  std::string name = block.name;
  changes_ = false;
  while (true) {
    if (take_ending(name, "_LOCAL") || take_ending(name, "_MUTABLE")) {
      changes_ = true;
    } else if (!take_ending(name, "_NOECHO")) {
      break;
    }
  }
  if (name != "PARAMETER" && name != "PARAMETER_EXPRESSION") fail_at(block.place, '*' + block.name + " is not read");
  Cards cards(block);
  if (name == "PARAMETER_EXPRESSION") {
    read_expressions(cards);
  } else {
    while (const std::optional<Card> card = cards.next_filled()) read_values(*card);
  }
}

void Parameters::read_duplication(const KeywordBlock& block) {
  Cards cards(block);
  const Card card = cards.next_or_blank();
  duplication_ = Fields(card, *this, layout::parameter_duplication).integer("DFLAG");
}

void Parameters::read_expressions(Cards& cards) {
  std::optional<Card> card = cards.next_filled();
  while (card) {
    const std::string_view text = card->text;
    const std::size_t columns = layout::parameters[0].columns_of(card->block->wide, card->block->twenty);
    const std::size_t end = end_of_declaration(text, columns);
    const std::string_view declaration = text.substr(0, end);
    const bool comma = end < text.size() && text[end] == ',';
    std::string expression(text.substr(std::min(end + (comma ? 1 : 0), text.size())));
    const DeckPlace place = card->place;
    // A line whose first columns are blank goes on with the expression of the line before.
    while ((card = cards.next_filled()) && trimmed(card->text.substr(0, columns)).empty()) expression += card->text;
    read_expression(declaration, expression, place);
  }
}

void Parameters::read_values(const Card& card) {
  const Fields fields(card, *this, layout::parameters);
  for (std::size_t pair = 0; pair < 4; ++pair) {
    if (fields.blank(2 * pair)) continue;
    set(fields.text(2 * pair), fields.text(2 * pair + 1), card.place);
  }
}

void Parameters::set(std::string_view declaration, std::string_view text, const DeckPlace& place) {
  const auto [kind, name] = kind_and_name(declaration, place);
  if (kind == 'c') return define(name, Value(std::string(text)), place);
  const std::optional<double> number = deck_number(text);
  if (!number) fail_at(place, fmt::format("parameter {}: expected a number, got \"{}\"", name, text));
  define(name, kind, kind == 'i' ? std::round(*number) : *number, place);
}

void Parameters::read_expression(std::string_view declaration, std::string expression, const DeckPlace& place) {
  const auto [kind, name] = kind_and_name(declaration, place);
  if (kind == 'c') return define(name, Value(std::string(trimmed(expression))), place);
  double value = 0;
  try {
    value = evaluate_expression(expression, [&](std::string_view other) { return number(other, place); });
    if (!std::isfinite(value)) throw std::invalid_argument("the value is not finite");
  } catch (const std::invalid_argument& error) {
    fail_at(place, fmt::format("parameter {}: {}", name, error.what()));
  }
  define(name, kind, kind == 'i' ? std::trunc(value) : value, place);
}

void Parameters::define(const std::string& name, char kind, double number, const DeckPlace& place) {
  if (kind != 'i') return define(name, Value(number), place);
  if (std::abs(number) > largest_integer)
    fail_at(place, fmt::format("parameter {}: expected a smaller whole number, got {:.6g}", name, number));
  define(name, Value(static_cast<std::int64_t>(number)), place);
}

/// Fields are read when all of the deck is known: a value that is another one from some place on cannot be had.
void Parameters::define(const std::string& name, Value value, const DeckPlace& place) {
  const auto [found, is_new] = values_.try_emplace(name, Parameter{value, place});
  if (is_new || found->second.value == value) return;
  const std::string twice = fmt::format("parameter {} has another value in {}", name, found->second.place.text());
  if (changes_) fail_at(place, twice + ": _LOCAL and _MUTABLE are read where a name has one value in the whole deck");
  if (duplication_ != 1 && duplication_ != 5)
    fail_at(place, fmt::format("{}: *PARAMETER_DUPLICATION with DFLAG {} is not read", twice, duplication_));
  notes_.push_back(fmt::format("{}: {}, which holds", place.text(), twice));
}

const Parameters::Value& Parameters::find(std::string_view name, const DeckPlace& place) const {
  const auto found = values_.find(lower_case(name));
  if (found != values_.end()) return found->second.value;
  std::vector<std::string> known;
  for (const auto& [other, value] : values_) known.push_back(other);
  fail_at(place, fmt::format("no parameter is named {}{}", name,
                             known.empty() ? "" : fmt::format(", nearest is {}", nearest(std::string(name), known))));
}

ExpressionNumber Parameters::number(std::string_view name, const DeckPlace& place) const {
  const Value& value = find(name, place);
  if (const auto* real = std::get_if<double>(&value)) return {*real};
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return {static_cast<double>(*whole), true};
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
