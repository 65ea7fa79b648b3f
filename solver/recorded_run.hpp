#pragma once

#include <cstdint>
#include <string>

#include "base/export.h"
#include "results.hpp"
#include "scene.hpp"

namespace pinball {

struct Checkpoint;  // solver/output/checkpoint.hpp: not for hosts

/// What a recorded run writes, and from what it goes on.
struct RecordOptions {
  std::string out;                    ///< folder for the results; empty: nothing is written
  bool quiet = false;                 ///< no progress
  std::int64_t checkpoint_every = 0;  ///< steps, or cycles of them with subcycling, between checkpoints; 0: none
  /// What the scene was read from, unchanged since: checkpoints and a last good state to restart from need it.
  const SceneSource* source = nullptr;
  /// The state to go on from; the scene is then that of its source.
  const Checkpoint* restart = nullptr;
};

/// Runs a scene to its end and writes history, fields and summary into the folder, and checkpoint.pinball if asked for.
/// A run that fails throws RunError, after the summary so far and the last good state were written: last_good.vtu, and
/// last_good.pinball to restart from.
PINBALL_API RunSummary run_recorded(const Scene& scene, const RecordOptions& options);

}  // namespace pinball
