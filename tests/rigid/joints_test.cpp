#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <solver/scene_rules.hpp>
#include <tests/support/saved_state.hpp>

#include "joint_case.hpp"

/// Joints of rigid bodies against closed forms, and what they keep.
namespace pinball::joints_test {
namespace {

using namespace test;
using testing::HasSubstr;

/// What a step that turns by a hundredth leaves of energies and speeds, which errs by its square.
constexpr double of_step = 1e-4;

/// Falls from the horizontal: T = 4 K(sin(theta_0/2)) sqrt(I/(m g d)), and below the hinge w^2 = 2 m g d/I.
TEST(Joints, APendulumHasTheLargePeriodOfItsAmplitude) {
  Solver<double> first(pendulum(1));
  const RigidBodyResult bar = first.rigid().results()[0];
  const double d = bar.centre[0], inertia = bar.inertia[1][1] + bar.mass * d * d;
  const double quarter = std::comp_ellint_1(std::sin(M_PI / 4)) * std::sqrt(inertia / (bar.mass * gravity * d));
  const double speed = std::sqrt(2 * bar.mass * gravity * d / inertia);
  for (const JointKind kind : {JointKind::revolute, JointKind::spherical, JointKind::cylindrical}) {
    Solver<double> solver(pendulum(21 * quarter, kind));
    run(solver);
    const RigidBodyResult now = solver.rigid().results()[0];
    EXPECT_NEAR(now.centre[0], 0, 5e-4 * d);
    EXPECT_NEAR(now.centre[2] - hinge[2], -d, 1e-6 * d);
    EXPECT_NEAR(std::abs(now.angular_velocity[1]), speed, of_step * speed);
    const JointResult joint = solver.rigid().joint_results()[0];
    EXPECT_NEAR(joint.force[2], bar.mass * (gravity + d * speed * speed), of_step * bar.mass * gravity);
    EXPECT_NEAR(joint.moment[1], 0, 1e-9);
    EXPECT_LT(joint.opening, 1e-14);
    EXPECT_LT(solver.ledger().balance_error_in_motion_max(), of_step);
    EXPECT_LT(std::abs(joint.work), of_step * bar.mass * gravity * d);
  }
}

/// A body that a step turns by half as much errs by a quarter.
TEST(Joints, AreOfSecondOrder) {
  const auto place = [](double size) {
    Scene scene = pendulum(1.5);
    scene.bodies.push_back(block("clock", {1, 1, 1}, size, {0, 100, 0}));  // its elements limit the step
    Solver<double> solver(scene);
    double work = 0;
    run_to_end(solver, [&] { work = std::max(work, std::abs(solver.rigid().joint_results()[0].work)); });
    return std::pair(solver.rigid().results()[0].centre[0], work);
  };
  const auto coarse = place(4), half = place(2), quarter = place(1), fine = place(0.25);
  EXPECT_NEAR((coarse.first - fine.first) / (half.first - fine.first), 4, 0.4);
  EXPECT_NEAR((half.first - fine.first) / (quarter.first - fine.first), 4, 0.4);
  EXPECT_NEAR(coarse.second / half.second, 4, 0.4);
}

/// Two asymmetric blocks that hang together at a corner, and whirl about it.
Scene whirling(double end) {
  Scene scene = mechanism({block("a", {3, 2, 1}, 0.1, {0, 0, 0}), block("b", {2, 4, 1}, 0.1, {0.3, 0.2, 0.1})},
                          {joint_of(JointKind::spherical, "a", "b", {0.3, 0.2, 0.1})}, end);
  scene.gravities.clear();
  const std::array<Point, 2> arms{Point{-0.15, -0.1, -0.05}, {0.1, 0.2, 0.05}};
  const std::array<Point, 2> spins{Point{1, 2, 0.5}, {-2, 1, 3}};
  for (std::size_t b = 0; b < 2; ++b) {
    const Point v = cross(spins[b], arms[b]);
    scene.rigid_bodies[b].velocity = Point{v[0] + 1, v[1], v[2] - 2};
    scene.rigid_bodies[b].angular_velocity = spins[b];
  }
  return scene;
}

TEST(Joints, LeaveBothMomentaAndTheEnergyOfAPair) {
  Solver<double> solver(whirling(20));
  const Point origin{};
  const Point before = angular_momentum_about(origin, solver.rigid().results()), momentum_before = solver.momentum();
  run(solver);
  const Point after = angular_momentum_about(origin, solver.rigid().results()), momentum_after = solver.momentum();
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(after[k], before[k], 1e-10 * norm(before));
    EXPECT_NEAR(momentum_after[k], momentum_before[k], 1e-11 * norm(momentum_before));
  }
  EXPECT_GT(solver.steps(), 5000);
  EXPECT_LT(largest_opening(solver), 1e-12) << "which is round-off of places that they have flown to";
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), of_step);
}

