#include "strained_cube.hpp"

/// The element kernel with Johnson and Cook's law.
namespace pinball::johnson_cook_elements_test {
namespace {

using namespace test;

TEST(JohnsonCookOfElements, IsHeatedByPlasticWorkAndSoftens) {
  ElementConstants<double> c = element_constants();
  c.specific_volume = 1.0 / 3;
  c.material.yield_stress = 0.8;
  JohnsonCookConstants<double>& law = c.johnson_cook;
  law.used = true;
  law.hardening = 0.6, law.exponent = 0.4, law.rate_sensitivity = 0.05, law.inverse_rate = 1 / 0.01;
  law.inverse_melting = 1.0 / 1000, law.softening_exponent = 1.2, law.heating = 900;  // chi/c_p
  law.measure = StrainRateMeasure::plastic;
  c.places.damage = c.places.hardening = -1;
  const double rate = 2, dt = 1e-4;
  StrainedCube cube(c);
  for (int i = 0; i < 5000; ++i) cube.strain({0, 0, 0}, rate, dt);
  // Adiabatic shear with rigid-plastic strain e: rho c_p dT = Y de, integrated finely; elastic strain is Y/(3 mu).
  const double factor = 1 + 0.05 * std::log(rate / std::sqrt(3.0) / 0.01);
  double strain = 0, heat = 0;
  const double end = rate * 5000 * dt / std::sqrt(3.0);
  const int steps = 200000;
  const auto yield = [&](double e, double temperature) {
    return (0.8 + 0.6 * std::pow(e, 0.4)) * factor * (1 - std::pow(temperature / 1000, 1.2));
  };
  double elastic = 0;
  for (int i = 0; i < steps; ++i) {
    const double middle = (i + 0.5) * end / steps;
    if (middle - yield(strain, heat) / (3 * 80) < strain) continue;  // still elastic
    const double next = middle - yield(strain, heat) / (3 * 80);
    heat += 900.0 / 3 * yield(0.5 * (strain + next), heat) * (next - strain);
    strain = next;
    elastic = yield(strain, heat);
  }
  const double found = std::sqrt(3.0) * std::hypot(cube.state().stress.xy, 0.5 * cube.state().stress.xx);
  EXPECT_NEAR(cube.state().plastic_strain, strain, 1e-3 * strain);
  EXPECT_NEAR(cube.state().temperature(), heat, 3e-3 * heat);
  EXPECT_GT(heat, 100);
  EXPECT_NEAR(found, elastic, 5e-3 * elastic);
}

/// Without heat and rates, in pure shear: D = e/e_f, and e_h = e - w e^2/(2 e_f).
TEST(JohnsonCookOfElements, IsWeakenedByDamage) {
  ElementConstants<double> c = element_constants();
  c.specific_volume = 1.0 / 3;
  c.material.yield_stress = 0.8;
  JohnsonCookConstants<double>& law = c.johnson_cook;
  law.used = true;
  law.hardening = 0.6, law.exponent = 0.4;
  law.failure[0] = 0.2, law.failure[1] = 0.4, law.weakening = 0.3;  // e_f = 0.6
  StrainedCube cube(c);
  for (int i = 0; i < 5000; ++i) cube.strain({0, 0, 0}, 2, 1e-4);
  ASSERT_EQ(cube.eroded(), 0);
  const double e = cube.state().plastic_strain, r = e - 0.3 * e * e / (2 * 0.6);
  EXPECT_GT(e, 0.5);
  EXPECT_NEAR(cube.state().damage(), e / 0.6, 1e-3);
  EXPECT_NEAR(cube.state().material[material_places.hardening], r, 2e-4 * r);
  const double found = std::sqrt(3.0) * std::hypot(cube.state().stress.xy, 0.5 * cube.state().stress.xx);
  const double strength = (1 - 0.3 * e / 0.6) * (0.8 + 0.6 * std::pow(r, 0.4));
  EXPECT_NEAR(found, strength, 2e-4 * strength);
}

TEST(JohnsonCookOfElements, FailsWhenItsDamageIsOne) {
  ElementConstants<double> c = element_constants();
  c.specific_volume = 1.0 / 3;
  c.material.yield_stress = 0.8;
  c.johnson_cook.used = true;
  c.johnson_cook.failure[0] = 0.02, c.johnson_cook.failure[1] = 0.1;  // 0.12 in pure shear
  c.johnson_cook.failure[2] = -1.5;
  StrainedCube cube(c);
  double before = 0;
  int steps = 0;
  while (cube.eroded() == 0 && steps < 10000) {
    before = cube.state().plastic_strain;
    cube.strain({0, 0, 0}, 1, 1e-4);
    ++steps;
  }
  EXPECT_NEAR(before, 0.12, 1e-3);
  EXPECT_GE(cube.state().damage(), 1);
  EXPECT_EQ(cube.state().mass, 0);
}

}  // namespace
}  // namespace pinball::johnson_cook_elements_test
