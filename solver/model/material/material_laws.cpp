#include "material_laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <kernels/material/principal_values.hpp>
#include <solver/scene/material/orthotropic_moduli.hpp>
#include <solver/scene/material/pressure_table.hpp>

#include "yield_curves.hpp"

namespace pinball {

namespace {

/// A number of a scene as one of the kernels.
template <class S>
constexpr auto to = [](double given) { return static_cast<S>(given); };

}  // namespace

template <class S>
JohnsonCookConstants<S> johnson_cook_constants(const Material& material) {
  JohnsonCookConstants<S> law;
  if (!material.johnson_cook) return law;
  const JohnsonCookSettings& given = *material.johnson_cook;
  law.used = true;
  law.hardening = to<S>(given.hardening_coefficient);
  law.exponent = to<S>(given.hardening_exponent);
  law.rate_sensitivity = to<S>(given.rate_coefficient);
  law.inverse_rate = to<S>(given.reference_rate > 0 ? 1 / given.reference_rate : 0);
  if (given.melting_temperature > 0) {
    law.inverse_melting = to<S>(1 / (given.melting_temperature - given.room_temperature));
  }
  law.softening_exponent = to<S>(given.softening_exponent);
  law.heating = to<S>(given.specific_heat > 0 ? given.heat_share / given.specific_heat : 0);
  law.measure = strain_rate_measure(material.strain_rate);
  std::transform(given.failure.begin(), given.failure.end(), law.failure, to<S>);
  law.weakening = to<S>(given.damage_weakening);
  return law;
}

template <class S>
JohnsonHolmquistConstants<S> brittle_constants(const Material& material) {
  JohnsonHolmquistConstants<S> law;
  if (!material.johnson_holmquist) return law;
  const JohnsonHolmquistSettings& given = *material.johnson_holmquist;
  law.used = true;
  law.intact = to<S>(given.intact_strength);
  law.intact_exponent = to<S>(given.intact_exponent);
  law.fractured = to<S>(given.fractured_strength);
  law.fractured_exponent = to<S>(given.fractured_exponent);
  if (given.most_fractured > 0) law.most_fractured = to<S>(given.most_fractured);
  law.rate_sensitivity = to<S>(given.rate_coefficient);
  law.inverse_rate = to<S>(given.reference_rate > 0 ? 1 / given.reference_rate : 0);
  law.measure = strain_rate_measure(material.strain_rate);
  law.tension = to<S>(given.tensile_strength);
  law.inverse_pressure = to<S>(1 / given.elastic_limit_pressure);
  law.stress = to<S>(1.5 * (given.elastic_limit - given.elastic_limit_pressure));
  law.failure = to<S>(given.damage_coefficient);
  law.failure_exponent = to<S>(given.damage_exponent);
  law.modulus[0] = to<S>(material.bulk_modulus);
  law.modulus[1] = to<S>(given.quadratic_modulus);
  law.modulus[2] = to<S>(given.cubic_modulus);
  law.bulking = to<S>(given.bulking);
  law.erodes = given.erodes;
  return law;
}

template <class S>
DruckerPragerConstants<S> granular_constants(const Material& material) {
  DruckerPragerConstants<S> law;
  if (!material.drucker_prager) return law;
  const DruckerPragerSettings& given = *material.drucker_prager;
  law.used = true;
  law.constant = to<S>(given.constant);
  law.linear = to<S>(given.linear);
  law.quadratic = to<S>(given.quadratic);
  law.most = to<S>(given.largest);
  law.none = to<S>(-given.tension_limit);
  if (given.quadratic > 0) law.apex = to<S>(-given.linear / (2 * given.quadratic));
  return law;
}

template <class S>
CrushableFoamConstants<S> foam_constants(const Material& material) {
  CrushableFoamConstants<S> law;
  if (!material.crushable_foam || !material.plastic) return law;
  const CrushableFoamSettings& given = *material.crushable_foam;
  const double along_one_axis = material.bulk_modulus + 4.0 / 3.0 * material.shear_modulus;
  law.used = true;
  law.cutoff = to<S>(given.tension_cutoff);
  law.damping = to<S>(given.damping * std::sqrt(material.density / along_one_axis));
  law.air_pressure = to<S>(given.air_pressure);
  law.open_share = to<S>(1 - given.solid_share);
  return law;
}

template <class S>
MooneyRivlinConstants<S> rubber_constants(const Material& material) {
  if (!material.mooney_rivlin || material.plastic) return {};
  const auto& [a, b, nu] = *material.mooney_rivlin;
  const double c = a / 2 + b, d = (a * (5 * nu - 2) + b * (11 * nu - 5)) / (2 * (1 - 2 * nu));
  return {true, to<S>(a), to<S>(b), to<S>(c), to<S>(d)};
}

template <class S>
OgdenConstants<S> ogden_constants(const Material& material) {
  OgdenConstants<S> law;
  if (!material.ogden || material.plastic) return law;
  const OgdenSettings& given = *material.ogden;
  law.used = true;
  law.whole = given.whole;
  law.terms = static_cast<int>(given.moduli.size());
  for (std::size_t p = 0; p < given.moduli.size(); ++p) {
    law.modulus[p] = to<S>(given.moduli[p]);
    law.exponent[p] = to<S>(given.exponents[p]);
  }
  if (given.whole) {
    law.coupling = to<S>(given.poisson_ratio / (1 - 2 * given.poisson_ratio));
  } else {
    law.bulk = to<S>(material.bulk_modulus);
  }
  return law;
}

namespace {

/// lambda and mu with which an isotropic material is at least as stiff in any strain: lambda of the mean of the moduli
/// between two axes, and 2 mu the largest eigenvalue of what is left, so that both are those of an isotropic one.
/// c: along the axes, where each shear is by itself (twice its modulus, as the norm of the strain is that of its
/// tensor).
std::array<double, 2> stiffest_moduli(const ElasticMatrix& c) {
  const double lambda = std::max(0.0, (c[0][1] + c[0][2] + c[1][2]) / 3);
  const double of_ends = principal_values(Symmetric<double>{c[0][0] - lambda, c[1][1] - lambda, c[2][2] - lambda,
                                                            c[0][1] - lambda, c[1][2] - lambda, c[0][2] - lambda})
                             .largest;
  return {lambda, std::max({of_ends / 2, c[3][3], c[4][4], c[5][5]})};
}

}  // namespace

template <class S>
OrthotropicConstants<S> orthotropic_constants(const Material& material) {
  OrthotropicConstants<S> law;
  if (!material.orthotropic || material.plastic) return law;
  const ElasticMatrix moduli = moduli_in_scene(*material.orthotropic);
  law.used = true;
  int k = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = i; j < 6; ++j) law.moduli[k++] = to<S>(moduli[i][j]);
  }
  const auto [lambda, mu] = stiffest_moduli(moduli_along_axes(*material.orthotropic));
  law.lambda = to<S>(lambda);
  law.mu = to<S>(mu);
  return law;
}

