#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <solver/scene_rules.hpp>
#include <tests/support/saved_state.hpp>

#include "rigid_case.hpp"

/// Rigid bodies in the step: what moves them, their momenta and energies, and that others stay as they are.
namespace pinball::rigid_bodies_test {
namespace {

using namespace test;
using testing::HasSubstr;

/// An asymmetric one that turns over as it flies.
Scene top(double end) {
  Scene scene = scene_of({block("top", {3, 2, 1}, 0.1, {7, 0, 0}, {1, 2, 0.5})}, end, false);
  scene.bodies[0].angular_velocity = {0.1, 6, 0.1};
  scene.rigid_bodies = {rigid("top")};
  return scene;
}

/// About the origin, of all nodes.
template <class S>
Point angular_momentum(const Solver<S>& solver) {
  const Model<S>& model = solver.model();
  Point all{};
  for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
    const S *x = model.nodes.position_of(n), *v = model.nodes.velocity_of(n);
    const Point own = cross({x[0], x[1], x[2]}, {v[0], v[1], v[2]});
    for (std::size_t k = 0; k < 3; ++k) all[k] += model.node_mass[n] * own[k];
  }
  return all;
}

/// From each node to the first one and to the last one, as the fields have them.
std::vector<double> lengths(const Solver<double>& solver) {
  const FieldSnapshot now = snapshot(solver);
  std::vector<double> all;
  for (const Point& p : now.position) {
    all.push_back(norm(minus(p, now.position.front())));
    all.push_back(norm(minus(p, now.position.back())));
  }
  return all;
}

TEST(RigidBodies, KeepMomentaEnergyAndShapeOverManyTurns) {
  Solver<double> solver(top(20));
  const Point momentum = angular_momentum(solver), start = solver.rigid().results()[0].centre;
  const std::vector<double> before = lengths(solver);
  for (int step = 0; step < 10; ++step) solver.step();
  const std::vector<double> meanwhile = lengths(solver);  // of a time that lies within a step
  for (std::size_t n = 0; n < before.size(); ++n) EXPECT_NEAR(meanwhile[n], before[n], 1e-13);
  run(solver);
  EXPECT_GT(solver.steps(), 10000);
  const RigidBodyResult result = solver.rigid().results()[0];
  const Point velocity{1, 2, 0.5};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(angular_momentum(solver)[k], momentum[k], 1e-10 * norm(momentum));
    EXPECT_NEAR(result.centre[k], start[k] + 20 * velocity[k], 1e-10);
  }
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-12);
  const std::vector<double> after = lengths(solver);
  for (std::size_t n = 0; n < before.size(); ++n) EXPECT_NEAR(after[n], before[n], 1e-13);
}

/// Far from where coordinates count from, sums of many lose digits of each axis.
TEST(RigidBodies, HaveTheirCentreFarAway) {
  Scene scene = scene_of({block("far", {20, 20, 20}, 0.1, {3e6, 5e6, -7e6})}, 1, false);
  scene.rigid_bodies = {rigid("far")};
  const Solver<double> solver(scene);
  const Model<double>& model = solver.model();
  const Point centre = solver.rigid().results()[0].centre;
  for (std::size_t k = 0; k < 3; ++k) {
    long double moment = 0, mass = 0;
    for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
      const long double own = model.node_mass[n];
      moment += own * (static_cast<long double>(model.nodes.position_of(n)[k]) - centre[k]);
      mass += own;
    }
    EXPECT_LE(std::abs(static_cast<double>(moment / mass)), 1e-9) << k;
  }
}

TEST(RigidBodies, HaveNoStressAndNoElementStep) {
  Scene scene = top(1);
  scene.bodies.push_back(block("soft", {2, 2, 2}, 0.1, {0, 0, 3}));
  Solver<double> solver(scene);
  solver.step();
  const double step = solver.dt();
  std::get<BlockMesh>(scene.bodies[0].mesh).elements = {30, 20, 10};  // with steps of a tenth
  Solver<double> fine(scene);
  fine.step();
  EXPECT_NEAR(fine.dt(), step, 1e-12 * step);
  RunSummary summary;
  fill_summary(fine, summary);
  EXPECT_EQ(summary.element_steps_rigid, 6000);
}

