#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include <tests/support/impulse_system.hpp>

#include "impact_case.hpp"

/// Coulomb friction: the law itself on random rows, and sliding blocks.
namespace pinball::friction_test {
namespace {

using namespace test;

// ---- The law --------------------------------------------------------------------------------------------------------

/// Rows between random nodes in random directions; `held`: one of the nodes is, along y.
ImpulseSystem random_system(std::mt19937& random, std::size_t rows, double mu, bool held = true) {
  std::uniform_real_distribution<double> number(-1, 1);
  ImpulseSystem s;
  for (int n = 0; n < 8; ++n) {
    const Vec3<double> v{number(random), number(random), number(random)};
    s.add_node(v, 1.5 + number(random), n == 0 && held);
  }
  for (int i = 0; i < static_cast<int>(rows); ++i) {
    const Vec3<double> a{number(random), number(random), number(random)};
    s.add_row((1 / std::sqrt(dot(a, a))) * a, 0);
    for (int k = 0; k < 4; ++k) s.add_entry((i + k * (1 + i % 2)) % 8, k < 2 ? -0.5 : 0.5);
  }
  s.build(mu);
  return s;
}

TEST(Friction, IterationsFindImpulsesThatObeyCoulombsLaw) {
  std::mt19937 random(31);
  const double mu = 0.8;
  int sticking = 0, sliding = 0;
  for (int trial = 0; trial < 200; ++trial) {
    ImpulseSystem s = random_system(random, 1 + static_cast<std::size_t>(trial) % 5, mu);
    EXPECT_TRUE(s.solve().converged) << "trial " << trial;
    for (std::size_t i = 0; i < s.rows.size(); ++i) {
      const Vec3<double> a{s.rows.rows[i].direction[0], s.rows.rows[i].direction[1], s.rows.rows[i].direction[2]};
      const Vec3<double> drive = s.drive(i), rate = drive - dot(a, drive) * a, q_vector = s.friction(i);
      const double speed = std::sqrt(dot(rate, rate)), q = std::sqrt(dot(q_vector, q_vector));
      const double most = mu * s.impulse(i);
      ASSERT_LE(q, most + 1e-10);
      EXPECT_LT(dot(a, drive), 1e-8);
      if (most == 0) continue;
      EXPECT_GT(dot(a, drive), -1e-8) << "what pushes does not open";
      if (q < most - 1e-8) {
        EXPECT_LT(speed, 1e-8) << "what does not slide is at rest";
        ++sticking;
      } else {
        EXPECT_NEAR(dot(q_vector, rate), most * speed, 1e-8) << "against the sliding";
        ++sliding;
      }
    }
  }
  EXPECT_GT(sticking, 20);
  EXPECT_GT(sliding, 20);
}

TEST(Friction, KeepsMomentumAndTakesOutEnergy) {
  std::mt19937 random(32);
  for (int trial = 0; trial < 100; ++trial) {
    ImpulseSystem s = random_system(random, 4, 0.3, false);
    const Vec3<double> before = s.momentum();
    const double energy = s.kinetic_energy();
    s.solve();
    const Vec3<double> change = s.momentum() - before;
    EXPECT_LT(std::sqrt(dot(change, change)), 2e-13);
    EXPECT_LE(s.kinetic_energy(), energy + 1e-13);
  }
}

// ---- Sliding blocks -------------------------------------------------------------------------------------------------

constexpr double h = 0.05, weight = 1000;  ///< size of the elements [m]; load over mass [m/s^2]
constexpr double block_height = 2 * h, floor_height = 2 * h;
constexpr double ramp = 0.002;  ///< of the push [s]

/// A flat block, pressed down by a force in proportion to its mass, and pushed along x by `push` times that force.
Scene pressed_block(double speed, double push, double end) {
  Scene scene = scene_of({block("block", {4, 4, 2}, h, {0, 0, floor_height}, {speed, 0, 0})}, end);
  const double mass = 7850 * 16 * h * h * block_height;
  NodalLoad down, forward;
  down.nodes.body = forward.nodes.body = "block";
  down.force = {0, 0, -mass * weight};
  scene.loads = {down};
  if (push > 0) {  // after the block has come to rest: a local slip of a block that is hardly pressed would set it off
    scene.loads[0].table = {{0, 0.5 * ramp}, {0, 1}};
    forward.force = {push * mass * weight, 0, 0};
    forward.table = {{0.5 * ramp, 1.5 * ramp}, {0, 1}};
    scene.loads.push_back(forward);
  }
  return scene;
}

Scene on_a_wall(Scene scene, double friction) {
  RigidWall wall;
  wall.name = "floor";
  wall.plane = {{0, 0, floor_height}, {0, 0, 1}};
  wall.friction = friction;
  scene.rigid_walls = {wall};
  scene.contact.method = ContactMethod::none;
  return scene;
}

struct Floor {
  ContactMethod method;
  Enforcement enforcement;
};

/// On a floor with a mesh of its own, whose lower side is held.
Scene on_a_floor(Scene scene, const Floor& floor, double at_rest, double sliding) {
  scene.bodies.push_back(block("floor", {9, 6, 1}, 2.0 / 3 * 2 * h, {-h, -h, floor_height - 4.0 / 3 * h}));
  FixedConstraint held;
  held.nodes.body = "floor";
  held.nodes.plane = Plane{{0, 0, floor_height - 4.0 / 3 * h}, {0, 0, 1}};
  held.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.fixed_constraints = {held};
  scene.contact.method = floor.method;
  scene.contact.enforcement = floor.enforcement;
  scene.contact.gap = ContactGap::face;
  scene.contact.friction = sliding;
  scene.contact.static_friction = at_rest;
  return scene;
}

/// The block slows down by mu times its weight and stops after v^2 / (2 mu weight): exact for a rigid one. An elastic
/// one also swings up and down and shears as it stops, by 0.02 m/s here, however fast it was.
void expect_to_slow_down(const Scene& scene, double speed, double friction) {
  Solver<double> solver(scene);
  const double stop = speed / (friction * weight);
  double worst = 0, highest = 0;
  while (!solver.at_end()) {
    solver.step();
    const double expected = std::max(0.0, speed - friction * weight * solver.force_time());
    worst = std::max(worst, std::abs(velocity_of_body(solver, 0)[0] - expected));
    highest = std::max(highest, std::abs(velocity_of_body(solver, 0)[2]));
  }
  solver.finish();
  ASSERT_GT(solver.time(), 1.2 * stop);
  EXPECT_LT(worst, 0.01 * speed);
  const double way = position_of(solver, 0)[0];
  EXPECT_NEAR(way, 0.5 * speed * stop, 0.01 * 0.5 * speed * stop);
  EXPECT_LT(std::abs(solver.balance_error()), 0.01);
}

TEST(Friction, StopsABlockOnAWall) { expect_to_slow_down(on_a_wall(pressed_block(4, 0, 0.0165), 0.3), 4, 0.3); }

class FrictionOnAFloor : public testing::TestWithParam<Floor> {};
INSTANTIATE_TEST_SUITE_P(All, FrictionOnAFloor,
                         testing::Values(Floor{ContactMethod::pinball, Enforcement::lagrange},
                                         Floor{ContactMethod::pinball, Enforcement::projection},
                                         Floor{ContactMethod::slideline, Enforcement::lagrange},
                                         Floor{ContactMethod::slideline, Enforcement::projection}),
                         [](const auto& test) {
                           return std::string(test.param.method == ContactMethod::pinball ? "pinball_" : "slideline_") +
                                  enforcement_name(test.param.enforcement);
                         });

TEST_P(FrictionOnAFloor, StopsABlock) {
  expect_to_slow_down(on_a_floor(pressed_block(4, 0, 0.0165), GetParam(), 0.3, 0.3), 4, 0.3);
}

/// With coefficients of 0.5 at rest and 0.2 while sliding, which need all rows of a step to be solved together.
class StaticFriction : public testing::TestWithParam<ContactMethod> {
 protected:
  static Scene pushed(double push) {
    return on_a_floor(pressed_block(0, push, 0.006), {GetParam(), Enforcement::lagrange}, 0.5, 0.2);
  }
};
INSTANTIATE_TEST_SUITE_P(All, StaticFriction, testing::Values(ContactMethod::pinball, ContactMethod::slideline),
                         [](const auto& test) {
                           return test.param == ContactMethod::pinball ? "pinball" : "slideline";
                         });

TEST_P(StaticFriction, HoldsABlockThatIsPushedLess) {
  Solver<double> solver(pushed(0.3));
  run(solver);
  // Sliding it would have gone 0.8 mm; the elastic shear is below a micrometre. The push is well below 0.5, because it
  // also takes the load off the rear edge, which slides before the block does.
  EXPECT_LT(std::abs(position_of(solver, 0)[0]), 1e-5);
}

TEST_P(StaticFriction, LetsABlockGoThatIsPushedMore) {
  Solver<double> solver(pushed(0.6));
  while (solver.time() < 0.004) solver.step();
  const double time = solver.force_time(), speed = velocity_of_body(solver, 0)[0];
  run(solver);
  const double expected = (0.6 - 0.2) * weight * (solver.force_time() - time);
  EXPECT_NEAR(velocity_of_body(solver, 0)[0] - speed, expected, 0.02 * expected);
}

TEST(Friction, OnAWallKeepsWhatIsHeld) {  // a plane of symmetry through the block
  Scene scene = on_a_wall(pressed_block(4, 0, 0.0165), 0.3);
  scene.constraints.push_back({{0, 0, 0}, {0, 1, 0}, ""});
  scene.loads[0].force[1] = 1e4;
  expect_to_slow_down(scene, 4, 0.3);
}

}  // namespace
}  // namespace pinball::friction_test
