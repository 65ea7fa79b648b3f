#include "info_material.hpp"

#include <fmt/core.h>

#include <algorithm>
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

void print_power(const Material& m, const Units& units) {
  fmt::print("    yield stress {}, then the power {} strain^{:.4g}\n", with_unit(m.yield_stress, units.stress),
             with_unit(m.power_hardening->coefficient, units.stress), m.power_hardening->exponent);
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

void print_johnson_cook(const Material& m, const Units& units) {
  const JohnsonCookSettings& law = *m.johnson_cook;
  fmt::print("    Johnson-Cook: A {}, B {}, n {:.4g}", with_unit(m.yield_stress, units.stress),
             with_unit(law.hardening_coefficient, units.stress), law.hardening_exponent);
  if (law.rate_coefficient > 0) {
    fmt::print(", C {:.4g} above the rate {:.6g} of the {}", law.rate_coefficient, law.reference_rate,
               rate_name(m.strain_rate));
  }
  if (law.melting_temperature > 0) {
    fmt::print(", m {:.4g} from {:.6g} to {:.6g} K", law.softening_exponent, law.room_temperature,
               law.melting_temperature);
  }
  fmt::print("\n");
  if (law.failure.empty()) return;
  const auto& d = law.failure;
  fmt::print("    failure: D1 to D5 {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}", d[0], d[1], d[2], d[3], d[4]);
  if (law.damage_weakening > 0) fmt::print(", weaker by {:.4g} until then", law.damage_weakening);
  fmt::print("\n");
}

void print_johnson_holmquist(const Material& m, const Units& units) {
  const JohnsonHolmquistSettings& law = *m.johnson_holmquist;
  fmt::print("    Johnson-Holmquist: intact A {:.4g}, N {:.4g}; fractured B {:.4g}, M {:.4g}", law.intact_strength,
             law.intact_exponent, law.fractured_strength, law.fractured_exponent);
  if (law.most_fractured > 0) fmt::print(", at most {:.4g}", law.most_fractured);
  if (law.rate_coefficient > 0) {
    fmt::print("; C {:.4g} above the rate {:.6g} of the {}", law.rate_coefficient, law.reference_rate,
               rate_name(m.strain_rate));
  }
  fmt::print("\n    Hugoniot elastic limit {}, pressure there {}, tensile strength {}\n",
             with_unit(law.elastic_limit, units.stress), with_unit(law.elastic_limit_pressure, units.stress),
             with_unit(law.tensile_strength, units.stress));
  fmt::print("    damage: D1 {:.6g}, D2 {:.6g}; pressure: K2 {}, K3 {}, bulking {:.4g}\n", law.damage_coefficient,
             law.damage_exponent, with_unit(law.quadratic_modulus, units.stress),
             with_unit(law.cubic_modulus, units.stress), law.bulking);
}

void print_drucker_prager(const DruckerPragerSettings& law, const Units& units) {
  const std::string square = units.stress.empty() ? "" : units.stress + "^2";
  fmt::print("    Drucker-Prager: s:s/2 <= {} + {} p + {:.6g} p^2", with_unit(law.constant, square),
             with_unit(law.linear, units.stress), law.quadratic);
  if (std::isfinite(law.largest)) fmt::print(", at most {}", with_unit(law.largest, square));
  if (std::isfinite(law.tension_limit)) {
    fmt::print(", no strength from the tension {} on", with_unit(law.tension_limit, units.stress));
  }
  fmt::print("\n");
}

void print_crushable_foam(const CrushableFoamSettings& law, const Units& units) {
  fmt::print("    crushable foam: yield stress {} at the compaction {:.4g} to {} at {:.4g}, {} points",
             with_unit(law.yield_stress.front(), units.stress), law.compaction.front(),
             with_unit(law.yield_stress.back(), units.stress), law.compaction.back(), law.compaction.size());
  if (std::isfinite(law.tension_cutoff)) {
    fmt::print(", no tension beyond {}", with_unit(law.tension_cutoff, units.stress));
  }
  if (law.damping > 0) fmt::print(", damping {:.4g}", law.damping);
  if (law.air_pressure > 0) {
    fmt::print(", air of {} in {:.4g} of the volume", with_unit(law.air_pressure, units.stress), 1 - law.solid_share);
  }
  fmt::print("\n");
}

void print_equation_of_state(const EquationOfStateSettings& eos, const Units& units) {
  if (eos.form == EquationOfStateForm::polynomial) {
    fmt::print("    equation of state: polynomial, c1 {}", with_unit(eos.coefficients[1], units.stress));
  } else if (eos.form == EquationOfStateForm::tabulated) {
    fmt::print("    equation of state: a table of {} points, volume strains {:.4g} to {:.4g}", eos.volume_strain.size(),
               eos.volume_strain.front(), eos.volume_strain.back());
  } else {
    fmt::print("    equation of state: Mie-Grueneisen, u_s = {} + {:.4g} u_p, Gamma {:.4g}",
               with_unit(eos.sound_speed, units.velocity), eos.slopes[0], eos.gamma);
  }
  if (eos.tension_limit > 0) fmt::print(", no tension beyond {}", with_unit(eos.tension_limit, units.stress));
  if (eos.tears) fmt::print(", and none at all from then on");
  if (!eos.bears_tension) fmt::print(", no tension");
  if (!eos.unloading_modulus.empty()) {
    const auto [least, most] = std::ranges::minmax(eos.unloading_modulus);
    fmt::print("; it crushes, and unloads with K {}", with_unit(least, units.stress));
    if (most > least) fmt::print(" to {}", with_unit(most, units.stress));
  }
  fmt::print("\n");
}

}  // namespace

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

void print_hardening(const Material& m, const Units& units) {
  if (m.equation_of_state) print_equation_of_state(*m.equation_of_state, units);
  if (m.fluid) {
    fmt::print("    fluid: viscosity {:.6g}, no strength\n", m.fluid->viscosity);
    return;
  }
  if (m.johnson_holmquist) {
    print_johnson_holmquist(m, units);
  } else if (m.drucker_prager) {
    print_drucker_prager(*m.drucker_prager, units);
  } else if (m.crushable_foam) {
    print_crushable_foam(*m.crushable_foam, units);
  } else if (m.johnson_cook) {
    print_johnson_cook(m, units);
  } else if (m.power_hardening) {
    print_power(m, units);
  } else if (m.yield_curves.empty()) {
    print_linear_hardening(m, units);
  } else {
    print_yield_curves(m, units);
  }
  print_rates(m, units);
}

void print_limits(const ErosionSettings& e, const Units& units) {
  std::string text;
  const auto say = [&text](const char* of, double limit, const std::string& unit) {
    if (limit > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", of, with_unit(limit, unit));
  };
  say("mean stress", e.tension, units.stress);
  say("pressure", e.compression, units.stress);
  say("largest principal stress", e.principal_stress, units.stress);
  say("effective stress", e.effective_stress, units.stress);
  say("largest principal strain", e.principal_strain, "");
  say("shear strain", e.shear_strain, "");
  say("time", e.time, units.time);
  if (e.smallest_step > 0)
    text += fmt::format("{}stable step below {}", text.empty() ? "" : ", ", with_unit(e.smallest_step, units.time));
  if (e.step_share > 0)
    text +=
        fmt::format("{}stable step below {:.4g} of the smallest at the start", text.empty() ? "" : ", ", e.step_share);
  fmt::print("    eroded beyond: {}\n", text);
}

}  // namespace pinball
