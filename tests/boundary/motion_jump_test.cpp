#include <gtest/gtest.h>

#include <solver/boundary/prescribed_motions.hpp>
#include <solver/model/model.hpp>
#include <solver/step/solver.hpp>
#include <tests/support/solver_case.hpp>

/// Velocities that nodes are given at once: how large they are, and that steps are short enough for them beforehand.
namespace pinball::motion_jump_test {
namespace {

using namespace test;

/// A column whose top moves down, and whose foot is held.
Scene driven(double speed, const TimeTable& table, const TimeSpan& when = {}) {
  Scene scene = scene_of({block("b", {1, 1, 4}, 5e-3, {0, 0, 0})}, 4e-5, false);
  scene.materials = {plastic_material("steel", 4e8, 0)};
  scene.element = ElementSettings{};
  FixedConstraint foot;
  foot.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  foot.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  scene.fixed_constraints = {foot};
  PrescribedVelocity top;
  top.direction = Point{0, 0, 1};
  top.velocity = {0, 0, -speed};
  top.table = table;
  top.when = when;
  top.nodes.plane = Plane{{0, 0, 0.02}, {0, 0, 1}};
  scene.prescribed_velocities = {top};
  return scene;
}

PrescribedMotions motions_of(const Scene& scene) { return PrescribedMotions(build_model<double>(scene)); }

TEST(MotionJump, AtTheStartIsTheDifferenceToWhatNodesHave) {
  EXPECT_DOUBLE_EQ(motions_of(driven(200, {})).leap_at_start(), 200);
  Scene scene = driven(200, {});
  scene.bodies[0].velocity = {0, 0, -150};
  EXPECT_DOUBLE_EQ(motions_of(scene).leap_at_start(), 150) << "of the foot, which is held; the top leaps by 50";
  scene.fixed_constraints.clear();
  EXPECT_DOUBLE_EQ(motions_of(scene).leap_at_start(), 50);
}

/// Of all its directions together, however the axes lie.
TEST(MotionJump, AtTheStartIsThatOfTheWholeVelocity) {
  Scene scene = driven(200, {});
  scene.prescribed_velocities[0].direction.reset();
  scene.prescribed_velocities[0].velocity = {120, 90, -200};
  EXPECT_DOUBLE_EQ(motions_of(scene).leap_at_start(), 250);
  scene.prescribed_velocities[0].velocity = {0, 0, 0};
  scene.bodies[0].velocity = {30, 0, 40};
  EXPECT_DOUBLE_EQ(motions_of(scene).leap_at_start(), 50);
}

TEST(MotionJump, IsThatBetweenTwoSteps) {
  const StepLengths step{1e-6, 1e-6};
  const PrescribedMotions ramp = motions_of(driven(200, TimeTable{{0, 1e-4}, {0, 1}}));
  EXPECT_EQ(ramp.leap_at_start(), 0);
  EXPECT_NEAR(ramp.leap(2e-5, 2e-5, step), 2, 1e-9);
  EXPECT_NEAR(ramp.leap(2e-5, 2.9e-5, step), 20, 1e-9);
  const PrescribedMotions sudden = motions_of(driven(200, TimeTable{{0, 2e-5, 2.00001e-5}, {0, 0, 1}}));
  EXPECT_EQ(sudden.leap(1.8e-5, 1.8e-5, step), 0);
  EXPECT_NEAR(sudden.leap(1.8e-5, 2.1e-5, step), 200, 1e-6);
  EXPECT_NEAR(sudden.leap(2.2e-5, 2.2e-5, step), 0, 1e-6) << "it is over";
  const PrescribedMotions later = motions_of(driven(200, {}, {5e-5, 8e-5}));
  EXPECT_EQ(later.leap_at_start(), 0);
  EXPECT_EQ(later.leap(3e-5, 4e-5, step), 0);
  EXPECT_EQ(later.leap(4.95e-5, 5.1e-5, step), 0) << "what begins leaps by what nodes do not have";
  Scene scene = driven(200, {}, {5e-5, 8e-5});
  const auto leap_of = [&scene] {
    const Model<double> model = build_model<double>(scene);
    return PrescribedMotions(model).leap_of(model, held_nodes(model, 5.1e-5), 5.1e-5, {1e-6, 1e-6});
  };
  EXPECT_NEAR(leap_of(), 200, 1e-9);
  scene.bodies[0].velocity = {0, 0, -150};
  scene.fixed_constraints.clear();
  EXPECT_NEAR(leap_of(), 50, 1e-9);
  EXPECT_NEAR(later.leap(6e-5, 7e-5, step), 0, 1e-9);
  EXPECT_EQ(later.leap(7.95e-5, 8.1e-5, step), 0) << "what ends lets go, and gives no velocity";
}

/// The first step was made as if nothing would happen, the next was shorter by a tenth: energy came of it.
TEST(MotionJump, TakesNoEnergyOfTheFirstSteps) {
  for (const double start : {0.0, 2e-5}) {
    Solver<double> solver(driven(200, {}, {start, 1}));
    run(solver);
    EXPECT_LT(solver.ledger().balance_error_max(), 2e-3) << start;
    EXPECT_GT(solver.impact_speed(), start > 0 ? -1.0 : 199.0);
  }
}

}  // namespace
}  // namespace pinball::motion_jump_test
