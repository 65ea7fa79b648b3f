#include "deck_plastic_laws.hpp"

#include <fmt/format.h>

#include <solver/formats/deck/deck_brittle.hpp>
#include <solver/formats/lsdyna/layouts/definition_cards.hpp>

namespace pinball {

void tell_first_strain(DeckReport& report, const std::string& what, const DeckCurve& curve) {
  if (curve.abscissa.front() > 0)
    report.understood(fmt::format("{}: before its first plastic strain, {:.6g}, it keeps the stress {:.6g}", what,
                                  curve.abscissa.front(), curve.ordinate.front()));
}

/// ETAN is the slope over the plastic strain, and not the tangent modulus that other materials have in its place.
void set_isotropic_plastic(const Fields& f, const DeckKeys<Material>& keys) {
  keys.set("shear_modulus", f.number("G"), "g");
  keys.set("bulk_modulus", f.number("BULK"), "bulk");
  keys.set("yield_stress", f.number("SIGY"), "sigy");
  keys.set("plastic_modulus", f.number("ETAN"), "etan");
}

/// (A + B ep^N)(1 + C ln(rate/EPS0)), cold, with the pressure of small strains; the rate is that of the strain's
/// deviator, or with VP of the plastic strain.
void set_simplified_johnson_cook(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys) {
  const Card second = cards.next_or_blank();
  const Fields s = data.fields(second, layout::simplified_johnson_cook_strength);
  const double coefficient = s.number("B"), rate = s.number("C"), reference = s.number("EPS0"),
               failure = s.number("PSFAIL");
  if (coefficient != 0 && !(s.number("N") > 0)) s.fail("N", "expected more than 0 beside B");
  if (rate != 0 && !(reference > 0)) s.fail("EPS0", "expected more than 0 beside C");
  if (failure < 0) s.fail("PSFAIL", fmt::format("expected a strain >= 0, got {}", failure));
  keys.set("yield_stress", s.number("A"), "a");
  if (rate != 0) keys.set("strain_rate", f.integer("VP") == 1 ? "plastic" : "deviatoric", "vp");
  InnerKeys<JohnsonCookSettings> law;
  if (coefficient != 0) {
    law.set("hardening_coefficient", coefficient);
    law.set("hardening_exponent", s.number("N"));
  } else if (s.number("N") != 0) {
    data.report.unused(s.place(), "*MAT_SIMPLIFIED_JOHNSON_COOK: N", "B is 0");
  }
  if (rate != 0) {
    law.set("rate_coefficient", rate);
    law.set("reference_rate", reference);
  } else if (f.integer("VP") != 0) {
    data.report.unused(f.place(), "*MAT_SIMPLIFIED_JOHNSON_COOK: VP", "C is 0");
  }
  keys.set("johnson_cook", law.value(), "b, n, c, eps0");
  if (failure > 0 && failure < 1e16) keys.set("erosion_strain", failure, "psfail");
}

/// The rate is that of the strain's deviator.
void set_johnson_holmquist(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys) {
  const Card second = cards.require("EPS0, T, SFMAX, HEL, PHEL and BETA"),
             third = cards.require("D1, D2, K1, K2 and K3");
  const Fields l = data.fields(second, layout::johnson_holmquist_limits),
               d = data.fields(third, layout::johnson_holmquist_damage);
  keys.set("bulk_modulus", d.number("K1"), "k1");
  keys.set("shear_modulus", f.number("G"), "g");
  DeckBrittle law;
  law.intact = {f.number("A"), f.number("N")};
  law.fractured = {f.number("B"), f.number("M")};
  law.most_fractured = l.number("SFMAX");
  law.rate_coefficient = f.number("C");
  law.reference_rate = l.number("EPS0");
  law.tensile_strength = l.number("T");
  law.limit = l.number("HEL");
  law.limit_pressure = l.number("PHEL");
  law.damage = {d.number("D1"), d.number("D2")};
  law.quadratic = d.number("K2");
  law.cubic = d.number("K3");
  law.bulking = l.number("BETA");
  if (law.rate_coefficient != 0 && !(law.reference_rate > 0)) l.fail("EPS0", "expected more than 0 beside C");
  if (law.rate_coefficient != 0) keys.set("strain_rate", "deviatoric", "eps0");
  const std::string name = "*MAT_JOHNSON_HOLMQUIST_CERAMICS";
  for (const DeckBrittle::WithoutEffect& unused : law.without_effect({"EPS0", "M", "SFMAX", "D2"}))
    data.report.unused(f.place(), fmt::format("{}: {}", name, unused.field), unused.reason);
  keys.set("johnson_holmquist", law.keys().value(), "a, b, c, m, n, t, hel, phel, d1, d2");
  const double failure = d.number("FS");
  if (failure < 0) data.report.reject(d.place(), name + " with FS < 0", "give 0, or limits of *MAT_ADD_EROSION");
  if (failure > 0) keys.set("erosion_strain", failure, "fs");
}

GivenValue given_state_equation(const DeckStateEquation& equation, double tension_limit) {
  const EquationOfStateSettings& settings = equation.settings;
  InnerKeys<EquationOfStateSettings> keys;
  if (settings.form == EquationOfStateForm::polynomial) {
    keys.set("form", "polynomial");
    keys.set("coefficients", settings.coefficients);
  } else if (settings.form == EquationOfStateForm::tabulated) {
    keys.set("form", "tabulated");
    keys.set("volume_strain", settings.volume_strain);
    keys.set("pressure", settings.pressure);
    if (!settings.energy_factor.empty()) keys.set("energy_factor", settings.energy_factor);
    if (!settings.unloading_modulus.empty()) keys.set("unloading_modulus", settings.unloading_modulus);
  } else {
    keys.set("sound_speed", settings.sound_speed);
    keys.set("slopes", settings.slopes);
    keys.set("gamma", settings.gamma);
    keys.set("gamma_slope", settings.gamma_slope);
  }
  if (tension_limit > 0) keys.set("tension_limit", tension_limit);
  return keys.value();
}

}  // namespace pinball
