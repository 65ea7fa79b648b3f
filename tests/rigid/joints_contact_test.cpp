#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <tests/support/saved_state.hpp>

#include "joint_case.hpp"

/// Impacts on jointed bodies against impulsive mechanics: contact knows what else it moves.
namespace pinball::joints_contact_test {
namespace {

using namespace test;

constexpr double speed = 2;

/// Bars without gravity, and a cube of 0.2 that strikes them from above.
Scene struck(const std::vector<Body>& bars, const std::vector<Joint>& joints, const Point& corner, double end) {
  std::vector<Body> bodies = bars;
  bodies.push_back(block("cube", {2, 2, 2}, 0.1, corner, {0, 0, -speed}));
  Scene scene = mechanism(bodies, joints, end);
  scene.gravities.clear();
  scene.contact.method = ContactMethod::pinball;
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  return scene;
}

/// About y through a point, of a body that turns about it.
double inertia_about(const RigidBodyResult& body, const Point& point) {
  const Point arm = minus(body.centre, point);
  return body.inertia[1][1] + body.mass * (arm[0] * arm[0] + arm[2] * arm[2]);
}

/// The same of a body that moves along z as a bar under it, on which it slides.
double inertia_on_bar(const RigidBodyResult& body, const Point& point) {
  const double arm = body.centre[0] - point[0];
  return body.inertia[1][1] + body.mass * arm * arm;
}

/// The cube stays on the bar, as rigid bodies do: m v r = (I_bar + I_cube) w about the hinge.
TEST(JointsContact, AHingedBarIsAsHeavyAsAboutItsHinge) {
  for (const JointKind kind : {JointKind::revolute, JointKind::spherical}) {
    for (const double left : {0.05, 0.4, 0.75}) {
      Scene scene = struck({block("bar", {10, 3, 1}, 0.1, {0, -0.15, 0})},
                           {joint_of(kind, "bar", ground, {0, 0, 0.05},
                                     kind == JointKind::revolute ? std::optional<Point>({0, 1, 0}) : std::nullopt)},
                           {left, -0.1, 0.101}, 4e-3);
      Solver<double> solver(scene);
      const auto before = solver.rigid().results();
      const Point at{0, 0, 0.05};
      const double momentum = before[1].mass * speed * before[1].centre[0];
      const double together = inertia_about(before[0], at) + inertia_on_bar(before[1], at);
      run(solver);
      const auto after = solver.rigid().results();
      EXPECT_GT(solver.counts().pairs_max(), 0);
      EXPECT_NEAR(after[0].angular_velocity[1], momentum / together, 3e-4 * momentum / together) << left;
      EXPECT_NEAR(after[1].angular_velocity[1], momentum / together, 3e-4 * momentum / together) << left;
      EXPECT_NEAR(angular_momentum_about(at, after)[1], momentum, 1e-6 * momentum);
      EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-3);
      EXPECT_LT(solver.rigid().joint_results()[0].opening, 1e-14);
    }
  }
}

Scene struck_chain(double end) {
  const Point y{0, 1, 0}, first{0, 0, 0.05}, second{1, 0, 0.05};
  Scene scene = struck({block("upper", {10, 3, 1}, 0.1, {0, -0.15, 0}), block("lower", {8, 3, 1}, 0.1, {1, -0.15, 0})},
                       {joint_of(JointKind::revolute, "upper", ground, first, y),
                        joint_of(JointKind::revolute, "upper", "lower", second, y)},
                       {1.3, -0.1, 0.101}, end);
  scene.contact_pairs.emplace_back().first.bodies = {"cube"};
  scene.contact_pairs.back().second.bodies = {"upper", "lower"};
  return scene;
}

/// Two bars in a row, each hinged to what is before it, of angular velocities w_1 and w_2. With the cube, which turns
/// as the second one, (M + M_cube) w = m v (l, r), r being its distance from the second hinge.
TEST(JointsContact, AChainOfTwoBarsIsMovedAsAWhole) {
  const Point first{0, 0, 0.05}, second{1, 0, 0.05};
  Solver<double> solver(struck_chain(2e-3));
  const auto before = solver.rigid().results();
  const double l = 1, d = before[1].centre[0] - 1, m2 = before[1].mass, m = before[2].mass, r = before[2].centre[0] - 1;
  const double m11 = inertia_about(before[0], first) + (m2 + m) * l * l, m12 = m2 * l * d + m * l * r,
               m22 = inertia_about(before[1], second) + inertia_on_bar(before[2], second);
  const double determinant = m11 * m22 - m12 * m12, p1 = m * speed * l, p2 = m * speed * r;
  const double w1 = (m22 * p1 - m12 * p2) / determinant, w2 = (m11 * p2 - m12 * p1) / determinant;
  run(solver);
  const auto after = solver.rigid().results();
  const double fastest = std::max(std::abs(w1), std::abs(w2));
  EXPECT_NEAR(after[0].angular_velocity[1], w1, 1e-4 * fastest);
  EXPECT_NEAR(after[1].angular_velocity[1], w2, 1e-4 * fastest);
  EXPECT_NEAR(after[2].angular_velocity[1], w2, 1e-4 * fastest);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-3);
}

