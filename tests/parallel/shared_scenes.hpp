#pragma once

#include <utility>

#include <tests/support/pressed_block.hpp>
#include <tests/support/torn_block.hpp>

/// Scenes without contact that ranks share.
namespace pinball::test {

inline Scene torn(Precision precision = Precision::float64) {
  Scene scene = torn_block(precision, {11, 7, 9});  // tiles of two sizes
  scene.output.body_energies = true;
  return scene;
}

/// Every kind of boundary condition that ranks know, several of them with names.
inline Scene held_and_driven() {
  Scene scene = pressed_blocks(1e-3);
  scene.contact.method = ContactMethod::none;
  scene.bodies = {block("a", {9, 8, 7}, 0.1, {0, 0, 0}, {0.5, 0, -20}), block("b", {4, 5, 4}, 0.1, {2, 0, 0.5})};
  scene.prescribed_velocities[0].nodes.plane = Plane{{0, 0, 0.7}, {0, 0, 1}};
  scene.prescribed_velocities[0].name = "press";
  scene.constraints[0].name = "middle";
  scene.rigid_walls[1].plane.point[0] = 0.91;
  scene.rigid_walls[0].friction = 0.2;
  scene.rigid_walls[0].nodes.body = "a";
  RigidWall pushed{"pushed", {{0, 0, 0.45}, {0, 0, 1}}, "b", "here"};
  pushed.mass = 100;
  pushed.speed = 40;
  scene.rigid_walls.push_back(pushed);
  Gravity weight;
  weight.acceleration = {0, 0, -1000};
  weight.name = "weight";
  Gravity of_one = weight;
  of_one.bodies = {"b"};
  of_one.name = "pull";
  scene.gravities = {weight, of_one};
  Pressure blast;
  blast.name = "blast";
  blast.pressure = 3e7;
  blast.faces.plane = Plane{{0.9, 0, 0}, {1, 0, 0}};
  scene.pressures = {blast};
  return scene;
}

/// Nodes of two bodies that move alike.
inline Scene with_equations() {
  Scene scene = held_and_driven();
  scene.rigid_walls.resize(1);
  scene.rigid_walls[0].nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  for (const auto& [body, factor] : {std::pair{"a", 1.0}, {"b", -1.0}}) {
    EquationTerm term{"even", {0, 0.6, 0.8}, factor, {}};
    term.nodes.body = body;
    term.nodes.box = body[0] == 'a' ? Box{{0.3, 0.2, 0.3}, {0.6, 0.4, 0.5}} : Box{{2.1, 0.2, 0.6}, {2.4, 0.4, 0.8}};
    scene.equation_terms.push_back(term);
  }
  return scene;
}

inline Scene resting_bar() {
  Scene scene = scene_of({block("bar", {60, 4, 4}, 0.01, {})}, 8e-5, false);
  NodalLoad pull;
  pull.nodes.plane = Plane{{0.6, 0, 0}, {1, 0, 0}};
  pull.force = {1e5, 0, 0};
  scene.loads = {pull};
  return scene;
}

}  // namespace pinball::test