TEST(RigidBodies, FallUnderGravityAndAreHeldByWhatHoldsThem) {
  Scene scene = top(0.5);
  scene.gravities = {{.acceleration = {1, 0, -9.8}}};
  scene.rigid_bodies[0].held = {{0, 0, 1}};
  scene.bodies[0].velocity = {};
  scene.bodies[0].angular_velocity = {};
  Solver<double> solver(scene);
  run(solver);
  const RigidBodyResult result = solver.rigid().results()[0];
  EXPECT_NEAR(result.velocity[0], 0.5, 1e-12);
  EXPECT_NEAR(result.velocity[2], 0, 1e-15);
  EXPECT_NEAR(result.force[2], 9.8 * result.mass, 1e-9 * result.mass);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-12);
}

TEST(RigidBodies, AnswerForcesAndMomentsOfNodes) {
  Scene scene = top(0.01);
  scene.bodies[0].velocity = {};
  scene.bodies[0].angular_velocity = {};
  NodalLoad load;
  load.nodes.nearest = {7.3, 0.2, 0.1};
  load.force = {0, 0, 0.1};  // by which it hardly turns
  scene.loads = {load};
  Solver<double> solver(scene);
  run(solver);
  const RigidBodyResult result = solver.rigid().results()[0];
  EXPECT_NEAR(result.velocity[2], 0.1 / result.mass * 0.01, 1e-15);
  EXPECT_NEAR(result.angular_momentum[0], 0.1 * 0.1 * 0.01, 1e-10);
  EXPECT_NEAR(result.angular_momentum[1], -0.15 * 0.1 * 0.01, 1e-10);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-12);
}

TEST(RigidBodies, MoveAndTurnAsGiven) {
  Scene scene = top(2);
  scene.bodies[0].velocity = {};
  scene.bodies[0].angular_velocity = {};
  scene.rigid_bodies[0].held_rotations = {{1, 0, 0}, {0, 1, 0}};
  RigidMotion move, turn;
  move.rigid_body = turn.rigid_body = "top";
  move.direction = {0, 0, 1};
  move.speed = 0.5;
  move.table = {{0, 1, 2}, {0, 1, 0}};
  turn.axis = {0, 0, 1};
  turn.angular_speed = 3;
  turn.quantity = MotionQuantity::displacement;
  turn.table = {{0, 2}, {0, 1}};
  scene.rigid_motions = {move, turn};
  Solver<double> solver(scene);
  const FieldSnapshot before = snapshot(solver);
  const Point centre = solver.rigid().results()[0].centre;
  run(solver);
  EXPECT_NEAR(solver.rigid().results()[0].centre[2] - centre[2], 0.5, 1e-9);
  const FieldSnapshot after = snapshot(solver);
  for (std::size_t n = 0; n < before.position.size(); ++n) {
    const Point r = minus(before.position[n], centre);
    EXPECT_NEAR(after.position[n][0], centre[0] + std::cos(3) * r[0] - std::sin(3) * r[1], 1e-10);
    EXPECT_NEAR(after.position[n][1], centre[1] + std::sin(3) * r[0] + std::cos(3) * r[1], 1e-10);
  }
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-11);
}

TEST(RigidBodies, BalanceEnergyWithAGivenMassAndInertia) {
  Scene scene = top(3);
  scene.rigid_bodies[0].mass = 10;
  scene.rigid_bodies[0].inertia = {Point{2, 0.1, 0}, {0.1, 3, 0}, {0, 0, 4}};
  NodalLoad load;
  load.nodes.nearest = {7.3, 0.2, 0.1};
  load.force = {0, 5, 3};
  scene.loads = {load};
  Solver<double> solver(scene);
  const RigidBodyResult result = solver.rigid().results()[0];
  EXPECT_NEAR(result.mass, 10, 1e-12);
  EXPECT_NEAR(result.angular_momentum[1], 0.1 * 0.1 + 3 * 6, 1e-12);
  run(solver);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-11);
}

