#pragma once

#include <string>

#include "base/export.h"
#include "field_base.hpp"
#include "results.hpp"
#include "scene.hpp"

namespace pinball {

/// What the page of a run tells besides its results.
struct RunPageSettings {
  std::string error{};                  ///< what ended the run; empty: nothing did
  const SceneSource* source = nullptr;  ///< for the text of the scene and the command that repeats the run; may be none
  std::string converged{};              ///< as of RecordOptions
  /// What the page shows of the bodies where the folder has no fields; null: nothing.
  const FieldSnapshot* last = nullptr;
  const FieldBase* base = nullptr;
};

/// Writes FOLDER/index.html, one file that shows the run in a browser: figures, warnings, the bodies at the times of
/// FOLDER/fields.pvd, curves of FOLDER/history.csv, where these are there, bodies, times, what was skipped and the
/// scene with every default. It appears complete or not at all. `scene`: completed, as Simulation::scene() is. Throws
/// RunError that names the file.
PINBALL_API void write_run_page(const std::string& folder, const Scene& scene, const RunSummary& summary,
                                const RunPageSettings& settings = {});

}  // namespace pinball
