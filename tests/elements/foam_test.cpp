#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <solver/summary.hpp>

#include "stretched_cube.hpp"

/// Foams, each of whose principal stresses yields by itself.
namespace pinball::test::foam_test {
namespace {

/// E and nu as they are given, and a density of 60.
Material foam(double young, double nu, const CrushableFoamSettings& law) {
  Material m;
  m.name = "steel";  // of the bodies of scene_of
  m.plastic = true;
  m.density = 60;
  m.bulk_modulus = young / (3 * (1 - 2 * nu));
  m.shear_modulus = young / (2 * (1 + nu));
  m.crushable_foam = law;
  return m;
}
const std::vector<double> compaction{0, 0.02, 0.4, 0.7}, strength{1e5, 3e5, 5e5, 4e6};

/// As LS-DYNA's MAT_063 has it, as Radioss' LAW33 has it with closed cells, and one that swells, with all.
std::vector<Material> foams() {
  return {foam(2e7, 0, {compaction, strength, 1e5}), foam(2e7, 0, {compaction, strength, INFINITY, 0, 1e5, 0.05}),
          foam(2e7, 0.2, {compaction, strength, 2e5, 0.3, 2e5, 0.1})};
}

/// The law by itself, along the axes of a stretch.
struct Integration {
  explicit Integration(const Material& m) : material(m), law(*m.crushable_foam) {}

  void stretch_to(const std::array<double, 3>& edges, double dt) {
    const double mu = material.shear_modulus, lambda = material.bulk_modulus - 2 * mu / 3;
    std::array<double, 3> strain{};
    double sum = 0, volume = 1, squares = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      strain[k] = 2 * (edges[k] - edge[k]) / (edges[k] + edge[k]);
      sum += strain[k];
      volume *= edges[k];
    }
    for (std::size_t k = 0; k < 3; ++k) squares += volume * volume / (edges[k] * edges[k]);
    edge = edges;
    const double yields = yield(1 - volume), most = std::isfinite(law.tension_cutoff) ? law.tension_cutoff : yields;
    const double air = law.air_pressure * std::max(0.0, 1 - volume) / (volume - law.solid_share);
    const double length = 0.01 * volume / std::sqrt(squares / 3), speed = std::sqrt((lambda + 2 * mu) / 60);
    double taken_square = 0, taken_sum = 0;
    std::array<double, 3> taken{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double more = lambda * sum + 2 * mu * strain[k], trial = skeleton[k] + more;
      skeleton[k] = std::clamp(trial, -yields, most);
      taken[k] = trial - skeleton[k];
      taken_sum += taken[k];
      crushed = crushed || trial < -yields;
      torn = torn || trial > most;
      stress[k] = skeleton[k] - air + law.damping * length / speed * more / dt;
    }
    for (const double one : taken) {  // Hooke's strain of what is taken
      const double of_strain = (one - lambda / (3 * lambda + 2 * mu) * taken_sum) / (2 * mu);
      taken_square += of_strain * of_strain;
    }
    plastic += std::sqrt(2.0 / 3 * taken_square);
  }

  const Material& material;
  const CrushableFoamSettings& law;
  std::array<double, 3> edge{1, 1, 1}, skeleton{}, stress{};
  double plastic = 0;
  bool crushed = false, torn = false;

