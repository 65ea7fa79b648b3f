#pragma once

#include <array>

#include "solver_case.hpp"

namespace pinball::test {

/// A block that turns, is torn, and hits nothing: yield, erosion, hourglass forces, viscosity.
inline Scene torn_block(Precision precision = Precision::float64, const std::array<int, 3>& elements = {7, 5, 6}) {
  Scene scene = scene_of({block("torn", elements, 0.01, {})}, 40e-6, false);
  scene.materials[0] = plastic_material("steel", 4e8, 0.02);
  scene.bodies[0].velocity_gradient = {Point{4000, 300, 0}, Point{0, -1500, 200}, Point{500, 0, -1200}};
  scene.bodies[0].velocity_noise = 5;
  scene.element.bulk_viscosity = true;
  scene.precision = precision;
  return scene;
}

}  // namespace pinball::test
