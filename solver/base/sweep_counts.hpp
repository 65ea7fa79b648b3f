#pragma once

#include <algorithm>
#include <cstdint>

namespace pinball {

/// Sweeps that the impulses of contact took.
struct SweepCounts {
  std::int64_t solutions = 0;  ///< systems that were swept over: steps with something to solve
  std::int64_t sweeps = 0;     ///< of all of them
  std::int64_t largest = 0;    ///< number of sweeps of one
  std::int64_t at_bound = 0;   ///< solutions that ended at the bound of the number of sweeps
  std::int64_t unsolved = 0;   ///< those of them whose last sweep still changed velocities by more than a hundredth
  double residual = 0;         ///< largest change of a velocity by the last sweep of a solution [length/time]
  double relative = 0;         ///< the same over the largest velocity that its system had to change [-]

  /// A solution; none if it had no sweeps.
  void add(std::int64_t count, bool met_bound, bool left_unsolved, double left, double scale) {
    if (count == 0) return;
    *this += {1, count, count, met_bound ? 1 : 0, left_unsolved ? 1 : 0, left, scale > 0 ? left / scale : 0.0};
  }
  SweepCounts& operator+=(const SweepCounts& other) {
    solutions += other.solutions;
    sweeps += other.sweeps;
    largest = std::max(largest, other.largest);
    at_bound += other.at_bound;
    unsolved += other.unsolved;
    residual = std::max(residual, other.residual);
    relative = std::max(relative, other.relative);
    return *this;
  }
  double mean() const { return solutions > 0 ? static_cast<double>(sweeps) / static_cast<double>(solutions) : 0.0; }
};

}  // namespace pinball