 private:
  double yield(double x) const {
    if (x <= 0) return strength[0];
    std::size_t k = 1;
    while (k + 1 < compaction.size() && x > compaction[k]) ++k;
    return strength[k] + (strength[k] - strength[k - 1]) * (x - compaction[k]) / (compaction[k] - compaction[k - 1]);
  }
};

std::array<double, 3> pressed_and_let_go(double part) {
  const double pressed = 1 - 0.45 * std::sin(2 * M_PI * part) * std::sin(2 * M_PI * part) - 0.2 * part;
  return {1, 1 - 0.02 * part, pressed};
}
std::array<double, 3> pressed_all_round_and_torn(double part) {
  const double edge = part < 0.5 ? 1 - 0.4 * part : 0.8 + 0.7 * (part - 0.5);
  return {edge, edge, edge};
}
std::array<double, 3> pressed_then_sheared(double part) {
  const double pressed = 1 - 0.3 * std::min(1.0, 2 * part), sheared = std::exp(0.4 * std::max(0.0, part - 0.5));
  return {pressed * sheared, 1 / sheared, 1 + 0.1 * part};
}

/// Orthogonal axes along none of the edges.
constexpr std::array<Point, 3> slanted{Point{2.0 / 3, -2.0 / 3, 1.0 / 3}, Point{1.0 / 3, 2.0 / 3, 2.0 / 3},
                                       Point{-2.0 / 3, -1.0 / 3, 2.0 / 3}};

/// xx yy zz xy yz zx of what has these values along axes.
std::array<double, 6> in_scene(const std::array<double, 3>& values, const std::array<Point, 3>& axes) {
  constexpr std::array<std::array<std::size_t, 2>, 6> entries{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  std::array<double, 6> tensor{};
  for (std::size_t e = 0; e < 6; ++e) {
    for (std::size_t k = 0; k < 3; ++k) tensor[e] += values[k] * axes[k][entries[e][0]] * axes[k][entries[e][1]];
  }
  return tensor;
}

double plastic_strain_of(const Solver<double>& solver) {
  const Model<double>& model = solver.model();
  return model.elements.plastic_strain[static_cast<std::size_t>(model.slot_of_element[0])];
}

TEST(Foam, FollowsItsLawAlongAnyAxes) {
  bool crushed = false, torn = false;
  for (const Material& material : foams()) {
    for (const Way way : {pressed_and_let_go, pressed_all_round_and_torn, pressed_then_sheared}) {
      for (const auto& axes : {along_edges, slanted}) {
        const double end = 4 * std::sqrt(material.density / material.bulk_modulus);
        Integration expected(material);
        double largest = 1e4;
        const auto solver = stretch_cube(
            material, way, end,
            [&](const Solver<double>& now, double time, double dt) {
              if (dt > 0) expected.stretch_to(way(time / end), dt);
              const std::array<double, 6> stress = stress_of(now, 0), own = in_scene(expected.stress, axes);
              for (std::size_t e = 0; e < 6; ++e) {
                largest = std::max(largest, std::abs(own[e]));
                ASSERT_NEAR(stress[e], own[e], 1e-10 * largest) << e << " at " << time / end;
              }
            },
            axes);
        EXPECT_NEAR(plastic_strain_of(*solver), expected.plastic, 1e-10);
        EXPECT_GT(expected.plastic, 0.05);
        crushed = crushed || expected.crushed;
        torn = torn || expected.torn;
      }
    }
  }
  EXPECT_TRUE(crushed);
  EXPECT_TRUE(torn);
}

/// A bar of foam does not swell where it is crushed: nothing keeps its sides, and they stay.
TEST(Foam, IsCrushedWithoutSwelling) {
  Scene scene = scene_of({block("bar", {2, 2, 6}, 0.01, {0, 0, 0}, {0, 0, -30})}, 2e-3, false);
  scene.materials = {foam(2e7, 0, {compaction, strength, 1e5})};
  scene.element.bulk_viscosity = false;  // which presses sideways
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  Solver<double> solver(scene);
  run(solver);
  double lowest = 1, highest = 0;
  for (std::size_t n = 0; n < 3 * 3 * 7; ++n) {
    const Point x = position_of(solver, n);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(std::abs(x[k] - 0.01 * std::round(x[k] / 0.01)), 1e-12) << n;
    lowest = std::min(lowest, x[2]);
    highest = std::max(highest, x[2]);
  }
  EXPECT_LT(highest - lowest, 0.058);
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_GT(summary.bodies[0].max_plastic_strain, 0.1);
}

/// A cube that is bent further and further: what it keeps of that is bounded.
TEST(Foam, BendsNoStifferThanItYields) {
  std::array<double, 2> energy{};
  for (const std::size_t i : {0, 1}) {
    const double end = 4e-4, turn = i == 0 ? 0.1 : 0.2;
    Scene scene = scene_of({block("cube", {1, 1, 1}, 0.01, {0, 0, 0})}, end, false);
    scene.materials = {foam(2e7, 0, {{0}, {1e5}, 1e5})};
    scene.element.hourglass = HourglassControl::assumed_strain;
    scene.element.bulk_viscosity = false;
    scene.guard.energy_error = 1e30;
    Solver<double> solver(scene);
    PrescribedMotion motion(solver, [&](const Point& start, double time) {
      const double bent = turn * time / end * (start[0] / 0.01 - 0.5) * (start[2] - 0.005);
      return Point{start[0] + 2 * bent, start[1], start[2]};
    });
    while (!solver.at_end()) motion.step();
    RunSummary summary;
    fill_summary(solver, summary);
    energy[i] = summary.energy.internal + summary.energy.hourglass;
  }
  EXPECT_GT(energy[0], 0);
  EXPECT_LT(energy[1] / energy[0], 2.5) << "of what is elastic 4";
}

}  // namespace
}  // namespace pinball::test::foam_test
