#pragma once

#include <array>
#include <memory>

#include <solver/verification/solver_run.hpp>
#include <tests/support/solver_case.hpp>

namespace pinball::test {

/// Stretches of the edges over the part of a run, from 0 to 1.
using Way = std::array<double, 3> (*)(double part);

inline constexpr std::array<Point, 3> along_edges{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};

/// A cube of one element that is stretched along its edges, or along other orthogonal axes. look(solver, time, dt):
/// after each step, the time of its stress, and since that of the one before. Returns the solver as it is at the end.
template <class Look>
std::unique_ptr<Solver<double>> stretch_cube(const Material& material, Way way, double end, const Look& look,
                                             const std::array<Point, 3>& axes = along_edges) {
  Scene scene = scene_of({block("cube", {1, 1, 1}, 0.01, {0, 0, 0})}, end, false);
  scene.materials = {material};
  scene.element.bulk_viscosity = false;
  scene.guard.energy_error = 1e30;
  auto solver = std::make_unique<Solver<double>>(scene);
  PrescribedMotion motion(*solver, [&](const Point& start, double time) {
    const std::array<double, 3> stretch = way(time / end);
    Point now{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = stretch[k] * (start[0] * axes[k][0] + start[1] * axes[k][1] + start[2] * axes[k][2]);
      for (std::size_t i = 0; i < 3; ++i) now[i] += along * axes[k][i];
    }
    return now;
  });
  double before = 0;
  while (!solver->at_end()) {
    motion.step();
    const double now = solver->force_time();
    look(*solver, now, now - before);
    before = now;
  }
  return solver;
}

}  // namespace pinball::test
