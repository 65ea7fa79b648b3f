#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/results/warnings.hpp>
#include <solver/summary.hpp>
#include <tests/support/solver_case.hpp>

/// time.smallest_step: mass for elements whose step would be smaller.
namespace pinball::mass_scaling_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A bar along z whose last two layers of ten are a fifth as thick.
Scene bar_with_thin_layers() {
  Scene scene =
      scene_of({block("bar", {2, 2, 10}, 0.1, {0, 0, 0}), block("far", {2, 2, 2}, 0.1, {3, 0, 0})}, 2e-3, false);
  BlockMesh mesh{{0.2, 0.2, 0.84}, {2, 2, 10}};
  mesh.sections[2] = {{0.8, 8}, {0.04, 2}};
  scene.bodies[0].mesh = mesh;
  return scene;
}

RunSummary summary_of(Solver<double>& solver) {
  RunSummary summary;
  fill_summary(solver, summary);
  return summary;
}

double first_step(const Scene& scene) {
  Solver<double> solver(scene);
  solver.step();
  return solver.clock().dt_min();
}

TEST(MassScaling, GivesTheStepThatIsAskedFor) {
  for (const bool viscous : {false, true}) {
    for (const double cfl : {0.9, 0.5}) {
      Scene scene = bar_with_thin_layers();
      scene.element.bulk_viscosity = viscous;
      scene.time.cfl = cfl;
      const double unscaled = first_step(scene);
      scene.time.smallest_step = 2.5 * unscaled;
      EXPECT_NEAR(first_step(scene) / scene.time.smallest_step, 1, 1e-12) << viscous << " " << cfl;
    }
  }
}

TEST(MassScaling, GivesTheStepInSinglePrecisionToo) {
  Scene scene = bar_with_thin_layers();
  scene.precision = Precision::float32;
  scene.time.smallest_step = 2.5 * first_step(scene);
  Solver<float> solver(scene);
  solver.step();
  EXPECT_NEAR(solver.clock().dt_min() / scene.time.smallest_step, 1, 1e-5);
}

TEST(MassScaling, AddsMassToNoElementThatNeedsNone) {
  Scene scene = bar_with_thin_layers();
  scene.time.smallest_step = 2.5 * first_step(scene);
  Solver<double> solver(scene);
  const Model<double>& model = solver.model();
  double added = 0, nodes = 0, elements = 0;
  for (std::size_t e = 0; e < model.element_mass.size(); ++e) {
    const bool thin = element_centre(model.mesh, e)[2] > 0.8;
    EXPECT_EQ(model.added_mass[e] > 0, thin) << e;
    added += model.added_mass[e];
    elements += model.element_mass[e];
  }
  for (const double mass : model.node_mass) nodes += mass;
  EXPECT_NEAR(nodes / elements, 1, 1e-12);
  const RunSummary summary = summary_of(solver);
  EXPECT_NEAR(summary.mass_added, added, 1e-12 * added);
  EXPECT_NEAR(summary.bodies[0].mass_added, added, 1e-12 * added);
  EXPECT_NEAR(summary.bodies[0].mass_initial, 7850 * 0.2 * 0.2 * 0.84 + added, 1e-9);
  EXPECT_EQ(summary.bodies[1].mass_added, 0);
  EXPECT_THAT(added_mass_text(summary), HasSubstr("% of all: body bar "));
  EXPECT_THAT(added_mass_text(summary), testing::Not(HasSubstr("far")));
}

TEST(MassScaling, ThatNoElementNeedsChangesNoBit) {
  Scene scene = bar_with_thin_layers();
  scene.bodies[0].velocity_gradient = {{{-20, 0, 30}, {0, 10, 0}, {40, 0, -10}}};
  scene.time.steps = 50;
  Solver<double> without(scene);
  scene.time.smallest_step = 0.99 * first_step(scene);
  Solver<double> with(scene);
  EXPECT_TRUE(with.model().added_mass.empty());
  run(without);
  run(with);
  EXPECT_EQ(state_hash(with.model()), state_hash(without.model()));
  EXPECT_THAT(added_mass_text(summary_of(with)), IsEmpty());
}

TEST(MassScaling, LeavesFreeFallAsItIs) {
  Scene scene = bar_with_thin_layers();
  scene.gravities = {{{0, 3, -10}, {}}};
  scene.bodies[0].velocity = {1, 0, 2};
  scene.time.smallest_step = 3 * first_step(scene);
  Solver<double> solver(scene);
  run(solver);
  const Model<double>& model = solver.model();
  const double t = solver.time(), mass = summary_of(solver).bodies[0].mass_initial;
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    if (model.mesh.body_of_node[n] != 0) continue;
    const double* x = model.nodes.position_of(model.node_of_scene_node[n]);
    const Point& start = model.mesh.nodes[n];
    EXPECT_NEAR(x[0] - start[0], t, 1e-12);
    EXPECT_NEAR(x[1] - start[1], 1.5 * t * t, 1e-12);
    EXPECT_NEAR(x[2] - start[2], 2 * t - 5 * t * t, 1e-12);
  }
  EXPECT_NEAR(solver.momentum()[0] / mass, 1, 1e-12);
  EXPECT_LT(std::abs(solver.balance_error()), 1e-12);
}

