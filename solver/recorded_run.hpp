#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/export.h"
#include "results.hpp"
#include "scene.hpp"

namespace pinball {

struct Checkpoint;  // solver/output/checkpoint.hpp: not for hosts
class Ranks;        // solver/parallel/ranks.hpp: not for hosts

/// What is known of the deck of another program that a scene is made of: for summary.json and checkpoints.
struct DeckNotes {
  std::vector<std::string> lines;  ///< what was made of what, and what of it is ignored
};

/// What a recorded run writes, and from what it goes on.
struct RecordOptions {
  std::string out;                    ///< folder for the results; empty: nothing is written
  bool quiet = false;                 ///< no progress, and no notes on what was read
  std::int64_t checkpoint_every = 0;  ///< steps, or cycles of them with subcycling, between checkpoints; 0: none
  /// What the scene was read from, unchanged since: checkpoints and a last good state to restart from need it.
  const SceneSource* source = nullptr;
  /// The state to go on from; the scene is then that of its source.
  const Checkpoint* restart = nullptr;
  /// Asked after each step: whether the run is to end there, with all its files and, where `source` is known, a
  /// checkpoint.pinball to go on from with the same bits. Empty: it goes on to its end.
  std::function<bool()> stop{};
  /// Of a run that goes on from a checkpoint (restart.hpp): where it does. Other runs: where their scene says.
  Device device = Device::none;
  int threads = 0;  ///< as in SimulationOptions
  /// As in SimulationOptions. Ranks other than 0 write nothing but pieces, and return when rank 0 has no more to do.
  Ranks* ranks = nullptr;
  /// Several ranks each write their piece of the fields, into a folder that all of them see, in place of rank 0.
  bool pieces = false;
  DeckNotes deck{};     ///< of a scene that is made of one; a restart has its own
  bool silent = false;  ///< nor warnings: for a host that tells them itself
  /// JSON of error bands of the scene's numbers, for summary and page; empty: none are known.
  std::string converged{};
};

/// Runs a scene to its end and writes history, fields and summary into the folder, and checkpoint.pinball if asked for.
/// What an earlier run has left there is removed; no other run can write there meanwhile. summary.json is there from
/// the beginning and says whether the run goes on, is done, was stopped or has failed. Returns what it says at the end.
/// Throws InputError, and leaves the folder as it was, where the scene cannot be run or the folder not be used. A run
/// that fails throws RunError, after the summary so far and the last good state were written: last_good.vtu, and
/// last_good.pinball to restart from.
PINBALL_API RunSummary run_recorded(const Scene& scene, const RecordOptions& options);

}  // namespace pinball
