#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <solver/scene_rules.hpp>
#include <tests/support/saved_state.hpp>

#include "rigid_case.hpp"

/// Rigid bodies whose centre and motion at the start are given.
namespace pinball::rigid_given_test {
namespace {

using namespace test;
using testing::HasSubstr;

void expect_near(const Point& a, const Point& b, double within, const char* what) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], within) << what << ' ' << k;
}

/// Two blocks of different densities that are one body: its centre lies in the heavy one.
Scene uneven(double end) {
  Scene scene = scene_of({block("light", {2, 2, 2}, 0.1, {0, 0, 0}, {3, -1, 2}),
                          block("heavy", {2, 2, 1}, 0.1, {0, 0, 0.2}, {3, -1, 2}, "lead")},
                         end, false);
  scene.materials.push_back(elastic_material("lead"));
  scene.materials[1].density *= 5;
  RigidBody both = rigid("light");
  both.bodies = {"light", "heavy"};
  scene.rigid_bodies = {both};
  scene.gravities = {{.acceleration = {1, 2, -9}, .table = {{0, end}, {0.5, 1.5}}}};
  NodalLoad load;
  load.nodes.nearest = {0.2, 0.2, 0.3};
  load.force = {0, 800, 100};
  scene.loads = {load};
  return scene;
}

/// The same of one density, with mass, centre and inertia as given.
Scene as_given(const Scene& uneven_one) {
  Scene scene = uneven_one;
  const RigidBodyResult whole = Solver<double>(uneven_one).rigid().results()[0];
  scene.bodies[1].material = "steel";
  RigidBody& given = scene.rigid_bodies[0];
  given.mass = whole.mass;
  given.centre = whole.centre;
  given.inertia = whole.inertia;
  given.velocity = Point{3, -1, 2};
  given.angular_velocity = Point{1, 2, -1};
  return scene;
}

/// What holds a body takes its part of the velocities before there is an energy, as constraints of nodes do: it is no
/// work from outside, and no impulse of the reaction in the first step.
TEST(RigidBodies, BeginWithoutWhatHoldsThemTakes) {
  for (const bool own : {true, false}) {
    Scene scene = scene_of({block("a", {2, 2, 1}, 0.1, {0, 0, 0}, {3, 2, 0})}, 1e-3, false);
    scene.bodies[0].angular_velocity = {0, 4, 5};
    scene.rigid_bodies = {rigid("a")};
    scene.rigid_bodies[0].held = {{0.6, 0.8, 0}};
    scene.rigid_bodies[0].held_rotations = {{0, 0, 1}};
    if (own) {
      scene.rigid_bodies[0].velocity = Point{3, 2, 0};
      scene.rigid_bodies[0].angular_velocity = Point{0, 4, 5};
    }
    Solver<double> solver(scene);
    const RigidBodyResult start = solver.rigid().results()[0];
    expect_near(start.velocity, {3 - 3.4 * 0.6, 2 - 3.4 * 0.8, 0}, 1e-12, "velocity");
    expect_near(start.angular_velocity, {0, 4, 0}, 1e-12, "spin");
    solver.step();
    const Point force = solver.rigid().results()[0].force;
    EXPECT_LT(norm(force), 1e-6 * start.mass);
    solver.step();
    const double kinetic = 0.5 * start.mass * dot(start.velocity, start.velocity) + 8 * start.inertia[1][1];
    EXPECT_NEAR(solver.initial_energy(), kinetic, 1e-9 * kinetic);
    EXPECT_NEAR(solver.energies().external, 0, 1e-9 * kinetic);
  }
}

TEST(RigidBodies, WithAGivenCentreMoveAsThoseWhoseMassIsThere) {
  Scene masses = uneven(1);
  const Scene given = as_given(masses);
  masses.rigid_bodies[0].velocity = given.rigid_bodies[0].velocity;
  masses.rigid_bodies[0].angular_velocity = given.rigid_bodies[0].angular_velocity;
  Solver<double> one(masses), other(given);
  expect_near(one.momentum(), other.momentum(), 1e-9, "momentum at the start");
  run(one);
  run(other);
  const RigidBodyResult a = one.rigid().results()[0], b = other.rigid().results()[0];
  EXPECT_GT(norm(a.angular_velocity), 3);
  EXPECT_NEAR(a.mass, b.mass, 1e-9);
  expect_near(a.centre, b.centre, 1e-9, "centre");
  expect_near(a.velocity, b.velocity, 1e-9, "velocity");
  expect_near(a.angular_velocity, b.angular_velocity, 1e-8, "angular velocity");
  expect_near(one.momentum(), other.momentum(), 1e-6, "momentum");
  EXPECT_NEAR(one.energies().kinetic / other.energies().kinetic, 1, 1e-9);
  EXPECT_NEAR(one.energies().external / other.energies().external, 1, 1e-9);
  EXPECT_LT(one.ledger().balance_error_in_motion_max(), 1e-11);
  EXPECT_LT(other.ledger().balance_error_in_motion_max(), 1e-11);
}

