#pragma once

#include <optional>
#include <string>

#include <solver/scene.hpp>

#include "costs/study_limits.hpp"
#include "run_results.hpp"

/// The runs of a study, each in a folder of its own, which is not made twice.
namespace pinball {

struct StudyFolder {
  std::string out;  ///< of the study
  int threads = 0;  ///< 0: what the size earns
  bool quiet = false;
  int states = 0;                       ///< of which fields are written, evenly spaced over the run; of one, the end
  const StudyBudget* budget = nullptr;  ///< none: runs may take any time
};

struct StudyRun {
  std::string folder;
  bool was_there = false;               ///< its results were found, not made
  bool stopped = false;                 ///< by a signal, before its end
  std::string failure;                  ///< what ended it; empty: it came to its end
  std::string left_out{};               ///< why it was not begun; empty: it was
  std::optional<RunResults> results{};  ///< of a run that came to its end
};

/// All that makes a run of the scene the same as another one: keys but those of field output, what its mesh files hold,
/// version and device.
std::string study_settings_text(const Scene& scene);

/// Runs the scene in OUT/NAME, without field output but for the states that are asked for, and leaves
/// study_settings.txt beside its results: all keys of the scene, what its mesh files hold, the version and the device.
/// Where that is there already, and the run was done, it reads the results instead. A run that fails, or that a signal
/// ends, is reported and made again the next time. Throws InputError for a scene that cannot be run. what: for the line
/// that says which run it is. expected: what it will take [s]; where the budget has less left, it is left out. None:
/// nothing is known of it, and it is made.
StudyRun make_study_run(const Scene& scene, const std::string& name, const std::string& what, const StudyFolder& folder,
                        std::optional<double> expected = {});

/// What such a run will leave, by its names. Throws InputError as well.
RunResults study_results_to_come(const Scene& scene, const StudyFolder& folder);

}  // namespace pinball
