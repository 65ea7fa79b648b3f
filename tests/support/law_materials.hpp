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
