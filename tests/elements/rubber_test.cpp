#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <solver/scene_rules.hpp>
#include <solver/summary.hpp>
#include <tests/support/law_materials.hpp>

/// Bodies of rubber at large strains.
namespace pinball::test::rubber_test {
namespace {

Scene ball_at_wall(const Material& material, HourglassControl hourglass = HourglassControl::assumed_strain) {
  Body body = block("ball", {4, 3, 5}, 0.01, {0, 0, 0.005}, {0, 0, -15});
  body.axis = Point{0.3, 0.1, 1};
  Scene scene = scene_of({body}, 4e-3, false);
  scene.element.hourglass = hourglass;
  scene.element.bulk_viscosity = true;
  scene.rigid_walls = {{"floor", {{0, 0, -0.01}, {0, 0, 1}}, "", "here"}};
  scene.bodies[0].material = "rubber";
  scene.materials = {material};
  return scene;
}

/// Of Mooney and Rivlin, and of powers of stretches with the same small strains and stresses of shape; and foam.
std::vector<Material> laws() {
  Material foam = rubber_of_powers();
  foam.ogden = OgdenSettings{{5e5, -1e5}, {3, -2}, 0.2, true};
  return {rubber(), rubber_of_powers(), foam};
}

/// As well as the neo-Hookean solid of the same small strains does, whatever the viscous hourglass forces swallow.
TEST(Rubber, KeepsTheBalanceOfEnergyAsNeoHookeanSolidsDo) {
  for (const Material& law : {rubber(), rubber_of_powers()}) {
    for (const HourglassControl hourglass : {HourglassControl::assumed_strain, HourglassControl::stiffness,
                                             HourglassControl::viscous, HourglassControl::none}) {
      Scene scene = ball_at_wall(law, hourglass);
      Solver<double> solver(scene);
      const double worst = worst_balance_of_run(solver);
      EXPECT_EQ(solver.counts().eroded_elements(), 0);
      complete_scene(scene);
      scene.materials[0].mooney_rivlin.reset();
      scene.materials[0].ogden.reset();
      Solver<double> other(scene);
      EXPECT_LT(worst, 1.5 * worst_balance_of_run(other) + 1e-4);
      if (hourglass != HourglassControl::viscous) {
        EXPECT_LT(worst, 5e-4);
      }
    }
  }
}

/// It is pressed more, in fewer steps: what they miss is of second order.
TEST(Rubber, OfWholeStretchesKeepsTheBalanceInSmallSteps) {
  const auto worst = [](double cfl) {
    Scene scene = ball_at_wall(laws()[2]);
    scene.time.cfl = cfl;
    Solver<double> solver(scene);
    return worst_balance_of_run(solver);
  };
  const double small = worst(0.1);
  EXPECT_LT(small, 1e-4);
  EXPECT_LT(small, worst(0.3) / 6);
}

TEST(Rubber, GivesTheSameBitsForAnyNumberOfThreads) {
  for (const Material& law : laws())
    EXPECT_EQ(hash_of_threads(ball_at_wall(law), 1), hash_of_threads(ball_at_wall(law), 3));
}

/// One element whose nodes move as F = 1 + t (...): sheared by 2 and turned at once, and pressed. Its stress is that of
/// where it is, whatever the way.
TEST(Rubber, HasTheStressOfSimpleShearInAnElementThatTurns) {
  Scene scene = scene_of({block("one", {1, 1, 1}, 0.01, {0, 0, 0}, {0, 0, 0})}, 1e-3, false);
  scene.element.bulk_viscosity = false;
  scene.guard.energy_error = 1e30;
  scene.bodies[0].material = "rubber";
  const double k = 2;
  for (const Material& law : {rubber(), rubber_of_powers()}) {
    scene.materials = {law};
    Solver<double> solver(scene);
    PrescribedMotion motion(solver, [&](const Point& x, double t) {
      const double share = std::min(1.0, t / 0.9e-3), turn = 0.7 * share;
      const double along = x[0] + k * share * x[1], across = x[1];
      return Point{std::cos(turn) * along - std::sin(turn) * across, std::sin(turn) * along + std::cos(turn) * across,
                   x[2]};
    });
    while (!solver.at_end()) motion.step();
    const auto s = stress_of(solver, 0);  // xx yy zz xy yz zx, turned by 0.7
    const double c = std::cos(0.7), n = std::sin(0.7);
    const double xx = c * c * s[0] + 2 * c * n * s[3] + n * n * s[1],
                 yy = n * n * s[0] - 2 * c * n * s[3] + c * c * s[1];
    const double xy = c * n * (s[1] - s[0]) + (c * c - n * n) * s[3], tolerance = 1e-9 * 2 * 4e5;
    EXPECT_NEAR(xy, 2 * 4e5 * k, tolerance);
    EXPECT_NEAR(xx - s[2], 2 * 3e5 * k * k, tolerance);
    EXPECT_NEAR(yy - s[2], -2 * 1e5 * k * k, tolerance);
  }
}

TEST(Rubber, IsTheSameInSinglePrecision) {
  for (const Material& law : laws()) {
    const double exact = height_at_end<double>(ball_at_wall(law));
    EXPECT_NEAR(height_at_end<float>(ball_at_wall(law)), exact, 1e-3 * std::abs(exact));
  }
}

}  // namespace
}  // namespace pinball::test::rubber_test