/// A bar all of whose elements get the same mass is one of a heavier material, whose waves are slower.
TEST(MassScaling, SlowsWavesAsTheMassDoes) {
  Scene scaled = scene_of({block("bar", {2, 2, 30}, 0.1, {0, 0, 0})}, 1e-3, false);
  scaled.bodies[0].velocity_gradient = {{{0, 0, 0}, {0, 0, 0}, {0, 0, -10}}};
  Scene heavy = scaled;
  scaled.time.smallest_step = 2 * first_step(scaled);
  heavy.materials[0].density *= 4;
  Solver<double> one(scaled), other(heavy);
  run(one);
  run(other);
  EXPECT_NEAR(one.clock().dt_max() / other.clock().dt_max(), 1, 1e-12);
  const Model<double>& model = one.model();
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(model.nodes.velocity_of(static_cast<std::int64_t>(n))[k],
                  other.model().nodes.velocity_of(static_cast<std::int64_t>(n))[k], 1e-9);
    }
  }
  EXPECT_NEAR(one.energies().total() / other.energies().total(), 1, 1e-9);
  EXPECT_LT(std::abs(one.balance_error()), 1e-5);
}

TEST(MassScaling, OfAllElementsTakesMassToo) {
  Scene scene = bar_with_thin_layers();
  const double least = first_step(scene);
  scene.time.smallest_step = 2.5 * least;
  scene.time.mass_scaling = MassScaling::all;
  Solver<double> solver(scene);
  const Model<double>& model = solver.model();
  EXPECT_LT(*std::min_element(model.added_mass.begin(), model.added_mass.end()), 0);
  EXPECT_GT(*std::max_element(model.added_mass.begin(), model.added_mass.end()), 0);
  solver.step();
  for (std::int64_t slot = 0; slot < model.elements.slots; ++slot) {
    EXPECT_EQ(model.elements.mass_share[slot] > 0, !model.is_padding(slot)) << slot;
  }
  EXPECT_NEAR(solver.clock().dt_min() / scene.time.smallest_step, 1, 1e-12);
}

/// Also where the mass is not that of the material: the force is a uniform traction of the face.
TEST(MassScaling, LeavesTheSharesOfLoadsAsTheyAre) {
  Scene scene = bar_with_thin_layers();
  NodalLoad load;
  load.nodes.body = "bar";
  load.force = {1, 0, 0};
  scene.loads = {load};
  scene.time.smallest_step = 2.5 * first_step(scene);
  Solver<double> solver(scene);
  const Model<double>& model = solver.model();
  double sum = 0;
  for (std::size_t n = 0; n < model.node_mass.size(); ++n) sum += model.material_mass_of_node(n);
  EXPECT_NEAR(sum, 7850 * (0.2 * 0.2 * 0.84 + 0.2 * 0.2 * 0.2), 1e-9);
  solver.step();
  // The first step has no length before it: what a node has got is dt/2 times its force over its mass.
  const double material = 7850 * 0.2 * 0.2 * 0.84;
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    if (model.mesh.body_of_node[n] != 0) continue;
    const auto node = static_cast<std::size_t>(model.node_of_scene_node[n]);
    const double expected = 0.5 * solver.dt() * model.material_mass_of_node(node) / material / model.node_mass[node];
    EXPECT_NEAR(model.nodes.velocity[4 * node] / expected, 1, 1e-12);
  }
}

TEST(MassScaling, BeyondFivePercentIsWarnedOf) {
  Scene scene = bar_with_thin_layers();
  const double least = first_step(scene);
  const auto told = [&scene](double step) {
    scene.time.smallest_step = step;
    Solver<double> solver(scene);
    return start_warnings(summary_of(solver));
  };
  EXPECT_THAT(told(1.1 * least), IsEmpty());  // 1.1^2 - 1 = 21 % of 4.8 % of the bar
  EXPECT_THAT(told(3 * least),
              ElementsAre(testing::AllOf(HasSubstr("raises the mass of body bar by"), HasSubstr("more than 5 %"))));
  scene.time.mass_scaling = MassScaling::all;
  EXPECT_THAT(told(1.1 * least), ElementsAre(HasSubstr("changes the mass of")));
}

TEST(MassScaling, GoesWithSubcycling) {
  Scene scene = bar_with_thin_layers();
  scene.bodies[0].velocity_gradient = {{{0, 0, 0}, {0, 0, 0}, {0, 0, -10}}};
  const double least = first_step(scene);
  scene.time.subcycling = true;
  Solver<double> unscaled(scene);
  scene.time.smallest_step = 2.5 * least;
  Solver<double> scaled(scene);
  run(unscaled);
  run(scaled);
  EXPECT_LE(2 * scaled.steps(), unscaled.steps());
  EXPECT_LT(std::abs(scaled.balance_error()), 1e-2);
}

TEST(MassScaling, IsInTheSummary) {
  Scene scene = bar_with_thin_layers();
  scene.time.smallest_step = 2.5 * first_step(scene);
  Solver<double> solver(scene);
  const std::string text = summary_json(summary_of(solver));
  EXPECT_THAT(text, HasSubstr("\"mass_scaling\": {\n    \"added\": "));
  EXPECT_THAT(text, HasSubstr("\"mass_added\": 0.0"));
}

}  // namespace
}  // namespace pinball::mass_scaling_test
