#pragma once

#include "../../scene.hpp"
#include "key.hpp"

/// The keys of equations of state, and of the limits at which materials are eroded.
namespace pinball::schema {

template <class Visit>
constexpr void describe(Of<EquationOfStateSettings>, Visit&& visit) {
  using T = EquationOfStateSettings;
  const auto curve = [](const T& eos) { return eos.form != EquationOfStateForm::mie_grueneisen; };
  const auto shock = [](const T& eos) { return eos.form == EquationOfStateForm::mie_grueneisen; };
  const auto polynomial = [](const T& eos) { return eos.form == EquationOfStateForm::polynomial; };
  const auto tabulated = [](const T& eos) { return eos.form == EquationOfStateForm::tabulated; };
  visit(Key{"form", &T::form, "of A and B in p = A + B e"});
  visit(Key{"sound_speed",
            &T::sound_speed,
            "c, of the bulk: of a shock u_s = c + s1 u_p",
            {.unit = "L/T", .bound = positive, .need = Need::required}}
            .only_where(shock, "but with form = \"mie_grueneisen\""));
  visit(Key{"slopes", &T::slopes, "`[s1, s2, s3]`", {.unit = "-"}}.only_where(shock,
                                                                              "but with form = \"mie_grueneisen\""));
  visit(Key{"gamma", &T::gamma, "Gamma_0 of Grueneisen", {.unit = "-", .bound = not_negative}}.only_where(
      shock, "but with form = \"mie_grueneisen\""));
  visit(Key{"gamma_slope", &T::gamma_slope, "a, of its change with the density", {.unit = "-"}}.only_where(
      shock, "but with form = \"mie_grueneisen\""));
  visit(Key{"coefficients",
            &T::coefficients,
            "`[c0, c1, c2, c3, c4, c5, c6]`, the last three without a unit",
            {.unit = "M/(L T^2)", .need = Need::required}}
            .only_where(polynomial, "but with form = \"polynomial\""));
  visit(Key{"volume_strain",
            &T::volume_strain,
            "of 2 to 16 points, rising or falling, below 0 in compression; beyond the ends the last pieces go on",
            {.unit = "-", .need = Need::required}}
            .only_where(tabulated, "but with form = \"tabulated\""));
  visit(Key{"pressure",
            &T::pressure,
            "A at these points, 0 where the volume is that at rest",
            {.unit = "M/(L T^2)", .need = Need::required}}
            .only_where(tabulated, "but with form = \"tabulated\""));
  visit(Key{"energy_factor", &T::energy_factor, "B at these points; none: 0", {.unit = "-"}}.only_where(
      tabulated, "but with form = \"tabulated\""));
  visit(Key{"tension_limit",
            &T::tension_limit,
            "the pressure is never below minus this; 0: no limit",
            {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{"bears_tension", &T::bears_tension, "`false`: the pressure is never below 0"});
  visit(Key{"volume_measure", &T::volume_measure,
            "what `volume_strain` is: `\"logarithmic\"`, ln(V/V_0); `\"density\"`, 1 - rho/rho_0"}
            .only_where(tabulated, "but with form = \"tabulated\""));
  visit(Key{"unloading_modulus",
            &T::unloading_modulus,
            "`[K]` of what crushes, in tension, too, or one for each point, or two of a polynomial, without compaction "
            "and at `full_compaction`: K is straight between them; none: it goes back as it came",
            {.unit = "M/(L T^2)", .otherwise = "none"}}
            .only_where(curve, "but with form = \"polynomial\" or \"tabulated\""));
  visit(Key{"full_compaction",
            &T::full_compaction,
            "beyond it what crushes goes back as it came: a `volume_strain` without its sign, or mu of a polynomial",
            {.unit = "-", .bound = positive, .unset = Unset::infinite, .otherwise = "infinite"}}
            .only_where([](const T& eos) { return !eos.unloading_modulus.empty(); }, "without unloading_modulus"));
  visit(Key{"elastic_compaction",
            &T::elastic_compaction,
            "up to it what crushes goes back as it came, in tension, too; as `full_compaction`",
            {.unit = "-",
             .bound = not_negative,
             .unset = Unset::negative,
             .otherwise = "none: K is that of tension from the start"}}
            .only_where([](const T& eos) { return !eos.unloading_modulus.empty(); }, "without unloading_modulus"));
  visit(Key{"tears", &T::tears, "whether what has come to `tension_limit` once bears no tension any more"});
}

template <class Visit>
constexpr void describe(Of<ErosionSettings>, Visit&& visit) {
  using T = ErosionSettings;
  visit(Key{"tension",
            &T::tension,
            "of the mean stress, which is minus the pressure; 0: no such limit, here and below",
            {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{"compression", &T::compression, "of the pressure", {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{"principal_stress",
            &T::principal_stress,
            "of the largest principal stress",
            {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{"effective_stress",
            &T::effective_stress,
            "of von Mises' effective stress",
            {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{"principal_strain",
            &T::principal_strain,
            "of the largest principal strain, logarithmic where its axes stay in the material",
            {.unit = "-", .bound = not_negative}});
  visit(Key{"shear_strain",
            &T::shear_strain,
            "of half the difference of the largest and the smallest principal strain",
            {.unit = "-", .bound = not_negative}});
  visit(Key{"time", &T::time, "after it all elements of the material are eroded", {.unit = "T", .bound = not_negative}}
            .idle_where([](const T& erosion, const Scene& scene) { return erosion.time > scene.time.end; },
                        "where it lies after time.end"));
  visit(Key{"smallest_step",
            &T::smallest_step,
            "an element whose stable step is smaller is eroded",
            {.unit = "T", .bound = not_negative}});
  visit(Key{"step_share",
            &T::step_share,
            "the same, as a part of the smallest stable step at the start",
            {.unit = "-", .bound = {.low = 0.0, .high = 1.0, .high_open = true}}});
}

}  // namespace pinball::schema
