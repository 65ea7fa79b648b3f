#include <gtest/gtest.h>

#include <cmath>

#include "stretched_cube.hpp"

/// Bodies of Johnson and Holmquist's brittle materials.
namespace pinball::test::brittle_test {
namespace {

Material brittle(double density, double bulk, double shear, const JohnsonHolmquistSettings& law) {
  Material m;
  m.name = "steel";  // of the bodies of scene_of
  m.plastic = true;
  m.density = density;
  m.bulk_modulus = bulk;
  m.shear_modulus = shear;
  m.strain_rate = StrainRate::deviatoric;
  m.johnson_holmquist = law;
  return m;
}

Material alumina() {
  return brittle(3700, 130.95e9, 90.16e9,
                 {0.93, 0.6, 0.31, 0.6, 0, 0, 0, 0.2e9, 2.79e9, 1.46e9, 0.005, 1, 0, 0, 1, false});
}
Material glass() {
  return brittle(
      2530, 45.4e9, 30.4e9,
      {0.93, 0.77, 0.088, 0.35, 0.5, 0.003, 1, 0.15e9, 5.95e9, 2.92e9, 0.053, 0.85, -138e9, 290e9, 1, false});
}
Material carbide() {
  return brittle(2510, 233e9, 197e9,
                 {0.927, 0.67, 0.7, 0.85, 0.2, 0.005, 1, 0.26e9, 19e9, 8.71e9, 0.001, 0.5, -593e9, 2800e9, 0.7, false});
}

/// The equations of the paper, of a cube that is stretched along its edges.
struct Integration {
  explicit Integration(const Material& m) : material(m), law(*m.johnson_holmquist) {}

  void stretch_to(const std::array<double, 3>& edges, double dt) {
    std::array<double, 3> strain{};
    double sum = 0, volume = 1, square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      strain[k] = 2 * (edges[k] - edge[k]) / (edges[k] + edge[k]);
      sum += strain[k];
      volume *= edges[k];
    }
    edge = edges;
    double rate = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double part = strain[k] - sum / 3;
      deviator[k] += 2 * material.shear_modulus * part;
      rate += 2.0 / 3 * part * part / (dt * dt);
      square += 1.5 * deviator[k] * deviator[k];
    }
    const double mu = 1 / volume - 1, q = std::sqrt(square), elastic = material.bulk_modulus * mu;
    pressure = elastic + bulking;
    if (mu > 0) pressure += mu * mu * (law.quadratic_modulus + law.cubic_modulus * mu);
    pressure = std::max(pressure, -law.tensile_strength * (1 - damage));
    const double factor = law.rate_coefficient > 0
                              ? 1 + law.rate_coefficient * std::log(std::max(1.0, std::sqrt(rate) / law.reference_rate))
                              : 1;
    const double before = strength(factor);
    if (!(q > before)) return;
    const double increment = (q - before) / (3 * material.shear_modulus);
    for (double& s : deviator) s *= before / q;
    plastic += increment;
    const double above = (pressure + law.tensile_strength) / law.elastic_limit_pressure;
    const double ductility = above > 0 ? law.damage_coefficient * std::pow(above, law.damage_exponent) : 0;
    damage = ductility > 0 ? std::min(1.0, damage + increment / ductility) : 1;
    const double after = strength(factor), freed = (before * before - after * after) / (6 * material.shear_modulus);
    if (!(freed > 0 && mu > 0)) return;
    const double pressed = elastic + bulking;
    bulking = std::sqrt(pressed * pressed + 2 * law.bulking * material.bulk_modulus * freed) - elastic;
  }

  const Material& material;
  const JohnsonHolmquistSettings& law;
  std::array<double, 3> edge{1, 1, 1}, deviator{};
  double pressure = 0, damage = 0, bulking = 0, plastic = 0;

 private:
  double strength(double factor) const {
    const double over = pressure / law.elastic_limit_pressure,
                 above = over + law.tensile_strength / law.elastic_limit_pressure;
    const double intact = above > 0 ? law.intact_strength * std::pow(above, law.intact_exponent) : 0;
    double fractured = over > 0 ? law.fractured_strength * std::pow(over, law.fractured_exponent) : 0;
    fractured *= factor;
    if (law.most_fractured > 0) fractured = std::min(fractured, law.most_fractured);
    return 1.5 * (law.elastic_limit - law.elastic_limit_pressure) *
           ((1 - damage) * factor * intact + damage * fractured);
  }
};

std::array<double, 3> pressed_and_let_go(double part) {
  return {1, 1, 1 - 0.12 * std::sin(M_PI * part) * (part < 0.5 ? 1 : 0.8) - (part < 0.5 ? 0 : 0.024)};
}
std::array<double, 3> pulled_and_pressed(double part) {
  return {1, 1, part < 0.3 ? 1 + 0.02 * part : 1.006 - 0.1 * (part - 0.3)};
}
std::array<double, 3> pressed_then_sheared(double part) {
  const double pressed = 1 - 0.03 * std::min(1.0, 2 * part), sheared = std::exp(0.1 * std::max(0.0, part - 0.5));
  return {pressed * sheared, pressed / sheared, pressed};
}

double damage_of(const Solver<double>& solver) {
  const Model<double>& model = solver.model();
  return model.elements.material_number(model.slot_of_element[0], model.constants[0].places.damage);
}

TEST(Brittle, FollowsTheEquationsOfThePaper) {
  bool pressed_by_fragments = false, broken = false, partly_broken = false;
  for (const Material& material : {alumina(), glass(), carbide()}) {
    for (const Way way : {pressed_and_let_go, pulled_and_pressed, pressed_then_sheared}) {
      constexpr double end = 4e-4;
      Integration expected(material);
      double largest = 1e6;
      const auto last = stretch_cube(material, way, end, [&](const Solver<double>& solver, double now, double dt) {
        if (dt > 0) expected.stretch_to(way(now / end), dt);
        const std::array<double, 6> stress = stress_of(solver, 0);
        for (std::size_t k = 0; k < 3; ++k) {
          const double own = expected.deviator[k] - expected.pressure;
          largest = std::max(largest, std::abs(own));
          ASSERT_NEAR(stress[k], own, 1e-10 * largest) << material.density << " at " << now;
        }
        partly_broken = partly_broken || (expected.damage > 0.2 && expected.damage < 0.8);
      });
      EXPECT_NEAR(damage_of(*last), expected.damage, 1e-9);
      EXPECT_GT(expected.plastic, 1e-3);
      broken = broken || expected.damage == 1;
      pressed_by_fragments = pressed_by_fragments || expected.bulking > 1e8;
    }
  }
  EXPECT_TRUE(broken);
  EXPECT_TRUE(partly_broken);
  EXPECT_TRUE(pressed_by_fragments);
}

}  // namespace
}  // namespace pinball::test::brittle_test
