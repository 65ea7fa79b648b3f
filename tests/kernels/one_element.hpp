#pragma once

#include "element_fixture.hpp"

/// An element by itself, moved from step to step.
namespace pinball::test {

/// At rest, of the default constants.
inline ElementScene one_element(const Corners& x) {
  ElementScene scene;
  Corners still;
  still.fill({0, 0, 0});
  ElementState state;
  state.mass = 3 * quadrature_gradient(x).volume;
  scene.add(x, still, state);
  scene.constants = element_constants();
  return scene;
}

/// Moves the nodes to `next`, as the integrator does before the element update: velocities of the step just made.
inline void move_to(ElementScene& scene, const Corners& next) {
  for (std::size_t i = 0; i < 8; ++i) {
    scene.velocity[i] = (1 / scene.dt) * (next[i] - scene.position[i]);
    scene.position[i] = next[i];
  }
}

}  // namespace pinball::test
