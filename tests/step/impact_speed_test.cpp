#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <solver/step/impact_speed.hpp>
#include <tests/support/solver_case.hpp>

namespace pinball::impact_speed_test {
namespace {

using namespace test;

const double radius = std::cbrt(3 / (4 * M_PI));  // of a cube of edge 1

double longest(const Scene& scene) { return longest_contact_step(build_model<double>(scene)); }

TEST(ImpactSpeed, OfTwoBodiesIsRelative) {
  const auto two = [](const Point& a, const Point& b) {
    return scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}, a), block("b", {2, 2, 2}, 1, {0, 0, 4}, b)}, 1);
  };
  EXPECT_NEAR(longest(two({0, 0, 50}, {0, 0, -50})), radius / 100, 1e-12);
  EXPECT_NEAR(longest(two({3, 0, 5e3}, {0, 4, 5e3})), radius / 5, 1e-12);
  EXPECT_TRUE(std::isinf(longest(two({7, 7, 7}, {7, 7, 7}))));
  EXPECT_TRUE(std::isinf(longest(scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}, {0, 0, 50})}, 1))));
}

/// In all directions, the slower pairs before the faster ones and after them.
TEST(ImpactSpeed, IsThatOfTheFastestOfAllPairs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-10, 10);
  for (int sample = 0; sample < 60; ++sample) {
    std::vector<Body> bodies;
    for (int b = 0; b < 5; ++b) {
      Point v{};
      for (std::size_t k = 0; k < 3; ++k) v[k] = sample % 4 == 3 || static_cast<int>(k) == sample % 4 ? any(random) : 0;
      bodies.push_back(block("b" + std::to_string(b), {1, 1, 1}, 1, {3.0 * b, 0, 0}, v));
    }
    double speed = 0;
    for (const Body& a : bodies) {
      for (const Body& b : bodies) {
        speed = std::max(speed, std::hypot(a.velocity[0] - b.velocity[0], a.velocity[1] - b.velocity[1],
                                           a.velocity[2] - b.velocity[2]));
      }
    }
    EXPECT_NEAR(longest(scene_of(bodies, 1)), radius / speed, 1e-12) << sample;
  }
}

/// By the nodes of a body that spins, each in turn the fastest, and by the smallest element, each in turn.
TEST(ImpactSpeed, CountsEveryNodeAndEveryElement) {
  for (int turn = 0; turn < 4; ++turn) {
    const double sign = turn % 2 == 0 ? 1 : -1;
    Scene scene = scene_of({block("a", {1, 1, 1}, 1, {-0.5, -0.5, 0}), block("b", {1, 1, 1}, 1, {5, 0, 0})}, 1);
    scene.bodies[0].velocity = {turn < 2 ? 10 * sign : 0, turn < 2 ? 0 : 10 * sign, 0};
    scene.bodies[0].velocity_gradient[turn < 2 ? 0 : 1][0] = 4;  // by a half to each side of its middle
    scene.bodies[0].velocity_gradient[turn < 2 ? 0 : 1][1] = 2;
    scene.bodies[0].velocity_gradient[turn < 2 ? 0 : 1][2] = 1;
    double speed = 0;
    const Model<double> model = build_model<double>(scene);
    for (std::size_t n = 0; n < 8; ++n) {
      const double* v = model.nodes.velocity_of(model.node_of_scene_node[n]);
      speed = std::max(speed, std::hypot(v[0], v[1], v[2]));
    }
    EXPECT_NEAR(speed, 13.5, 1e-12);
    EXPECT_NEAR(longest(scene), radius / speed, 1e-12) << turn;
  }
  for (const std::size_t small : {0, 1}) {
    Scene scene = scene_of({block("a", {1, 1, 1}, 1, {0, 0, 0}, {0, 0, 50}), block("b", {1, 1, 1}, 1, {5, 0, 0})}, 1);
    scene.bodies[small].mesh = BlockMesh{{0.5, 0.5, 0.5}, {1, 1, 1}};
    EXPECT_NEAR(longest(scene), radius / 2 / 50, 1e-12) << small;
  }
}

/// A vector turned about an axis of unit length, as Rodrigues has it.
Point turned(const Point& v, const Point& axis, double angle) {
  const Point across = cross(axis, v);
  Point there;
  for (std::size_t k = 0; k < 3; ++k)
    there[k] = std::cos(angle) * v[k] + std::sin(angle) * across[k] + (1 - std::cos(angle)) * dot(axis, v) * axis[k];
  return there;
}

/// Bodies that spin, in a scene that is turned as a whole.
TEST(ImpactSpeed, IsTheSameHoweverTheAxesLie) {
  const Point axis{0.6, -0.8, 0};  // at right angles to z, as the shortest rotation of a body's axis
  const auto scene = [&](double angle) {
    const auto turn = [&](const Point& v) { return turned(v, axis, angle); };
    Scene all = scene_of({block("a", {3, 2, 1}, 1, turn({0, 0, 0}), turn({30, 5, -8})),
                          block("b", {2, 2, 2}, 1, turn({0, 0, 4}), turn({-10, 7, 40}))},
                         1);
    all.bodies[0].angular_velocity = turn({20, -9, 13});
    all.bodies[1].angular_velocity = turn({-3, 17, 5});
    for (Body& body : all.bodies) body.axis = turn({0, 0, 1});
    return longest(all);
  };
  const double as_it_is = scene(0);
  for (const double angle : {0.3, 0.8, 1.5, 2.9}) EXPECT_NEAR(scene(angle), as_it_is, 1e-12 * as_it_is) << angle;
}

TEST(ImpactSpeed, FastBodiesDoNotJumpOverEachOther) {
  // At ten times the wave speed a stable step would be 5.7 elements long; the bodies are 4 thick.
  const double speed = 10 * 6000;
  for (const ContactMethod method : {ContactMethod::pinball, ContactMethod::slideline}) {
    Scene scene = scene_of({block("a", {4, 4, 4}, 1, {0, 0, 0}, {0, 0, speed / 2}),
                            block("b", {4, 4, 4}, 1, {0, 0, 7.3}, {0, 0, -speed / 2})},
                           9 / speed);
    scene.contact.method = method;
    scene.guard.energy_error = 1e30;
    Solver<double> solver(scene);
    std::int64_t pairs = 0;
    try {
      while (!solver.at_end()) {
        solver.step();
        pairs = std::max(pairs, solver.counts().pairs());
      }
    } catch (const RunError&) {  // no elastic body bears this
    }
    EXPECT_GT(pairs, 0);
  }
}

}  // namespace
}  // namespace pinball::impact_speed_test
