#pragma once

#include <solver/scene/units/units.hpp>
#include <solver/step/solver.hpp>

namespace pinball {

/// One line per thing that this scene does not pay for, with the reason. solver: before its first step.
template <class S>
void print_what_is_skipped(const Solver<S>& solver, const Units& units);

}  // namespace pinball
