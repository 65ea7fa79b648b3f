#pragma once

#include <cstdint>
#include <utility>

#include <solver/step/report.hpp>

#include "solver_case.hpp"

/// Materials of laws that the kernels for linear hardening do not have, and what is asked of bodies of them.
namespace pinball::test {

/// Sum over the nodes at the end of a run [length].
template <class S>
double height_at_end(const Scene& scene) {
  Solver<S> solver(scene);
  run(solver);
  double sum = 0;
  for (const Point& x : snapshot(solver).position) sum += x[2];
  return sum;
}

/// Of the state at the end of a run by so many threads.
inline std::uint64_t hash_of_threads(const Scene& scene, int threads) {
  DefaultExecutionSpace::set_concurrency(threads);
  Solver<double> solver(scene);
  run(solver);
  DefaultExecutionSpace::set_concurrency(1);
  return state_hash(std::as_const(solver).model());
}

inline Material rubber() {
  Material m;
  m.name = "rubber";
  m.density = 1100;
  m.mooney_rivlin = MooneyRivlinSettings{3e5, 1e5, 0.49};
  return m;
}

/// The same stresses of shape, by powers of stretches: m = 2 A and -2 B of 2 and -2.
inline Material rubber_of_powers() {
  Material m;
  m.name = "rubber";
  m.density = 1100;
  m.ogden = OgdenSettings{{6e5, -2e5}, {2, -2}, 0.49, false};
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
