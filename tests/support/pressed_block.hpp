#pragma once

#include "solver_case.hpp"

namespace pinball::test {

/// A block of 2 x 2 x 6 elements, one end held, that is pressed to a sixth of its length at 200 m/s.
inline Scene pressed_block(double resistance) {
  Scene scene = scene_of({block("b", {2, 2, 6}, 5e-3, {0, 0, 0})}, 1.25e-4, false);
  scene.materials = {plastic_material("steel", 4e8, 0)};
  scene.materials[0].plastic_modulus = 5e8;
  scene.element = ElementSettings{};
  scene.element.folding_resistance = resistance;
  FixedConstraint held;
  held.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  held.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  FixedConstraint guided;
  guided.directions = {{1, 0, 0}, {0, 1, 0}};
  guided.nodes.plane = Plane{{0, 0, 0.03}, {0, 0, 1}};
  scene.fixed_constraints = {held, guided};
  PrescribedVelocity push;
  push.direction = Point{0, 0, 1};
  push.velocity = {0, 0, -200};
  push.nodes.plane = Plane{{0, 0, 0.03}, {0, 0, 1}};
  scene.prescribed_velocities = {push};
  return scene;
}

}  // namespace pinball::test
