#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <tests/support/solver_case.hpp>

/// The whole step without contact: laws that hold exactly or to round-off.
namespace pinball::solver_test {
namespace {

using namespace test;

TEST(Solver, FreeFlightLeavesEveryStressAtZeroBitwise) {
  Scene scene = scene_of({block("a", {3, 4, 5}, 0.1, {7, 8, 9}, {123.4, -56.7, 8.9})}, 1e-2, false);
  scene.element.bulk_viscosity = true;
  scene.materials = {plastic_material("steel", 1e8, 0.5)};
  Solver<double> solver(scene);
  run(solver);
  ASSERT_GT(solver.steps(), 100);
  for (std::size_t e = 0; e < solver.mesh().hexahedra.size(); ++e) {
    for (const double s : stress_of(solver, e)) ASSERT_EQ(s, 0.0);
  }
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    ASSERT_EQ(velocity_of(solver, n), (Point{123.4, -56.7, 8.9}));
  }
  EXPECT_EQ(solver.energies().internal, 0.0);
  EXPECT_EQ(solver.energies().hourglass, 0.0);
  EXPECT_EQ(solver.energies().bulk_viscosity, 0.0);
}

TEST(Solver, RotationTurnsTheStressAndCostsNoEnergy) {
  // Strained to a uniform stress in 20 steps, then turned by 90 degrees in large steps.
  Scene scene = scene_of({block("a", {2, 3, 2}, 0.1, {-0.1, -0.15, -0.1})}, 1.0, false);
  scene.guard.energy_error = 1e30;
  Solver<double> trial(scene), solver(scene);
  trial.step();
  const double dt = trial.dt(), strained = 20 * dt, turning = 22 * dt, turned = 62 * dt;
  const std::array<Point, 3> g{{{1e-3, 4e-4, 0}, {0, -5e-4, 2e-4}, {3e-4, 0, 2e-4}}};
  // Strained by 1e-3 first, then turned: no step has part of both.
  PrescribedMotion motion(solver, [&](const Point& x0, double t) {
    Point x = x0;
    const double s = std::min(1.0, t / strained);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) x[i] += s * g[i][j] * x0[j];
    }
    const double angle = 0.5 * M_PI * std::clamp((t - turning) / (turned - turning), 0.0, 1.0);
    return Point{std::cos(angle) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + std::cos(angle) * x[1],
                 x[2]};
  });
  while (solver.force_time() < strained) motion.step();
  const auto before = stress_of(solver, 0);
  const double internal = solver.energies().internal;
  ASSERT_GT(std::abs(before[0]), 1e7);
  while (solver.force_time() < turned + dt) motion.step();
  // xx and yy change places, xy changes its sign; yz becomes zx and zx becomes -yz: components xx yy zz xy yz zx.
  const std::array<double, 6> exact{before[1], before[0], before[2], -before[3], before[5], -before[4]};
  double worst = 0;
  for (std::size_t e = 0; e < solver.mesh().hexahedra.size(); ++e) {
    const auto after = stress_of(solver, e);
    for (std::size_t c = 0; c < 6; ++c) worst = std::max(worst, std::abs(after[c] - exact[c]));
  }
  EXPECT_LT(worst, 1e-11 * 2.1e11);  // round-off of strains, times the modulus
  EXPECT_NEAR(solver.energies().internal, internal, 1e-9 * internal);
}

TEST(Solver, VibratingBlockKeepsEnergyAndMomentum) {
  Scene scene = scene_of({block("a", {4, 5, 6}, 0.1, {0, 0, 0}, {3, -2, 1})}, 5e-3, false);
  scene.bodies[0].velocity_gradient = {{{50, 20, 0}, {0, -30, 10}, {40, 0, 0}}};
  Solver<double> solver(scene);
  const Point before = solver.momentum();
  double worst = 0;
  while (solver.time() < scene.time.end) {
    solver.step();
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  solver.finish();
  ASSERT_GT(solver.steps(), 200);
  // Rates of 50/s and steps of 1.4e-5 s: strains and rotations of a step below 1e-3, of which the square is the error.
  EXPECT_LT(worst, 1e-4);
  const double scale = 7850 * 0.12 * 4;
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solver.momentum()[k], before[k], 1e-13 * scale);
  // At the end everything belongs to one time. The kinetic energy that central differences keep is less than that of
  // the velocities by the square of half a step times the acceleration: for the slow modes here by little.
  EXPECT_NEAR(solver.energies().kinetic, kinetic_energy(solver), 0.02 * solver.initial_energy());
}

