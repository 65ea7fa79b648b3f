#pragma once

#include <solver/scene/units/units.hpp>
#include <solver/step/solver.hpp>

namespace pinball {

/// Makes steps for at most half a second, and says how many there will be and how long the run will take; of a run that
/// this is enough for, how long it took.
template <class S>
void print_cost(Solver<S>& solver, const Units& units);

}  // namespace pinball
