#include "radioss_hardening.hpp"

#include <fmt/format.h>

#include <cmath>

#include <solver/scene_material.hpp>

namespace pinball {

void RadiossHardening::take_ultimate(double young, const DeckPlace& place) {
  const double engineering = factor, elongation = exponent;
  const double stress = engineering * (1 + elongation), strain = std::log(1 + elongation);
  exponent = stress * strain / (stress - yield);
  factor = stress / (exponent * std::pow(strain, exponent - 1));
  if (exponent > 1) {  // as the starter has it: a line through both points
    exponent = 1;
    factor = (stress - yield) / (strain - stress / young - yield / young);
  }
  if (!(exponent > 0 && factor > 0 && std::isfinite(factor)))
    fail_at(place, fmt::format("SIG_Y, UTS, EUTS: expected UTS (1 + EUTS) > SIG_Y and EUTS > 0, got {}, {}, {}", yield,
                               engineering, elongation));
}

GivenValue RadiossHardening::curve() const {
  constexpr int pieces = 128;
  constexpr double farthest = 4.0;  // strain
  const bool ends = limit > 0 && limit < 1e19;
  double end = farthest;
  if (ends) end = limit <= yield || factor == 0 ? 0 : std::pow((limit - yield) / factor, 1 / exponent);
  std::vector<double> strain{0}, stress{ends && limit < yield ? limit : yield};
  for (int i = 1; i <= pieces && end > 0; ++i) {  // closer together where a root rises steeply
    const double x = static_cast<double>(i) / pieces;
    strain.push_back(end * std::pow(x, 4));
    stress.push_back(yield + factor * std::pow(strain.back(), exponent));
  }
  if (ends) {
    strain.push_back(end + 1);
    stress.push_back(end > 0 ? limit : stress.front());
    if (end > 0) stress[stress.size() - 2] = limit;
  }
  InnerKeys<YieldCurve> keys;
  keys.set("plastic_strain", strain);
  keys.set("stress", stress);
  return keys.value();
}

}  // namespace pinball