/// Along an axis that leans by 30 degrees, while it turns: both go on as if the other were not.
TEST(Joints, ACylindricalOneSlidesAndTurns) {
  const Point axis{std::sin(M_PI / 6), 0, std::cos(M_PI / 6)};
  Scene scene = mechanism({block("sleeve", {2, 2, 2}, 0.1, {-0.1, -0.1, -0.1})},
                          {joint_of(JointKind::cylindrical, "sleeve", ground, {0, 0, 0}, axis)}, 1);
  scene.rigid_bodies[0].angular_velocity = Point{3 * axis[0], 0, 3 * axis[2]};
  Solver<double> solver(scene);
  run(solver);
  const RigidBodyResult sleeve = solver.rigid().results()[0];
  const double slid = -0.5 * gravity * axis[2];
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(sleeve.centre[k], slid * axis[k], 1e-12);
    EXPECT_NEAR(sleeve.velocity[k], 2 * slid * axis[k], 1e-12);
    EXPECT_NEAR(sleeve.angular_velocity[k], 3 * axis[k], 1e-12);
  }
}

/// As if they were one body: the same top, of one rigid body and of two.
TEST(Joints, ALockingOneMakesOneBodyOfTwo) {
  const std::vector<Body> bodies{block("a", {3, 2, 1}, 0.1, {0, 0, 0}), block("b", {2, 1, 3}, 0.1, {0.3, 0, 0})};
  Scene two = mechanism(bodies, {joint_of(JointKind::locking, "a", "b", {0.3, 0.1, 0.1})}, 4);
  Scene one = two;
  one.joints.clear();
  one.rigid_bodies = {rigid("a")};
  one.rigid_bodies[0].bodies = {"a", "b"};
  for (Scene* scene : {&one, &two}) {
    scene->gravities.clear();
    InitialVelocity all;
    all.nodes.box = Box{{-1, -1, -1}, {1, 1, 1}};
    all.angular_velocity = {1, 5, 0.3};
    scene->initial_velocities = {all};
  }
  Solver<double> jointed(two), whole(one);
  run(jointed);
  run(whole);
  const Point expected = whole.rigid().results()[0].angular_velocity;
  for (const RigidBodyResult& body : jointed.rigid().results()) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(body.angular_velocity[k], expected[k], 1e-4 * norm(expected));
  }
  EXPECT_LT(largest_opening(jointed), 1e-14);
}

TEST(Joints, ThatKeepTheSameTwiceAreAsOne) {
  Scene twice = pendulum(2);
  twice.joints.push_back(joint_of(JointKind::cylindrical, "bar", ground, {0, 0.5, 0.05}, Point{0, 1, 0}));
  twice.joints.push_back(joint_of(JointKind::revolute, ground, "bar", {0, 0.07, 0.05}, Point{0, -1, 0}));
  Solver<double> once(pendulum(2)), solver(checked_scene(twice));
  run(once);
  run(solver);
  const RigidBodyResult expected = once.rigid().results()[0], found = solver.rigid().results()[0];
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.centre[k], expected.centre[k], 1e-10);
    EXPECT_NEAR(found.angular_velocity[k], expected.angular_velocity[k], 1e-9);
  }
  EXPECT_LT(largest_opening(solver), 1e-14);
}