TEST(Solver, AngularMomentumOfASpinningVibratingBlockIsConstant) {
  Scene scene = scene_of({block("a", {3, 4, 5}, 0.1, {-0.15, -0.2, -0.25})}, 5e-3, false);
  scene.bodies[0].velocity_noise = 5;
  scene.bodies[0].angular_velocity = {200, -100, 300};
  Solver<double> solver(scene);
  const Point before = angular_momentum(solver);
  run(solver);
  const Point after = angular_momentum(solver);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[k], before[k], 1e-12 * std::abs(before[2]));
}

TEST(Solver, ASpinningBlockStaysStable) {
  // Several thousand steps at a turn of 3e-3 each: a stress increment turned by half a step too much would make the
  // highest modes grow by 1e-3 per step, from round-off to ruin.
  Scene scene = scene_of({block("a", {6, 2, 2}, 0.05, {-0.15, -0.05, -0.05})}, 0.25, false);
  scene.bodies[0].angular_velocity = {0, 0, 400};
  scene.guard.energy_error = 1e-3;
  Solver<double> solver(scene);
  EXPECT_NO_THROW(run(solver));
  EXPECT_GT(solver.steps(), 20000);
  EXPECT_LT(solver.energies().hourglass, 1e-3 * solver.initial_energy());
}

TEST(Solver, AnswersDoNotDependOnThePlaceInSpace) {
  const auto blocks = [](const Point& shift) {
    Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, shift, {0, 0, 10}),
                            block("b", {2, 2, 2}, 0.1, {shift[0], shift[1], shift[2] + 0.225}, {0, 0, -10})},
                           2e-4);
    scene.bodies[0].velocity_noise = 1;
    return scene;
  };
  Solver<double> here(blocks({0, 0, 0})), there(blocks({10, -5, 3}));
  run(here);
  run(there);
  EXPECT_EQ(here.steps(), there.steps());
  for (std::size_t e = 0; e < here.model().mesh.hexahedra.size(); ++e) {
    const auto a = stress_of(here, e), b = stress_of(there, e);
    // Positions near 10 carry round-off of 2e-15: 2e-14 of an element's size, times the modulus, over 100 steps.
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(a[c], b[c], 1e-11 * 2.1e11);
  }
}

TEST(Solver, SymmetryKeepsNodesOnThePlaneBitwise) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}, {0, 0, 50})}, 2e-3, false);
  scene.bodies[0].velocity_noise = 20;
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}, {{0, 0, 0}, {0, 1, 0}, ""}};
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (solver.mesh().nodes[n][k] != 0) continue;
      EXPECT_EQ(position_of(solver, n)[k], 0.0);
    }
  }
  // Strains of a step are 3e-3 here.
  EXPECT_LT(std::abs(solver.balance_error()), 5e-3);
}

TEST(Solver, MirroredHalfMovesAsTheWhole) {
  // The whole block, stretched along x, against its half with a plane of symmetry.
  Scene whole = scene_of({block("a", {4, 2, 2}, 0.1, {-0.2, 0, 0})}, 5e-4, false);
  whole.bodies[0].velocity_gradient[0] = {100, 0, 0};
  Scene half = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {10, 0, 0})}, 5e-4, false);
  half.bodies[0].velocity_gradient[0] = {100, 0, 0};  // about the centroid of the half, which moves with 10
  half.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}};
  Solver<double> a(whole), b(half);
  run(a);
  run(b);
  const auto right = stress_of(a, 3), same = stress_of(b, 1);  // first row: the last element along x
  for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(right[c], same[c], 1e-5 * std::abs(right[0]));
  EXPECT_NEAR(a.initial_energy(), 2 * b.initial_energy(), 1e-12 * a.initial_energy());
}

