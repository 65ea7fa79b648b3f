#pragma once

#include <algorithm>
#include <cstdint>

namespace pinball {

/// Iterations that the impulses of contact took: products with their matrix, of the island of rows that took the most.
struct IterationCounts {
  std::int64_t solutions = 0;   ///< systems that were solved: steps with something to solve
  std::int64_t iterations = 0;  ///< of all of them
  std::int64_t largest = 0;     ///< of one solution
  std::int64_t at_bound = 0;    ///< solutions that had not converged at the bound of that number
  std::int64_t unsolved = 0;    ///< those of them that left more than a hundredth of what they had to change
  double residual = 0;          ///< largest velocity that a solution left [length/time]
  double relative = 0;          ///< the same over the largest that its island had to change [-]

  /// A solution; none if it had no iterations.
  void add(std::int64_t count, bool met_bound, bool left_unsolved, double left, double scale) {
    if (count == 0) return;
    *this += {1, count, count, met_bound ? 1 : 0, left_unsolved ? 1 : 0, left, scale > 0 ? left / scale : 0.0};
  }
  IterationCounts& operator+=(const IterationCounts& other) {
    solutions += other.solutions;
    iterations += other.iterations;
    largest = std::max(largest, other.largest);
    at_bound += other.at_bound;
    unsolved += other.unsolved;
    residual = std::max(residual, other.residual);
    relative = std::max(relative, other.relative);
    return *this;
  }
  double mean() const { return solutions > 0 ? static_cast<double>(iterations) / static_cast<double>(solutions) : 0.0; }
};

}  // namespace pinball
