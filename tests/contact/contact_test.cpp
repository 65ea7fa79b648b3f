#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "impact_case.hpp"

/// Contact of whole bodies, through the solver.
namespace pinball::contact_test {
namespace {

using namespace test;

/// Centre of the corners of an element, along z.
double height(const Solver<double>& solver, std::size_t element) {
  double sum = 0;
  for (const std::int32_t n : solver.mesh().hexahedra[element]) {
    sum += position_of(solver, static_cast<std::size_t>(n))[2] / 8;
  }
  return sum;
}

TEST(Contact, HeadOnImpactConservesMomentumAndEnergy) {
  Scene scene = head_on_impact(1.01 * touching_gap);
  scene.time.cfl = 0.2;
  Solver<double> solver(scene);
  const double momentum_of_one = 7850 * 0.027 * 10;
  double worst = 0;
  bool touched = false;
  while (solver.time() < scene.time.end) {
    solver.step();
    worst = std::max(worst, std::abs(solver.balance_error()));
    touched = touched || solver.energies().contact_stored > 0;
    for (const double p : solver.momentum()) ASSERT_NEAR(p, 0, 1e-12 * momentum_of_one);
  }
  solver.finish();
  EXPECT_TRUE(touched);
  EXPECT_EQ(solver.energies().contact_stored, 0);  // apart again
  EXPECT_LT(worst, 5e-3);
  EXPECT_LT(velocity_of_body(solver, 0)[2], -7);  // thrown back, not above the speed of approach
  EXPECT_GT(velocity_of_body(solver, 0)[2], -10);
  EXPECT_NEAR(velocity_of_body(solver, 0)[2], -velocity_of_body(solver, 1)[2], 1e-9);
}

TEST(Contact, OffsetObliqueImpactConservesMomentum) {
  const double h = 0.1;
  Scene scene = scene_of({block("a", {3, 3, 3}, h, {0, 0, 0}, {15, 5, 40}),
                          block("b", {4, 4, 2}, 0.08, {0.033, -0.047, 0.33}, {0, 0, -40})},
                         5e-4);
  scene.bodies[0].angular_velocity = {20, 30, 10};
  Solver<double> solver(scene);
  const Point before = solver.momentum();
  bool touched = false;
  while (solver.time() < scene.time.end) {
    solver.step();
    touched = touched || solver.energies().contact_stored > 0;
  }
  EXPECT_TRUE(touched);
  const double scale = 7850 * 0.027 * 40;
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solver.momentum()[k], before[k], 1e-12 * scale);
}

TEST(Contact, ObliqueImpactsKeepEnergyAndAngularMomentum) {
  // The forces of a pair act along the line of centres, or up to 18 degrees off it where the normals decide: only then
  // they have a small torque.
  const auto as_it_is = [](const Scene& scene) { return scene; };
  expect_oblique_impacts_conserve(as_it_is, 0.03, [](const Solver<double>& solver, double /*energy*/) {
    EXPECT_EQ(solver.energies().contact_stored, 0);
  });
}

TEST(Contact, ImpactOnItsMirrorImageIsTheMirrorImage) {
  // The same impact along +z and -z, and along x: the same velocity of rebound.
  const double h = 0.1, gap = (2 + 1.05 * touching_gap) * h;
  const auto rebound = [&](std::size_t axis, double sign) {
    Point corner{}, velocity{};
    corner[axis] = sign * gap;
    velocity[axis] = -sign * 20;
    Scene scene = scene_of({block("a", {2, 2, 2}, h, {0, 0, 0}), block("b", {2, 2, 2}, h, corner, velocity)}, 4e-4);
    Solver<double> solver(scene);
    run(solver);
    return sign * velocity_of_body(solver, 1)[axis];
  };
  const double up = rebound(2, 1);
  EXPECT_GT(up, -10);  // slowed down
  EXPECT_NEAR(rebound(2, -1), up, 1e-8);
  EXPECT_NEAR(rebound(0, 1), up, 1e-8);
  EXPECT_NEAR(rebound(1, -1), up, 1e-8);
}

TEST(Contact, APlateOneElementThickIsHitFromBothSides) {
  const auto plate_velocity = [&](double sign) {
    Solver<double> solver(impact_on_plate(sign, 1.05 * touching_gap));
    EXPECT_EQ(solver.contact()->surface_elements(), 36 + 8);
    const double side_before = height(solver, 36) - height(solver, 14);
    run(solver);
    const double side_after = height(solver, 36) - height(solver, 14);
    EXPECT_GT(side_before * side_after, 0) << "the block has passed through the plate";
    EXPECT_LT(std::abs(solver.balance_error()), 0.03);
    EXPECT_GT(sign * (velocity_of_body(solver, 1)[2] - velocity_of_body(solver, 0)[2]), 0) << "they separate";
    return velocity_of_body(solver, 0)[2];
  };
  const double from_above = plate_velocity(1), from_below = plate_velocity(-1);
  EXPECT_LT(from_above, -1);
  EXPECT_NEAR(from_below, -from_above, 1e-7);
}

/// All balls of such short bars are those of ends, whose faces along the bars look past each other. They meet as plates
/// do, ball on ball.
TEST(Contact, BarsOfOneElementAcrossMeetWhereTheyLieOnEachOther) {
  const auto rebound = [](int length, int width) {
    const double h = 0.1;
    Scene scene = scene_of({block("lower", {length, width, 1}, h, {0, 0, 0}, {0, 0, 5}),
                            block("upper", {length, width, 1}, h, {0, 0, (1 + 1.001 * touching_gap) * h}, {0, 0, -5})},
                           4e-4);
    Solver<double> solver(scene);
    run(solver);
    EXPECT_NEAR(velocity_of_body(solver, 0)[2], -velocity_of_body(solver, 1)[2], 1e-7);
    return velocity_of_body(solver, 1)[2];
  };
  for (const int length : {2, 3}) {
    EXPECT_GT(rebound(length, 1), 1) << "they have passed through each other";
    EXPECT_NEAR(rebound(length, 1), rebound(length, 2), 1e-9);
  }
}

TEST(Contact, BodiesThatTouchAtRestStayAtRest) {
  // Faces together, so that the balls overlap by a quarter of an element: the depth that they begin with stores
  // nothing.
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}), block("b", {2, 2, 2}, 0.15, {0, 0, 0.3})}, 1e-3);
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    ASSERT_EQ(position_of(solver, n), solver.mesh().nodes[n]);
  }
}

