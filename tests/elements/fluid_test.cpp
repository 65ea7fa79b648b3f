#include <gtest/gtest.h>

#include <cmath>

#include <solver/scene_rules.hpp>
#include <solver/summary.hpp>
#include <tests/support/solver_case.hpp>

/// Bodies of fluid: what flows, what travels through it, and where it cavitates.
namespace pinball::test::fluid_test {
namespace {

constexpr double density = 1000, sound_speed = 1500;

Material water(double viscosity = 1e-3) {
  Material m;
  m.name = "water";
  m.plastic = true;
  m.density = density;
  m.fluid = FluidSettings{viscosity};
  m.equation_of_state.emplace();
  m.equation_of_state->sound_speed = sound_speed;
  m.equation_of_state->slopes = {1.9, 0, 0};
  m.equation_of_state->gamma = 0.3;
  return m;
}

/// A block that falls on a wall.
Scene splash(const Material& material) {
  Scene scene = scene_of({block("drop", {4, 4, 8}, 0.1, {0, 0, 0}, {0, 0, -30})}, 1.5e-3, false);
  scene.element.hourglass = HourglassControl::viscous;
  scene.element.bulk_viscosity = true;
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  scene.bodies[0].material = "water";
  scene.materials = {material};
  return scene;
}

TEST(Fluid, KeepsTheBalanceOfEnergy) {
  for (const double viscosity : {0.0, 1e-3, 100.0}) {
    Solver<double> solver(splash(water(viscosity)));
    EXPECT_LT(worst_balance_of_run(solver), 5e-3) << viscosity;
  }
}

TEST(Fluid, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto hash = [](int threads) {
    DefaultExecutionSpace::set_concurrency(threads);
    Solver<double> solver(splash(water()));
    run(solver);
    DefaultExecutionSpace::set_concurrency(1);
    return state_hash(std::as_const(solver).model());
  };
  EXPECT_EQ(hash(1), hash(3));
}

/// Least mean stress of the elements while a layer is pulled apart.
double least_pressure(double limit) {
  Material material = water();
  material.equation_of_state->tension_limit = limit;
  Scene scene = splash(material);
  scene.rigid_walls.clear();
  scene.bodies[0].velocity = {0, 0, 0};
  scene.time.end = 2e-4;
  scene.guard.energy_error = 1e30;
  Solver<double> solver(scene);
  PrescribedMotion motion(solver, [](const Point& x, double t) { return Point{x[0], x[1], x[2] * (1 + 100 * t)}; });
  double least = 0;
  while (!solver.at_end()) {
    motion.step();
    const auto stress = stress_of(solver, 0);
    least = std::min(least, -(stress[0] + stress[1] + stress[2]) / 3);
  }
  return least;
}

TEST(Fluid, CavitatesAtItsLimit) {
  EXPECT_NEAR(least_pressure(1e5), -1e5, 1);
  EXPECT_LT(least_pressure(0), -1e7);
}

TEST(Fluid, IsRefusedWhereElementsResistAsSolidsDo) {
  for (const HourglassControl control : {HourglassControl::assumed_strain, HourglassControl::stiffness}) {
    Scene scene = splash(water());
    scene.element.hourglass = control;
    EXPECT_NE(error_of([&] { checked_scene(scene); }).find("expected elements with element.hourglass = \"viscous\""),
              std::string::npos);
  }
  EXPECT_NO_THROW(checked_scene(splash(water())));
}

TEST(Fluid, IsRefusedWithLevelsOfStepsThatDoNotKnowItsViscosity) {
  Scene scene = splash(water());
  scene.time.subcycling = true;
  EXPECT_NE(error_of([&] { checked_scene(scene); }).find("expected time.subcycling = false with water"),
            std::string::npos);
  scene.materials = {water(0)};
  EXPECT_NO_THROW(checked_scene(scene));
}

}  // namespace
}  // namespace pinball::test::fluid_test
