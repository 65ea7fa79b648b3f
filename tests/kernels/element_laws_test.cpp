#include "strained_cube.hpp"

/// The element kernel with laws of kernels/material that have their own state: heat, damage, equations of state.
namespace pinball::element_laws_test {
namespace {

using namespace test;

template <HourglassKind kind>
constexpr ElementFeatures general{true, true, true, kind, YieldLaw::general};

/// random_element_scene of a material that has it all, near its failure.
ElementScene scene_of_laws(StrainRateMeasure measure) {
  ElementScene scene = random_element_scene();
  Random random(51);
  for (ElementState& state : scene.element) {
    if (state.mass == 0) continue;  // eroded
    state.material[material_places.temperature] = uniform(random, 0, 300);
    state.material[material_places.energy] = uniform(random, -1, 5);
    state.material[material_places.damage] = uniform(random, 0, 1);
    state.material[material_places.hardening] = uniform(random, 0, 0.5);
  }
  ElementConstants<double>& c = scene.constants;
  JohnsonCookConstants<double>& law = c.johnson_cook;
  law.used = true, law.measure = measure;
  law.hardening = 3, law.exponent = 0.3, law.rate_sensitivity = 0.02, law.inverse_rate = 10;
  law.inverse_melting = 1e-3, law.softening_exponent = 1.1, law.heating = 2;
  const double d[5] = {0.05, 0.3, -1.5, 0.01, 0.5};
  std::copy(d, d + 5, law.failure);
  law.weakening = 0.3;
  EquationOfState<double>& eos = c.pressure;
  eos.law = PressureLaw::mie_grueneisen;
  eos.modulus = c.material.lambda + 2 * c.material.mu / 3;
  eos.slope[0] = 1.5, eos.gamma = 2, eos.gamma_slope = 0.4;
  eos.tension_limit = 40;
  return scene;
}

template <HourglassKind kind>
void expect_packs_as_lanes(StrainRateMeasure measure) {
  const ElementScene scene = scene_of_laws(measure);
  const ElementOutcome expected = advance<double, general<kind>>(scene);
  const ElementOutcome found = advance<Pack<double, 8>, general<kind>>(scene);
  expect_equal(found, expected, general<kind>, 1e-12);
  bool heated = false, damaged = false;
  for (std::size_t e = 0; e < expected.element.size(); ++e) {
    const ElementState &one = found.element[e], &other = expected.element[e], &before = scene.element[e];
    for (std::size_t c = 0; c < material_numbers; ++c) {
      EXPECT_NEAR(one.material[c], other.material[c], 1e-11 * std::max(1.0, std::abs(other.material[c]))) << c;
    }
    heated = heated || other.temperature() > before.temperature();
    damaged = damaged || other.damage() > before.damage();
  }
  EXPECT_TRUE(heated && damaged);
  EXPECT_GT(expected.eroded_count, 0);
}

TEST(LawsOfElements, PacksGiveWhatTheirLanesGive) {
  for (const StrainRateMeasure measure : {StrainRateMeasure::total, StrainRateMeasure::plastic}) {
    expect_packs_as_lanes<HourglassKind::none>(measure);
    expect_packs_as_lanes<HourglassKind::viscous>(measure);
    expect_packs_as_lanes<HourglassKind::stiffness>(measure);
    expect_packs_as_lanes<HourglassKind::assumed_strain>(measure);
  }
}

/// The same of what crushes, with a strength of the pressure.
ElementScene scene_that_crushes() {
  ElementScene scene = scene_of_laws(StrainRateMeasure::total);
  ElementConstants<double>& c = scene.constants;
  c.johnson_cook.used = false;
  c.granular.used = true;
  c.granular.constant = 0.5, c.granular.linear = 0.4, c.granular.quadratic = 0.1, c.granular.apex = -2;
  EquationOfState<double>& eos = c.pressure;
  eos.law = PressureLaw::tabulated;
  eos.pieces = 3;
  const double strain[3] = {0, 0.02, 0.1}, cold[3] = {0, 2, 4}, rise[3] = {100, 25, 300};
  std::copy(strain, strain + 3, eos.strain);
  std::copy(cold, cold + 3, eos.cold);
  std::copy(rise, rise + 3, eos.cold_rise);
  std::fill(eos.unloading, eos.unloading + 3, 250.0);
  std::fill(eos.unloading_rise, eos.unloading_rise + 3, 100.0);
  eos.crushes = true;
  eos.last = 0.3, eos.tension_limit = 1;
  Random random(52);
  for (ElementState& state : scene.element) {
    if (state.mass > 0) state.material[material_places.compaction] = uniform(random, 0, 0.3);
  }
  return scene;
}

/// The same of a foam with air and a damping.
ElementScene scene_of_foam() {
  static constexpr double compaction[2] = {-0.1, 0.3}, stress[2] = {2, 4}, slope[2] = {5, 5};
  ElementScene scene = scene_of_laws(StrainRateMeasure::total);
  ElementConstants<double>& c = scene.constants;
  c.johnson_cook.used = false;
  c.pressure.law = PressureLaw::linear;
  c.hardening.points = 2, c.hardening.curves = 1;
  c.hardening.strain = compaction, c.hardening.stress = stress, c.hardening.slope = slope;
  c.foam = {true, 1.5, 0.01, 2, 0.8};
  return scene;
}

template <HourglassKind kind>
void expect_packs_of_foam_as_lanes() {
  const ElementScene scene = scene_of_foam();
  const ElementOutcome expected = advance<double, general<kind>>(scene);
  const ElementOutcome found = advance<Pack<double, 8>, general<kind>>(scene);
  expect_equal(found, expected, general<kind>, 1e-12);
  int yielded = 0;
  for (std::size_t e = 0; e < expected.element.size(); ++e) {
    const ElementState &now = expected.element[e], &before = scene.element[e];
    if (now.mass == 0) continue;
    if (now.plastic_strain > before.plastic_strain) ++yielded;
    for (int c = 0; c < 6; ++c) {
      const double beside = now.material[material_places.beside + c];
      EXPECT_NEAR(found.element[e].material[material_places.beside + c], beside, 1e-12 * (1 + std::abs(beside)));
    }
  }
  EXPECT_GT(yielded, 0);
}

TEST(LawsOfElements, PacksOfFoamGiveWhatTheirLanesGive) {
  expect_packs_of_foam_as_lanes<HourglassKind::none>();
  expect_packs_of_foam_as_lanes<HourglassKind::viscous>();
  expect_packs_of_foam_as_lanes<HourglassKind::stiffness>();
  expect_packs_of_foam_as_lanes<HourglassKind::assumed_strain>();
}

template <HourglassKind kind>
void expect_packs_that_crush_as_lanes() {
  const ElementScene scene = scene_that_crushes();
  const ElementOutcome expected = advance<double, general<kind>>(scene);
  expect_equal(advance<Pack<double, 8>, general<kind>>(scene), expected, general<kind>, 1e-12);
  int more = 0, same = 0, yielded = 0;
  for (std::size_t e = 0; e < expected.element.size(); ++e) {
    const ElementState &now = expected.element[e], &before = scene.element[e];
    if (now.mass == 0) continue;
    (now.compaction() > before.compaction() ? more : same)++;
    if (now.plastic_strain > before.plastic_strain) ++yielded;
  }
  EXPECT_GT(more, 0);
  EXPECT_GT(same, 0);
  EXPECT_GT(yielded, 0);
}

TEST(LawsOfElements, PacksThatCrushGiveWhatTheirLanesGive) {
  expect_packs_that_crush_as_lanes<HourglassKind::none>();
  expect_packs_that_crush_as_lanes<HourglassKind::viscous>();
  expect_packs_that_crush_as_lanes<HourglassKind::stiffness>();
  expect_packs_that_crush_as_lanes<HourglassKind::assumed_strain>();
}

ElementConstants<double> with_equation_of_state() {
  ElementConstants<double> c = element_constants();
  c.specific_volume = 1.0 / 3;
  c.material.yield_stress = 0.5;
  c.material.plastic_modulus = 0;
  c.hardening = HardeningConstants<double>{};
  c.pressure.law = PressureLaw::mie_grueneisen;
  c.pressure.modulus = 200;
  c.pressure.slope[0] = 1.4, c.pressure.gamma = 1.8;
  c.pressure.tension_limit = std::numeric_limits<double>::infinity();
  return c;
}

/// A law with a constant yield stress needs no curve of the general kernel.
void use_constant_strength(ElementConstants<double>& c) {
  c.johnson_cook.used = true;
  c.places.damage = c.places.hardening = -1;
}

TEST(EquationOfStateOfElements, KeepsAllWorkAsEnergyAndFollowsItsCurve) {
  ElementConstants<double> c = with_equation_of_state();
  use_constant_strength(c);
  for (const double viscosity : {0.0, 0.5}) {
    c.viscosity.linear = viscosity, c.viscosity.quadratic = 2 * viscosity;
    StrainedCube cube(c);
    for (int i = 0; i < 400; ++i) cube.strain({0, 0, -0.5}, 0, 1e-3);
    // All of the work has become e, whatever it was of: the pressure, the deviator or the bulk viscosity.
    EXPECT_NEAR(cube.state().energy(), cube.internal() + cube.viscous(), 1e-10 * cube.internal());
    EXPECT_EQ(cube.viscous() > 0, viscosity > 0);
    const double mu = 1 / cube.volume() - 1;
    const PressureParts<double> at = pressure_parts(c.pressure, mu);
    EXPECT_NEAR(cube.pressure(), at.cold + at.thermal * cube.state().energy(), 1e-9 * cube.pressure());
    if (viscosity > 0) continue;
    // The step is that of the present stiffness (stable_time_step.hpp): of S_ij two are 1/2, the third 1/2 over a^2.
    const double a = cube.volume(), stiffness = (1 + mu) * (at.cold_slope + at.thermal_slope * cube.state().energy()) +
                                                at.thermal * cube.pressure() / (1 + mu);
    const double lambda = stiffness - 2.0 / 3 * 80;
    const double square = 8 * a / 3 * (2 * 80 * 0.5 / (a * a) + lambda * (1 + 0.5 / (a * a)));
    EXPECT_GT(stiffness, 2 * 200);
    EXPECT_NEAR(cube.time_step(), 2 / std::sqrt(square), 1e-6 * cube.time_step());
  }
}

/// Elements that flow, of a viscosity of 0.3.
ElementConstants<double> with_fluid() {
  ElementConstants<double> c = with_equation_of_state();
  c.fluid = {true, 0.3};
  c.material.lambda = 200, c.material.mu = 0, c.material.yield_stress = 0;
  return c;
}

TEST(FluidOfElements, HasTheDeviatorOfItsRateAndThePressureOfItsVolume) {
  StrainedCube cube(with_fluid());
  for (int i = 0; i < 300; ++i) cube.strain({0, 0, -0.5}, 0, 1e-3);
  const double mu = 1 / cube.volume() - 1;
  const PressureParts<double> at = pressure_parts(with_fluid().pressure, mu);
  EXPECT_NEAR(cube.pressure(), at.cold + at.thermal * cube.state().energy(), 1e-9 * cube.pressure());
  EXPECT_NEAR(cube.state().energy(), cube.internal(), 1e-10 * cube.internal());  // all work, also that of s
  // Of the middle of a step: D_zz = -tanh(dk/2)/(dk/2) of the logarithmic rate.
  EXPECT_NEAR(cube.state().stress.zz + cube.pressure(), -2 * 0.3 * 0.5 * 2 / 3, 1e-7);
  EXPECT_NEAR(cube.state().stress.xx + cube.pressure(), 2 * 0.3 * 0.5 / 3, 1e-7);
  const double pressed = cube.state().energy(), dt = 1e-3;
  for (int i = 0; i < 2000; ++i) cube.strain({0, 0, 0}, 4, dt);
  EXPECT_NEAR(cube.state().stress.xy, 0.3 * 4 / cube.stretch().y, 1e-3);  // without strength, whatever the strain
  EXPECT_EQ(cube.state().plastic_strain, 0);
  const double heat = cube.state().energy() - pressed;
  EXPECT_NEAR(heat, 0.3 * 16 * 2 * cube.volume(), 1e-3 * heat);  // eta rate^2 t; e is of the undeformed volume
  EXPECT_EQ(cube.eroded(), 0);
}

/// Nothing comes back where it stops, and a step is no longer than its viscosity lets it be.
TEST(FluidOfElements, ForgetsItsShearAndShortensTheStep) {
  ElementConstants<double> c = with_fluid();
  StrainedCube cube(c);
  cube.strain({0, 0, 0}, 5, 1e-3);
  EXPECT_NEAR(cube.state().stress.xy, 0.3 * 5, 1e-2);
  cube.strain({0, 0, 0}, 0, 1e-3);
  EXPECT_NEAR(cube.state().stress.xy, 0, 1e-12);
  const double loose = cube.time_step();
  c.fluid.viscosity = 30;
  StrainedCube thick(c);
  thick.strain({0, 0, 0}, 0, 1e-3);
  // s_i = 1/2 of the cube (stable_time_step.hpp): d/2 = 4 V/m 2 eta tr S, w^2 = 8 V/m lambda tr S.
  const double half_damping = 4.0 / 3 * 2 * 30 * 1.5, square = 8.0 / 3 * 200 * 1.5;
  EXPECT_NEAR(thick.time_step(), 2 / (half_damping + std::sqrt(half_damping * half_damping + square)), 1e-3 * loose);
  EXPECT_LT(thick.time_step(), 0.5 * loose);
}

TEST(FluidOfElements, PacksGiveWhatTheirLanesGive) {
  ElementScene scene = scene_of_laws(StrainRateMeasure::total);
  scene.constants.fluid = {true, 0.3};
  scene.constants.material.lambda += 2 * scene.constants.material.mu / 3, scene.constants.material.mu = 0;
  constexpr ElementFeatures features = general<HourglassKind::viscous>;
  const ElementOutcome expected = advance<double, features>(scene);
  expect_equal(advance<Pack<double, 8>, features>(scene), expected, features, 1e-12);
}

/// What is kept lies from `place` on; take: gives the constants their law.
template <HourglassKind kind, class Take>
void expect_elastic_packs_as_lanes(int place, const Take& take) {
  ElementScene scene = random_element_scene();
  Random random(52);
  for (ElementState& state : scene.element) {
    if (state.mass == 0) continue;  // eroded
    for (int c = 0; c < 6; ++c) state.material[static_cast<std::size_t>(place + c)] = uniform(random, -0.2, 0.2);
  }
  scene.constants.never_yields = true;
  take(scene.constants);
  const ElementOutcome expected = advance<double, general<kind>>(scene);
  const ElementOutcome found = advance<Pack<double, 8>, general<kind>>(scene);
  expect_equal(found, expected, general<kind>, 1e-12);
  bool moved = false;
  for (std::size_t e = 0; e < expected.element.size(); ++e) {
    const auto &one = found.element[e].material, &other = expected.element[e].material;
    for (std::size_t c = place; c < material_numbers; ++c) {
      EXPECT_NEAR(one[c], other[c], 1e-12);
      moved = moved || other[c] != scene.element[e].material[c];
    }
  }
  EXPECT_TRUE(moved);
}

TEST(RubberOfElements, PacksGiveWhatTheirLanesGive) {
  const auto rubber = [](ElementConstants<double>& c) { c.rubber = {true, 30, 10, 25, 40}; };
  const int place = material_places.deformation;
  expect_elastic_packs_as_lanes<HourglassKind::none>(place, rubber);
  expect_elastic_packs_as_lanes<HourglassKind::viscous>(place, rubber);
  expect_elastic_packs_as_lanes<HourglassKind::stiffness>(place, rubber);
  expect_elastic_packs_as_lanes<HourglassKind::assumed_strain>(place, rubber);
}

/// Of its axes alone: lambda and mu are those of the isotropic material that the fixture has.
ElementConstants<double> with_axes(ElementConstants<double> c) {
  c.never_yields = true;
  c.orthotropic.used = true;
  c.orthotropic.lambda = 60, c.orthotropic.mu = 180;
  const double moduli[21] = {400, 80, 50, 0, 0,  0, 200, 40, 0, 0, 0,  //
                             100, 0,  0,  0, 60, 0, 0,   30, 0, 90};
  std::copy(moduli, moduli + 21, c.orthotropic.moduli);
  return c;
}

TEST(OrthotropicElements, PacksGiveWhatTheirLanesGive) {
  const auto take = [](ElementConstants<double>& c) { c = with_axes(c); };
  const int place = material_places.gradient;
  expect_elastic_packs_as_lanes<HourglassKind::none>(place, take);
  expect_elastic_packs_as_lanes<HourglassKind::viscous>(place, take);
  expect_elastic_packs_as_lanes<HourglassKind::stiffness>(place, take);
  expect_elastic_packs_as_lanes<HourglassKind::assumed_strain>(place, take);
}

/// Stretched and sheared in 200 steps: S = C : E of where it is, whatever the way, and its work is the energy.
TEST(OrthotropicElements, KeepAsEnergyWhatTheyTake) {
  const ElementConstants<double> c = with_axes(element_constants());
  StrainedCube cube(c);
  for (int i = 0; i < 200; ++i) cube.strain({0.5, -0.3, 0.2}, 0.4, 1e-3);
  const Vec3<double> l = cube.stretch();
  const double k = 0.4 * 0.2;  // dx over the undeformed y
  const Symmetric<double> e{
      0.5 * (l.x * l.x - 1), 0.5 * (l.y * l.y + k * k - 1), 0.5 * (l.z * l.z - 1), 0.5 * l.x * k, 0, 0};
  const Symmetric<double> s = product_of_moduli<double>(c.orthotropic.moduli, e);
  EXPECT_NEAR(s.xx, 400 * e.xx + 80 * e.yy + 50 * e.zz, 1e-12);
  EXPECT_NEAR(s.xy, 2 * 60 * e.xy, 1e-12);
  const double j = l.x * l.y * l.z;
  const Symmetric<double>& found = cube.state().stress;  // F S F^T / J of F = {l.x, k; l.y; l.z}
  EXPECT_NEAR(found.xx, (l.x * l.x * s.xx + 2 * l.x * k * s.xy + k * k * s.yy) / j, 1e-10);
  EXPECT_NEAR(found.xy, (l.x * l.y * s.xy + k * l.y * s.yy) / j, 1e-10);
  EXPECT_NEAR(found.yy, l.y * l.y * s.yy / j, 1e-10);
  EXPECT_NEAR(found.zz, l.z * l.z * s.zz / j, 1e-10);
  EXPECT_NEAR(cube.internal(), 0.5 * contract(s, e), 1e-4 * contract(s, e));
}

}  // namespace
}  // namespace pinball::element_laws_test