template <class S>
std::uint64_t hash_of(Solver<S>& solver) {
  run(solver);
  return state_hash(solver.model());
}

/// Rigid and deformable blocks that meet, many rows in one island.
Scene meeting_blocks() {
  Scene scene = scene_of({block("a", {30, 30, 2}, 0.1, {0, 0, 0}, {0, 0, 10}),
                          block("b", {31, 31, 1}, 0.09, {0.05, 0, 0.2001}, {20, 0, -10}),
                          block("c", {8, 8, 2}, 0.1, {0.3, 0.2, 0.2902}, {0, 3, -10})},
                         1e-3);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.contact.friction = 0.1;
  scene.contact.static_friction = 0.1;
  scene.rigid_bodies = {rigid("a"), rigid("c")};
  return scene;
}

TEST(RigidBodies, HaveTheSameBitsForAnyNumberOfThreadsAndAfterARestart) {
  DefaultExecutionSpace::set_concurrency(1);
  Solver<double> one(meeting_blocks());
  const std::uint64_t expected = hash_of(one);
  EXPECT_GT(one.counts().pairs_max(), 100);
  DefaultExecutionSpace::set_concurrency(2);
  Solver<double> two(meeting_blocks());
  EXPECT_EQ(hash_of(two), expected);
  Solver<double> first(meeting_blocks());
  while (first.time() < 5e-4) first.step();
  const StateBytes state = saved(first);
  Solver<double> second(meeting_blocks());
  EXPECT_EQ(load(second, state), 0U);
  EXPECT_EQ(hash_of(second), expected);
  DefaultExecutionSpace::set_concurrency(1);
}

std::string refused(const Scene& scene) {
  return error_of([&] { Solver<double>{checked_scene(scene)}; });
}

TEST(RigidBodies, RefuseByNameWhatTheyAreNotThereFor) {
  const auto with = [](const auto& change) {
    Scene scene = top(1);
    change(scene);
    return refused(scene);
  };
  EXPECT_EQ(with([](Scene&) {}), no_error);
  EXPECT_THAT(with([](Scene& s) { s.time.subcycling = true; }), HasSubstr("expected time.subcycling = false"));
  EXPECT_THAT(with([](Scene& s) {
                s.contact.method = ContactMethod::pinball;
                s.contact.enforcement = Enforcement::projection;
                s.contact.gap = ContactGap::not_set;
              }),
              HasSubstr("\"projection\" knows no rigid bodies"));
  EXPECT_THAT(with([](Scene& s) { s.bodies[0].velocity_noise = 1; }), HasSubstr("velocity_noise"));
  EXPECT_THAT(with([](Scene& s) { s.rigid_bodies.push_back(s.rigid_bodies[0]); }), HasSubstr("each body once"));
  EXPECT_THAT(with([](Scene& s) { s.rigid_bodies[0].bodies = {"tap"}; }), HasSubstr("no body is named \"tap\""));
  EXPECT_THAT(with([](Scene& s) { s.rigid_bodies[0].inertia[0][0] = 1; }), HasSubstr("expected that of a body"));
  EXPECT_THAT(with([](Scene& s) {
                s.rigid_walls.emplace_back().plane = {{0, 0, -5}, {0, 0, 1}};
              }),
              HasSubstr("rigid walls know no rigid bodies"));
  EXPECT_THAT(with([](Scene& s) {
                s.fixed_constraints = {{{.body = "top"}, {{1, 0, 0}}}};
              }),
              HasSubstr("rigid_body.held"));
  EXPECT_THAT(with([](Scene& s) {
                s.prescribed_velocities = {{.nodes = {.body = "top"}, .velocity = {1, 0, 0}}};
              }),
              HasSubstr("[[rigid_motion]] moves the body"));
  EXPECT_THAT(with([](Scene& s) {
                InitialVelocity part;
                part.nodes.nearest = {7, 0, 0};
                s.initial_velocities = {part};
              }),
              HasSubstr("no motion of the rigid body top"));
  EXPECT_THAT(with([](Scene& s) {
                s.rigid_bodies[0].held = all_directions;
                RigidMotion move;
                move.rigid_body = "top";
                move.direction = {1, 0, 0};
                s.rigid_motions = {move};
              }),
              HasSubstr("at right angles"));
}