template <class S>
FluidConstants<S> fluid_constants(const Material& material) {
  if (!material.fluid) return {};
  return {true, to<S>(material.fluid->viscosity)};
}

template <class S>
EquationOfState<S> pressure_constants(const Material& material) {
  EquationOfState<S> eos;
  if (!material.equation_of_state) return eos;
  const EquationOfStateSettings& given = *material.equation_of_state;
  eos.tension_limit = given.tension_limit > 0 ? to<S>(given.tension_limit) : std::numeric_limits<S>::infinity();
  if (!given.bears_tension) eos.tension_limit = 0;
  eos.crushes = !given.unloading_modulus.empty();
  eos.full = to<S>(given.full_compaction);
  if (given.elastic_compaction >= 0) eos.elastic = to<S>(given.elastic_compaction);
  eos.tears = given.tears;
  if (given.form == EquationOfStateForm::polynomial) {
    eos.law = PressureLaw::polynomial;
    std::transform(given.coefficients.begin(), given.coefficients.end(), eos.polynomial, to<S>);
    eos.logarithmic = false;
    if (eos.crushes) eos.unloading[0] = to<S>(given.unloading_modulus.front());
    if (given.unloading_modulus.size() > 1) {
      const double rise = given.unloading_modulus[1] - given.unloading_modulus[0];
      eos.unloading_rise[0] = to<S>(rise / given.full_compaction);
    }
    return eos;
  }
  if (given.form == EquationOfStateForm::tabulated) {
    eos.law = PressureLaw::tabulated;
    eos.logarithmic = given.volume_measure == VolumeMeasure::logarithmic;
    eos.last = to<S>(0.0 - std::ranges::min(given.volume_strain));
    for (const TablePiece& piece : pieces_of_table(given)) {
      const int k = eos.pieces++;
      eos.strain[k] = to<S>(piece.strain);
      eos.cold[k] = to<S>(piece.cold);
      eos.cold_rise[k] = to<S>(piece.cold_rise);
      eos.thermal[k] = to<S>(piece.thermal);
      eos.thermal_rise[k] = to<S>(piece.thermal_rise);
      eos.unloading[k] = to<S>(piece.unloading);
      eos.unloading_rise[k] = to<S>(piece.unloading_rise);
    }
    return eos;
  }
  eos.law = PressureLaw::mie_grueneisen;
  eos.modulus = to<S>(material.density * given.sound_speed * given.sound_speed);
  std::transform(given.slopes.begin(), given.slopes.end(), eos.slope, to<S>);
  eos.gamma = to<S>(given.gamma);
  eos.gamma_slope = to<S>(given.gamma_slope);
  return eos;
}

