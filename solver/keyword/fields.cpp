#include "fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

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

Fields::Fields(const Card& card, const Parameters& parameters, std::span<const int> widths)
    : parameters_(&parameters), place_(card.place), log_(card.log), line_(card.text.data()) {
  std::string_view rest = card.text;
  if (rest.find(',') != std::string_view::npos) {
    cut_at_commas(rest);
    return;
  }
  // Nobody knows what columns a tab stands for.
  if (const std::size_t tab = rest.find('\t');
      tab != std::string_view::npos && tab + 1 < rest.find_last_not_of(" \t") + 1)
    fail_at(place_, "there is a tab in a card of columns: expected blanks, or commas between the fields");
  for (const int width : widths) {
    if (rest.empty()) break;
    const std::size_t length = std::min<std::size_t>(static_cast<std::size_t>(width), rest.size());
    fields_[count_++] = trimmed(rest.substr(0, length));
    rest.remove_prefix(length);
  }
}

Fields::~Fields() {
  if (log_ == nullptr) return;
  std::uint32_t left = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const bool is_open = (asked_ >> i & 1U) == 0 && !fields_[i].empty();
    if (is_open && deck_number(fields_[i]) != 0.0) left |= 1U << i;  // 0 is a blank
  }
  log_->left(line_, left);
}

void Fields::cut_at_commas(std::string_view rest) {
  while (count_ < most_fields) {
    const std::size_t comma = rest.find(',');
    fields_[count_++] = trimmed(rest.substr(0, comma));
    if (comma == std::string_view::npos) return;
    rest.remove_prefix(comma + 1);
  }
  if (rest.find_first_not_of(", \t\r") != std::string_view::npos)
    fail_at(place_, fmt::format("expected at most {} fields between commas, got more", most_fields));
}

std::string_view Fields::raw(std::size_t field) const {
  if (field >= count_) return {};
  asked_ |= 1U << field;
  return fields_[field];
}

std::string Fields::text(std::size_t field) const {
  const std::string_view given = raw(field);
  const bool parameter = given.starts_with('&') || given.starts_with("-&");
  return parameter ? parameters_->value(given, place_) : std::string(given);
}

std::int64_t Fields::integer(std::size_t field, const char* name, std::optional<std::int64_t> otherwise) const {
  std::string_view given = raw(field);
  if (given.empty()) return otherwise ? *otherwise : (fail(field, name, "a whole number"), 0);
  std::string value;
  if (given.find('&') != std::string_view::npos) given = value = text(field);
  if (const std::optional<std::int64_t> number = deck_integer(given)) return *number;
  fail(field, name, "a whole number");
}

double Fields::number(std::size_t field, const char* name, std::optional<double> otherwise) const {
  std::string_view given = raw(field);
  if (given.empty()) return otherwise ? *otherwise : (fail(field, name, "a number"), 0.0);
  std::string value;
  if (given.find('&') != std::string_view::npos) given = value = text(field);
  if (const std::optional<double> number = deck_number(given)) return *number;
  fail(field, name, "a number");
}

void Fields::fail(std::size_t field, const char* name, const std::string& expected) const {
  const std::string_view given = raw(field);
  fail_at(place_, fmt::format("{} (field {}): expected {}, got {}", name, field + 1, expected,
                              given.empty() ? "nothing" : fmt::format("\"{}\"", given)));
}

}  // namespace pinball
