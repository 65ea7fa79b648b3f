#pragma once

#include <string>
#include <vector>

#include <solver/results.hpp>

namespace pinball {

/// Warnings about the results of a run that went to its end, each with number, time and place; empty for a sound run.
/// Bounds are those of sound_bounds.hpp: the energy balance (guard.energy_error stops a run where it is off by more
/// still), energy that contact made or swallowed, hourglass energy, contact that let bodies go into each other although
/// nothing eroded, impulses that were not solved for; and all of start_warnings().
std::vector<std::string> warnings(const RunSummary& summary);

/// Those that are known before the first step: what is wrong with meshes of files, what nobody is likely to mean,
/// bodies that overlap, balls that cannot see what they should, steps that hourglass control and added masses are too
/// large for, and what the chosen form of contact cannot do.
std::vector<std::string> start_warnings(const RunSummary& summary);

/// The mass that is added, in total and of each body, also in percent; empty: none is.
std::string added_mass_text(const RunSummary& summary);
/// What a tied contact has found: "glue: 25 nodes are tied, 3 lie near and are not".
std::string tied_text(const TiedResult& tied);

}  // namespace pinball
