#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <pinball/solver/error.hpp>
#include <pinball/solver/field_output.hpp>
#include <pinball/solver/history.hpp>
#include <pinball/solver/progress.hpp>
#include <pinball/solver/simulation.hpp>
#include <pinball/solver/solver.hpp>
#include <pinball/solver/summary.hpp>

namespace pinball {

namespace {

using Clock = std::chrono::steady_clock;

/// The next of a sequence of output times: every interval, or a list.
class Schedule {
 public:
  Schedule(double interval, std::vector<double> times) : interval_(interval), times_(std::move(times)) {}

  bool due(double time) const {
    const double tolerance = 1e-9 * interval_;
    return (interval_ > 0 && time >= static_cast<double>(count_) * interval_ - tolerance) ||
           (next_ < times_.size() && time >= times_[next_]);
  }
  void passed(double time) {
    if (interval_ > 0) {
      while (time >= static_cast<double>(count_) * interval_ - 1e-9 * interval_) ++count_;
    }
    while (next_ < times_.size() && time >= times_[next_]) ++next_;
  }

 private:
  double interval_;
  std::vector<double> times_;
  std::int64_t count_ = 0;
  std::size_t next_ = 0;
};

/// What a running scene writes; nothing for an empty folder.
template <class S>
class Recorder {
 public:
  Recorder(const Scene& scene, const Solver<S>& solver, const std::string& folder)
      : folder_(folder),
        history_times_(scene.output.interval > 0 ? scene.output.interval : scene.time.end / 200, {}),
        every_step_(scene.output.every_step),
        field_times_(scene.output.field_interval, scene.output.field_times),
        units_(scene.units) {
    if (folder.empty()) return;
    std::filesystem::create_directories(folder);
    std::filesystem::remove(std::filesystem::path(folder) / "last_good.vtu");
    history_ = std::make_unique<HistoryWriter>(folder, solver.model().mesh.body_names, units_, solver.more_columns());
    if (scene.output.field_interval > 0 || !scene.output.field_times.empty()) {
      fields_ = std::make_unique<FieldWriter>(folder, "fields", scene.output.fields, units_);
    }
  }

  /// Called after each step; last: also writes what is not due.
  void record(const Solver<S>& solver, bool last) {
    const double time = solver.force_time();
    if (history_ && (last || every_step_ || history_times_.due(time))) {
      history_->write(solver.history_row());
      history_times_.passed(time);
      if (!fields_ || !field_times_.due(time)) keep_state(solver);
    }
    if (fields_ && field_times_.due(time)) {
      solver.snapshot(last_good_);  // never two copies: one is a third of the stores
      fields_->write(last_good_);
      field_times_.passed(time);
    }
  }

  /// Keeps a copy of the state as the last good one, as often as costs little: at most 5 % of the run's time.
  void keep_state(const Solver<S>& solver) {
    const auto start = Clock::now();
    if (start < next_copy_) return;
    solver.snapshot(last_good_);
    next_copy_ = Clock::now() + 20 * (Clock::now() - start);
  }

  /// Saves the state that was kept; returns the name of the file.
  std::string save_last_good() const {
    return history_ && !last_good_.position.empty() ? write_last_good_state(folder_, last_good_, units_) : "";
  }

 private:
  std::string folder_;
  Schedule history_times_;
  bool every_step_;
  Schedule field_times_;
  std::string units_;
  std::unique_ptr<HistoryWriter> history_;
  std::unique_ptr<FieldWriter> fields_;
  FieldSnapshot last_good_;
  Clock::time_point next_copy_{};
};

template <class S>
RunSummary run_to_end(const Scene& scene, const SimulationOptions& options) {
  Solver<S> solver(scene);
  Recorder<S> recorder(scene, solver, options.out);
  Progress progress({scene.time.end, scene.time.steps, scene.units, options.quiet});
  const auto start = Clock::now();
  RunSummary summary;
  const auto finish_summary = [&] {
    summary.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    solver.fill_summary(summary);
    if (!options.out.empty()) write_summary(options.out, summary);
  };
  try {
    while (!solver.at_end()) {
      solver.step();
      solver.timers().measure(Phase::output, [&] { recorder.record(solver, false); });
      progress.update(solver.progress_state());
    }
    solver.finish();
    solver.timers().measure(Phase::output, [&] { recorder.record(solver, true); });
    progress.finish(solver.progress_state());
  } catch (const RunError& error) {
    finish_summary();
    const std::string saved = recorder.save_last_good();
    throw RunError(saved.empty() ? std::string(error.what())
                                 : fmt::format("{}; the last good state is in {}", error.what(), saved));
  }
  finish_summary();
  return summary;
}

}  // namespace

RunSummary simulate(const Scene& scene, const SimulationOptions& options) {
  return scene.precision == Precision::float32 ? run_to_end<float>(scene, options) : run_to_end<double>(scene, options);
}

}  // namespace pinball
