#pragma once

#include <string_view>
#include <vector>

#include "../../scene.hpp"
#include "key.hpp"
#include "pressure_and_erosion.hpp"
#include "rigid.hpp"
#include "strength.hpp"

/// The keys of materials.
namespace pinball::schema {

/// yield_curve: a curve without a rate.
struct OneYieldCurve {};

template <class Visit>
constexpr void describe(Of<YieldCurve>, Visit&& visit) {
  using T = YieldCurve;
  visit(Key{"rate",
            &T::rate,
            "at which it holds",
            {.unit = "1/T", .bound = not_negative, .need = Need::required, .done = Done::reading_by_hand}});
  visit(Key{"plastic_strain",
            &T::plastic_strain,
            "from 0, ascending",
            {.unit = "-", .bound = not_negative, .need = Need::required}});
  visit(Key{
      "stress", &T::stress, "one for each of them", {.unit = "M/(L T^2)", .bound = positive, .need = Need::required}});
}

template <class Visit>
constexpr void describe(Of<OneYieldCurve>, Visit&& visit) {
  describe(Of<YieldCurve>{}, [&visit](const auto& key) {
    if (key.name != std::string_view("rate")) visit(key);
  });
}

/// The tables that a material may have in it.
using TablesOfMaterial = Types<PowerHardeningSettings, JohnsonCookSettings, JohnsonHolmquistSettings,
                               DruckerPragerSettings, CrushableFoamSettings, MooneyRivlinSettings, OgdenSettings,
                               OrthotropicSettings, FluidSettings, EquationOfStateSettings, ErosionSettings>;
template <class Part>
requires is_one_of<Part, TablesOfMaterial>
struct IsInnerTable<Part> : std::true_type {
};

template <class Visit>
constexpr void describe(Of<PowerHardeningSettings>, Visit&& visit) {
  using T = PowerHardeningSettings;
  visit(Key{"coefficient", &T::coefficient, "K", {.unit = "M/(L T^2)", .bound = positive, .need = Need::required}});
  visit(Key{"exponent",
            &T::exponent,
            "n",
            {.unit = "-", .bound = {.low = 0.0, .low_open = true, .high = 1.0}, .need = Need::required}});
}

template <class Visit>
constexpr void describe(Of<MooneyRivlinSettings>, Visit&& visit) {
  using T = MooneyRivlinSettings;
  visit(Key{"a", &T::a, "A", {.unit = "M/(L T^2)", .bound = not_negative, .need = Need::required}});
  visit(Key{"b", &T::b, "B; A + B > 0", {.unit = "M/(L T^2)", .bound = not_negative}});
  visit(Key{
      "poisson_ratio",
      &T::poisson_ratio,
      "of small strains, whose shear modulus is 2 (A + B)",
      {.unit = "-", .bound = {.low = 0.0, .low_open = true, .high = 0.5, .high_open = true}, .need = Need::required}});
}

template <class Visit>
constexpr void describe(Of<OgdenSettings>, Visit&& visit) {
  using T = OgdenSettings;
  visit(Key{"moduli", &T::moduli, "m_p, one per term, 10 at most", {.unit = "M/(L T^2)", .need = Need::required}});
  visit(Key{"exponents",
            &T::exponents,
            "a_p, as many, none 0; half the sum of m_p a_p is the shear modulus of small strains",
            {.unit = "-", .need = Need::required}});
  visit(Key{"poisson_ratio",
            &T::poisson_ratio,
            "of small strains",
            {.unit = "-", .bound = {.low = 0.0, .high = 0.5, .high_open = true}, .need = Need::required}});
  visit(Key{"stretches",
            &T::whole,
            "what the powers are of: `\"shape\"`, without the change of volume, which has an energy of its own, of "
            "rubber; `\"whole\"`, of foam",
            {.field = "whole", .no = "shape", .yes = "whole"}});
}

template <class Visit>
constexpr void describe(Of<OrthotropicSettings>, Visit&& visit) {
  using T = OrthotropicSettings;
  visit(Key{"young_moduli", &T::young_moduli, "`[E_a, E_b, E_c]`", {.unit = "M/(L T^2)", .need = Need::required}});
  visit(Key{"poisson_ratios",
            &T::poisson_ratios,
            "`[nu_ab, nu_ac, nu_bc]`: the first of two letters is the direction of the tension, the other that of the "
            "contraction; nu_ba = nu_ab E_b/E_a",
            {.unit = "-", .need = Need::required}});
  visit(Key{"shear_moduli", &T::shear_moduli, "`[G_ab, G_ac, G_bc]`", {.unit = "M/(L T^2)", .need = Need::required}});
  visit(Key{"first_axis", &T::first_axis, "a, in the scene at the start, of any length", {.unit = "-"}});
  visit(Key{"second_axis", &T::second_axis, "in the plane of a and b, on the side of b; not along a", {.unit = "-"}});
}

template <class Visit>
constexpr void describe(Of<FluidSettings>, Visit&& visit) {
  visit(Key{"viscosity",
            &FluidSettings::viscosity,
            "eta: the deviator is 2 eta times that of the rate of deformation",
            {.unit = "M/(L T)", .bound = not_negative}});
}

/// Whether all bodies of a material are rigid.
inline bool of_rigid_bodies(const Material& material, const Scene& scene) {
  bool any = false;
  for (const Body& body : scene.bodies) {
    if (body.material != material.name) continue;
    if (!is_rigid(body, scene)) return false;
    any = true;
  }
  return any;
}

inline bool no_rates(const Material& material, const Scene&) {
  const auto& law = material.johnson_cook;
  const bool rates_of_law = law && (law->rate_coefficient > 0 || (law->failure.size() > 3 && law->failure[3] != 0));
  const bool brittle_rates = material.johnson_holmquist && material.johnson_holmquist->rate_coefficient > 0;
  return !(material.rate_constant > 0) && material.yield_curves.size() < 2 && !rates_of_law && !brittle_rates;
}

template <class Visit>
constexpr void describe(Of<Material>, Visit&& visit) {
  using T = Material;
  const auto where_it_deforms = [&visit](const auto& key) {
    visit(key.idle_where(of_rigid_bodies, "of rigid bodies"));
  };
  const auto plastic = [](const Material& material) { return material.plastic; };
  const auto solid = [](const Material& material) { return !material.fluid; };
  visit(Key{"name", &T::name, "unique", {.need = Need::required, .form = Form::name, .listed = Listed::never}});
  visit(FileKey<std::string>{"use",
                             "name of a published material of `data/materials`, which gives what is not given here, in "
                             "the units of the scene",
                             {.otherwise = "none"}});
  visit(Key{"model",
            &T::plastic,
            "neo-Hookean, for large strains, too; or von Mises plasticity",
            {.need = Need::required, .field = "plastic", .no = "elastic", .yes = "von_mises"}});
  visit(Key{"density", &T::density, "mass per volume", {.unit = "M/L^3", .bound = positive, .need = Need::required}});
  visit(Key{"bulk_modulus",
            &T::bulk_modulus,
            "K, beside `shear_modulus`",
            {.unit = "M/(L T^2)",
             .bound = positive,
             .need = Need::one_of,
             .otherwise = "required, or the two from young_modulus on",
             .done = Done::reading_by_hand}});
  visit(Key{"shear_modulus",
            &T::shear_modulus,
            "G, beside `bulk_modulus`",
            {.unit = "M/(L T^2)",
             .bound = positive,
             .need = Need::one_of,
             .otherwise = "as bulk_modulus",
             .done = Done::reading_by_hand}}
            .only_where(solid, "beside fluid"));
  visit(FileKey<double>{
      "young_modulus",
      "E, beside `poisson_ratio`",
      {.unit = "M/(L T^2)", .bound = positive, .need = Need::one_of, .otherwise = "required, or the two above"}});
  visit(FileKey<double>{"poisson_ratio",
                        "beside `young_modulus`",
                        {.unit = "-",
                         .bound = {.low = -1.0, .low_open = true, .high = 0.5, .high_open = true},
                         .need = Need::one_of,
                         .otherwise = "as young_modulus"}});
  visit(Key{"yield_stress",
            &T::yield_stress,
            "where plastic strain begins",
            {.unit = "M/(L T^2)",
             .bound = positive,
             .need = Need::one_of,
             .unset = Unset::zero,
             .otherwise = "required for `\"von_mises\"`"}}
            .only_where(has_yield_stress));
  where_it_deforms(Key{"plastic_modulus",
                       &T::plastic_modulus,
                       "H, slope of the yield stress over the effective plastic strain",
                       {.unit = "M/(L T^2)", .bound = not_negative}});
  where_it_deforms(
      Key{"ultimate_stress",
          &T::ultimate_stress,
          "hardening ends at this yield stress, >= `yield_stress`",
          {.unit = "M/(L T^2)", .bound = positive, .unset = Unset::zero_or_infinite, .otherwise = "infinite"}}
          .idle_where([](const T& material, const Scene&) { return material.plastic_modulus == 0; },
                      "without plastic_modulus")
          .only_where(plastic));
  where_it_deforms(Key{"erosion_strain",
                       &T::erosion_strain,
                       "effective plastic strain at which an element is eroded; 0: never",
                       {.unit = "-", .bound = not_negative}});
  where_it_deforms(
      Key{"isotropic_share",
          &T::isotropic_share,
          "beta: the yield surface grows by this part of H, and moves by the rest, as back stress: 1 isotropic, 0 "
          "kinematic hardening",
          {.unit = "-", .bound = {.low = 0.0, .high = 1.0}}}
          .idle_where([](const T& material, const Scene&) { return material.plastic_modulus == 0; },
                      "without plastic_modulus"));
  visit(FileKey<OneYieldCurve>{
      "yield_curve",
      "`{ plastic_strain = [0, ...], stress = [...] }`, in the place of the three stresses above: yield stress over "
      "effective plastic strain, as many points as one likes",
      {.otherwise = "none"}});
  visit(FileKey<std::vector<YieldCurve>>{
      "yield_curves", "some of these, each with its `rate` [1/T], ascending", {.otherwise = "none"}});
  visit(Field{"yield_curves", &T::yield_curves, "in the place of yield_stress, of ascending rates"});
  where_it_deforms(Key{
      "power_hardening",
      &T::power_hardening,
      "table (below), in the place of `plastic_modulus` and `ultimate_stress`: a power of the plastic strain",
      {.otherwise =
           "none"}}.only_where(plastic));
  where_it_deforms(
      Key{"rate_interpolation", &T::rate_interpolation, "between `yield_curves`: in the rate, or in its logarithm"}
          .idle_where([](const T& material, const Scene&) { return material.yield_curves.size() < 2; },
                      "without yield_curves of several rates")
          .only_where(plastic));
  where_it_deforms(
      Key{"strain_rate", &T::strain_rate,
          "of which the yield stress depends: `\"total\"`, sqrt(D:D) of the rate of deformation D; `\"deviatoric\"`, "
          "sqrt(2/3 D':D') of its deviator; `\"plastic\"`, rate of the effective plastic strain"}
          .idle_where(no_rates, "where the yield stress depends on no rate")
          .only_where(plastic));
  where_it_deforms(
      Key{"rate_constant",
          &T::rate_constant,
          "C of Cowper and Symonds: the yield stress is (1 + (rate/C)^(1/p)) times as large; 0: no such law",
          {.unit = "1/T", .bound = not_negative}});
  where_it_deforms(
      Key{"rate_exponent", &T::rate_exponent, "p, > 0 beside `rate_constant`", {.unit = "-", .bound = not_negative}}
          .idle_where([](const T& material, const Scene&) { return material.rate_constant == 0; },
                      "without rate_constant"));
  where_it_deforms(Key{"rate_stress",
                       &T::rate_stress,
                       "the law adds this stress times (rate/C)^(1/p) instead; 0: none",
                       {.unit = "M/(L T^2)", .bound = not_negative}});
  where_it_deforms(Key{
      "johnson_cook",
      &T::johnson_cook,
      "table (below), in the place of the laws of hardening and rate above; `yield_stress` is its A",
      {.otherwise =
           "none"}}.only_where(plastic));
  where_it_deforms(Key{
      "johnson_holmquist",
      &T::johnson_holmquist,
      "table (below), in the place of `yield_stress` and the laws above: ceramics, glass and rock, "
      "whose strength grows with the pressure; `bulk_modulus` is its K_1",
      {.otherwise =
           "none"}}.only_where(plastic));
  where_it_deforms(Key{
      "drucker_prager",
      &T::drucker_prager,
      "table (below), in the place of `yield_stress` and the laws above: soils, foams and concrete, whose strength "
      "grows "
      "with the pressure",
      {.otherwise =
           "none"}}.only_where(plastic));
  where_it_deforms(Key{
      "crushable_foam",
      &T::crushable_foam,
      "table (below), in the place of `yield_stress` and the laws above: foams whose principal stresses yield each by "
      "itself, at a stress of the volume",
      {.otherwise =
           "none"}}.only_where(plastic));
  visit(Key{
      "mooney_rivlin", &T::mooney_rivlin, "table (below): rubber, in the place of the moduli", {.otherwise = "none"}}
            .only_where([](const Material& material) { return !material.plastic; }, "with model = \"von_mises\""));
  visit(Key{"ogden", &T::ogden, "table (below): rubber and foam, in the place of the moduli", {.otherwise = "none"}}
            .only_where([](const Material& material) { return !material.plastic; }, "with model = \"von_mises\""));
  visit(Key{"orthotropic",
            &T::orthotropic,
            "table (below): moduli that differ with the direction, for small strains and any rotation, in the place of "
            "the moduli",
            {.otherwise = "none"}}
            .only_where([](const Material& material) { return !material.plastic; }, "with model = \"von_mises\""));
  visit(Key{"fluid",
            &T::fluid,
            "table (below), in the place of all strength, `shear_modulus` and `yield_stress`, beside an "
            "`equation_of_state`; of `\"von_mises\"`, with elements of viscous hourglass control, or none",
            {.otherwise = "none"}}
            .only_where(plastic, "with model = \"elastic\": expected \"von_mises\", which has no yield_stress then"));
  visit(Key{"equation_of_state",
            &T::equation_of_state,
            "table (below), in the place of the bulk modulus, beside `shear_modulus` or `fluid`; of `\"von_mises\"`",
            {.otherwise = "none"}}
            .only_where(plastic,
                        "with model = \"elastic\": expected \"von_mises\", with a yield_stress that is never reached "
                        "where nothing yields"));
  where_it_deforms(Key{"erosion",
                       &T::erosion,
                       "table (below) of limits: an element beyond one of them is eroded; of elastic materials, too",
                       {.otherwise = "none"}});
}

}  // namespace pinball::schema
