#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <solver/scene_rules.hpp>
#include <solver/simulation.hpp>
#include <solver/summary.hpp>

#include "stretched_cube.hpp"

/// Bodies that crush, and whose strength grows with the pressure.
namespace pinball::test::granular_test {
namespace {

Material granular(double density, double shear, const DruckerPragerSettings& strength,
                  const EquationOfStateSettings& pressure) {
  Material m;
  m.name = "steel";  // of the bodies of scene_of
  m.plastic = true;
  m.density = density;
  m.shear_modulus = shear;
  m.drucker_prager = strength;
  m.equation_of_state = pressure;
  m.bulk_modulus = bulk_modulus_at_rest(pressure, density);
  return m;
}

/// Sand of a cone, which hardly bears tension, with a modulus of unloading that grows.
Material sand() {
  EquationOfStateSettings p;
  p.form = EquationOfStateForm::tabulated;
  p.volume_strain = {0, -0.02, -0.08, -0.2};
  p.pressure = {0, 1e6, 1e7, 1e8};
  p.unloading_modulus = {2e8, 3e8, 6e8, 2e9};
  p.tension_limit = 1e4;
  return granular(1800, 8e7, {1e8, 2e4, 0.3}, p);
}
/// Foam of a constant strength, over the density.
Material foam() {
  EquationOfStateSettings p;
  p.form = EquationOfStateForm::tabulated;
  p.volume_measure = VolumeMeasure::density;
  p.volume_strain = {-0.9, -0.5, -0.02, 0};
  p.pressure = {6e6, 8e5, 4e5, 0};
  p.unloading_modulus = {3e7};
  p.bears_tension = false;
  p.full_compaction = 0.12;
  return granular(60, 9e6, {1.2e10, 0, 0}, p);
}
/// Concrete, along a polynomial, with a largest strength.
Material concrete() {
  EquationOfStateSettings p;
  p.form = EquationOfStateForm::polynomial;
  p.coefficients = {0, 5e9, 2e10, 4e10, 0, 0, 0};
  p.unloading_modulus = {1.6e10};
  p.tension_limit = 5e6;
  Material m = granular(2300, 9e9, {4e12, 6e6, 0.4}, p);
  m.drucker_prager->largest = 4e16;
  m.drucker_prager->tension_limit = 5e6;
  return m;
}

/// The law by itself, of a cube that is stretched along its edges.
struct Integration {
  explicit Integration(const Material& m) : material(m), eos(*m.equation_of_state), law(*m.drucker_prager) {}

  void stretch_to(const std::array<double, 3>& edges) {
    std::array<double, 3> strain{};
    double sum = 0, volume = 1, square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      strain[k] = 2 * (edges[k] - edge[k]) / (edges[k] + edge[k]);
      sum += strain[k];
      volume *= edges[k];
    }
    edge = edges;
    const bool logarithmic =
        eos.form == EquationOfStateForm::tabulated && eos.volume_measure == VolumeMeasure::logarithmic;
    const double x = logarithmic ? -std::log(volume) : 1 / volume - 1;
    pressure = curve(x);
    if (x < most) {
      pressure = std::min(pressure, curve(most) + modulus(most) * (x - most));
      unloaded = true;
    }
    most = std::min(std::max(most, x), eos.full_compaction);
    const double limit = !eos.bears_tension ? 0 : eos.tension_limit;
    torn = torn || pressure < -limit;
    pressure = std::max(pressure, -limit);
    for (std::size_t k = 0; k < 3; ++k) {
      deviator[k] += 2 * material.shear_modulus * (strain[k] - sum / 3);
      square += 0.5 * deviator[k] * deviator[k];
    }
    double allowed = law.constant + law.linear * pressure + law.quadratic * pressure * pressure;
    if (pressure <= -law.tension_limit) allowed = 0;
    capped = capped || allowed > law.largest;
    allowed = std::clamp(allowed, 0.0, law.largest);
    if (!(square > allowed)) return;
    plastic += (std::sqrt(square) - std::sqrt(allowed)) / (std::sqrt(3.0) * material.shear_modulus);
    for (double& s : deviator) s *= std::sqrt(allowed / square);
  }

  const Material& material;
  const EquationOfStateSettings& eos;
  const DruckerPragerSettings& law;
  std::array<double, 3> edge{1, 1, 1}, deviator{};
  double pressure = 0, most = 0, plastic = 0;
  bool unloaded = false, torn = false, capped = false;

