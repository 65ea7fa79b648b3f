#pragma once

#include <tests/support/solver_case.hpp>

/// Scenes with contact, ties and rigid bodies that ranks share.
namespace pinball::test {

/// A block that goes through a plate: both erode, and new surface comes up all the time.
inline Scene eroding(ContactMethod method, Enforcement enforcement, ContactGap gap) {
  Scene scene = scene_of({block("plate", {9, 9, 3}, 0.01, {0, 0, 0}),
                          block("block", {3, 3, 4}, 0.011, {0.029, 0.031, 0.0301}, {150, 0, -900})},
                         6e-5);
  scene.materials = {plastic_material("steel", 4e8, 0.25)};
  scene.element.bulk_viscosity = true;
  scene.contact.method = method;
  scene.contact.enforcement = enforcement;
  scene.contact.gap = gap;
  return scene;
}

/// Blocks on each other: two are glued, the glue ends, and some of its faces erode before.
inline Scene glued() {
  Scene scene = scene_of({block("low", {6, 6, 4}, 0.01, {0, 0, 0}, {0, 0, 60}),
                          block("high", {5, 5, 3}, 0.012, {0, 0, 0.04}, {30, 0, -60}),
                          block("top", {4, 4, 3}, 0.015, {0, 0, 0.0761}, {0, 20, -400})},
                         4e-5);
  scene.materials = {plastic_material("steel", 2e8, 0.05)};
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.contact.friction = scene.contact.static_friction = 0.2;
  TiedContact tied;
  tied.name = "glue";
  tied.first.bodies = {"high"};
  tied.second.bodies = {"low"};
  tied.start = 2e-6;
  tied.end = 3e-5;
  scene.tied_contacts = {tied};
  return scene;
}

/// A rigid block falls on a soft one that hangs on a rigid plate, which is moved.
inline Scene with_rigid_bodies(Enforcement enforcement) {
  Scene scene = scene_of({block("plate", {6, 6, 1}, 0.01, {0, 0, 0}), block("soft", {5, 5, 4}, 0.01, {0, 0, 0.01}),
                          block("hammer", {3, 3, 3}, 0.01, {0.011, 0.012, 0.0505}, {20, 0, -150})},
                         6e-5);
  scene.contact.enforcement = enforcement;
  if (enforcement != Enforcement::penalty) {
    scene.contact.gap = ContactGap::face;
    scene.contact.friction = 0.3;
  }
  for (const char* name : {"plate", "hammer"}) {
    RigidBody rigid;
    rigid.name = name;
    rigid.bodies = {name};
    scene.rigid_bodies.push_back(rigid);
  }
  AttachedNodes attached;
  attached.rigid_body = "plate";
  attached.nodes.body = "soft";
  attached.nodes.plane = Plane{{0, 0, 0.01}, {0, 0, 1}};
  scene.attached_nodes = {attached};
  RigidMotion motion;
  motion.rigid_body = "plate";
  motion.direction = Point{0, 0, 1};
  motion.speed = 30;
  motion.when.start = 1e-5;
  scene.rigid_motions = {motion};
  return scene;
}

/// The hammer on a guide.
inline Scene with_jointed_bodies() {
  Scene scene = with_rigid_bodies(Enforcement::lagrange);
  scene.bodies[2].velocity = {0, 0, -150};
  Joint guide;
  guide.name = "guide";
  guide.kind = JointKind::translational;
  guide.bodies = {"hammer", ground};
  guide.point = Point{0.02, 0.02, 0.06};
  guide.axis = Point{0, 0, 1};
  scene.joints = {guide};
  return scene;
}

}  // namespace pinball::test
