#include <gtest/gtest.h>

#include "rigid_case.hpp"

/// Rigid bodies that gain speed on their way, where nothing deforms: a step is a part of the run.
namespace pinball::fast_rigid_test {
namespace {

using namespace test;

/// A cube falls a thousand times its size onto a plate that is held.
Scene fall(ContactMethod method, ContactGap gap) {
  constexpr double height = 20, gravity = 1e5;
  Body plate = block("plate", {5, 5, 1}, 0.02, {-0.05, -0.05, -0.02});
  const Body cube = block("cube", {2, 2, 2}, 0.01, {-0.01, -0.01, height});
  Scene scene = scene_of({plate, cube}, 1.2 * std::sqrt(2 * height / gravity));
  scene.contact.method = method;
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = gap;
  scene.rigid_bodies = {rigid("plate"), rigid("cube")};
  scene.rigid_bodies[0].held = scene.rigid_bodies[0].held_rotations = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Gravity down;
  down.acceleration = {0, 0, -gravity};
  scene.gravities = {down};
  return scene;
}

TEST(FastRigid, WhatFallsFarStopsAtWhatItMeets) {
  for (const auto& [method, gap] : {std::pair(ContactMethod::pinball, ContactGap::face),
                                    {ContactMethod::pinball, ContactGap::pinball},
                                    {ContactMethod::slideline, ContactGap::not_set}}) {
    Solver<double> solver(fall(method, gap));
    double largest = 0;
    run_to_end(solver, [&] {
      const double speed = norm(solver.rigid().results()[1].velocity);
      if (speed > 100) largest = std::max(largest, speed * solver.dt());
    });
    EXPECT_LT(largest, 0.0063) << "the radius of the smallest ball";
    EXPECT_GT(solver.rigid().results()[1].centre[2], -0.01);
    EXPECT_GT(solver.rigid().results()[1].velocity[2], -100);
  }
}

/// With what it meets, and beside it, whatever both do together.
TEST(FastRigid, SpeedsAreRelative) {
  Scene scene = fall(ContactMethod::pinball, ContactGap::face);
  scene.rigid_bodies[0].held = scene.rigid_bodies[0].held_rotations = {};
  Solver<double> solver(scene);
  run_to_end(solver, [] {});
  EXPECT_LE(solver.steps(), 1001) << "both fall alike";
}

/// What is moved as given leaps.
TEST(FastRigid, AMotionThatBeginsIsSeenBefore) {
  Scene scene = fall(ContactMethod::pinball, ContactGap::pinball);
  scene.gravities.clear();
  scene.time.end = 1;
  RigidMotion& push = scene.rigid_motions.emplace_back();
  push.rigid_body = "cube";
  push.direction = Point{0, 0, -1};
  push.speed = 1;
  push.when.start = 0.5;
  push.table.times = {0, 0.6, 0.6001, 1};
  push.table.factors = {30, 30, 100, 100};
  Solver<double> solver(scene);
  double largest = 0;
  while (solver.time() < 0.65) {
    solver.step();
    largest = std::max(largest, std::abs(solver.rigid().results()[1].velocity[2]) * solver.dt());
  }
  EXPECT_GT(std::abs(solver.rigid().results()[1].velocity[2]), 50);
  EXPECT_LT(largest, 0.0063);
}

}  // namespace
}  // namespace pinball::fast_rigid_test
