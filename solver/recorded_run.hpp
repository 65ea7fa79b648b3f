#pragma once

#include <pinball/solver/recorder.hpp>

namespace pinball {

/// Runs a scene to its end and writes history, fields and summary into the folder, and checkpoint.pinball if asked for.
/// A run that fails throws RunError, after the summary so far and the last good state were written: last_good.vtu, and
/// last_good.pinball to restart from.
PINBALL_API RunSummary run_recorded(const Scene& scene, const RecordOptions& options);

}  // namespace pinball