/// Gravity works on what places are rounded by, to which a joint keeps them: that is no energy in motion.
TEST(Joints, LetWhatTheyHoldRestWithoutAnAlarm) {
  for (const Point& corner : {Point{0, 0, 0}, Point{10, 5, 3}}) {
    const Point place{corner[0] + 0.1, corner[1] + 0.2, corner[2] + 0.3};
    Scene scene =
        mechanism({block("a", {3, 2, 1}, 0.1, corner)}, {joint_of(JointKind::locking, "a", ground, place)}, 0.05);
    scene.gravities = {{.acceleration = {1, 0.5, -2}}};
    Solver<double> solver(scene);
    run(solver);
    EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 0.01);
  }
}

/// A body that is held about some directions slides along the axis of its joint, or not at all: what rounding leaves of
/// the rows that the hold keeps moves nothing.
TEST(Joints, ThatKeepWhatIsHeldAnywayAreAsOne) {
  const std::vector<std::vector<Point>> held{{{0, 1, 0}}, {{1, 0, 0}}, {{0.6, 0.8, 0}}, {{0, 0, 1}, {0.8, -0.6, 0}}};
  for (const JointKind kind : {JointKind::translational, JointKind::locking}) {
    for (const Point& axis : {Point{0, 1, 0}, Point{0.6, 0.8, 0}, Point{5, 8, 6}}) {
      for (const std::vector<Point>& about : held) {
        const bool slides = kind == JointKind::translational;
        const std::optional<Point> of = slides ? std::optional(axis) : std::nullopt;
        Scene scene = mechanism({block("a", {3, 2, 1}, 0.1, {0, 0, 0})},
                                {joint_of(kind, "a", ground, {0.1, 0.2, 0.3}, of)}, 0.05);
        scene.gravities = {{.acceleration = {1, 0.5, -2}}};
        scene.rigid_bodies[0].held_rotations = about;
        Solver<double> solver(checked_scene(scene));
        const Point start = solver.rigid().results()[0].centre;
        run(solver);
        const RigidBodyResult found = solver.rigid().results()[0];
        const Point pulls = scene.gravities[0].acceleration;
        const double along = slides ? dot(pulls, axis) / dot(axis, axis) : 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(found.velocity[k], along * axis[k] * 0.05, 1e-12);
          EXPECT_NEAR(found.centre[k] - start[k], along * axis[k] * 0.00125, 1e-13);
          EXPECT_NEAR(found.angular_velocity[k], 0, 1e-12);
        }
        EXPECT_LT(largest_opening(solver), 1e-14);
      }
    }
  }
}

/// A second axis that is off by rounding of what was given: the body still turns about the first.
TEST(Joints, OnOneAxisMayBeGivenToSomeDigits) {
  Scene twice = pendulum(2);
  twice.joints.push_back(joint_of(JointKind::revolute, "bar", ground, {1e-7, 1, 0.05}, Point{1e-7, 1, 0}));
  Solver<double> once(pendulum(2)), solver(checked_scene(twice));
  run(once);
  run(solver);
  EXPECT_NEAR(solver.rigid().results()[0].centre[2], once.rigid().results()[0].centre[2], 1e-8);
  EXPECT_LT(largest_opening(solver), 1e-8);
}

TEST(Joints, GoOnWithTheSameBitsAfterARestart) {
  const auto hash_of = [](Solver<double>& solver) {
    run(solver);
    return state_hash(solver.model());
  };
  Solver<double> one(whirling(1)), first(whirling(1)), second(whirling(1));
  const std::uint64_t expected = hash_of(one);
  while (first.time() < 0.5) first.step();
  const StateBytes state = saved(first);
  EXPECT_EQ(load(second, state), 0U);
  EXPECT_EQ(second.rigid().joint_results()[0].force, first.rigid().joint_results()[0].force);
  EXPECT_EQ(hash_of(second), expected);
  EXPECT_EQ(second.rigid().joint_results()[0].work, one.rigid().joint_results()[0].work);
}