/// With friction, and many rows in one system of both.
TEST(JointsContact, HasTheSameBitsForAnyNumberOfThreadsAndAfterARestart) {
  const auto scene = [] {
    Scene fine = struck_chain(4e-3);
    std::get<BlockMesh>(fine.bodies[1].mesh).elements = {40, 40, 2};
    std::get<BlockMesh>(fine.bodies[2].mesh).elements = {33, 33, 3};
    fine.contact_pairs[0].friction = fine.contact_pairs[0].static_friction = 0.2;
    return fine;
  };
  const auto hash_of = [](Solver<double>& solver) {
    run(solver);
    return state_hash(solver.model());
  };
  Solver<double> one(scene()), first(scene()), second(scene());
  const std::uint64_t expected = hash_of(one);
  EXPECT_GT(one.counts().pairs_max(), 1000);
  while (first.time() < 2e-3) first.step();
  const StateBytes state = saved(first);
  EXPECT_EQ(load(second, state), 0U);
  EXPECT_EQ(hash_of(second), expected);
  DefaultExecutionSpace::set_concurrency(2);
  Solver<double> two(scene());
  EXPECT_EQ(hash_of(two), expected);
  DefaultExecutionSpace::set_concurrency(1);
}

/// Three blocks that are locked to each other, met by one plate at once, are moved as one.
TEST(JointsContact, BodiesThatAreStruckTogetherAreNotStruckOneByOne) {
  std::vector<Body> bodies;
  for (int b = 0; b < 3; ++b) bodies.push_back(block("b" + std::to_string(b), {2, 2, 2}, 0.1, {0.2 * b, 0, 0}));
  bodies.push_back(block("plate", {7, 3, 1}, 0.1, {-0.05, -0.05, 0.201}, {0, 0, -speed}));
  Scene scene = struck(bodies,
                       {joint_of(JointKind::locking, "b0", "b1", {0.2, 0.1, 0.1}),
                        joint_of(JointKind::locking, "b1", "b2", {0.4, 0.1, 0.1})},
                       {5, 0, 0}, 4e-3);
  scene.contact_pairs.emplace_back().first.bodies = {"plate"};
  scene.contact_pairs.back().second.bodies = {"b0", "b1", "b2"};
  Solver<double> solver(scene);
  const double plate = solver.rigid().results()[3].mass, blocks = 3 * solver.rigid().results()[0].mass;
  run(solver);
  const auto after = solver.rigid().results();
  const double common = -speed * plate / (plate + blocks);
  for (std::size_t b = 0; b < 4; ++b) EXPECT_NEAR(after[b].velocity[2], common, 1e-3 * speed) << b;
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-3);
}

/// An elastic cube that rebounds from a hinged plate: nothing is created, and the hinge turns nothing about its axis.
TEST(JointsContact, AnElasticImpactKeepsMomentumAboutTheHingeAndEnergy) {
  Scene scene =
      struck({block("plate", {10, 4, 1}, 0.1, {0, -0.2, 0})},
             {joint_of(JointKind::revolute, "plate", ground, {0, 0, 0.05}, Point{0, 1, 0})}, {0.7, -0.1, 0.101}, 3e-3);
  scene.rigid_bodies.pop_back();
  scene.bodies.pop_back();
  const std::size_t cube = scene.bodies.size();
  scene.bodies.push_back(block("cube", {4, 4, 4}, 0.05, {0.7, -0.1, 0.101}, {0, 0, -speed}));
  const auto moment = [&](const Solver<double>& solver) {
    const Model<double>& model = solver.model();
    double sum = 0;
    for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
      const double *x = model.nodes.position_of(n), *v = model.nodes.velocity_of(n);
      sum += model.node_mass[n] * ((x[2] - 0.05) * v[0] - x[0] * v[2]);
    }
    return sum;
  };
  Solver<double> solver(scene);
  const double before = moment(solver), energy = kinetic_energy(solver);
  run(solver);
  EXPECT_NEAR(moment(solver), before, 1e-6 * before);
  EXPECT_LT(kinetic_energy(solver), energy);
  EXPECT_GT(solver.rigid().results()[0].angular_velocity[1], 0.1);
  EXPECT_GT(body_results(solver)[cube].velocity[2], -speed);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-3);
}

}  // namespace
}  // namespace pinball::joints_contact_test
