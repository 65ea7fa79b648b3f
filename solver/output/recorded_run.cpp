#include <fmt/core.h>

#include <solver/base/error.hpp>
#include <solver/recorded_run.hpp>
#include <solver/results/warnings.hpp>
#include <solver/run_page.hpp>
#include <solver/summary.hpp>

#include "progress.hpp"
#include "recorder.hpp"

namespace pinball {

RunSummary run_recorded(const Scene& scene, const RecordOptions& options) {
  Simulation simulation(scene);
  Recorder recorder(simulation, options);
  if (!options.quiet) {
    for (const std::string& warning : start_warnings(simulation.summary())) {
      fmt::print(stderr, "pinball: warning: {}\n", warning);
    }
  }
  Progress progress({scene.time.end, scene.time.steps, scene.units, options.quiet});
  simulation.on_step([&](Simulation& s) {
    recorder.record(s, s.complete());
    if (!s.complete()) recorder.checkpoint(s, s.at_end());
    if (s.complete()) {
      progress.finish(s.progress());
    } else {
      progress.update(s.progress());
    }
    return AfterStep::go_on;
  });
  const auto finish_summary = [&](const std::string& error) {
    RunSummary summary = simulation.summary();
    summary.wall_seconds = recorder.wall_seconds();
    if (!options.out.empty()) {
      write_summary(options.out, summary);
      write_run_page(options.out, simulation.scene(), summary, {error, options.source});
    }
    return summary;
  };
  try {
    simulation.run();
  } catch (const RunError& error) {
    finish_summary(error.what());
    throw RunError(error.what() + recorder.save_last_good(simulation));
  }
  return finish_summary("");
}

}  // namespace pinball
