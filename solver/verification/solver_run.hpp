#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <solver/step/report.hpp>

/// Runs of a solver, and what is looked at in them, by the numbers that nodes and elements have in the scene.
namespace pinball {

/// To the end of the scene, with everything brought to one time; calls `after_step` after each step.
void run_to_end(
    Solver<double>& solver, const std::function<void()>& after_step = [] {});

/// Moves nodes along a path that is known beforehand: after each step their positions are those of the path, their
/// velocities those that lead from one position to the next. The solver then computes strains, stresses and the forces
/// on the remaining nodes. The work that this takes is in no energy: the scene's guard.energy_error must be wide.
class PrescribedMotion {
 public:
  /// Place at a time of the node that began at `start`.
  using Path = std::function<Point(const Point& start, double time)>;

  /// nodes: of the scene; empty: all.
  PrescribedMotion(Solver<double>& solver, Path path, std::vector<std::int32_t> nodes = {});

  /// One step of the solver, then the prescribed nodes are put in their places.
  void step();

 private:
  Solver<double>& solver_;
  Path path_;
  std::vector<std::int32_t> nodes_;
};

/// Stress of an element: xx yy zz xy yz zx [stress].
std::array<double, 6> stress_of(const Solver<double>& solver, std::size_t element);

/// Position and velocity of a node, as the store has them [length], [length/time].
Point position_of(const Solver<double>& solver, std::size_t node);
Point velocity_of(const Solver<double>& solver, std::size_t node);

/// Sum of m x cross v about the origin; exact after finish(), when positions and velocities belong to one time.
Point angular_momentum(const Solver<double>& solver);

}  // namespace pinball
