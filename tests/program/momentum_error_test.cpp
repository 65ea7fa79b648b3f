#include <gtest/gtest.h>

#include <cmath>

#include <solver/program/momentum_error.hpp>

namespace pinball::momentum_error_test {
namespace {

/// Mass 2 and energy 4: at most a momentum of 4. It changes by (1, 2, 2).
RunSummary summary() {
  RunSummary s;
  s.bodies.resize(2);
  for (BodyResult& body : s.bodies) body.mass_initial = 1;
  s.initial_total = 4;
  s.momentum_initial = {5, 0, -1};
  s.momentum_final = {6, 2, 1};
  return s;
}

TEST(MomentumError, IsTheChangeOverTheLargestMomentumOfTheEnergy) {
  EXPECT_DOUBLE_EQ(momentum_error({}, summary()).value(), 0.75);
}

TEST(MomentumError, LeavesOutDirectionsInWhichSomethingActs) {
  Scene scene;
  scene.constraints = {{{}, {0, 1, 0}, ""}, {{}, {0, -1, 0}, ""}};
  EXPECT_DOUBLE_EQ(momentum_error(scene, summary()).value(), std::sqrt(5.0) / 4);
  scene.rigid_walls.resize(1);
  scene.rigid_walls[0].plane.normal = {0, 0.6, 0.8};  // with the constraint: y and z
  EXPECT_DOUBLE_EQ(momentum_error(scene, summary()).value(), 0.25);
  scene.loads.resize(1);
  EXPECT_TRUE(momentum_error(scene, summary()).has_value());  // a load of no force
  scene.loads[0].force = {1e-3, 0, 0};
  EXPECT_FALSE(momentum_error(scene, summary()).has_value());
}

/// The forces of an equation add up to a multiple of the sum of its coefficients.
TEST(MomentumError, IsWhatEquationsKeep) {
  Scene scene;
  for (const double factor : {0.3, -0.1, -0.2}) scene.equation_terms.push_back({"even", {1, 0, 0}, factor, {}});
  EXPECT_DOUBLE_EQ(momentum_error(scene, summary()).value(), momentum_error({}, summary()).value());
  scene.equation_terms[0].factor = 0.4;
  Scene held;
  held.constraints.resize(1);
  held.constraints[0].normal = {1, 0, 0};
  EXPECT_DOUBLE_EQ(momentum_error(scene, summary()).value(), momentum_error(held, summary()).value());
  EXPECT_NE(momentum_error(scene, summary()).value(), momentum_error({}, summary()).value());
}

TEST(MomentumError, IsNotKnownWhereEverythingIsActedOn) {
  const auto with = [](const auto& change) {
    Scene scene;
    change(scene);
    return momentum_error(scene, summary());
  };
  EXPECT_FALSE(with([](Scene& s) { s.damping.mass = 1; }));
  EXPECT_FALSE(with([](Scene& s) { s.prescribed_velocities.resize(1); }));
  EXPECT_FALSE(with([](Scene& s) {
    s.fixed_constraints.resize(1);
    s.fixed_constraints[0].frame = Frame::cylindrical;
  }));
  EXPECT_TRUE(with([](Scene& s) {
    s.prescribed_velocities.resize(1);
    s.prescribed_velocities[0].direction = Point{0, 0, 1};
    s.fixed_constraints.resize(1);
    s.fixed_constraints[0].directions = {{1, 0, 0}};
  }));
  RunSummary at_rest = summary();
  at_rest.initial_total = 0;
  EXPECT_FALSE(momentum_error({}, at_rest));
}

}  // namespace
}  // namespace pinball::momentum_error_test
