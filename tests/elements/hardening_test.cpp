#include <gtest/gtest.h>

#include <solver/summary.hpp>
#include <tests/support/solver_case.hpp>

/// Runs with materials of YieldLaw::general.
namespace pinball::hardening_test {
namespace {

using namespace test;

Material steel(double isotropic_share = 1) {
  Material m = plastic_material("steel", 3e8, 0);
  m.plastic_modulus = 4e9;
  m.isotropic_share = isotropic_share;
  return m;
}

Material with_curves() {
  Material m = steel();
  m.plastic_modulus = 0;
  m.yield_curves = {{1, {0, 0.01, 0.1}, {3e8, 4e8, 4.2e8}}, {1000, {0, 0.03}, {4e8, 5e8}}};
  m.rate_interpolation = RateInterpolation::logarithmic;
  return m;
}

Material with_rate(StrainRate rate, double isotropic_share = 1) {
  Material m = steel(isotropic_share);
  m.rate_constant = 500;
  m.rate_exponent = 4;
  m.strain_rate = rate;
  return m;
}

Material with_power(StrainRate rate) {
  Material m = with_rate(rate);
  m.plastic_modulus = 0;
  m.power_hardening = PowerHardeningSettings{2 * m.yield_stress, 0.2};
  return m;
}

/// Johnson and Cook beside an equation of state: heat and energy are kept.
Material with_heat(StrainRate rate) {
  Material m = steel();
  m.plastic_modulus = 0;
  m.strain_rate = rate;
  m.johnson_cook = JohnsonCookSettings{5e8, 0.4, 0.02, 1, 1.1, 1000, 300, 450, 1, {}};
  m.equation_of_state.emplace();
  m.equation_of_state->sound_speed = std::sqrt(m.bulk_modulus / m.density);
  m.equation_of_state->slopes = {1.5, 0, 0};
  m.equation_of_state->gamma = 2;
  return m;
}

Material with_damage() {
  Material m = with_heat(StrainRate::plastic);
  m.johnson_cook->failure = {0.5, 1, -1.5, 0, 0};
  m.johnson_cook->damage_weakening = 0.5;
  return m;
}

/// Aluminium oxide, weaker than it is, so that it breaks and is pressed apart.
Material that_breaks() {
  Material m = steel();
  m.yield_stress = m.plastic_modulus = 0;
  m.strain_rate = StrainRate::deviatoric;
  m.johnson_holmquist =
      JohnsonHolmquistSettings{0.93, 0.6, 0.31, 0.6, 0, 0.01, 1, 2e8, 2.8e9, 1.46e9, 0.05, 1, 1e10, 2e10, 1, false};
  return m;
}

std::vector<Material> materials() {
  return {steel(0),
          steel(0.5),
          with_curves(),
          with_rate(StrainRate::total),
          with_rate(StrainRate::plastic, 0.3),
          with_power(StrainRate::total),
          with_power(StrainRate::plastic),
          with_heat(StrainRate::deviatoric),
          with_heat(StrainRate::plastic),
          with_damage(),
          that_breaks(),
          soil_material("steel"),
          foam_material("steel")};
}

/// A bar that strikes a wall with its edge first: it yields, bends and springs back.
Scene bar_at_wall(const Material& material, HourglassControl hourglass = HourglassControl::assumed_strain) {
  Body bar = block("bar", {8, 3, 3}, 0.1, {0, 0, 0.1}, {0, 0, -60});
  bar.axis = Point{0.3, 0.1, 1};
  Scene scene = scene_of({bar}, 2e-3, false);
  scene.element.hourglass = hourglass;
  scene.element.bulk_viscosity = true;
  scene.rigid_walls = {{"floor", {{0, 0, -0.2}, {0, 0, 1}}, "", "here"}};
  scene.materials = {material};
  return scene;
}

TEST(Hardening, KeepsTheBalanceOfEnergy) {
  for (const Material& material : materials()) {
    for (const HourglassControl hourglass : {HourglassControl::assumed_strain, HourglassControl::stiffness,
                                             HourglassControl::viscous, HourglassControl::none}) {
      Solver<double> solver(bar_at_wall(material, hourglass));
      EXPECT_LT(worst_balance_of_run(solver), 5e-3);
      RunSummary summary;
      fill_summary(solver, summary);
      EXPECT_GT(summary.bodies[0].max_plastic_strain, 0.02);
      EXPECT_GT(summary.energy.internal, 0.1 * summary.initial_total);
    }
  }
}

TEST(Hardening, StoresBackStressWhereASurfaceMoves) {
  for (const Material& material : {steel(), with_curves(), with_rate(StrainRate::plastic)}) {
    EXPECT_TRUE(Solver<double>(bar_at_wall(material)).model().elements.material_state.empty());
  }
  Solver<double> solver(bar_at_wall(steel(0.5)));
  run(solver);
  double largest = 0;
  const auto& back = std::as_const(solver).model().elements.material_state;
  for (std::size_t i = 0; i < back.size(); ++i) largest = std::max(largest, std::abs(back[i]));
  EXPECT_GT(largest, 1e7);
  EXPECT_LT(largest, 0.5 * 4e9);
}

std::uint64_t hash_of_run(const Scene& scene, int threads) {
  DefaultExecutionSpace::set_concurrency(threads);
  Solver<double> solver(scene);
  run(solver);
  DefaultExecutionSpace::set_concurrency(1);
  return state_hash(std::as_const(solver).model());
}

TEST(Hardening, GivesTheSameBitsForAnyNumberOfThreads) {
  for (const Material& material : materials()) {
    const Scene scene = bar_at_wall(material);
    EXPECT_EQ(hash_of_run(scene, 1), hash_of_run(scene, 3));
  }
}

TEST(Hardening, RestingTilesChangeNoBit) {
  Scene scene = scene_of({block("a", {4, 4, 200}, 0.1, {0, 0, 0}, {0, 0, -40})}, 6e-4, false);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.materials = {with_rate(StrainRate::plastic, 0.5)};
  const std::uint64_t resting = hash_of_run(scene, 1);
  scene.skip.resting = false;
  EXPECT_EQ(hash_of_run(scene, 1), resting);
}

/// From its lowest node to its highest at the end [length].
template <class S>
double height_of_bar(const Scene& scene) {
  Solver<S> solver(scene);
  run(solver);
  const FieldSnapshot end = snapshot(solver);
  const auto [low, high] = std::minmax_element(end.position.begin(), end.position.end(),
                                               [](const Point& a, const Point& b) { return a[2] < b[2]; });
  return (*high)[2] - (*low)[2];
}

TEST(Hardening, IsTheSameInSinglePrecisionAndWithSubcycling) {
  for (const Material& material : materials()) {
    Scene scene = bar_at_wall(material);
    const double height = height_of_bar<double>(scene);
    EXPECT_NEAR(height_of_bar<float>(scene), height, 1e-3 * height);
    scene.time.subcycling = true;
    EXPECT_NEAR(height_of_bar<double>(scene), height, 1e-2 * height);
  }
}

TEST(Hardening, HeatsByPlasticWork) {
  const Scene scene = bar_at_wall(with_heat(StrainRate::plastic));
  Solver<double> solver(scene);
  run(solver);
  const FieldSnapshot end = snapshot(solver);
  double heat = 0, internal = 0;
  for (std::size_t e = 0; e < end.temperature.size(); ++e) {
    EXPECT_GE(end.temperature[e], 300);
    heat += (end.temperature[e] - 300) * 450 * solver.model().element_mass[e];
  }
  RunSummary summary;
  fill_summary(solver, summary);
  internal = summary.energy.internal;
  // All of the internal energy but what is elastic and what hourglass modes lost.
  EXPECT_LT(heat, internal);
  EXPECT_GT(heat, 0.7 * internal);
  EXPECT_TRUE(end.damage.empty());
}

TEST(Hardening, ErodesByDamage) {
  Material material = with_heat(StrainRate::plastic);
  material.johnson_cook->failure = {0.01, 0.02, -1.5, 0, 0};
  Solver<double> solver(bar_at_wall(material));
  EXPECT_LT(worst_balance_of_run(solver), 2e-2);
  EXPECT_GT(solver.counts().eroded_elements(), 0);
  const FieldSnapshot end = snapshot(solver);
  double largest = 0;
  for (std::size_t e = 0; e < end.damage.size(); ++e) {
    if (end.alive[e] == 1) largest = std::max(largest, end.damage[e]);
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 1);
}

TEST(Hardening, Erodes) {
  for (Material material : materials()) {
    material.erosion_strain = 0.01;
    Solver<double> solver(bar_at_wall(material));
    EXPECT_LT(worst_balance_of_run(solver), 2e-2);
    EXPECT_GT(solver.counts().eroded_elements(), 0);
  }
}

}  // namespace
}  // namespace pinball::hardening_test
