#include <fmt/format.h>

#include <algorithm>

#include <solver/scene_rules.hpp>

namespace pinball {

namespace {

/// As far as shocks compress what is brittle [-].
constexpr double most_compression = 0.2;

/// The least slope of K_1 mu + K_2 mu^2 + K_3 mu^3 from 0 to most_compression.
double least_slope(double k1, double k2, double k3) {
  const auto slope = [&](double mu) { return k1 + mu * (2 * k2 + mu * 3 * k3); };
  double least = std::min(k1, slope(most_compression));
  const double middle = k3 > 0 ? -k2 / (3 * k3) : 0.0;  // where it is least
  if (middle > 0 && middle < most_compression) least = std::min(least, slope(middle));
  return least;
}

}  // namespace

std::optional<Problem> problem_of(const JohnsonHolmquistSettings& law, double bulk_modulus) {
  if (!(law.elastic_limit > law.elastic_limit_pressure)) {
    return Problem{"elastic_limit", fmt::format("expected a number > elastic_limit_pressure = {}, got {}",
                                                law.elastic_limit_pressure, law.elastic_limit)};
  }
  if (law.rate_coefficient > 0 && !(law.reference_rate > 0)) {
    return Problem{"reference_rate", "expected a number > 0 beside rate_coefficient"};
  }
  if (const double least = least_slope(bulk_modulus, law.quadratic_modulus, law.cubic_modulus); !(least > 0)) {
    return Problem{law.quadratic_modulus < 0 ? "quadratic_modulus" : "cubic_modulus",
                   fmt::format("expected a pressure K_1 mu + K_2 mu^2 + K_3 mu^3 that rises up to mu = {}, the slope "
                               "falls to {:.6g}",
                               most_compression, least)};
  }
  return {};
}

}  // namespace pinball
