#include "abaqus_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include <solver/base/text_distance.hpp>

namespace pinball {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_parameter_name(std::string_view text) {
  const auto fits = [](char c) { return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; };
  return !text.empty() && is_letter(text.front()) && std::ranges::all_of(text, fits);
}

/// Of Python's two kinds of quotes; what is between them, if that is one text.
bool take_quotes(std::string_view& text) {
  const bool quoted = text.size() >= 2 && (text.front() == '\'' || text.front() == '"') &&
                      text.find(text.front(), 1) == text.size() - 1;
  if (quoted) text = text.substr(1, text.size() - 2);
  return quoted;
}

std::string text_of_number(const ExpressionNumber& number) {
  return number.is_whole && std::abs(number.value) < largest_integer ? fmt::format("{:.0f}", number.value)
                                                                     : fmt::format("{}", number.value);
}

}  // namespace

void AbaqusParameters::read(const AbaqusBlock& block) {
  ++blocks_;
  DataLines lines(block);
  while (const auto line = lines.next()) {
    const std::string_view text = trimmed(line->text.substr(0, line->text.find('#')));
    if (text.empty()) continue;
    const std::size_t equals = text.find('=');
    const std::string_view name = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || !is_parameter_name(name))
      fail_at(line->place, fmt::format("*PARAMETER: expected NAME = EXPRESSION, got \"{}\"", text));
    define(name, trimmed(text.substr(equals + 1)), line->place);
  }
}

void AbaqusParameters::define(std::string_view name, std::string_view expression, const DeckPlace& place) {
  Parameter given = evaluated(name, expression, place);
  const auto [found, is_new] = parameters_.try_emplace(std::string(name), given);
  Parameter& known = found->second;
  if (is_new || known.text == given.text) return;
  if (known.block != blocks_)
    fail_at(place, fmt::format("*PARAMETER: {} has another value in {}", name, known.place.text()));
  notes_.push_back(
      fmt::format("*PARAMETER: {} ({}) takes the place of what {} says", name, place.text(), known.place.text()));
  given.is_used = known.is_used;
  known = std::move(given);
}

AbaqusParameters::Parameter AbaqusParameters::evaluated(std::string_view name, std::string_view expression,
                                                        const DeckPlace& place) {
  if (take_quotes(expression)) return {std::string(expression), {}, place, blocks_};
  try {
    const ExpressionNumber number = evaluate_python(expression, [&](std::string_view other) {
      const Parameter& known = find(other, place);
      if (!known.number) throw std::invalid_argument(fmt::format("expected a number, {} is a text", other));
      return *known.number;
    });
    if (!std::isfinite(number.value)) throw std::invalid_argument("the value is not finite");
    return {text_of_number(number), number, place, blocks_};
  } catch (const std::invalid_argument& error) {
    fail_at(place, fmt::format("*PARAMETER: {}: {}", name, error.what()));
  }
}

AbaqusParameters::Parameter& AbaqusParameters::find(std::string_view name, const DeckPlace& place) {
  const auto found = parameters_.find(std::string(name));
  if (found == parameters_.end()) {
    std::vector<std::string> known;
    for (const auto& [other, parameter] : parameters_) known.push_back(other);
    fail_at(place, fmt::format("no *PARAMETER before it has the name {}{}", name,
                               known.empty() ? "" : fmt::format(", nearest is {}", nearest(name, known))));
  }
  found->second.is_used = true;
  return found->second;
}

std::string AbaqusParameters::replaced(std::string_view line, const DeckPlace& place) {
  std::string text;
  for (std::size_t at = line.find('<'); at != std::string_view::npos; at = line.find('<')) {
    const std::size_t end = line.find('>', at);
    const std::string_view name = trimmed(line.substr(at + 1, std::min(end, line.size()) - at - 1));
    if (end == std::string_view::npos || !is_parameter_name(name))
      fail_at(place, fmt::format("expected the name of a *PARAMETER between < and >, got \"{}\"",
                                 trimmed(line.substr(at, 40))));
    text += line.substr(0, at);
    text += find(name, place).text;
    line.remove_prefix(end + 1);
  }
  text += line;
  return text;
}

std::string AbaqusParameters::replaced_lines(std::string_view lines, DeckPlace before) {
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size() - 1) + 1;
    const std::string_view line = lines.substr(0, end);
    ++before.line;
    text += trimmed(line).starts_with("**") ? std::string(line) : replaced(line, before);
    lines.remove_prefix(end);
  }
  return text;
}

std::vector<std::string> AbaqusParameters::notes() const {
  std::vector<std::string> notes = notes_;
  for (const auto& [name, parameter] : parameters_) {
    if (!parameter.is_used)
      notes.push_back(fmt::format("not used: *PARAMETER: {} ({}): nothing names it", name, parameter.place.text()));
  }
  return notes;
}

}  // namespace pinball