/// Accelerations are added to what the body has at the start.
TEST(RigidMotion, OfAnAccelerationChangesTheVelocityThatIsThere) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 0.1, false);
  RigidBody body = rigid("a");
  body.velocity = Point{3, 0, 2};
  body.angular_velocity = Point{0, 0, 4};
  scene.rigid_bodies = {body};
  RigidMotion along, about;
  along.rigid_body = about.rigid_body = "a";
  along.direction = Point{1, 0, 0};
  along.speed = 10;
  about.axis = Point{0, 0, 1};
  about.angular_speed = 6;
  along.quantity = about.quantity = MotionQuantity::acceleration;
  scene.rigid_motions = {along, about};
  Solver<double> solver(scene);
  run(solver);
  const RigidBodyResult moved = solver.rigid().results()[0];
  expect_near(moved.velocity, {3 + 10 * 0.1, 0, 2}, 1e-10, "velocity");  // thousands of steps round
  expect_near(moved.angular_velocity, {0, 0, 4 + 6 * 0.1}, 1e-10, "angular velocity");
}

/// A block whose principal axes lie askew to those of the scene, by a given inertia.
Scene askew(double end) {
  Scene scene = scene_of({block("a", {2, 1, 3}, 0.1, {-0.1, -0.05, -0.15})}, end, false);
  RigidBody body = rigid("a");
  body.mass = 50;
  body.centre = Point{};
  body.inertia = {Point{0.9, 0.1, 0.2}, {0.1, 0.7, -0.15}, {0.2, -0.15, 0.5}};
  scene.rigid_bodies = {body};
  return scene;
}

/// Of an inertia at the start that has turned about z by an angle.
Point turned_about_z(const std::array<Point, 3>& inertia, double angle, const Point& w) {
  const auto turn = [](const Point& v, double by) {
    return Point{std::cos(by) * v[0] - std::sin(by) * v[1], std::sin(by) * v[0] + std::cos(by) * v[1], v[2]};
  };
  const Point own = turn(w, -angle);
  return turn({dot(inertia[0], own), dot(inertia[1], own), dot(inertia[2], own)}, angle);
}

/// A rotor that is out of balance, on bearings that hold its axis and beside one that is driven: w x I w.
TEST(RigidBodies, AreHeldAboutAxesByWhatTheyTakeFromThese) {
  constexpr double speed = 5, end = 0.4;
  Scene held = askew(end), driven = held;
  held.rigid_bodies[0].held = driven.rigid_bodies[0].held = all_directions;
  held.rigid_bodies[0].held_rotations = driven.rigid_bodies[0].held_rotations = {{1, 0, 0}, {0, 1, 0}};
  held.rigid_bodies[0].angular_velocity = driven.rigid_bodies[0].angular_velocity = Point{0, 0, speed};
  RigidMotion motion;
  motion.rigid_body = "a";
  motion.axis = Point{0, 0, 1};
  motion.angular_speed = speed;
  driven.rigid_motions = {motion};
  for (const Scene& scene : {held, driven}) {
    Solver<double> solver(scene);
    Point sum{};
    run_to_end(solver, [&] {
      const RigidBodyResult body = solver.rigid().results()[0];
      const Point w{0, 0, speed};
      const Point expected = cross(w, turned_about_z(held.rigid_bodies[0].inertia, speed * solver.force_time(), w));
      expect_near(body.moment, expected, 1e-9 * norm(expected), "moment");
      for (std::size_t k = 0; k < 3; ++k) sum[k] += body.moment[k];
    });
    EXPECT_GT(norm(sum), 1);
  }
}

/// At one time with the pictures, also at the start: straight back from where the step ends they would be off the arc.
TEST(RigidBodies, AreWatchedWhereTheyTurn) {
  Scene scene = scene_of({block("a", {2, 1, 1}, 0.1, {0, 0, 0})}, 0.2, false);
  scene.rigid_bodies = {rigid("a")};
  scene.rigid_bodies[0].angular_velocity = Point{0, 0, 40};
  Probe probe;
  probe.name = "corner";
  probe.point = Point{0.2, 0.1, 0.1};
  probe.quantities = {"position", "displacement"};
  scene.probes = {probe};
  Solver<double> solver(scene);
  const FieldSnapshot start = snapshot(solver);
  const std::size_t corner = start.position.size() - 1;
  run_to_end(solver, [&] {
    const Point now = snapshot(solver).position[corner];
    const std::vector<double> values = solver.probe_values();
    const Point position{values[0], values[1], values[2]}, displacement{values[3], values[4], values[5]};
    expect_near(position, now, 1e-15, "position");
    expect_near(displacement, minus(now, start.position[corner]), 1e-15, "displacement");
  });
}

