#pragma once

#include <string>
#include <vector>

#include "base/export.h"
#include "recorded_run.hpp"
#include "simulation.hpp"

/// Runs that go on from a file: a checkpoint as `pinball run` writes it and goes on from. It holds the text of its
/// scene.
namespace pinball {

/// Writes the state between two steps; the file appears complete or not at all. source: what the simulation's scene was
/// read from, unchanged since. A run that goes on from it writes to another folder. Throws RunError where the file
/// cannot be written.
PINBALL_API void save_checkpoint(const std::string& path, Simulation& simulation, const SceneSource& source);

/// What the scene of a checkpoint is read from. set: "KEY=VALUE" of time.end, time.steps, time.cfl, output.* but
/// body_energies, or guard.*. Throws InputError for a file that is damaged or of another kind, other keys, and mesh
/// files that have changed.
PINBALL_API SceneSource scene_of_checkpoint(const std::string& path, const std::vector<std::string>& set = {});

/// Brings a simulation of that scene to the state. Throws InputError where it does not fit.
PINBALL_API void load_checkpoint(const std::string& path, Simulation& simulation);

/// Where a run that goes on from a checkpoint writes, if nothing else is said.
PINBALL_API std::string folder_of_checkpoint(const std::string& path);

/// run_recorded() from a checkpoint on, as `pinball run --restart`. options.out: empty: folder_of_checkpoint();
/// options.source and options.restart are not looked at.
PINBALL_API RunSummary restart_recorded(const std::string& path, const std::vector<std::string>& set,
                                        const RecordOptions& options);

}  // namespace pinball
