#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <solver/scene_rules.hpp>

#include "joint_case.hpp"

/// Several jointed bodies, against integrations and kinematics of their own.
namespace pinball::joint_mechanisms_test {
namespace {

using namespace test;

/// Two bars in the plane y = 0, by their angles from below: Lagrange's equations.
struct DoublePendulum {
  double mass_1, mass_2, inertia_1, inertia_2;  ///< inertia about the centres [mass length^2]
  double arm_1, arm_2, length;                  ///< of the centres from the joints above them; between the joints

  using State = std::array<double, 4>;  ///< two angles and their rates

  State rates(const State& s) const {
    const double apart = s[0] - s[1], m12 = mass_2 * length * arm_2 * std::cos(apart),
                 turning = mass_2 * length * arm_2 * std::sin(apart);
    const double m11 = inertia_1 + mass_1 * arm_1 * arm_1 + mass_2 * length * length,
                 m22 = inertia_2 + mass_2 * arm_2 * arm_2;
    const double f1 = -turning * s[3] * s[3] - (mass_1 * arm_1 + mass_2 * length) * gravity * std::sin(s[0]);
    const double f2 = turning * s[2] * s[2] - mass_2 * arm_2 * gravity * std::sin(s[1]);
    const double determinant = m11 * m22 - m12 * m12;
    return {s[2], s[3], (m22 * f1 - m12 * f2) / determinant, (m11 * f2 - m12 * f1) / determinant};
  }
  /// Runge and Kutta's classical method.
  State after(State s, double end, int steps) const {
    const double h = end / steps;
    const auto moved = [](const State& from, const State& by, double time) {
      State to;
      for (std::size_t k = 0; k < 4; ++k) to[k] = from[k] + time * by[k];
      return to;
    };
    for (int step = 0; step < steps; ++step) {
      const State a = rates(s), b = rates(moved(s, a, h / 2)), c = rates(moved(s, b, h / 2)), d = rates(moved(s, c, h));
      for (std::size_t k = 0; k < 4; ++k) s[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return s;
  }
};

/// Bars of lengths 1 and 0.8 that fall from the horizontal and swing through.
Scene double_pendulum(double end) {
  return mechanism({block("upper", {10, 1, 1}, 0.1, {0, 0, 0}), block("lower", {8, 2, 1}, 0.1, {1, 0, 0})},
                   {joint_of(JointKind::revolute, "upper", ground, hinge, Point{0, 1, 0}),
                    joint_of(JointKind::revolute, "lower", "upper", {1, 0.05, 0.05}, Point{0, 1, 0})},
                   end);
}

TEST(JointMechanisms, ADoublePendulumSwingsAsIntegratedByItself) {
  for (const double end : {1.0, 2.0, 3.0}) {
    Solver<double> solver(double_pendulum(end));
    const RigidBodyResult upper = solver.rigid().results()[0], lower = solver.rigid().results()[1];
    const DoublePendulum own{upper.mass,          lower.mass, upper.inertia[1][1], lower.inertia[1][1], upper.centre[0],
                             lower.centre[0] - 1, 1};
    const DoublePendulum::State expected = own.after({M_PI / 2, M_PI / 2, 0, 0}, end, 20000);
    run(solver);
    const auto found = solver.rigid().results();
    EXPECT_NEAR(found[0].centre[0], own.arm_1 * std::sin(expected[0]), 2e-4) << end;
    EXPECT_NEAR(found[1].centre[0], std::sin(expected[0]) + own.arm_2 * std::sin(expected[1]), 2e-4) << end;
    EXPECT_NEAR(found[1].centre[2] - hinge[2], -std::cos(expected[0]) - own.arm_2 * std::cos(expected[1]), 2e-4) << end;
    EXPECT_LT(largest_opening(solver), 1e-14);
    EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-4);
  }
}

/// A crank of 0.2 that turns as given, a rod of 1 and a slider, which keep several directions twice. With the angle p
/// of the crank the slider is at x = r cos p + sqrt(l^2 - r^2 sin^2 p).
Scene slider_crank(double end, double speed) {
  Scene scene = mechanism({block("crank", {2, 1, 1}, 0.1, {0, 0, 0}), block("rod", {10, 1, 1}, 0.1, {0.2, 0, 0}),
                           block("slider", {1, 1, 1}, 0.1, {1.2, 0, 0})},
                          {joint_of(JointKind::revolute, "crank", ground, hinge, Point{0, 1, 0}),
                           joint_of(JointKind::revolute, "rod", "crank", {0.2, 0.05, 0.05}, Point{0, 1, 0}),
                           joint_of(JointKind::revolute, "slider", "rod", {1.2, 0.05, 0.05}, Point{0, 1, 0}),
                           joint_of(JointKind::translational, "slider", ground, {1.2, 0.05, 0.05}, Point{1, 0, 0})},
                          end);
  scene.gravities.clear();
  RigidMotion turn;
  turn.rigid_body = "crank";
  turn.axis = Point{0, -1, 0};
  turn.angular_speed = speed;
  scene.rigid_motions = {turn};
  return scene;
}

TEST(JointMechanisms, ASliderCrankFollowsItsKinematics) {
  const double speed = 3, r = 0.2, l = 1;
  for (const double end : {0.3, 1.0, 2.5}) {
    Solver<double> solver(slider_crank(end, speed));
    const double centre = solver.rigid().results()[2].centre[0] - 1.2;
    run(solver);
    const RigidBodyResult slider = solver.rigid().results()[2];
    const double p = speed * end, root = std::sqrt(l * l - r * r * std::sin(p) * std::sin(p));
    const double v = -speed * r * std::sin(p) * (1 + r * std::cos(p) / root);
    EXPECT_NEAR(slider.centre[0] - centre, r * std::cos(p) + root, 1e-12) << end;
    EXPECT_NEAR(slider.centre[2], 0.05, 1e-12);
    EXPECT_NEAR(slider.velocity[0], v, 1e-12) << end;
    EXPECT_LT(largest_opening(solver), 1e-13);
    EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-4);
  }
}

/// Cardan: of shafts at an angle b to each other that turn by p and q. The axis of the cross in the first, across the
/// plane of both at the start, is (0, -sin p, cos p) then, that in the second (-sin b cos q, cos b cos q, sin q). They
/// stay at right angles: tan q = tan p cos b.
TEST(JointMechanisms, AUniversalJointTurnsAsCardanSays) {
  const double b = M_PI / 6, speed = 2, end = 0.6;
  const Point second{std::cos(b), std::sin(b), 0};
  Scene scene = mechanism({block("in", {4, 1, 1}, 0.1, {-0.4, -0.05, -0.05}), block("out", {4, 1, 1}, 0.1, {0, 0, 0})},
                          {joint_of(JointKind::revolute, "in", ground, {-0.4, 0, 0}, Point{1, 0, 0}),
                           joint_of(JointKind::cylindrical, "out", ground, {0, 0, 0}, second),
                           joint_of(JointKind::universal, "in", "out", {0, 0, 0}, Point{0, 0, 1})},
                          end);
  scene.joints[2].second_axis = Point{-std::sin(b), std::cos(b), 0};
  scene.gravities.clear();
  scene.rigid_motions.resize(1);
  scene.rigid_motions[0].rigid_body = "in";
  scene.rigid_motions[0].axis = Point{1, 0, 0};
  scene.rigid_motions[0].angular_speed = speed;
  Solver<double> solver(checked_scene(scene));
  const Point arm = solver.rigid().results()[1].centre;
  run(solver);
  const Point across = solver.rigid().results()[1].centre;
  // The angle that the centre has turned about the second shaft.
  const auto off = [&](const Point& p) {
    Point q = p;
    for (std::size_t k = 0; k < 3; ++k) q[k] -= dot(p, second) * second[k];
    return q;
  };
  const double q = std::atan2(dot(second, cross(off(arm), off(across))), dot(off(arm), off(across)));
  const double p = speed * end;
  EXPECT_NEAR(std::tan(q), std::tan(p) * std::cos(b), 1e-12);
  EXPECT_LT(largest_opening(solver), 1e-13);
}

/// Four bars of a parallelogram that hangs and swings: the coupler stays as it lies.
TEST(JointMechanisms, AParallelogramCarriesItsCouplerAlong) {
  const Point y{0, 1, 0};
  Scene scene =
      mechanism({block("left", {1, 1, 5}, 0.1, {-0.05, 0, -0.5}), block("right", {1, 1, 5}, 0.1, {0.95, 0, -0.5}),
                 block("coupler", {10, 1, 1}, 0.1, {0, 0.2, -0.55})},
                {joint_of(JointKind::revolute, "left", ground, {0, 0.05, 0}, y),
                 joint_of(JointKind::revolute, "right", ground, {1, 0.05, 0}, y),
                 joint_of(JointKind::revolute, "coupler", "left", {0, 0.15, -0.5}, y),
                 joint_of(JointKind::revolute, "coupler", "right", {1, 0.15, -0.5}, y)},
                2);
  scene.gravities[0].acceleration = {8, 0, -9.81};
  Solver<double> solver(scene);
  double turned = 0, fastest = 0;
  run_to_end(solver, [&] {
    turned = std::max(turned, norm(solver.rigid().results()[2].angular_velocity));
    fastest = std::max(fastest, norm(solver.rigid().results()[0].angular_velocity));
  });
  EXPECT_GT(fastest, 2);
  EXPECT_LT(turned, 1e-10);
  EXPECT_LT(largest_opening(solver), 1e-13);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-4);
}

}  // namespace
}  // namespace pinball::joint_mechanisms_test
