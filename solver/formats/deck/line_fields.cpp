#include "line_fields.hpp"

#include <fmt/format.h>

namespace pinball {

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
  fail_at(place_, fmt::format("{}{}: {}", keyword(), name, problem));
}

std::string LineFields::spilled(std::size_t field) const {
  const std::string_view given = fields_[field];
  if (field + 1 >= count_ || given.empty()) return {};
  const std::string_view next = fields_[field + 1];
  if (next.empty() || next.data() != given.data() + given.size()) return {};
  std::string whole = std::string(given) + std::string(next.substr(0, next.find_first_of(" \t")));
  return deck_number(whole) ? whole : std::string();
}

void LineFields::fail_to_read(std::size_t field, std::string_view name, const std::string& expected) const {
  const std::string_view given = raw(field);
  std::string got = given.empty() ? "nothing" : fmt::format("\"{}\"", given);
  if (const std::string whole = given.empty() ? "" : spilled(field); !whole.empty())
    got += fmt::format(" of {}, which goes on behind the columns of the field", whole);
  fail(fmt::format("{} (field {})", name, field + 1), fmt::format("expected {}, got {}", expected, got));
}

}  // namespace pinball