TEST(Solver, SinglePrecisionAgreesWithDouble) {
  Scene scene = scene_of({block("a", {4, 4, 4}, 0.1, {0, 0, 0})}, 1e-3, false);
  scene.bodies[0].velocity_gradient[0] = {50, 20, 0};
  Solver<double> a(scene);
  Solver<float> b(scene);
  run(a);
  run(b);
  EXPECT_NEAR(b.energies().internal, a.energies().internal, 1e-3 * a.energies().internal);
  EXPECT_NEAR(b.balance_error(), a.balance_error(), 1e-5);
}

TEST(Solver, TheEndOfTheRunDoesNotCutAStep) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0})}, 1e-3, false);
  scene.bodies[0].velocity_gradient[0] = {20, 10, 0};
  Solver<double> solver(scene);
  solver.step();
  double shortest = solver.dt(), longest = solver.dt();
  while (solver.time() < scene.time.end * (1 - 1e-12)) {
    solver.step();
    shortest = std::min(shortest, solver.dt());
    longest = std::max(longest, solver.dt());
  }
  EXPECT_GT(shortest, 0.97 * longest);  // strains of 2 % at most
  EXPECT_NEAR(solver.time(), scene.time.end, 1e-15);
}

TEST(Solver, ErodedNodesKeepTheirMassAndFlyOn) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {10, 20, -30})}, 1e-3, false);
  scene.materials = {plastic_material("steel", 1e9, 1.0)};
  scene.bodies[0].velocity_noise = 1;
  Solver<double> solver(scene);
  solver.step();
  const Point before = solver.momentum();
  strain_to_failure(solver, {0, 1, 2, 3, 4, 5, 6, 7});
  solver.step();
  EXPECT_EQ(solver.counts().eroded_elements(), 8);
  std::vector<Point> velocity;
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) velocity.push_back(velocity_of(solver, n));
  run(solver);
  for (std::size_t n = 0; n < velocity.size(); ++n) EXPECT_EQ(velocity_of(solver, n), velocity[n]);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solver.momentum()[k], before[k], 1e-10);
  EXPECT_NEAR(solver.time(), 1e-3, 1e-15);
}

TEST(Solver, ErosionIsInTheEnergyBalance) {
  // A block in strong shear whose elements fail one after the other.
  Scene scene = scene_of({block("a", {6, 6, 6}, 0.1, {0, 0, 0})}, 2e-3, false);
  scene.materials = {plastic_material("steel", 4e8, 0.05)};
  scene.bodies[0].velocity_gradient[0] = {0, 2000, 0};
  scene.bodies[0].velocity_noise = 20;
  Solver<double> solver(scene);
  double worst = 0;
  while (solver.time() < scene.time.end) {
    solver.step();
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  EXPECT_GT(solver.counts().eroded_elements(), 20);
  EXPECT_GT(solver.energies().eroded, 0);
  // Forces of an element vanish within a step and with them half the work of that step.
  EXPECT_LT(worst, 1e-2);
}

TEST(Solver, TheStepDoesNotFollowVibrationsAndFeedThem) {
  // A free cube of one element, all of whose modes vibrate, at strains of about 1e-3.
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0})}, 1e9, false);
  scene.bodies[0].velocity_noise = 5;
  Solver<double> solver(scene);
  double shortest = 1e9, longest = 0;
  while (solver.steps() < 50'000) {
    solver.step();
    if (solver.steps() < 1000) continue;
    shortest = std::min(shortest, solver.dt());
    longest = std::max(longest, solver.dt());
  }
  EXPECT_LT(longest / shortest - 1, 1e-5);
  EXPECT_LT(std::abs(solver.balance_error()), 1e-3);  // with a step that follows the vibrations: 0.2
}

TEST(Solver, MemoryPerElementIsBounded) {
  Solver<double> solver(read_scene(find_scene("rod_plate"), {.refine = 3}));
  solver.step();
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_EQ(summary.elements, 27 * (414 + 1428));
  EXPECT_LT(summary.bytes_per_element, 1000);
}

}  // namespace
}  // namespace pinball::solver_test
