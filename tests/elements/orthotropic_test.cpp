#include <gtest/gtest.h>

#include <cmath>

#include <solver/scene/material/orthotropic_moduli.hpp>
#include <solver/summary.hpp>
#include <tests/support/collapsed_case.hpp>
#include <tests/support/law_materials.hpp>
#include <tests/support/tetrahedra_case.hpp>

/// Bodies whose elasticity differs with the direction.
namespace pinball::test::orthotropic_test {
namespace {

Scene one_element(const Material& material) {
  Scene scene = scene_of({block("one", {1, 1, 1}, 0.01, {0, 0, 0}, {0, 0, 0}, "wood")}, 1e-4, false);
  scene.guard.energy_error = 1e30;
  scene.materials = {material};
  return scene;
}

/// Stress of an element whose nodes go to F x.
std::array<double, 6> stress_after(const Scene& scene, const std::array<Point, 3>& f) {
  Solver<double> solver(scene);
  PrescribedMotion motion(solver, [&](const Point& x, double t) {
    const double share = std::min(1.0, t / (0.8 * scene.time.end));
    Point y{};
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] = x[i];
      for (std::size_t j = 0; j < 3; ++j) y[i] += share * (f[i][j] - (i == j ? 1 : 0)) * x[j];
    }
    return y;
  });
  while (!solver.at_end()) motion.step();
  return stress_of(solver, 0);
}

/// Along each axis of the material a strain with which nothing acts across: E times it, also where the specimen is cut
/// so that the axis lies askew in the scene.
TEST(Orthotropic, HasYoungsModulusAlongEachAxis) {
  for (const bool askew : {false, true}) {
    Material material = orthotropic();
    OrthotropicSettings& law = *material.orthotropic;
    if (!askew) law.first_axis = {1, 0, 0}, law.second_axis = {0, 1, 0};
    const double n = std::sqrt(1.29);  // of the first axis of the material
    const Point a = askew ? Point{1 / n, 0.5 / n, 0.2 / n} : Point{1, 0, 0};
    const double strain = 1e-6;
    const auto& [ab, ac, bc] = law.poisson_ratios;
    // Its other axes: c is across the first and the second given one.
    Point c = cross(a, askew ? Point{0, 1, 1} : Point{0, 1, 0});
    const double length = std::hypot(c[0], c[1], c[2]);
    for (double& component : c) component /= length;
    const std::array<Point, 3> axes{a, cross(c, a), c};
    const double ratio[3][3] = {
        {1, -ab, -ac},
        {-ab * law.young_moduli[1] / law.young_moduli[0], 1, -bc},
        {-ac * law.young_moduli[2] / law.young_moduli[0], -bc * law.young_moduli[2] / law.young_moduli[1], 1}};
    for (std::size_t pulled = 0; pulled < 3; ++pulled) {
      std::array<Point, 3> f{};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          f[i][j] = i == j ? 1 : 0;
          for (std::size_t k = 0; k < 3; ++k) f[i][j] += strain * ratio[pulled][k] * axes[k][i] * axes[k][j];
        }
      }
      const auto s = stress_after(one_element(material), f);
      const double exact = law.young_moduli[pulled] * strain, tolerance = 1e-5 * exact;  // E has a square of F
      const Point& p = axes[pulled];
      const double expected[6] = {p[0] * p[0], p[1] * p[1], p[2] * p[2], p[0] * p[1], p[1] * p[2], p[2] * p[0]};
      for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(s[i], exact * expected[i], tolerance) << pulled << i;
    }
  }
}

TEST(Orthotropic, HasAShearModulusInEachPlane) {
  Material material = orthotropic();
  OrthotropicSettings& law = *material.orthotropic;
  law.first_axis = {1, 0, 0}, law.second_axis = {0, 1, 0};
  const double shear = 1e-6;
  const Scene scene = one_element(material);
  EXPECT_NEAR(stress_after(scene, {{{1, shear, 0}, {0, 1, 0}, {0, 0, 1}}})[3], law.shear_moduli[0] * shear, 1e-1);
  EXPECT_NEAR(stress_after(scene, {{{1, 0, shear}, {0, 1, 0}, {0, 0, 1}}})[5], law.shear_moduli[1] * shear, 1e-1);
  EXPECT_NEAR(stress_after(scene, {{{1, 0, 0}, {0, 1, shear}, {0, 0, 1}}})[4], law.shear_moduli[2] * shear, 1e-1);
}

/// Strained by a few per cent, and then turned by a right angle: the stress turns with it.
TEST(Orthotropic, ATurnKeepsTheStressInTheMaterial) {
  Scene scene = one_element(orthotropic());
  Solver<double> solver(scene);
  std::array<double, 6> strained{};
  PrescribedMotion motion(solver, [&](const Point& x, double t) {
    const double share = std::min(1.0, t / 0.3e-4), turn = std::acos(0.0) * std::clamp((t - 0.4e-4) / 0.4e-4, 0.0, 1.0);
    const Point y{x[0] * (1 + 0.02 * share) + 0.03 * share * x[1], x[1] * (1 - 0.01 * share),
                  x[2] * (1 + 0.01 * share)};
    return Point{std::cos(turn) * y[0] - std::sin(turn) * y[1], std::sin(turn) * y[0] + std::cos(turn) * y[1], y[2]};
  });
  while (!solver.at_end()) {
    motion.step();
    if (solver.force_time() < 0.39e-4) strained = stress_of(solver, 0);
  }
  const auto s = stress_of(solver, 0);
  const double tolerance = 1e-9 * 2e11;
  EXPECT_NEAR(s[0], strained[1], tolerance);
  EXPECT_NEAR(s[1], strained[0], tolerance);
  EXPECT_NEAR(s[2], strained[2], tolerance);
  EXPECT_NEAR(s[3], -strained[3], tolerance);
  EXPECT_NEAR(s[4], strained[5], tolerance);
  EXPECT_NEAR(s[5], -strained[4], tolerance);
  EXPECT_GT(std::abs(strained[3] - strained[4]), 1e8);
}

