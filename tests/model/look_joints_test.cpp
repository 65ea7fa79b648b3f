#include <gtest/gtest.h>

#include <solver/model/model.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/solver_case.hpp>

/// Where bodies that are jointed, or taken along, may come before the first step is known.
namespace pinball::look_joints_test {
namespace {

using namespace test;

ContactMethod decided(Scene scene) {
  complete_scene(scene);
  ModelMesh mesh = build_mesh(scene);
  look_at(scene, mesh);
  return scene.contact.method;
}

/// A bar along x that hangs at its left end, and a block at a place.
Scene pendulum(const Point& place) {
  Scene scene = scene_of({block("bar", {10, 1, 1}, 1, {0, 0, 0}), block("block", {1, 1, 1}, 1, place)}, 2);
  scene.contact.method = ContactMethod::not_set;
  scene.rigid_bodies.emplace_back().bodies = {"bar"};
  Joint& hinge = scene.joints.emplace_back();
  hinge.kind = JointKind::spherical;
  hinge.bodies = {"bar", ground};
  hinge.point = Point{0, 0, 0};
  scene.fixed_constraints = {{{.body = "block"}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  return scene;
}

TEST(LookAtJoints, AJointLeadsAsideWhatFalls) {
  Scene scene = pendulum({-5, 0, -5});
  EXPECT_EQ(decided(scene), ContactMethod::none) << "nothing moves it";
  scene.gravities = {{.acceleration = {0, 0, -10}}};
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
  scene.bodies[1].position = {-500, 0, 0};
  EXPECT_EQ(decided(scene), ContactMethod::none) << "it is too far";
  scene.bodies[1].position = {-5, 0, -5};
  scene.joints.clear();
  EXPECT_EQ(decided(scene), ContactMethod::none) << "it falls past";
}

/// A rigid body falls beside a block, whose nodes at one end it takes along.
TEST(LookAtJoints, WhatARigidBodyTakesAlongIsOneWithIt) {
  Scene scene = scene_of({block("hammer", {2, 2, 2}, 1, {0, 0, 2}), block("block", {2, 2, 2}, 1, {0, 0, 0})}, 2);
  scene.contact.method = ContactMethod::not_set;
  scene.rigid_bodies.emplace_back().bodies = {"hammer"};
  scene.bodies[0].velocity = {0, 0, -10};
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
  scene.rigid_bodies[0].name = "hammer";
  AttachedNodes& top = scene.attached_nodes.emplace_back();
  top.rigid_body = "hammer";
  top.nodes.body = "block";
  top.nodes.plane = Plane{{0, 0, 2}, {0, 0, 1}};
  EXPECT_EQ(decided(scene), ContactMethod::none);
}

/// A bar whose nodes at its left end are a rigid body, and a block above its other end.
Scene led_by_nodes() {
  Scene scene = scene_of({block("bar", {10, 1, 1}, 1, {0, 0, 0}), block("block", {1, 1, 1}, 1, {9, 0, 3})}, 2);
  scene.contact.method = ContactMethod::not_set;
  scene.rigid_bodies.emplace_back().name = "end";
  AttachedNodes& end = scene.attached_nodes.emplace_back();
  end.rigid_body = "end";
  end.nodes.body = "bar";
  end.nodes.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  return scene;
}

TEST(LookAtJoints, RigidBodiesOfNodesBeginAsTheyAreGiven) {
  Scene scene = led_by_nodes();
  EXPECT_EQ(decided(scene), ContactMethod::none) << "nothing moves it";
  scene.rigid_bodies[0].velocity = Point{0, 0, 40};
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
  scene.rigid_bodies[0].velocity = {};
  scene.rigid_bodies[0].angular_velocity = Point{0, -100, 0};
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
}

TEST(LookAtJoints, AJointLeadsNodesThatAreARigidBody) {
  Scene scene = led_by_nodes();
  scene.bodies.push_back(block("lift", {1, 1, 1}, 1, {-100, 0, 0}));
  scene.rigid_bodies.emplace_back().bodies = {"lift"};
  scene.rigid_bodies[1].held_rotations = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  RigidMotion up;
  up.rigid_body = "lift";
  up.direction = Point{0, 0, 1};
  up.speed = 4;
  scene.rigid_motions = {up};
  EXPECT_EQ(decided(scene), ContactMethod::none) << "nothing leads the bar";
  Joint& rod = scene.joints.emplace_back();
  rod.kind = JointKind::locking;
  rod.bodies = {"end", "lift"};
  rod.point = Point{-50, 0, 0};
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
}

/// A crank that is turned as given moves a rod that nothing else moves.
TEST(LookAtJoints, WhatIsJointedToWhatTurnsMoves) {
  Scene scene = pendulum({12, 0, 5});
  scene.bodies.push_back(block("rod", {5, 1, 1}, 1, {10, 0, 0}));
  scene.rigid_bodies.emplace_back().bodies = {"rod"};
  Joint& pin = scene.joints.emplace_back(scene.joints[0]);
  pin.bodies = {"bar", "rod"};
  pin.point = Point{10, 0, 0};
  scene.contact_pairs.emplace_back().first.bodies = {"rod"};
  scene.contact_pairs[0].second.bodies = {"block"};
  scene.contact.method = ContactMethod::pinball;
  RigidMotion turn;
  turn.rigid_body = "bar";
  turn.axis = Point{0, 1, 0};
  turn.angular_speed = -1;
  scene.rigid_motions = {turn};
  complete_scene(scene);
  ModelMesh mesh = build_mesh(scene);
  for (const std::string& sentence : look_at(scene, mesh).unlikely)
    EXPECT_EQ(sentence.find("meet"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace pinball::look_joints_test
