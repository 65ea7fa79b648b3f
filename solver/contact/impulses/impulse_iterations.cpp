#include "impulse_iterations.hpp"

#include <algorithm>

#include "island_solution.hpp"

namespace pinball {

namespace {

/// Rows of a system from which on threads share its islands.
constexpr std::int32_t rows_of_islands_to_share = 256;

using island::IslandSolution;

}  // namespace

void ImpulseIterations::reset(const RowSystem& system) {
  const std::size_t rows = system.size();
  for (Records* records :
       {&impulse_, &sought_, &gradient_, &step_, &of_step_, &direction_, &of_direction_, &residual_, &trial_}) {
    records->renew(4 * rows);
  }
  freedom_.renew(rows);
  free_.renew(rows);
  before_.renew(rows);
}

ImpulseIterations::Result ImpulseIterations::solve(const RowSystem& system, double* velocity) {
  const std::span<const Island> islands = system.islands();
  change_.renew(4 * system.places());
  results_.assign(islands.size(), {});
  const auto solve_one = [&](std::size_t i) {
    results_[i] = islands[i].rubs ? IslandSolution<true>(system, *this, islands[i], velocity).solve()
                                  : IslandSolution<false>(system, *this, islands[i], velocity).solve();
  };
  // Small islands by one thread each, in pieces of about as many rows; large ones by all threads, one after the other.
  const auto solve_piece = [&](std::int64_t piece) {
    const std::int64_t rows = system.size();
    const auto begin = rows * piece / fixed_pieces, end = rows * (piece + 1) / fixed_pieces;
    const auto after = [](const Island& island, std::int64_t row) { return island.first_row < row; };
    std::size_t i = std::lower_bound(islands.begin(), islands.end(), begin, after) - islands.begin();
    for (; i < islands.size() && islands[i].first_row < end; ++i) {
      if (islands[i].rows() < rows_to_share) solve_one(i);
    }
  };
  if (system.size() < rows_of_islands_to_share) {
    parallel_for("islands of rows", RangePolicy<Serial>{0, fixed_pieces}, solve_piece);
  } else {
    parallel_for("islands of rows", RangePolicy<>{0, fixed_pieces}, solve_piece);
  }
  for (std::size_t i = 0; i < islands.size(); ++i) {
    if (islands[i].rows() >= rows_to_share) solve_one(i);
  }
  Result all;
  for (const Result& one : results_) {
    all.steps = std::max(all.steps, one.steps);
    all.converged = all.converged && one.converged;
    if (one.residual * all.scale > all.residual * one.scale || all.scale == 0) {
      all.residual = one.residual;
      all.scale = one.scale;
    }
  }
  return all;
}

std::size_t ImpulseIterations::bytes() const {
  std::size_t sum =
      freedom_.bytes() + free_.bytes() + before_.bytes() + results_.capacity() * sizeof(results_[0]) + change_.bytes();
  for (const Records* records :
       {&impulse_, &sought_, &gradient_, &step_, &of_step_, &direction_, &of_direction_, &residual_, &trial_}) {
    sum += records->bytes();
  }
  return sum;
}

}  // namespace pinball