TEST(Joints, AreOfSinglePrecisionToo) {
  Solver<float> single(pendulum(1));
  Solver<double> twice_as_long(pendulum(1));
  run(single);
  run(twice_as_long);
  EXPECT_NEAR(single.rigid().results()[0].centre[2], twice_as_long.rigid().results()[0].centre[2], 1e-5);
}

std::string refused(const Scene& scene) {
  return error_of([&] {
    Solver<double> solver{checked_scene(scene)};
    run(solver);
  });
}

TEST(Joints, ThatCannotBeAreRefused) {
  const auto with = [](const auto& change) {
    Scene scene = pendulum(0.01);
    scene.bodies.push_back(block("soft", {1, 1, 1}, 0.1, {5, 0, 0}));
    change(scene, scene.joints[0]);
    return refused(scene);
  };
  EXPECT_EQ(with([](Scene&, Joint&) {}), no_error);
  EXPECT_THAT(with([](Scene&, Joint& j) { j.bodies = {"bar"}; }), HasSubstr("expected two rigid bodies, or one and"));
  EXPECT_THAT(with([](Scene&, Joint& j) { j.bodies = {"bar", "bar"}; }), HasSubstr("got one twice"));
  EXPECT_THAT(with([](Scene&, Joint& j) { j.bodies = {"bar", "soft"}; }), HasSubstr("a body that is no rigid one"));
  EXPECT_THAT(with([](Scene&, Joint& j) { j.bodies = {"bar", "bra"}; }), HasSubstr("expected names of [[rigid_body]]"));
  EXPECT_THAT(with([](Scene& s, Joint& j) {
                s.rigid_bodies[0].name = "ground";
                j.bodies = {"ground", "bar"};
              }),
              HasSubstr("named \"ground\""));
  EXPECT_THAT(with([](Scene&, Joint& j) { j.point.reset(); }), HasSubstr("joint.0.point: missing"));
  EXPECT_THAT(with([](Scene&, Joint& j) { j.axis.reset(); }), HasSubstr("axis: missing"));
  EXPECT_THAT(with([](Scene&, Joint& j) { j.kind = JointKind::spherical; }), HasSubstr("axis: expected none"));
  EXPECT_THAT(with([](Scene&, Joint& j) { j.kind = JointKind::universal; }), HasSubstr("second_axis: missing"));
  EXPECT_THAT(with([](Scene&, Joint& j) {
                j.kind = JointKind::universal;
                j.second_axis = Point{1, 1, 0};
              }),
              HasSubstr("at right angles to axis"));
  EXPECT_THAT(with([](Scene&, Joint& j) { j.second_axis = Point{1, 0, 0}; }), HasSubstr("second_axis: expected none"));
  EXPECT_THAT(with([](Scene& s, Joint& j) { s.joints.push_back(j); }), no_error);
  EXPECT_THAT(with([](Scene& s, Joint&) {
                s.joints[0].name = "pin";
                s.joints.push_back(s.joints[0]);
              }),
              HasSubstr("pin"));
}

TEST(Joints, ThatContradictWhatMovesTheirBodiesAreTold) {
  Scene thrown = pendulum(0.01);
  thrown.rigid_bodies[0].velocity = Point{0, 0, 1};
  EXPECT_THAT(refused(thrown), HasSubstr("at the start that joint joint_0 lets them have"));
  Scene moved = pendulum(1);
  RigidMotion motion;
  motion.rigid_body = "bar";
  motion.direction = Point{0, 1, 0};
  motion.speed = 1;
  moved.rigid_motions = {motion};
  Solver<double> solver(moved);
  EXPECT_THAT(error_of<RunError>([&] { run(solver); }),
              HasSubstr("joint joint_0 of bar and ground cannot stay closed"));
}

}  // namespace
}  // namespace pinball::joints_test
