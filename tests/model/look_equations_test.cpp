#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/model/model.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/solver_case.hpp>

/// Where bodies that an equation moves may come before the first step is known.
namespace pinball::test::look_equations_test {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

/// A slide that moves by 1 until the end, a block far from it, and another one half as far beside that as it moves.
Scene led(double factor) {
  Scene scene = scene_of({block("slide", {1, 1, 1}, 1, {0, 0, 0}), block("led", {1, 1, 1}, 1, {100, 0, 0}),
                          block("hit", {1, 1, 1}, 1, {101.5, 0, 0})},
                         1);
  scene.contact.method = ContactMethod::not_set;
  PrescribedVelocity& motion = scene.prescribed_velocities.emplace_back();
  motion.nodes.body = "slide";
  motion.velocity = {1, 0, 0};
  for (const char* body : {"slide", "led"}) {
    EquationTerm& term = scene.equation_terms.emplace_back();
    term.name = "lever";
    term.direction = {1, 0, 0};
    term.nodes.body = body;
  }
  scene.equation_terms[1].factor = factor;
  return scene;
}

Look look_of(Scene& scene) {
  complete_scene(scene);
  ModelMesh mesh = build_mesh(scene);
  return look_at(scene, mesh);
}

ContactMethod decided(Scene scene) {
  look_of(scene);
  return scene.contact.method;
}

TEST(LookAtEquations, WhatAnEquationMovesMayMeetOthers) {
  EXPECT_EQ(decided(led(-1)), ContactMethod::pinball);
  Scene without = led(-1);
  without.equation_terms.clear();
  EXPECT_EQ(decided(without), ContactMethod::none);
  Scene at_rest = led(-1);
  at_rest.prescribed_velocities.clear();
  EXPECT_EQ(decided(at_rest), ContactMethod::none);
}

TEST(LookAtEquations, ALeverMovesItAsManyTimesAsFar) {
  Scene scene = led(-1);
  scene.bodies[2].position = {120, 0, 0};
  EXPECT_EQ(decided(scene), ContactMethod::none) << "it is too far";
  scene.equation_terms[1].factor = -0.05;
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
}

TEST(LookAtEquations, WithinABodyTheyMoveNoOther) {
  Scene scene = led(-1);
  scene.equation_terms[0].nodes.body = "led";
  EXPECT_EQ(decided(scene), ContactMethod::none);
}

TEST(LookAtEquations, AWallThatItMayReachIsNotToldToBeOutOfReach) {
  const auto sentences = [](bool equation) {
    Scene scene = led(-1);
    scene.contact.method = ContactMethod::none;
    scene.bodies[2].position = {50, 50, 0};
    scene.rigid_walls.emplace_back().plane = {{103, 0, 0}, {-1, 0, 0}};
    scene.rigid_walls[0].body = "led";
    if (!equation) scene.equation_terms.clear();
    return look_of(scene).unlikely;
  };
  EXPECT_THAT(sentences(true), Each(Not(HasSubstr("wall"))));
  EXPECT_THAT(sentences(false), Contains(HasSubstr("wall")));
}

}  // namespace
}  // namespace pinball::test::look_equations_test