 private:
  /// Between the points of a table, from the smallest compression on.
  double between(double x, const std::vector<double>& values) const {
    std::vector<std::pair<double, double>> points;
    for (std::size_t k = 0; k < values.size(); ++k) points.emplace_back(-eos.volume_strain[k], values[k]);
    std::sort(points.begin(), points.end());
    std::size_t k = 1;
    while (k + 1 < points.size() && x > points[k].first) ++k;
    const auto& [from, low] = points[k - 1];
    const auto& [to, high] = points[k];
    return low + (high - low) * (x - from) / (to - from);
  }
  double curve(double x) const {
    if (eos.form == EquationOfStateForm::tabulated) return between(x, eos.pressure);
    const auto& c = eos.coefficients;
    return x * (c[1] + (x > 0 ? c[2] * x : 0) + c[3] * x * x);
  }
  double modulus(double x) const {
    if (eos.unloading_modulus.size() == 1) return eos.unloading_modulus[0];
    const double last = -*std::min_element(eos.volume_strain.begin(), eos.volume_strain.end());
    return between(std::min(x, last), eos.unloading_modulus);
  }
};

std::array<double, 3> pressed_let_go_and_pressed(double part) {
  return {1, 1, 1 - 0.05 * part - 0.06 * std::sin(3 * M_PI * part) * std::sin(3 * M_PI * part)};
}
std::array<double, 3> pressed_and_torn(double part) {
  const double edge = part < 0.4 ? 1 - 0.2 * part : part < 0.8 ? 0.92 + 0.3 * (part - 0.4) : 1.04 - 0.8 * (part - 0.8);
  return {edge, edge, edge};
}
std::array<double, 3> pressed_then_sheared(double part) {
  const double pressed = 1 - 0.04 * std::min(1.0, 2 * part), sheared = std::exp(0.3 * std::max(0.0, part - 0.5));
  return {pressed * sheared, pressed / sheared, pressed};
}

double compaction_of(const Solver<double>& solver) {
  const Model<double>& model = solver.model();
  return model.elements.material_number(model.slot_of_element[0], model.constants[0].places.compaction);
}

TEST(Granular, FollowsItsLaw) {
  bool unloaded = false, torn = false, capped = false, sheared = false;
  for (const Material& material : {sand(), foam(), concrete()}) {
    for (const Way way : {pressed_let_go_and_pressed, pressed_and_torn, pressed_then_sheared}) {
      const double end = 2 * std::sqrt(material.density / material.bulk_modulus);
      Integration expected(material);
      double largest = 1e-4 * material.bulk_modulus;
      const auto last = stretch_cube(material, way, end, [&](const Solver<double>& solver, double now, double dt) {
        if (dt > 0) expected.stretch_to(way(now / end));
        const std::array<double, 6> stress = stress_of(solver, 0);
        for (std::size_t k = 0; k < 3; ++k) {
          const double own = expected.deviator[k] - expected.pressure;
          largest = std::max(largest, std::abs(own));
          ASSERT_NEAR(stress[k], own, 1e-10 * largest) << material.density << " at " << now / end;
        }
      });
      EXPECT_NEAR(compaction_of(*last), expected.most, 1e-12);
      EXPECT_GT(expected.most, 0.03);
      sheared = sheared || (way == pressed_then_sheared && expected.plastic > 1e-2);
      unloaded = unloaded || expected.unloaded;
      torn = torn || expected.torn;
      capped = capped || expected.capped;
    }
  }
  EXPECT_TRUE(unloaded);
  EXPECT_TRUE(torn);
  EXPECT_TRUE(capped);
  EXPECT_TRUE(sheared);
}

/// Without an equation of state: at the pressure of a constant bulk modulus.
TEST(Granular, HasTheStrengthOfAConstantBulkModulus) {
  Material m = sand();
  m.equation_of_state.reset();
  m.bulk_modulus = 2e8;
  m.drucker_prager->quadratic = 0.03;
  constexpr double end = 1e-3, h = 0.01, strain = 0.05;
  Scene scene = scene_of({block("cube", {1, 1, 1}, h, {0, 0, 0})}, end, false);
  scene.materials = {m};
  scene.guard.energy_error = 1e30;
  Solver<double> solver(scene);
  PrescribedMotion motion(solver, [&](const Point& start, double time) {
    return Point{start[0], start[1], start[2] * std::exp(-strain * time / end)};
  });
  while (!solver.at_end()) motion.step();
  motion.step();
  const std::array<double, 6> s = stress_of(solver, 0);
  const double p = -(s[0] + s[1] + s[2]) / 3;
  EXPECT_NEAR(p, 2e8 * strain, 1e-5 * p);
  EXPECT_NEAR(s[0] - s[2], std::sqrt(3 * (1e8 + 2e4 * p + 0.03 * p * p)), 1e-10 * p);
}

/// Nothing strains a body that falls: of what round-off makes, its yield condition takes all in each step.
TEST(Granular, FallsWithoutCohesion) {
  Scene scene = scene_of({block("cube", {3, 2, 3}, 0.03, {0, 0, 0})}, 1e-3, false);
  Material m = sand();
  m.drucker_prager = {0, 2e7, 0};
  scene.materials = {m};
  scene.bodies[0].velocity = {0, -6, -60};
  scene.gravities.emplace_back().acceleration = {1e4, 0, -1e5};
  for (const Precision precision : {Precision::float64, Precision::mixed}) {
    scene.precision = precision;
    Simulation simulation(scene);
    simulation.run();
    EXPECT_TRUE(simulation.complete());
    EXPECT_NEAR(simulation.bodies()[0].velocity[2], -60 - 1e5 * simulation.time(), 1e-9 * 160);
  }
}

}  // namespace
}  // namespace pinball::test::granular_test
