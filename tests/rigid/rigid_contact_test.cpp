#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rigid_case.hpp"

/// Impacts of rigid bodies against closed forms.
namespace pinball::rigid_contact_test {
namespace {

using namespace test;

Scene by_impulses(const std::vector<Body>& bodies, double end) {
  Scene scene = scene_of(bodies, end);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  return scene;
}

/// Rows of a body differ, and the compliance leaves a ten-thousandth of what they change.
TEST(RigidContact, OfTwoRigidBodiesIsPlastic) {
  Scene scene = by_impulses(
      {block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {0, 0, 3}), block("b", {3, 3, 3}, 0.1, {-0.05, -0.05, 0.21}, {0, 0, -1})},
      0.02);
  scene.rigid_bodies = {rigid("a"), rigid("b")};
  Solver<double> solver(scene);
  run(solver);
  const auto after = solver.rigid().results();
  const double common = (8 * 3.0 - 27 * 1.0) / 35;
  EXPECT_NEAR(after[0].velocity[2], common, 1e-4 * 4);
  EXPECT_NEAR(after[1].velocity[2], common, 1e-4 * 4);
  EXPECT_NEAR(norm(after[0].angular_velocity), 0, 1e-8);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-12);
}

/// The foot of a block that swings is attached to a rigid one, whose face it touches, is in or is above.
TEST(RigidContact, IsNoneWhereNodesAreAttached) {
  for (const double height : {0.3, 0.299, 0.25, 0.31}) {
    for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::penalty}) {
      Scene scene = by_impulses({block("hard", {3, 3, 3}, 0.1, {0, 0, 0}, {1, 2, 3}),
                                 block("soft", {2, 2, 2}, 0.1, {0.05, 0.05, height}, {4, 2, 9})},
                                1e-3);
      scene.contact.enforcement = enforcement;
      if (enforcement == Enforcement::penalty) scene.contact.gap = ContactGap::pinball;
      scene.contact.friction = scene.contact.static_friction = 0.3;
      scene.rigid_bodies = {rigid("hard")};
      scene.attached_nodes = {attached_at("hard", "soft", height)};
      Scene among_itself = scene;  // with the same steps, which contact has a say in
      among_itself.contact_pairs.emplace_back().first.bodies = {"soft"};
      Solver<double> solver(scene), free(among_itself);
      run(solver);
      run(free);
      const RigidBodyResult found = solver.rigid().results()[0], expected = free.rigid().results()[0];
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(found.velocity[k], expected.velocity[k], 1e-9) << height;
        EXPECT_NEAR(found.angular_velocity[k], expected.angular_velocity[k], 1e-9) << height;
      }
      EXPECT_NEAR(solver.energies().internal, free.energies().internal, 1e-9 * free.energies().internal);
      EXPECT_EQ(solver.energies().contact_damped, 0);
    }
  }
}

/// Two blocks side by side on one rigid body: their feet are of one body, above they press each other.
TEST(RigidContact, ActsBetweenBodiesThatAreAttachedToOne) {
  Scene scene =
      by_impulses({block("hard", {4, 2, 1}, 0.1, {0, 0, 0}), block("left", {2, 2, 3}, 0.1, {0, 0, 0.1}, {1, 0, 0}),
                   block("right", {2, 2, 3}, 0.1, {0.2, 0, 0.1}, {-1, 0, 0})},
                  2e-3);
  scene.rigid_bodies = {rigid("hard")};
  scene.attached_nodes = {attached_at("hard", "left", 0.1), attached_at("hard", "right", 0.1)};
  Solver<double> solver(scene);
  run(solver);
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_GT(summary.pairs_max, 0);
  EXPECT_EQ(summary.iterations.unsolved, 0);
  EXPECT_LT(summary.max_penetration_ratio, 1e-2);
  EXPECT_NEAR(solver.momentum()[0], 0, 1e-9);
}

TEST(RigidContact, WithSpringsIsElastic) {
  Scene scene = scene_of(
      {block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {0, 0, 3}), block("b", {2, 2, 2}, 0.1, {0, 0, 0.25}, {0, 0, -1})}, 0.05);
  scene.contact.damping = 0;
  scene.time.cfl = 0.05;
  scene.rigid_bodies = {rigid("a"), rigid("b")};
  Solver<double> solver(scene);
  run(solver);
  const auto after = solver.rigid().results();
  EXPECT_NEAR(after[0].velocity[2], -1, 1e-3);
  EXPECT_NEAR(after[1].velocity[2], 3, 1e-3);
}

