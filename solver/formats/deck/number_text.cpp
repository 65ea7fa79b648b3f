#include "number_text.hpp"

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

}  // namespace pinball
