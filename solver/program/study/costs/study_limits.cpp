#include "study_limits.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include <solver/base/error.hpp>

namespace pinball {

namespace {

/// The number that a text begins with, and what stands behind it; NaN where it begins with none.
std::pair<double, std::string> number_and_unit(const std::string& text) {
  double number = NAN;
  const char* end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, number);
  std::string unit(problem == std::errc() ? rest : end, end);
  unit.erase(0, unit.find_first_not_of(' '));
  return {problem == std::errc() ? number : NAN, unit};
}

}  // namespace

double parse_error_share(const std::string& text) {
  const auto [number, unit] = number_and_unit(text);
  const double share = unit == "%" ? number / 100 : unit.empty() ? number : NAN;
  if (share > 0 && share < 1) return share;
  throw InputError(fmt::format("--error {}: expected a part of the value between 0 and 1, such as 1% or 0.01", text));
}

double parse_budget(const std::string& text) {
  const auto [number, unit] = number_and_unit(text);
  for (const auto& [name, seconds] : {std::pair{"", 1.0}, {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}}) {
    if (unit == name && number > 0 && std::isfinite(number)) return number * seconds;
  }
  throw InputError(fmt::format("--budget {}: expected a time above 0, such as 90s, 10min or 2h", text));
}

}  // namespace pinball
