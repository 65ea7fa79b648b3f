#include <gtest/gtest.h>

#include <cmath>

#include <tests/support/solver_case.hpp>

/// Steps become short before something is stopped, and stay so while that vibrates.
namespace pinball::impact_step_test {
namespace {

using namespace test;

/// A cube of edge 1 cm at some height over a wall, or over a plate.
Scene falling(const Point& velocity, double height, bool wall) {
  Scene scene = scene_of({block("cube", {1, 1, 1}, 0.01, {0.01, 0.01, height}, velocity)}, 4e-5);
  scene.element = ElementSettings();
  scene.contact = ContactSettings();
  if (wall) {
    scene.contact.method = ContactMethod::none;
    scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", ""}};
  } else {
    scene.contact.method = ContactMethod::pinball;
    scene.bodies.push_back(block("plate", {3, 3, 1}, 0.01, {0, 0, -0.01}));
  }
  return scene;
}

TEST(ImpactStep, EnergiesBalanceInTheCoarsestImpacts) {
  for (const bool wall : {true, false}) {
    for (const double speed : {100.0, 500.0, 1000.0, 1500.0}) {
      for (const double height : {3e-5, 1e-3}) {
        for (const bool plastic : {false, true}) {
          Scene scene = falling({0, 0, -speed}, height, wall);
          if (plastic) scene.materials = {plastic_material("steel", 4e8, 1e9)};
          Solver<double> solver(scene);
          run(solver);
          EXPECT_LT(solver.ledger().balance_error_max(), 0.01)
              << (wall ? "wall " : "plate ") << speed << ' ' << height << ' ' << plastic;
        }
      }
    }
  }
}

TEST(ImpactStep, BecomesShortBeforeTheImpactAndNotInFlight) {
  for (const bool wall : {true, false}) {
    Solver<double> solver(falling({0, 0, -1000}, 0.01, wall));  // 10 us away
    solver.step();
    const double first = solver.clock().dt();
    solver.step();
    solver.step();
    const double flight = solver.clock().dt();
    EXPECT_GT(flight, 1.3 * first);  // the first steps are as if the impact were in them
    double shortest = flight;
    while (solver.clock().time() < 0.7e-5) solver.step();
    EXPECT_NEAR(solver.clock().dt(), flight, 0.05 * flight);
    while (solver.energies().internal < 1e-3 * solver.ledger().initial()) {
      solver.step();
      shortest = std::min(shortest, solver.clock().dt_before());
    }
    EXPECT_LT(shortest, 0.8 * flight);  // before anything is compressed
  }
}

TEST(ImpactStep, ViscosityThatIsOffAsksForLess) {
  Scene scene = falling({0, 0, -1000}, 1e-4, true);
  Solver<double> with(scene);
  scene.element.bulk_viscosity = false;
  Solver<double> without(scene);
  with.step();
  without.step();
  EXPECT_LT(with.clock().dt(), 0.75 * without.clock().dt());
}

/// While all energy is in a vibration of one element, a longer step would take much of it.
TEST(ImpactStep, StaysShortWhileAllThatMovesVibrates) {
  Solver<double> solver(falling({0, 0, -1000}, 1e-4, true));
  solver.step();
  const double first = solver.clock().dt();
  while (!solver.at_end()) {
    solver.step();
    ASSERT_LT(solver.clock().dt(), 1.05 * first);
  }
}

/// The more mobile of two sides takes the more of the closing speed.
TEST(ImpactStep, BeforeAHeavyBodyIsThatBeforeAWall) {
  const auto shortest = [](double density, bool held) {
    Scene scene = falling({0, 0, -1000}, 5e-4, false);
    scene.materials.push_back(elastic_material("heavy"));
    Material& heavy = scene.materials.back();
    heavy.density *= density;
    heavy.bulk_modulus *= density;
    heavy.shear_modulus *= density;
    scene.bodies[1].material = "heavy";
    if (held) {
      PrescribedVelocity still;
      still.nodes.body = "plate";
      still.velocity = {0, 0, 0};
      scene.prescribed_velocities = {still};
    }
    Solver<double> solver(scene);
    double least = 1;
    for (int i = 0; i < 3; ++i) {
      solver.step();
      if (i > 0) least = std::min(least, solver.clock().dt());
    }
    return least;
  };
  const double equal = shortest(1, false), heavy = shortest(100, false), held = shortest(1, true);
  EXPECT_LT(heavy, 0.9 * equal);
  EXPECT_NEAR(held, heavy, 0.02 * heavy);
}

}  // namespace
}  // namespace pinball::impact_step_test
