#pragma once

#include "../../scene.hpp"
#include "key.hpp"

/// The keys of strengths that are tables of a material.
namespace pinball::schema {

template <class Visit>
constexpr void describe(Of<JohnsonCookSettings>, Visit&& visit) {
  using T = JohnsonCookSettings;
  visit(Key{"hardening_coefficient", &T::hardening_coefficient, "B", {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{"hardening_exponent", &T::hardening_exponent, "n", {.unit = "-", .bound = positive}}.idle_where(
      [](const T& law, const Scene&) { return law.hardening_coefficient == 0; }, "without hardening_coefficient"));
  visit(Key{"rate_coefficient", &T::rate_coefficient, "C", {.unit = "-", .bound = not_negative}});
  visit(Key{"reference_rate",
            &T::reference_rate,
            "at which r = 1; > 0 beside `rate_coefficient` and D4",
            {.unit = "1/T", .bound = not_negative}}
            .idle_where(
                [](const T& law, const Scene&) {
                  return law.rate_coefficient == 0 && (law.failure.size() < 4 || law.failure[3] == 0);
                },
                "without rate_coefficient or D4"));
  visit(Key{"softening_exponent", &T::softening_exponent, "m", {.unit = "-", .bound = positive}}.idle_where(
      [](const T& law, const Scene&) { return law.melting_temperature == 0; }, "without melting_temperature"));
  visit(Key{"melting_temperature",
            &T::melting_temperature,
            "> `room_temperature`; 0: heat does not soften",
            {.unit = "K", .bound = not_negative}});
  visit(
      Key{"room_temperature", &T::room_temperature, "of the undeformed material", {.unit = "K", .bound = not_negative}}
          .idle_where([](const T& law, const Scene&) { return law.melting_temperature == 0 && law.specific_heat == 0; },
                      "without melting_temperature or specific_heat"));
  visit(Key{"specific_heat",
            &T::specific_heat,
            "per mass; > 0 beside `melting_temperature`",
            {.unit = "L^2/(T^2 K)", .bound = not_negative}});
  visit(Key{"heat_share",
            &T::heat_share,
            "part of the plastic work that heats",
            {.unit = "-", .bound = {.low = 0.0, .high = 1.0}}}
            .idle_where([](const T& law, const Scene&) { return law.specific_heat == 0; }, "without specific_heat"));
  visit(Key{"failure",
            &T::failure,
            "`[D1, D2, D3, D4, D5]`: an element whose damage reaches 1 is eroded",
            {.unit = "-", .otherwise = "none"}});
  visit(Key{"damage_weakening",
            &T::damage_weakening,
            "w: part of the strength that is lost by then, in proportion to the damage",
            {.unit = "-", .bound = {.low = 0.0, .high = 1.0}}}
            .idle_where([](const T& law, const Scene&) { return law.failure.empty(); }, "without failure"));
}

template <class Visit>
constexpr void describe(Of<JohnsonHolmquistSettings>, Visit&& visit) {
  using T = JohnsonHolmquistSettings;
  visit(Key{"intact_strength", &T::intact_strength, "A", {.unit = "-", .bound = positive, .need = Need::required}});
  visit(Key{"intact_exponent", &T::intact_exponent, "N", {.unit = "-", .bound = not_negative, .need = Need::required}});
  visit(Key{"fractured_strength", &T::fractured_strength, "B", {.unit = "-", .bound = not_negative}});
  const auto no_fragments = [](const T& law, const Scene&) { return law.fractured_strength == 0; };
  visit(Key{"fractured_exponent", &T::fractured_exponent, "M", {.unit = "-", .bound = not_negative}}.idle_where(
      no_fragments, "without fractured_strength"));
  visit(Key{"most_fractured",
            &T::most_fractured,
            "F, of the strength of fragments; 0: no such limit",
            {.unit = "-", .bound = not_negative}}
            .idle_where(no_fragments, "without fractured_strength"));
  visit(Key{"rate_coefficient", &T::rate_coefficient, "C", {.unit = "-", .bound = not_negative}});
  visit(Key{"reference_rate",
            &T::reference_rate,
            "above which strength grows with the rate; > 0 beside `rate_coefficient`",
            {.unit = "1/T", .bound = not_negative}}
            .idle_where([](const T& law, const Scene&) { return law.rate_coefficient == 0; },
                        "without rate_coefficient"));
  visit(Key{"tensile_strength",
            &T::tensile_strength,
            "of the mean stress",
            {.unit = "M/(L T^2)", .bound = not_negative, .need = Need::required}});
  visit(Key{"elastic_limit",
            &T::elastic_limit,
            "HEL, Hugoniot elastic limit: stress along a shock",
            {.unit = "M/(L T^2)", .bound = positive, .need = Need::required}});
  visit(Key{"elastic_limit_pressure",
            &T::elastic_limit_pressure,
            "p_H, the pressure there, < `elastic_limit`",
            {.unit = "M/(L T^2)", .bound = positive, .need = Need::required}});
  visit(Key{"damage_coefficient",
            &T::damage_coefficient,
            "D_1; 0: it breaks where it yields",
            {.unit = "-", .bound = not_negative}});
  visit(Key{"damage_exponent", &T::damage_exponent, "D_2", {.unit = "-", .bound = not_negative}}.idle_where(
      [](const T& law, const Scene&) { return law.damage_coefficient == 0; }, "without damage_coefficient"));
  visit(Key{"quadratic_modulus", &T::quadratic_modulus, "K_2, of the pressure", {.unit = "M/(L T^2)"}});
  visit(Key{"cubic_modulus", &T::cubic_modulus, "K_3", {.unit = "M/(L T^2)"}});
  visit(Key{"bulking",
            &T::bulking,
            "beta: part of the elastic energy set free by damage that presses fragments apart",
            {.unit = "-", .bound = {.low = 0.0, .high = 1.0}}});
  visit(Key{"erodes", &T::erodes, "whether an element whose damage reaches 1 is eroded"});
}

template <class Visit>
constexpr void describe(Of<DruckerPragerSettings>, Visit&& visit) {
  using T = DruckerPragerSettings;
  visit(Key{"constant", &T::constant, "a0", {.unit = "M^2/(L^2 T^4)", .bound = not_negative}});
  visit(Key{"linear", &T::linear, "a1", {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{"quadratic", &T::quadratic, "a2; one of the three > 0", {.unit = "-", .bound = not_negative}});
  visit(Key{"largest",
            &T::largest,
            "which s:s/2 never exceeds",
            {.unit = "M^2/(L^2 T^4)", .bound = positive, .unset = Unset::infinite, .otherwise = "infinite"}});
  visit(Key{"tension_limit",
            &T::tension_limit,
            "where the mean stress reaches this there is no strength",
            {.unit = "M/(L T^2)", .bound = not_negative, .unset = Unset::infinite, .otherwise = "infinite"}});
}

template <class Visit>
constexpr void describe(Of<CrushableFoamSettings>, Visit&& visit) {
  using T = CrushableFoamSettings;
  visit(Key{"compaction",
            &T::compaction,
            "1 - V/V_0 of the points of a curve, ascending, as many as one likes; before the first the stress is as "
            "there, behind the last as between the last two, or as there where it falls",
            {.unit = "-", .need = Need::required}});
  visit(Key{"yield_stress",
            &T::yield_stress,
            "one for each of them, of each principal stress",
            {.unit = "M/(L T^2)", .bound = not_negative, .need = Need::required}});
  visit(Key{"tension_cutoff",
            &T::tension_cutoff,
            "which no principal stress exceeds",
            {.unit = "M/(L T^2)", .bound = not_negative, .unset = Unset::infinite, .otherwise = "the yield stress"}});
  visit(Key{"damping",
            &T::damping,
            "zeta: a rate of deformation adds zeta L/c of what the strain would add; L: of an element, c: the speed of "
            "waves along one axis",
            {.unit = "-", .bound = not_negative}});
  visit(Key{"air_pressure",
            &T::air_pressure,
            "P_0 at rest of the air in closed cells, whose pressure over that adds to the stress; 0: none",
            {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{"solid_share",
            &T::solid_share,
            "phi: part of the volume at rest that is not air",
            {.unit = "-", .bound = {.low = 0.0, .high = 1.0, .high_open = true}}}
            .idle_where([](const T& law, const Scene&) { return law.air_pressure == 0; }, "without air_pressure"));
}

}  // namespace pinball::schema
