#pragma once

#include <string>
#include <vector>

#include <solver/results.hpp>

namespace pinball {

/// Warnings about the results of a run that went to its end: an error of the energy balance above 10 %
/// (guard.energy_error stops a run where it is larger still), contact that let bodies go into each other by more than a
/// quarter of their pinballs although nothing eroded, bodies that overlapped at the start. Empty for a sound run.
std::vector<std::string> warnings(const RunSummary& summary);

}  // namespace pinball
