#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <solver/base/state_hash.hpp>
#include <solver/scene.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>
#include <tests/support/tied_case.hpp>

/// Velocities that leap, whatever makes them: the step is short before they do, so that energies balance.
namespace pinball::leap_balance_test {
namespace {

using namespace test;

constexpr double h = 0.01;         ///< size of elements
constexpr double balance = 0.015;  ///< largest error, of the energy

NodeSelection foot() {
  NodeSelection nodes;
  nodes.body = "b";
  nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  return nodes;
}

/// One element at a height.
Scene cube(double height, double speed) {
  Scene scene = scene_of({block("b", {1, 1, 1}, h, {0, 0, height}, {0, 0, -speed})}, 4e-5, false);
  scene.element = ElementSettings();
  return scene;
}

/// The foot of an element at rest is that of a rigid body.
Scene attached(double speed_of_element = 0) {
  Scene scene = cube(0, speed_of_element);
  scene.rigid_bodies = {{.name = "tool"}};
  scene.attached_nodes = {{"tool", foot()}};
  return scene;
}

RigidMotion motion(double speed, double begins) {
  return {.rigid_body = "tool", .direction = Point{0, 0, 1}, .speed = speed, .when = {begins}};
}

/// Nothing before `begins`, and then all at once.
TimeTable sudden(double begins) { return {{0, begins, 1.001 * begins}, {0, 0, 1}}; }

Scene with_wall(Scene scene, const RigidWall& wall) {
  scene.rigid_walls = {wall};
  return scene;
}

RigidWall floor() {
  RigidWall wall;
  wall.name = "floor";
  wall.plane = {{0, 0, 0}, {0, 0, 1}};
  return wall;
}

/// Of elastic and plastic elements at several speeds, with times of leaps at several places within steps.
/// make: of a speed and a time.
template <class Make>
void expect_balance(const Make& make, const std::vector<double>& speeds = {300, 500, 1000}) {
  for (const bool plastic : {false, true}) {
    for (const double speed : speeds) {
      for (const double begins : {1e-5, 1.023e-5, 1.046e-5, 1.069e-5, 1.092e-5, 1.115e-5}) {
        Scene scene = make(speed, begins);
        if (plastic) scene.materials = {plastic_material("steel", 4e8, 0)};
        Solver<double> solver(scene);
        run(solver);
        EXPECT_LT(solver.ledger().balance_error_max(), balance) << speed << ' ' << begins << ' ' << plastic;
      }
    }
  }
}

TEST(LeapBalance, OfNodesOfRigidBodies) {
  expect_balance([](double speed, double begins) {
    Scene scene = attached();
    scene.rigid_motions = {motion(speed, begins)};
    return scene;
  });
  expect_balance([](double speed, double begins) {
    Scene scene = attached(speed);
    scene.rigid_motions = {motion(0, begins)};
    return scene;
  });
  expect_balance([](double speed, double begins) {
    Scene scene = attached();
    scene.rigid_motions = {motion(speed, 0)};
    scene.rigid_motions[0].table = sudden(begins);
    return scene;
  });
  expect_balance([](double speed, double begins) {
    constexpr double width = 2e-8;
    Scene scene = attached();
    scene.rigid_motions = {motion(speed / width, 0)};
    scene.rigid_motions[0].quantity = MotionQuantity::acceleration;
    scene.rigid_motions[0].table = {{0, begins, begins + width / 2, begins + width, begins + 1.5 * width},
                                    {0, 0, 1, 1, 0}};
    return scene;
  });
}

TEST(LeapBalance, OfNodesOfRigidBodiesAsTheRunBegins) {
  expect_balance([](double speed, double) {
    Scene scene = attached(speed);
    scene.rigid_bodies[0].held = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return scene;
  });
  expect_balance([](double speed, double) {
    Scene scene = attached();
    scene.rigid_motions = {motion(speed, 0)};
    return scene;
  });
  expect_balance([](double speed, double) {
    Scene scene = attached();
    scene.rigid_bodies[0].velocity = Point{0, 0, speed};
    return scene;
  });
}

TEST(LeapBalance, OfWallsThatBeginAsNodesArrive) {
  for (const double height : {1.005, 1.05, 1.1}) {
    expect_balance([height](double speed, double begins) {
      Scene scene = with_wall(cube(height * speed * begins, speed), floor());
      scene.rigid_walls[0].when.start = begins;
      return scene;
    });
  }
}

TEST(LeapBalance, OfWallsThatAreSetInMotion) {
  expect_balance([](double speed, double begins) {
    Scene scene = with_wall(cube(0, 0), floor());
    scene.rigid_walls[0].speed = speed;
    scene.rigid_walls[0].table = sudden(begins);
    return scene;
  });
}

TEST(LeapBalance, OfTies) {
  for (const bool from_start : {true, false}) {
    for (const Point& direction : {Point{0, 0, -1}, Point{0, 0, 1}, Point{1, 0, 0}}) {
      expect_balance([&](double speed, double begins) {
        Scene scene = cube(0, 0);
        for (std::size_t k = 0; k < 3; ++k) scene.bodies[0].velocity[k] = speed * direction[k];
        scene.bodies.push_back(block("a", {2, 2, 2}, h, {-h / 2, -h / 2, -2 * h}));
        scene.tied_contacts = {tie("b", "a")};
        scene.tied_contacts[0].start = from_start ? 0 : begins / 5;
        return scene;
      });
    }
  }
}

/// Nearer to each other, and apart, which had an error of half of the energy.
TEST(LeapBalance, OfVelocitiesThatDifferWithinAnElement) {
  for (const double sign : {1.0, -1.0}) {
    expect_balance([sign](double speed, double) {
      Scene scene = cube(0, 0);
      InitialVelocity& initial = scene.initial_velocities.emplace_back();
      initial.nodes = foot();
      initial.velocity = {0, 0, sign * speed};
      return scene;
    });
  }
}

/// A quarter to all of the energy was created by that.
TEST(LeapBalance, OfVelocitiesThatAHostGivesToSomeNodes) {
  for (const bool plastic : {false, true}) {
    for (const double speed : {300.0, 500.0, 1000.0, -300.0, -500.0, -1000.0}) {
      Scene scene = cube(0, 0);
      if (plastic) scene.materials = {plastic_material("steel", 4e8, 0)};
      Solver<double> solver(scene);
      for (int step = 0; step < 5; ++step) solver.step();
      Array<double>& velocity = solver.change_velocities();
      for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
        if (solver.mesh().nodes[n][2] > 0) continue;
        velocity[4 * static_cast<std::size_t>(solver.layout().node_of_scene_node[n]) + 2] = speed;
      }
      run(solver);
      EXPECT_LT(solver.ledger().balance_error_max(), balance) << speed << ' ' << plastic;
    }
  }
}

/// What is stretched, sheared, spun and shaken as a whole does not leap.
TEST(LeapBalance, OfSmoothVelocitiesIsNone) {
  const auto first_step = [](double gradient, double noise) {
    Scene scene = scene_of({block("b", {4, 4, 4}, h, {0, 0, 0})}, 4e-5, false);
    scene.bodies[0].velocity_gradient = {{{gradient, 0, gradient}, {0, -gradient, 0}, {-gradient, 0, 0}}};
    scene.bodies[0].velocity_noise = noise;
    Solver<double> solver(scene);
    solver.step();
    return solver.clock().dt();
  };
  const double at_rest = first_step(0, 0);
  EXPECT_EQ(first_step(1000, 5), at_rest);
  EXPECT_LT(first_step(1e5, 5), 0.9 * at_rest);
}

/// With subcycling steps are chosen for a whole cycle, and leaps looked for as far ahead.
TEST(LeapBalance, MakesTheStepShortInTheCycleInWhichAMotionBegins) {
  for (const double begins : {1e-5, 1.02e-5, 1.04e-5, 1.06e-5, 1.08e-5, 1.1e-5, 1.12e-5, 1.14e-5}) {
    Scene scene = cube(0, 0);
    scene.bodies[0].mesh = BlockMesh{{h, h, 5 * h}, {1, 1, 8}, {{{}, {}, {{h, 4}, {4 * h, 4}}}}};
    scene.time.subcycling = true;
    PrescribedVelocity push;
    push.nodes = foot();
    push.direction = Point{0, 0, 1};
    push.velocity = {0, 0, 500};
    push.when.start = begins;
    scene.prescribed_velocities = {push};
    Solver<double> solver(scene);
    for (int cycle = 0; cycle < 3; ++cycle) solver.step();
    const double flight = solver.clock().dt();
    const auto end_of_cycle = [&] {  // whose step is known, and the first one made
      return solver.time() + (solver.subcycling()->cycle_steps() - 1) * solver.dt();
    };
    while (end_of_cycle() <= begins) solver.step();
    EXPECT_GT(solver.subcycling()->cycle_steps(), 1) << begins;
    EXPECT_LT(solver.dt(), 0.8 * flight) << begins;
    run(solver);
    EXPECT_LT(solver.ledger().balance_error_max(), balance) << begins;
  }
}

/// Leaps of a tie, and then of a rigid body and a wall at once.
Scene of_all(Device device) {
  Scene scene = scene_of({block("b", {3, 3, 3}, h, {0, 0, 0}), block("c", {3, 3, 3}, h, {0.1, 0, 0}, {0, 0, -400}),
                          block("d", {2, 2, 2}, h, {0.105, 0.005, 3 * h}, {0, 0, 300})},
                         1.6e-5, false);
  scene.element = ElementSettings();
  scene.device = device;
  scene.rigid_bodies = {{.name = "tool"}};
  scene.attached_nodes = {{"tool", foot()}};
  scene.rigid_motions = {motion(500, 1e-5)};
  scene = with_wall(scene, floor());
  scene.rigid_walls[0].plane.point = {0, 0, -4.2e-3};
  scene.rigid_walls[0].when.start = 1e-5;
  scene.rigid_walls[0].body = "c";
  scene.tied_contacts = {tie("d", "c")};
  scene.tied_contacts[0].start = 5e-6;
  return scene;
}

/// A run that goes on from a state just before a leap knows of it, as one without a break.
TEST(LeapBalance, GoesOnFromAnyStepWithTheSameBits) {
  for (const Device device : {Device::none, Device::mock}) {
    const Scene scene = of_all(device);
    Solver<double> whole(scene);
    std::vector<StateBytes> states;
    while (!whole.at_end()) {
      const double time = whole.time();
      if ((time > 3e-6 && time < 6e-6) || (time > 8e-6 && time < 1.1e-5)) states.push_back(saved(whole));
      whole.step();
    }
    EXPECT_GT(states.size(), 8U);
    whole.finish();
    EXPECT_LT(whole.ledger().balance_error_max(), balance);
    for (std::size_t i = 0; i < states.size(); ++i) {
      DefaultExecutionSpace::set_concurrency(static_cast<int>(1 + i % 2));
      Solver<double> rest(scene);
      EXPECT_EQ(load(rest, states[i]), 0U);
      run(rest);
      EXPECT_EQ(state_hash(rest.model()), state_hash(whole.model())) << "from state " << i;
    }
    DefaultExecutionSpace::set_concurrency(1);
  }
}

}  // namespace
}  // namespace pinball::leap_balance_test
