#include <gtest/gtest.h>

#include <tests/support/solver_case.hpp>

/// Runs with limits beyond which elements of a material are eroded (material.erosion).
namespace pinball::erosion_limits_test {
namespace {

using namespace test;

Material limited(Material material, const ErosionSettings& limits) {
  material.erosion = limits;
  return material;
}
Material elastic_with(const ErosionSettings& limits) { return limited(elastic_material(), limits); }
Material plastic_with(const ErosionSettings& limits) { return limited(plastic_material("steel", 3e8, 0), limits); }

/// A bar that strikes a wall with its edge first.
Scene bar_at_wall(const Material& material) {
  Body bar = block("bar", {8, 3, 3}, 0.1, {0, 0, 0.1}, {0, 0, -60});
  bar.axis = Point{0.3, 0.1, 1};
  Scene scene = scene_of({bar}, 1e-3, false);
  scene.element.hourglass = HourglassControl::assumed_strain;
  scene.element.bulk_viscosity = true;
  scene.rigid_walls = {{"floor", {{0, 0, -0.2}, {0, 0, 1}}, "", "here"}};
  scene.materials = {material};
  return scene;
}

TEST(ErosionLimits, KeepTheBalanceOfEnergyInAnyMaterial) {
  int number = 0;
  for (const ErosionSettings& limits :
       {ErosionSettings{.tension = 1e8}, ErosionSettings{.compression = 3e8}, ErosionSettings{.principal_stress = 2e8},
        ErosionSettings{.effective_stress = 2.9e8}, ErosionSettings{.principal_strain = 1e-3},
        ErosionSettings{.shear_strain = 1e-3}, ErosionSettings{.step_share = 0.9995}}) {
    for (const Material& material : {elastic_with(limits), plastic_with(limits)}) {
      Solver<double> solver(bar_at_wall(material));
      EXPECT_LT(worst_balance_of_run(solver), 2e-2) << number;
      EXPECT_GT(solver.counts().eroded_elements(), 0) << number;
      EXPECT_GT(solver.energies().eroded, 0) << number;
      ++number;
    }
  }
}

TEST(ErosionLimits, OutOfReachChangeNothing) {
  Material linear = plastic_material("steel", 3e8, 0);
  linear.isotropic_share = 0.999999;  // of the same kernel
  Solver<double> without(bar_at_wall(linear));
  Solver<double> with(bar_at_wall(limited(linear, {.tension = 1e15, .principal_strain = 1e3, .time = 1})));
  run_to_end(without, [] {});
  run_to_end(with, [] {});
  EXPECT_EQ(with.counts().eroded_elements(), 0);
  EXPECT_EQ(with.energies().internal, without.energies().internal);
  EXPECT_EQ(with.energies().kinetic, without.energies().kinetic);
}

/// Elements at rest are worked for it, those of longer steps when theirs end.
TEST(ErosionLimits, OfTheTimeAreMetByAllElements) {
  for (const bool subcycling : {false, true}) {
    Scene scene =
        scene_of({block("coarse", {2, 2, 2}, 0.4, {0, 0, 0}), block("fine", {2, 2, 2}, 0.05, {2, 0, 0})}, 2e-4, false);
    scene.time.subcycling = subcycling;
    scene.materials = {elastic_with({.time = 1e-4})};
    Solver<double> solver(scene);
    while (!solver.at_end() && solver.force_time() <= 0.99e-4) {
      EXPECT_EQ(solver.counts().eroded_elements(), 0) << solver.force_time();
      solver.step();
    }
    run_to_end(solver, [] {});
    EXPECT_EQ(solver.counts().eroded_elements(), 16);
  }
}

TEST(ErosionLimits, OfAShareOfTheFirstStepAreThatOfTheWholeMesh) {
  // The fine body sets the step; the coarse one, whose steps are eight times as long, may be squeezed by seven eighths.
  Scene scene =
      scene_of({block("coarse", {1, 1, 1}, 0.4, {0, 0, 0}), block("fine", {1, 1, 1}, 0.05, {2, 0, 0})}, 1e-4, false);
  for (Body& body : scene.bodies) body.velocity_gradient = {{{-1e3, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  scene.materials = {elastic_with({.step_share = 0.9985})};
  Solver<double> solver(scene);
  run_to_end(solver, [] {});
  EXPECT_EQ(solver.counts().eroded_elements(), 1);
  EXPECT_FALSE(solver.model().elements.alive(solver.model().slot_of_element[1]));
}

}  // namespace
}  // namespace pinball::erosion_limits_test