template <class S>
FailureLimits<S> failure_limits(const Material& material, double smallest_step_at_start) {
  FailureLimits<S> limits;
  if (!material.erosion) return limits;
  const ErosionSettings& given = *material.erosion;
  const auto set = [](S& limit, double value) {
    if (value > 0) limit = to<S>(value);
  };
  limits.any = true;
  set(limits.tension, given.tension);
  set(limits.compression, given.compression);
  set(limits.principal_stress, given.principal_stress);
  set(limits.effective_stress, given.effective_stress);
  set(limits.principal_strain, given.principal_strain);
  set(limits.shear_strain, given.shear_strain);
  set(limits.time, given.time);
  set(limits.smallest_step, std::max(given.smallest_step, given.step_share * smallest_step_at_start));
  return limits;
}

MaterialPlaces material_places(const Material& material) {
  MaterialPlaces places;
  const auto keep = [&places](int& place, int count) {
    place = places.numbers;
    places.numbers += count;
  };
  if (material.erosion && (material.erosion->principal_strain > 0 || material.erosion->shear_strain > 0)) {
    keep(places.strain, 6);
  }
  if ((material.mooney_rivlin || material.ogden) && !material.plastic) keep(places.deformation, 6);
  if (material.orthotropic && !material.plastic) keep(places.gradient, 9);
  if (!material.plastic) return places;
  if (material.isotropic_share < 1) keep(places.back_stress, 5);
  if (const auto& law = material.johnson_cook) {
    if (law->specific_heat > 0) keep(places.temperature, 1);
    if (!law->failure.empty()) keep(places.damage, 1);
    if (!law->failure.empty() && law->damage_weakening > 0) keep(places.hardening, 1);
  }
  if (material.johnson_holmquist) {
    keep(places.damage, 1);
    keep(places.bulking, 1);
  }
  if (const auto& foam = material.crushable_foam; foam && (foam->damping > 0 || foam->air_pressure > 0)) {
    keep(places.beside, 6);
  }
  if (const auto& eos = material.equation_of_state) {
    keep(places.energy, 1);
    if (!eos->unloading_modulus.empty()) keep(places.compaction, 1);
    if (eos->tears) keep(places.torn, 1);
  }
  return places;
}

template JohnsonCookConstants<double> johnson_cook_constants<double>(const Material&);
template JohnsonCookConstants<float> johnson_cook_constants<float>(const Material&);
template JohnsonHolmquistConstants<double> brittle_constants<double>(const Material&);
template JohnsonHolmquistConstants<float> brittle_constants<float>(const Material&);
template DruckerPragerConstants<double> granular_constants<double>(const Material&);
template DruckerPragerConstants<float> granular_constants<float>(const Material&);
template CrushableFoamConstants<double> foam_constants<double>(const Material&);
template CrushableFoamConstants<float> foam_constants<float>(const Material&);
template MooneyRivlinConstants<double> rubber_constants<double>(const Material&);
template MooneyRivlinConstants<float> rubber_constants<float>(const Material&);
template OgdenConstants<double> ogden_constants<double>(const Material&);
template OgdenConstants<float> ogden_constants<float>(const Material&);
template OrthotropicConstants<double> orthotropic_constants<double>(const Material&);
template OrthotropicConstants<float> orthotropic_constants<float>(const Material&);
template FluidConstants<double> fluid_constants<double>(const Material&);
template FluidConstants<float> fluid_constants<float>(const Material&);
template EquationOfState<double> pressure_constants<double>(const Material&);
template EquationOfState<float> pressure_constants<float>(const Material&);
template FailureLimits<double> failure_limits<double>(const Material&, double);
template FailureLimits<float> failure_limits<float>(const Material&, double);

}  // namespace pinball