/// A block that stands on its corner hits a plate beside its centre: with arms r from the centres and n = z
///
///     p = u / (1/M1 + 1/M2 + (r1 x n) . I1^-1 (r1 x n) + (r2 x n) . I2^-1 (r2 x n)) ,   u: the closing speed.
///
/// The inverses are taken by Cramer's rule, independently of the solver's.
double turning(const std::array<Point, 3>& inertia, const Point& moment, Point& spin) {
  const double det = dot(inertia[0], cross(inertia[1], inertia[2]));
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<Point, 3> m = inertia;  // symmetric: rows for columns
    m[k] = moment;
    spin[k] = dot(m[0], cross(m[1], m[2])) / det;
  }
  return dot(moment, spin);
}

TEST(RigidContact, BesideTheCentresTurnsBoth) {
  Scene scene =
      by_impulses({block("plate", {4, 4, 1}, 0.1, {0, 0, -0.1}), block("corner", {1, 2, 3}, 0.1, {0, 0, 0})}, 1e-4);
  scene.bodies[1].axis = {1, 1, 1};
  scene.bodies[1].velocity = {0, 0, -5};
  const auto lowest = [](const Scene& of) {
    const ModelMesh mesh = build_mesh(of);
    Point low{0, 0, 1e9};
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (mesh.body_of_node[n] == 1 && mesh.nodes[n][2] < low[2]) low = mesh.nodes[n];
    }
    return low;
  };
  const Point at = lowest(scene), wanted{0.13, 0.07, 1e-4};
  for (std::size_t k = 0; k < 3; ++k) scene.bodies[1].position[k] += wanted[k] - at[k];
  scene.rigid_bodies = {rigid("plate"), rigid("corner")};
  Solver<double> solver(scene);
  const auto before = solver.rigid().results();
  while (solver.counts().pairs() == 0) solver.step();
  for (int i = 0; i < 3; ++i) solver.step();
  const auto after = solver.rigid().results();
  double inverse = 1 / before[0].mass + 1 / before[1].mass;
  std::array<Point, 2> spin{};
  for (std::size_t b = 0; b < 2; ++b) {
    Point r = minus(wanted, before[b].centre);
    const Point moment = cross(r, {0, 0, b == 0 ? -1.0 : 1.0});
    inverse += turning(before[b].inertia, moment, spin[b]);
  }
  const double p = 5 / inverse;
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_NEAR(after[b].velocity[2], before[b].velocity[2] + (b == 0 ? -p : p) / before[b].mass, 1e-3);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(after[b].angular_velocity[k], p * spin[b][k], 1e-4 * p * norm(spin[b])) << b << k;
  }
}

TEST(RigidContact, SlidesAsFrictionHasIt) {
  Scene scene = by_impulses(
      {block("floor", {12, 4, 1}, 0.2, {-0.7, -0.41, -0.2}), block("block", {4, 4, 2}, 0.05, {0, 0, 0}, {2, 0, 0})},
      0.5);
  scene.contact.friction = scene.contact.static_friction = 0.3;
  scene.rigid_bodies = {rigid("floor"), rigid("block")};
  scene.rigid_bodies[0].held = scene.rigid_bodies[0].held_rotations = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.gravities = {{.acceleration = {0, 0, -10}}};
  Solver<double> solver(scene);
  const double start = solver.rigid().results()[1].centre[0];
  run(solver);
  const RigidBodyResult after = solver.rigid().results()[1];
  EXPECT_NEAR(after.centre[0] - start, 2 * 0.5 - 0.5 * 0.3 * 10 * 0.25, 1e-5);
  EXPECT_NEAR(after.velocity[0], 2 - 0.3 * 10 * 0.5, 1e-5);
  EXPECT_NEAR(after.centre[2], 0.05, 1e-6);
}