/// A block that spins and strikes a wall, by elements of all kinds.
Scene at_wall(HourglassControl hourglass = HourglassControl::assumed_strain) {
  Body body = block("block", {4, 3, 5}, 0.01, {0, 0, 0.005}, {0, 0, -15}, "wood");
  body.axis = Point{0.3, 0.1, 1};
  Scene scene = scene_of({body}, 2e-4, false);
  scene.element.hourglass = hourglass;
  scene.rigid_walls = {{"floor", {{0, 0, -0.01}, {0, 0, 1}}, "", "here"}};
  scene.materials = {orthotropic()};
  return scene;
}

TEST(Orthotropic, KeepsTheBalanceOfEnergy) {
  for (const HourglassControl hourglass : {HourglassControl::assumed_strain, HourglassControl::stiffness}) {
    Solver<double> solver(at_wall(hourglass));
    EXPECT_LT(worst_balance_of_run(solver), 1e-3);
  }
}

/// Of constants that are those of an isotropic one it moves as that does, whose energy is another: at small strains
/// they differ by a share that is as large as the strain.
TEST(Orthotropic, IsIsotropicWhereItsConstantsAre) {
  const auto difference = [](double rate) {
    Scene scene = at_wall();
    scene.rigid_walls.clear();
    scene.bodies[0].velocity = {0, 0, 0};
    scene.bodies[0].velocity_gradient = {{{-rate, 0.7 * rate, 0}, {0, 0.5 * rate, 0}, {0, -0.4 * rate, 0.3 * rate}}};
    const double young = 2.1e11, nu = 0.3, shear = young / 2.6;
    scene.materials[0].orthotropic->young_moduli = {young, young, young};
    scene.materials[0].orthotropic->poisson_ratios = {nu, nu, nu};
    scene.materials[0].orthotropic->shear_moduli = {shear, shear, shear};
    Scene other = scene;
    other.materials = {elastic_material("wood", nu)};
    Solver<double> a(scene), b(other);
    EXPECT_NEAR(a.model().scene.materials[0].bulk_modulus, other.materials[0].bulk_modulus, 1);
    run(a);
    run(b);
    return std::abs(a.energies().internal / b.energies().internal - 1);
  };
  const double slow = difference(10), fast = difference(100);
  EXPECT_LT(slow, 2e-5);
  EXPECT_NEAR(fast / slow, 10, 0.5);
}

TEST(Orthotropic, IsTheSameInSinglePrecisionAndOnAnyNumberOfThreads) {
  Scene scene = at_wall();
  const double exact = height_at_end<double>(scene);
  EXPECT_NEAR(height_at_end<float>(scene), exact, 1e-3 * std::abs(exact));
  scene.precision = Precision::mixed;
  EXPECT_NEAR(height_at_end<double>(scene), exact, 1e-3 * std::abs(exact));
  EXPECT_EQ(hash_of_threads(at_wall(), 1), hash_of_threads(at_wall(), 3));
}

/// The step is one of the moduli that are there: a soft axis does not make it longer than its stiffest one allows.
TEST(Orthotropic, ItsStepFollowsItsStiffestAxis) {
  const auto first_step = [](const Point& young) {
    Scene scene = at_wall();
    scene.materials[0].orthotropic->young_moduli = young;
    scene.materials[0].orthotropic->poisson_ratios = {0, 0, 0};
    Solver<double> solver(scene);
    solver.step();
    return solver.dt();
  };
  const double all = first_step({2e11, 2e11, 2e11}), one = first_step({2e11, 2e10, 2e10});
  EXPECT_NEAR(one, all, 1e-3 * all);
}

/// What flies freely and is elastic gives back what it has stored. With volumes averaged over nodes, as those of
/// isotropic materials are, it made a hundred times the energy that it began with.
TEST(Orthotropic, TetrahedraAndWedgesMakeNoEnergy) {
  const Body whole = block("a", {3, 3, 3}, 0.01, {0, 0, 0}, {0, 0, 0}, "wood");
  const HostMesh mesh = block_cut({3, 3, 3}, {0.03, 0.03, 0.03}, Cut::across_z);
  const Body wedges = body_of(mesh, "wood");
  for (Body body : {whole, cut(whole), wedges}) {
    body.velocity_gradient = {{{0, 2e3, 0}, {0, 0, -2e3}, {1.4e3, 0, 0}}};
    Scene scene = scene_of({body}, 1e-4, false);
    scene.materials = {orthotropic()};
    scene.guard.energy_error = 1e30;
    Solver<double> solver(scene);
    solver.step();
    const double start = solver.energies().kinetic;
    double least = 0, most = 0;
    run_to_end(solver, [&] {
      least = std::min(least, solver.energies().internal);
      most = std::max(most, solver.energies().kinetic);
    });
    EXPECT_GT(least, -1e-3 * start);
    EXPECT_LT(most, 1.001 * start);
  }
}

}  // namespace
}  // namespace pinball::test::orthotropic_test
