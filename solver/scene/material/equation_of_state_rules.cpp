#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/scene_rules.hpp>

#include "pressure_table.hpp"

namespace pinball {

namespace {

constexpr std::size_t coefficients = 7;  ///< c0 ... c6

std::optional<Problem> problem_of_polynomial(const std::vector<double>& c) {
  if (c.size() != coefficients) {
    return Problem{"coefficients", fmt::format("expected seven numbers, c0 to c6, got {}", c.size())};
  }
  for (const double one : c) {
    if (!std::isfinite(one)) return Problem{"coefficients", fmt::format("expected finite numbers, got {}", one)};
  }
  if (c[0] != 0) {
    return Problem{"coefficients",
                   fmt::format("expected c0 = 0, a body at rest that presses on nothing, got {}", c[0])};
  }
  if (!(c[1] > 0)) {
    return Problem{"coefficients", fmt::format("expected c1 > 0, the bulk modulus at rest, got {}", c[1])};
  }
  return {};
}

}  // namespace

std::optional<Problem> problem_of(const EquationOfStateSettings& eos) {
  if (!eos.bears_tension && eos.tension_limit > 0) {
    return Problem{"tension_limit", fmt::format("expected 0 beside bears_tension = false, got {}", eos.tension_limit)};
  }
  for (const double one : eos.unloading_modulus) {
    if (!(one > 0 && std::isfinite(one)))
      return Problem{"unloading_modulus", fmt::format("expected numbers > 0, got {}", one)};
  }
  if (eos.elastic_compaction >= eos.full_compaction) {
    return Problem{"elastic_compaction", fmt::format("expected a number < full_compaction = {}, got {}",
                                                     eos.full_compaction, eos.elastic_compaction)};
  }
  if (eos.tears && !(eos.tension_limit > 0)) {
    return Problem{"tension_limit", fmt::format("expected a number > 0 beside tears, got {}", eos.tension_limit)};
  }
  if (eos.form == EquationOfStateForm::tabulated) return problem_of_table(eos);
  if (eos.form == EquationOfStateForm::polynomial) {
    const std::size_t moduli = eos.unloading_modulus.size();
    if (moduli > 2) {
      return Problem{"unloading_modulus", fmt::format("expected one number of a polynomial, or two, got {}", moduli)};
    }
    if (moduli == 2 && !std::isfinite(eos.full_compaction)) {
      return Problem{"full_compaction", "missing, expected that of the second unloading_modulus"};
    }
    return problem_of_polynomial(eos.coefficients);
  }
  for (const double slope : eos.slopes) {
    if (!std::isfinite(slope)) return Problem{"slopes", fmt::format("expected finite numbers, got {}", slope)};
  }
  return {};
}

double bulk_modulus_at_rest(const EquationOfStateSettings& eos, double density) {
  if (eos.form == EquationOfStateForm::mie_grueneisen) return density * eos.sound_speed * eos.sound_speed;
  if (eos.form == EquationOfStateForm::tabulated) return bulk_modulus_of_table(eos);
  if (eos.coefficients.size() != coefficients) return 0;
  return eos.unloading_modulus.empty() ? eos.coefficients[1]
                                       : std::max(eos.coefficients[1], eos.unloading_modulus.front());
}

}  // namespace pinball
