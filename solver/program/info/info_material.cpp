#include "info_material.hpp"

#include <fmt/core.h>

#include <cmath>

namespace pinball {

namespace {

void print_linear_hardening(const Material& m, const Units& units) {
  fmt::print("    yield stress {}, plastic modulus {}", with_unit(m.yield_stress, units.stress),
             with_unit(m.plastic_modulus, units.stress));
  if (m.ultimate_stress > 0 && std::isfinite(m.ultimate_stress))
    fmt::print(", ultimate stress {}", with_unit(m.ultimate_stress, units.stress));
  fmt::print("\n");
  if (m.isotropic_share < 1) {
    fmt::print("    hardening: {:.4g} isotropic, {:.4g} kinematic\n", m.isotropic_share, 1 - m.isotropic_share);
  }
}

void print_yield_curves(const Material& m, const Units& units) {
  for (const YieldCurve& curve : m.yield_curves) {
    fmt::print("    yield curve");
    if (m.yield_curves.size() > 1) fmt::print(" at the strain rate {:.6g}", curve.rate);
    fmt::print(": {} point{}, from {} to {} at plastic strain {:.4g}\n", curve.stress.size(),
               curve.stress.size() == 1 ? "" : "s", with_unit(curve.stress.front(), units.stress),
               with_unit(curve.stress.back(), units.stress), curve.plastic_strain.back());
  }
}

const char* rate_name(StrainRate rate) {
  return rate == StrainRate::total        ? "total strain"
         : rate == StrainRate::deviatoric ? "deviatoric strain"
                                          : "plastic strain";
}

void print_rates(const Material& m, const Units& units) {
  if (m.rate_constant > 0) {
    fmt::print("    Cowper-Symonds: C {:.6g}, p {:.4g}, rate of the {}", m.rate_constant, m.rate_exponent,
               rate_name(m.strain_rate));
    if (m.rate_stress > 0) fmt::print(", adds to the yield stress, by {}", with_unit(m.rate_stress, units.stress));
    fmt::print("\n");
  } else if (m.yield_curves.size() > 1) {
    fmt::print("    {} between curves, rate of the {}\n",
               m.rate_interpolation == RateInterpolation::linear ? "linear" : "logarithmic", rate_name(m.strain_rate));
  }
}

}  // namespace

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

void print_hardening(const Material& m, const Units& units) {
  if (m.yield_curves.empty()) {
    print_linear_hardening(m, units);
  } else {
    print_yield_curves(m, units);
  }
  print_rates(m, units);
}

}  // namespace pinball
