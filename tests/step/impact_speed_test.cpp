#include <gtest/gtest.h>

#include <cmath>

#include <solver/step/impact_speed.hpp>
#include <tests/support/solver_case.hpp>

namespace pinball {
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
}  // namespace pinball
