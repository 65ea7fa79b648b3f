#pragma once

#include <solver/results.hpp>

#include "solver.hpp"

namespace pinball {

/// Fills in what tells how far the results of a run can be believed: watched energies, the deepest penetration, and
/// what was wrong from the start.
template <class S>
void fill_soundness(const Solver<S>& solver, RunSummary& summary);

}  // namespace pinball