TEST(Contact, ErosionExposesTheElementBehind) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}), block("far", {1, 1, 1}, 0.1, {5, 5, 5})}, 1.0);
  scene.materials = {plastic_material("steel", 1e9, 1.0)};
  Solver<double> solver(scene);
  solver.step();
  EXPECT_EQ(solver.contact()->surface_elements(), 26 + 1);
  strain_to_failure(solver, {22});  // in the middle of the upper face; the one behind it is the centre of the block
  solver.step();
  EXPECT_EQ(solver.counts().eroded_elements(), 1);
  EXPECT_EQ(solver.contact()->surface_elements(), 25 + 1 + 1);
  const auto radius = snapshot(solver).pinball_radius;
  EXPECT_EQ(radius[22], 0);
  EXPECT_GT(radius[13], 0);
}

TEST(Contact, ABodyStopsAtTheSurfaceThatErosionHasExposed) {
  const double h = impact_h;
  const Scene scene = impact_on_eroding_target(2 * touching_gap);
  Solver<double> solver(scene);
  solver.step();
  erode_upper_layer(solver);
  const Point before = solver.momentum();
  double closest = 1;
  while (solver.time() < scene.time.end) {
    solver.step();
    // Lower face of the block over the new surface of the target, in the middle of both.
    const double gap = height(solver, 64) - height(solver, 37) - h;
    closest = std::min(closest, gap);
  }
  EXPECT_EQ(solver.counts().eroded_elements(), 16);
  EXPECT_LT(closest, touching_gap * h) << "it has not reached the new surface";
  EXPECT_GT(closest, -0.2 * h) << "it has passed the new surface";
  EXPECT_GT(velocity_of_body(solver, 1)[2], velocity_of_body(solver, 0)[2]) << "they separate";
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solver.momentum()[k], before[k], 1e-10 * 7850 * 0.008 * 50);
}

TEST(Contact, FragmentsOfOneBodyTouchUnlessSelfContactIsOff) {
  const double h = 0.1;
  const auto smallest_gap = [&](bool self, bool& apart) {
    Scene scene = scene_of({block("bar", {2, 2, 6}, h, {0, 0, 0})}, 6e-3);
    scene.materials = {plastic_material("steel", 1e10, 1.0)};
    scene.bodies[0].velocity_gradient[2] = {0, 0, -200};  // the ends move towards each other with 2 x 40
    scene.contact.self = self;
    Solver<double> solver(scene);
    solver.step();
    strain_to_failure(solver, {8, 9, 10, 11, 12, 13, 14, 15});  // the two layers in the middle
    const Point before = solver.momentum();
    double smallest = 1;
    while (solver.time() < scene.time.end) {
      solver.step();
      smallest = std::min(smallest, height(solver, 16) - height(solver, 4) - h);
    }
    EXPECT_EQ(solver.counts().eroded_elements(), 8);
    EXPECT_NEAR(solver.momentum()[2], before[2], 1e-9);
    apart = height(solver, 16) > height(solver, 4);
    return smallest;
  };
  bool apart = false;
  const double gap = smallest_gap(true, apart);
  EXPECT_TRUE(apart);
  EXPECT_LT(gap, touching_gap * h);
  EXPECT_GT(gap, -0.3 * h);
  smallest_gap(false, apart);
  EXPECT_FALSE(apart);
}

TEST(Contact, ABallOnThePlaneOfSymmetryFeelsNothingThroughIt) {
  // Half of a head-on impact off the axis: with the plane x = 0 the halves stay on their side.
  const double h = 0.1;
  Scene scene = scene_of({block("a", {2, 2, 2}, h, {0, 0, 0}),
                          block("b", {2, 2, 2}, h, {0, 0, (2 + 1.05 * touching_gap) * h}, {0, 0, -20})},
                         5e-4);
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}};
  Scene whole = scene;
  whole.constraints.clear();
  for (Body& body : whole.bodies) {
    std::get<BlockMesh>(body.mesh).size[0] *= 2;
    std::get<BlockMesh>(body.mesh).elements[0] *= 2;
    body.position[0] = -2 * h;
  }
  Solver<double> half(scene), full(whole);
  run(half);
  run(full);
  EXPECT_NEAR(velocity_of_body(half, 1)[2], velocity_of_body(full, 1)[2], 1e-6);
  EXPECT_GT(velocity_of_body(half, 1)[2], 0 - 20.0);
}

}  // namespace
}  // namespace pinball::contact_test