/// What a motor gives a body that tumbles about the other two axes is its moment times its speed.
TEST(RigidMotion, DoesTheWorkOfItsMoment) {
  Scene scene = askew(1);
  scene.rigid_bodies[0].angular_velocity = Point{1, 2, 0};
  RigidMotion motion;
  motion.rigid_body = "a";
  motion.axis = Point{0, 0, 1};
  motion.angular_speed = 6;
  motion.table = {{0, 0.5}, {0, 1}};
  scene.rigid_motions = {motion};
  Solver<double> solver(scene);
  double work = 0, largest = 0, before = 0;
  run_to_end(solver, [&] {
    const double time = solver.force_time(), step = 0.5 * (solver.time() - before);
    before = time;
    const double moment = solver.rigid().results()[0].moment[2];
    work += step * moment * 6 * std::min(time / 0.5, 1.0);
    largest = std::max(largest, std::abs(moment));
  });
  EXPECT_GT(largest, 5);
  EXPECT_NEAR(work / solver.energies().external, 1, 1e-3);
}

/// Struck beside its centre by another one: both lose and gain the same momenta.
TEST(RigidBodies, WithAGivenCentreAreStruckAsThoseWhoseMassIsThere) {
  Scene masses = uneven(0.05);
  masses.contact.method = ContactMethod::pinball;
  masses.contact.enforcement = Enforcement::lagrange;
  masses.contact.gap = ContactGap::face;
  masses.loads.clear();
  masses.bodies.push_back(block("ball", {1, 1, 1}, 0.05, {0.02, 0.03, 0.32}, {3, -1, -3}));
  masses.rigid_bodies.push_back(rigid("ball"));
  Scene given = as_given(masses);
  given.rigid_bodies[0].angular_velocity = Point{};
  Solver<double> one(masses), other(given);
  const Point before = one.momentum();
  run(one);
  run(other);
  for (std::size_t b = 0; b < 2; ++b) {
    const RigidBodyResult first = one.rigid().results()[b], second = other.rigid().results()[b];
    EXPECT_GT(norm(first.angular_velocity), 0.1) << b;
    expect_near(first.velocity, second.velocity, 1e-6, "velocity");
    expect_near(first.angular_velocity, second.angular_velocity, 1e-5 * norm(first.angular_velocity), "spin");
  }
  const double mass = one.rigid().results()[0].mass + one.rigid().results()[1].mass;
  for (const Solver<double>* solver : {&one, &other}) {
    const Point after = solver->momentum();
    EXPECT_NEAR(after[2] - before[2], -9 * 0.05 * mass, 1e-9 * mass);
    EXPECT_LT(solver->ledger().balance_error_in_motion_max(), 1e-10);
  }
}

TEST(RigidBodies, WithAGivenCentreGoOnAfterARestart) {
  const Scene scene = as_given(uneven(0.2));
  Solver<double> whole(scene), first(scene), second(scene);
  run(whole);
  while (first.time() < 0.1) first.step();
  const StateBytes state = saved(first);
  EXPECT_EQ(load(second, state), 0U);
  run(second);
  EXPECT_EQ(state_hash(second.model()), state_hash(whole.model()));
  EXPECT_EQ(second.momentum(), whole.momentum());
}

TEST(RigidBodies, BeginWithTheirVelocitiesWhateverThoseOfTheirNodes) {
  Scene scene = scene_of({block("a", {2, 1, 1}, 0.1, {0, 0, 0}, {1, 0, 0})}, 0.1, false);
  InitialVelocity part;
  part.nodes.nearest = {0, 0, 0};
  scene.initial_velocities = {part};
  scene.rigid_bodies = {rigid("a")};
  scene.rigid_bodies[0].angular_velocity = Point{0, 0, 4};
  Solver<double> solver(scene);
  run(solver);
  const RigidBodyResult result = solver.rigid().results()[0];
  expect_near(result.centre, {0.1, 0.05, 0.05}, 1e-12, "centre");
  expect_near(result.angular_velocity, {0, 0, 4}, 1e-10, "angular velocity");
  const FieldSnapshot now = snapshot(solver);
  EXPECT_NEAR(now.position[0][0], 0.1 - 0.1 * std::cos(0.4) + 0.05 * std::sin(0.4), 1e-9);
}

TEST(RigidBodies, RefuseACentreWithoutWhatBelongsToIt) {
  const auto refused = [](const auto& change) {
    Scene scene = as_given(uneven(1));
    change(scene);
    return error_of([&] { Solver<double>{checked_scene(scene)}; });
  };
  EXPECT_EQ(refused([](Scene&) {}), no_error);
  EXPECT_THAT(refused([](Scene& s) { s.rigid_bodies[0].inertia = {}; }), HasSubstr("expected an inertia beside it"));
  EXPECT_THAT(refused([](Scene& s) { s.damping.mass = 1; }), HasSubstr("expected damping.mass = 0"));
  EXPECT_THAT(refused([](Scene& s) { s.gravities[0].bodies = {"heavy"}; }), HasSubstr("of all bodies"));
  EXPECT_EQ(refused([](Scene& s) { s.gravities[0].bodies = {"heavy", "light"}; }), no_error);
}

}  // namespace
}  // namespace pinball::rigid_given_test
