#include <gtest/gtest.h>

#include <cmath>

#include <solver/step/energy/drift_energy.hpp>
#include <tests/support/collapsed_case.hpp>
#include <tests/support/law_materials.hpp>
#include <tests/support/solver_case.hpp>
#include <tests/support/torn_block.hpp>

/// Nodes in double, elements in single precision: the same answer as in double, but for what single precision rounds.
namespace pinball::mixed_precision_test {
namespace {

using namespace test;

struct End {
  std::vector<Point> position, velocity;  ///< by the nodes of the scene
  double momentum[3] = {};                ///< what a run has changed it by, of its largest part
  double energy = 0, balance = 0;
  std::int64_t steps = 0, inside_out = 0;  ///< inside_out: elements, at the worst time
};

template <class S>
End end_of(Scene scene, Precision precision) {
  scene.precision = precision;
  Solver<S> solver(scene);
  run(solver);
  End end;
  const Model<S>& model = solver.model();
  for (const std::int32_t n : model.node_of_scene_node) {
    const S *const x = model.nodes.position_of(n), *const v = model.nodes.velocity_of(n);
    end.position.push_back({double(x[0]), double(x[1]), double(x[2])});
    end.velocity.push_back({double(v[0]), double(v[1]), double(v[2])});
  }
  double size = 0;
  for (std::size_t n = 0; n < end.velocity.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      size += model.node_mass[std::size_t(model.node_of_scene_node[n])] * std::abs(end.velocity[n][k]);
    }
  }
  RunSummary summary;
  fill_summary(solver, summary);
  for (std::size_t k = 0; k < 3; ++k) {
    end.momentum[k] = (summary.momentum_final[k] - summary.momentum_initial[k]) / size;
  }
  end.energy = summary.final_total;
  end.balance = summary.balance_error_max;
  end.steps = summary.steps;
  end.inside_out = solver.inside_out().most();
  return end;
}

/// Root of the mean square of the differences of velocities, over that of the velocities.
double difference(const End& a, const End& b) {
  double of = 0, all = 0;
  for (std::size_t n = 0; n < a.velocity.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      of += std::pow(a.velocity[n][k] - b.velocity[n][k], 2);
      all += std::pow(b.velocity[n][k], 2);
    }
  }
  return std::sqrt(of / all);
}

Scene whole_block(const Point& position = {}) {
  Scene scene = torn_block();
  scene.materials[0].erosion_strain = 0;
  scene.bodies[0].position = position;
  return scene;
}

TEST(MixedPrecision, HasTheVelocitiesOfDouble) {
  const End exact = end_of<double>(whole_block(), Precision::float64);
  const End mixed = end_of<double>(whole_block(), Precision::mixed);
  const End single = end_of<float>(whole_block(), Precision::float32);
  EXPECT_EQ(mixed.steps, exact.steps);
  EXPECT_GT(difference(mixed, exact), 0);
  EXPECT_LT(difference(mixed, exact), 1e-6);
  EXPECT_LT(difference(mixed, exact), 0.5 * difference(single, exact));
  EXPECT_NEAR(mixed.energy, exact.energy, 1e-6 * exact.energy);
  EXPECT_LT(mixed.balance, 2 * exact.balance);
}

/// As good as at the origin, where single precision rounds coordinates by a thousandth of an element.
TEST(MixedPrecision, KnowsNoOrigin) {
  const End exact = end_of<double>(whole_block(), Precision::float64);
  EXPECT_LT(difference(end_of<double>(whole_block({16, -16, 16}), Precision::mixed), exact), 1e-6);
  EXPECT_LT(difference(end_of<double>(whole_block({1e4, -1e4, 1e4}), Precision::mixed), exact), 1e-6);
  EXPECT_GT(difference(end_of<float>(whole_block({16, -16, 16}), Precision::float32), exact), 1e-5);
}

TEST(MixedPrecision, ConservesMomentumAsDoubleDoes) {
  const End exact = end_of<double>(torn_block(), Precision::float64);
  const End mixed = end_of<double>(torn_block(Precision::mixed), Precision::mixed);
  const End single = end_of<float>(torn_block(), Precision::float32);
  double most = 0, most_of_single = 0;
  for (int k = 0; k < 3; ++k) {
    most = std::max(most, std::abs(mixed.momentum[k]));
    most_of_single = std::max(most_of_single, std::abs(single.momentum[k]));
    EXPECT_LT(std::abs(exact.momentum[k]), 1e-15);
  }
  EXPECT_LT(most, 1e-15);
  EXPECT_GT(most_of_single, 1e-10) << "then this test finds nothing";
}