/// A block under its weight, pushed by a share of it, on a floor that is rigid or whose nodes are held.
double speed_on_a_floor(double push, bool floor_is_rigid, const Point& axis) {
  Scene scene = by_impulses(
      {block("floor", {12, 4, 1}, 0.2, {-0.7, -0.41, -0.2}), block("block", {4, 4, 2}, 0.05, {0, 0, 0})}, 0.05);
  scene.contact.friction = 0.3;
  scene.contact.static_friction = 0.4;
  scene.rigid_bodies = {rigid("block")};
  const std::vector<Point> all{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (floor_is_rigid) {
    scene.rigid_bodies.push_back(rigid("floor"));
    scene.rigid_bodies[1].held = scene.rigid_bodies[1].held_rotations = all;
  } else {
    FixedConstraint& held = scene.fixed_constraints.emplace_back();
    held.nodes.body = "floor";
    held.directions = all;
  }
  scene.gravities = {{.acceleration = {10 * push * axis[0], 10 * push * axis[1], -10}, .bodies = {"block"}}};
  Solver<double> solver(scene);
  run(solver);
  return dot(solver.rigid().results()[0].velocity, axis);
}

/// Which of its rows hold is for none of them to say: only all of them together have a share of the weight that the
/// push, the height of its centre and the shape of the block give.
TEST(RigidContact, HoldsAsLongAsAllRowsOfAPairDoTogether) {
  for (const bool floor_is_rigid : {true, false}) {
    for (const Point& axis : {Point{1, 0, 0}, Point{0, -1, 0}, Point{0.6, 0.8, 0}}) {
      for (const double push : {0.35, 0.39}) EXPECT_NEAR(speed_on_a_floor(push, floor_is_rigid, axis), 0, 1e-6) << push;
      for (const double push : {0.42, 0.5}) {
        const double expected = 10 * (push - 0.3) * 0.05;
        EXPECT_NEAR(speed_on_a_floor(push, floor_is_rigid, axis), expected, 0.02 * expected) << push;
      }
    }
  }
}

/// A block whose nodes ring as it slides: what they get back where they part rubs as well.
TEST(RigidContact, RubsByAllThatPresses) {
  const double friction = 0.3, gravity = 10, end = 0.1;
  Scene scene = by_impulses(
      {block("floor", {12, 4, 1}, 0.2, {-0.7, -0.41, -0.2}), block("block", {2, 2, 2}, 0.05, {0, 0, 0}, {2, 0, 0})},
      end);
  scene.element.hourglass = HourglassControl::assumed_strain;
  scene.materials[0].bulk_modulus *= 0.01;  // steps ten times as long
  scene.materials[0].shear_modulus *= 0.01;
  scene.contact.friction = scene.contact.static_friction = friction;
  scene.rigid_bodies = {rigid("floor")};
  scene.rigid_bodies[0].held = scene.rigid_bodies[0].held_rotations = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.gravities = {{.acceleration = {0, 0, -gravity}, .bodies = {"block"}}};
  Solver<double> solver(scene);
  const double mass = 7850 * 0.001;
  run(solver);
  const Point after = solver.momentum();
  const double pressed = mass * gravity * end + after[2], rubbed = 2 * mass - after[0];
  EXPECT_NEAR(rubbed / (friction * pressed), 1, 5e-4);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-3);
}

/// A rigid block on a bar of the same section: the bar's end gets the block's velocity, and the stress is that of a
/// wave, rho c v; the block slows down by exp(-rho c A t/M).
TEST(RigidContact, OnABarSlowsDownAsThePressureOfTheWaveHasIt) {
  const double h = 0.01, v = 1;
  Scene scene =
      by_impulses({block("bar", {1, 1, 200}, h, {0, 0, 0}), block("block", {1, 1, 4}, h, {0, 0, 2 + 1e-6})}, 3e-5);
  scene.materials = {elastic_material("steel", 0.0)};
  scene.element.bulk_viscosity = true;
  scene.bodies[1].velocity = {0, 0, -v};
  scene.rigid_bodies = {rigid("block")};
  Solver<double> solver(scene);
  run(solver);
  const RigidBodyResult after = solver.rigid().results()[0];
  const double c = std::sqrt(2.1e11 / 7850), time = 3e-5 - 1e-6;
  EXPECT_NEAR(-after.velocity[2], v * std::exp(-7850 * c * h * h * time / after.mass), 0.02);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-4);
}

}  // namespace
}  // namespace pinball::rigid_contact_test
