#include <pinball/solver/error.hpp>
#include <pinball/solver/progress.hpp>
#include <pinball/solver/recorder.hpp>
#include <pinball/solver/simulation.hpp>
#include <pinball/solver/solver.hpp>
#include <pinball/solver/summary.hpp>

namespace pinball {

namespace {

template <class S>
RunSummary run_to_end(const Scene& scene, const SimulationOptions& options) {
  Solver<S> solver(scene);
  Recorder<S> recorder(scene, solver, options);
  Progress progress({scene.time.end, scene.time.steps, scene.units, options.quiet});
  RunSummary summary;
  const auto finish_summary = [&] {
    summary.wall_seconds = recorder.wall_seconds();
    solver.fill_summary(summary);
    if (!options.out.empty()) write_summary(options.out, summary);
  };
  try {
    while (!solver.at_end()) {
      solver.step();
      solver.timers().measure(Phase::output, [&] {
        recorder.record(solver, false);
        recorder.checkpoint(solver, solver.at_end());
      });
      progress.update(solver.progress_state());
    }
    solver.finish();
    solver.timers().measure(Phase::output, [&] { recorder.record(solver, true); });
    progress.finish(solver.progress_state());
  } catch (const RunError& error) {
    finish_summary();
    throw RunError(error.what() + recorder.save_last_good(solver));
  }
  finish_summary();
  return summary;
}

}  // namespace

RunSummary simulate(const Scene& scene, const SimulationOptions& options) {
  return scene.precision == Precision::float32 ? run_to_end<float>(scene, options) : run_to_end<double>(scene, options);
}

}  // namespace pinball
