#include <fmt/format.h>

#include <cmath>

#include <solver/scene_rules.hpp>

namespace pinball {

namespace {

std::optional<Problem> problem_of_heat(const JohnsonCookSettings& law) {
  const bool softens = law.melting_temperature > 0;
  if (softens && !(law.melting_temperature > law.room_temperature)) {
    return Problem{"melting_temperature", fmt::format("expected a number > room_temperature = {}, got {}",
                                                      law.room_temperature, law.melting_temperature)};
  }
  if (softens && !(law.specific_heat > 0)) {
    return Problem{"specific_heat", "expected a number > 0 beside melting_temperature"};
  }
  return {};
}

std::optional<Problem> problem_of_failure(const JohnsonCookSettings& law) {
  const std::vector<double>& d = law.failure;
  if (d.empty()) return {};
  if (d.size() != 5) return Problem{"failure", fmt::format("expected five numbers, D1 to D5, got {}", d.size())};
  for (const double one : d) {
    if (!std::isfinite(one)) return Problem{"failure", fmt::format("expected finite numbers, got {}", one)};
  }
  if (!(d[0] + d[1] > 0)) {
    return Problem{"failure",
                   fmt::format("expected D1 + D2 > 0, the strain at failure in pure shear, got {:.6g}", d[0] + d[1])};
  }
  if (d[3] != 0 && !(law.reference_rate > 0)) return Problem{"reference_rate", "expected a number > 0 beside D4"};
  if (d[4] != 0 && !(law.melting_temperature > 0)) {
    return Problem{"melting_temperature", "expected a number > 0 beside D5"};
  }
  return {};
}

}  // namespace

std::optional<Problem> problem_of(const JohnsonCookSettings& law) {
  if (law.rate_coefficient > 0 && !(law.reference_rate > 0)) {
    return Problem{"reference_rate", "expected a number > 0 beside rate_coefficient"};
  }
  if (const auto problem = problem_of_heat(law)) return problem;
  return problem_of_failure(law);
}

}  // namespace pinball
