#pragma once

#include <solver/scene/units/units.hpp>
#include <solver/step/solver.hpp>

namespace pinball {

/// What has been spent, as run does, too.
struct SpentSoFar {
  double program = 0;  ///< until the command began [s]
  double built = 0;    ///< until the solver was there [s]
};

/// Makes steps for at most a twentieth of a second, and says how many there will be and how long the run will take,
/// from the start of the program to the last file.
template <class S>
void print_cost(Solver<S>& solver, const Units& units, const SpentSoFar& spent);

/// Time that this process has had processors, all threads together [s].
double processor_seconds();

}  // namespace pinball