/// A flat body has one moment that is the sum of the others, and none has a larger one.
TEST(RigidBodies, HaveNoInertiaThatNoBodyHas) {
  const auto with = [](double x, double y, double z) {
    Scene scene = top(1);
    scene.rigid_bodies[0].inertia = {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
    return refused(scene);
  };
  for (const double third : {1.01, 2.0, 2.99, 3.0}) EXPECT_EQ(with(1, 2, third), no_error) << third;
  for (const auto& [x, y, z] : {Point{1, 2, 3.01}, {3.01, 1, 2}, {2, 3.01, 1}, {1, 1, 0}, {1, 1, -0.1}})
    EXPECT_THAT(with(x, y, z), HasSubstr("expected that of a body")) << x << ' ' << y << ' ' << z;
}

TEST(RigidBodies, OnAPlaneOfSymmetryMoveAlongIt) {
  Scene scene = top(0.2);
  scene.bodies[0].position = {0, 0, 0};
  scene.bodies[0].angular_velocity = {};
  scene.bodies[0].velocity = {0, 2, 1};
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}};
  NodalLoad load;
  load.nodes.nearest = {0.3, 0.2, 0.1};
  load.force = {500, 20, 0};
  scene.loads = {load};
  Solver<double> solver(scene);
  run(solver);
  const RigidBodyResult result = solver.rigid().results()[0];
  EXPECT_NEAR(result.velocity[0], 0, 1e-14);
  EXPECT_NEAR(result.angular_velocity[1], 0, 1e-13);
  EXPECT_NEAR(result.angular_velocity[2], 0, 1e-13);
  EXPECT_GT(std::abs(result.angular_velocity[0]), 1e-6);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-11);
}

/// Two planes at 60 degrees, and one that is held by itself as well.
TEST(RigidBodies, ArePartOfTheForceOfAPlaneThatHoldsThem) {
  Scene scene = top(0.01);
  scene.bodies[0].position = {0, 0, 0};
  scene.bodies[0].angular_velocity = {};
  scene.bodies[0].velocity = {};
  const Point first{1, 0, 0}, second{0.5, std::sqrt(0.75), 0};
  scene.constraints = {{{0, 0, 0}, first, "", "", 0, "", "first"}, {{0, 0, 0}, second, "", "", 0, "", "second"}};
  NodalLoad load;
  load.nodes.nearest = {0, 0, 0};
  load.force = {500, 20, 70};
  scene.loads = {load};
  const auto forces = [&] {
    Solver<double> solver(scene);
    for (int step = 0; step < 3; ++step) solver.step();
    return solver.named_forces();
  };
  const double by_second = -20 / second[1], by_first = -500 - 0.5 * by_second;
  const std::vector<ForceResult> both = forces();
  ASSERT_EQ(both.size(), 2U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(both[0].force[k], by_first * first[k], 1e-9);
    EXPECT_NEAR(both[1].force[k], by_second * second[k], 1e-9);
  }
  scene.rigid_bodies[0].held = {{0, 0, 1}};
  EXPECT_EQ(forces()[0].force[2], 0);
  scene.rigid_bodies[0].held = {{0, 1, 0}};
  scene.constraints.pop_back();
  const std::vector<ForceResult> beside = forces();
  EXPECT_NEAR(beside[0].force[0], -500, 1e-9);
  EXPECT_NEAR(beside[0].force[1], 0, 1e-9) << "of the body itself";
}

}  // namespace
}  // namespace pinball::rigid_bodies_test
