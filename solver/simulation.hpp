#pragma once

#include <cstdio>
#include <pinball/solver/results.hpp>
#include <pinball/solver/scene.hpp>
#include <string>

namespace pinball {

struct SimulationOptions {
  std::string out;     ///< folder for the results; empty: nothing is written
  bool quiet = false;  ///< no progress
};

/// Runs a scene to its end and writes history, fields and summary into the folder.
/// A run that fails throws RunError, after the last good state (last_good.vtu) and the summary so far were written.
RunSummary simulate(const Scene& scene, const SimulationOptions& options);

}  // namespace pinball