TEST(MixedPrecision, OfEveryKindOfHourglassControlAndMaterial) {
  Scene scene = whole_block();
  for (const HourglassControl control : {HourglassControl::none, HourglassControl::viscous, HourglassControl::stiffness,
                                         HourglassControl::assumed_strain}) {
    scene.element.hourglass = control;
    for (const bool general : {false, true}) {
      scene.materials[0].isotropic_share = general ? 0.5 : 1;
      const End exact = end_of<double>(scene, Precision::float64), mixed = end_of<double>(scene, Precision::mixed);
      EXPECT_LT(difference(mixed, exact), 1e-5) << int(control) << general;
    }
  }
}

/// Corners that are one node have ways to them that are rounded differently. Averaged volumes are single numbers: what
/// these are wrong by is more than what hexahedra are.
TEST(MixedPrecision, OfCollapsedElementsThatSpin) {
  for (const bool plastic : {false, true}) {
    for (const Cut cut : {Cut::none, Cut::across_x, Cut::across_y, Cut::across_z, Cut::pyramids}) {
      const HostMesh mesh = block_cut({3, 2, 2}, {0.3, 0.2, 0.2}, cut);
      Scene scene = scene_of({body_of(mesh)}, 1e-3, false);
      scene.element = ElementSettings();
      scene.bodies[0].angular_velocity = {120, 160, 0};
      if (plastic) scene.materials = {plastic_material("steel", 4e8, 0)};
      const End exact = end_of<double>(scene, Precision::float64), mixed = end_of<double>(scene, Precision::mixed);
      EXPECT_EQ(mixed.steps, exact.steps);
      EXPECT_LT(difference(mixed, exact), cut == Cut::none ? 2e-6 : 1e-4) << int(cut);
      EXPECT_LT(mixed.balance, 2 * exact.balance + 1e-6);
      EXPECT_EQ(mixed.inside_out, 0) << int(cut);
    }
  }
}

/// A load that begins later, and weight.
void load_later(Scene& scene) {
  NodalLoad load;
  load.nodes.body = scene.bodies[0].name;
  load.force = {0, 0, 1e3};
  load.table = {{0, 2e-5, 4e-5}, {0, 0, 1}};
  scene.loads = {load};
}
void weigh(Scene& scene) { scene.gravities.emplace_back().acceleration = {0, 0, -9.81}; }

/// Where a law sees volumes, those of elements at rest press by what single precision rounds of them. While nothing
/// else moves that is no error of the balance: such runs stopped in their first step.
TEST(MixedPrecision, LetsBodiesAtRestRestWhereVolumesPress) {
  Material brittle = plastic_material("ceramic", 0, 0);
  brittle.plastic_modulus = 0;
  brittle.johnson_holmquist = JohnsonHolmquistSettings{};
  brittle.johnson_holmquist->intact_strength = 0.9;
  brittle.johnson_holmquist->intact_exponent = 0.6;
  brittle.johnson_holmquist->tensile_strength = 3e8;
  brittle.johnson_holmquist->elastic_limit = 1.1e10;
  brittle.johnson_holmquist->elastic_limit_pressure = 5e9;
  for (const Material& material : {soil_material("soil"), brittle, rubber()}) {
    for (const auto begin : {load_later, weigh}) {
      Body body = block("body", {3, 3, 3}, 1, {0.013, 0.027, 0}, {}, material.name);
      body.mesh = BlockMesh{{0.031, 0.017, 0.023}, {3, 3, 3}};
      Scene scene = scene_of({body}, 6e-5, false);
      scene.materials = {material};
      begin(scene);
      for (const bool single : {false, true}) {
        const auto run_it = [&] {
          return single ? end_of<float>(scene, Precision::float32).steps
                        : end_of<double>(scene, Precision::mixed).steps;
        };
        EXPECT_EQ(error_of<RunError>(run_it), no_error) << material.name;
      }
    }
  }
}

/// Energies of others are measured as in double: they were not looked at below 1e-6 of the speed of sound.
TEST(MixedPrecision, HasRestOfItsOwnOnlyWhereVolumesPress) {
  const auto at_rest = [](Precision precision, const char* second) {
    Scene scene = scene_of({block("a", {1, 1, 2}, 0.1, {0, 0, 0}), block("b", {1, 1, 3}, 0.1, {1, 0, 0}, {}, second)},
                           1e-3, false);
    scene.materials = {elastic_material(), soil_material("soil")};
    scene.precision = precision;
    return energy_at_rest(build_model<double>(scene));
  };
  const double of_double = at_rest(Precision::float64, "steel");
  EXPECT_GT(of_double, 0);
  EXPECT_EQ(at_rest(Precision::mixed, "steel"), of_double);
  EXPECT_NEAR(at_rest(Precision::float64, "soil"), of_double, of_double);
  const double mass = 3 * 1e-3 * 7850, speed2 = 2 * at_rest(Precision::mixed, "soil") / (1e-12 * mass);
  EXPECT_GT(std::sqrt(speed2), 4000) << "of its three elements";
  EXPECT_LT(std::sqrt(speed2), 6500);
}

}  // namespace
}  // namespace pinball::mixed_precision_test
