#include <gtest/gtest.h>

#include <tests/support/solver_case.hpp>

/// A ball of rubber thrown at a wall so fast that it becomes flat: what its hourglass modes store they give back, and
/// no more, and its elements stay whole in the flight afterwards.
namespace pinball::rubber_ball_test {
namespace {

using namespace test;

class RubberBall : public testing::TestWithParam<HourglassControl> {};
INSTANTIATE_TEST_SUITE_P(Forms, RubberBall,
                         testing::Values(HourglassControl::assumed_strain, HourglassControl::stiffness),
                         [](const auto& form) {
                           return form.param == HourglassControl::stiffness ? "stiffness" : "assumed_strain";
                         });

TEST_P(RubberBall, TakesNoEnergyFromNothing) {
  Material rubber = elastic_material("rubber");
  rubber.density = 0.01;
  rubber.shear_modulus = 1000 / (2 * 1.49);
  rubber.bulk_modulus = 1000 / (3 * 0.02);
  Body ball = block("ball", {1, 1, 1}, 1, {0, 0, 5}, {0, 0, -180}, "rubber");
  ball.mesh = SphereMesh{.radius = 5, .core = {4, 4}, .ring = 2};
  Scene scene = scene_of({ball}, 0.5, false);
  scene.materials = {rubber};
  RigidWall wall;
  wall.name = "wall";
  wall.plane.normal = {0, 0, 1};
  scene.rigid_walls = {wall};
  scene.element.hourglass = GetParam();
  scene.element.hourglass_coefficient = default_hourglass_coefficient(GetParam());
  Solver<double> solver(scene);
  double kinetic = 0, least = 0, largest = 0, shortest = 1;
  run_to_end(solver, [&] {
    kinetic = std::max(kinetic, solver.energies().kinetic);
    least = std::min(least, solver.energies().hourglass);
    largest = std::max(largest, solver.energies().hourglass);
    if (solver.time() < 0.49) shortest = std::min(shortest, solver.dt());
  });
  EXPECT_GT(largest, 0);
  EXPECT_GE(least, -1e-12 * largest);
  EXPECT_LT(std::abs(solver.balance_error()), 3e-3);
  EXPECT_GT(shortest, 1e-4);  // of 2.9e-4 at the start
  EXPECT_LT(solver.energies().internal + solver.energies().hourglass, kinetic);
}

}  // namespace
}  // namespace pinball::rubber_ball_test
