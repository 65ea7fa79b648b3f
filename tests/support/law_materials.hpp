#pragma once

#include "solver_case.hpp"

/// Materials of laws that the kernels for linear hardening do not have.
namespace pinball::test {

inline Material rubber() {
  Material m;
  m.name = "rubber";
  m.density = 1100;
  m.mooney_rivlin = MooneyRivlinSettings{3e5, 1e5, 0.49};
  return m;
}

/// Of another stiffness along each of its axes, which lie across those of the scene.
inline Material orthotropic() {
  Material m;
  m.name = "wood";
  m.density = 7850;
  m.orthotropic = OrthotropicSettings{
      {2.1e11, 1.2e11, 0.8e11}, {0.3, 0.35, 0.25}, {0.5e11, 0.6e11, 0.3e11}, {1, 0.5, 0.2}, {0, 1, 1}};
  return m;
}

/// Mie-Grueneisen.
inline Material with_equation_of_state() {
  Material m = plastic_material("metal", 3e8, 0);
  m.equation_of_state.emplace();
  m.equation_of_state->sound_speed = 4500;
  m.equation_of_state->slopes = {1.5, 0, 0};
  m.equation_of_state->gamma = 2;
  return m;
}

}  // namespace pinball::test
