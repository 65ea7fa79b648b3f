#include "comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <solver/base/error.hpp>
#include <solver/base/thread_count.hpp>
#include <solver/output/history.hpp>
#include <solver/output/page/surface/surface_block.hpp>
#include <solver/output/progress.hpp>
#include <solver/scene_rules.hpp>
#include <solver/simulation/base_of_fields.hpp>
#include <solver/step/report.hpp>
#include <solver/summary.hpp>

#include "momentum_error.hpp"
#include "shown_states.hpp"

namespace pinball {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double shortest_turn = 1.0 / 50;                   ///< of a run
constexpr double between_frames = 1.0 / (shown_states - 1);  ///< of a run
constexpr double fewest_steps = 4;  ///< of a turn: at its begin the caches hold another variant's data

/// A solver of either precision.
class AnySolver {
 public:
  virtual ~AnySolver() = default;
  virtual std::int64_t elements() const = 0;
  virtual bool at_end() const = 0;
  virtual void step() = 0;
  virtual void finish() = 0;
  virtual ProgressState state() const = 0;
  virtual std::vector<double> numbers() const = 0;  ///< of a row of history.csv
  virtual std::vector<std::string> columns() const = 0;
  virtual void fill_summary(RunSummary& summary) const = 0;
  virtual FieldSnapshot snapshot() const = 0;
  virtual FieldBase base() const = 0;
};

template <class S>
class SolverOf final : public AnySolver {
 public:
  explicit SolverOf(const Scene& scene) : solver_(scene) {}
  std::int64_t elements() const override { return solver_.element_count(); }
  bool at_end() const override { return solver_.at_end(); }
  void step() override { solver_.step(); }
  void finish() override { solver_.finish(); }
  ProgressState state() const override { return progress_state(solver_); }
  std::vector<double> numbers() const override { return history_numbers(history_row(solver_)); }
  std::vector<std::string> columns() const override {
    return history_column_names(names_of(solver_.scene().bodies), more_columns(solver_));
  }
  void fill_summary(RunSummary& summary) const override { pinball::fill_summary(solver_, summary); }
  FieldSnapshot snapshot() const override { return pinball::snapshot(solver_); }
  FieldBase base() const override { return base_of_fields(solver_.mesh()); }

 private:
  Solver<S> solver_;
};

std::unique_ptr<AnySolver> make_solver(const Scene& scene) {
  if (scene.precision == Precision::float32) return std::make_unique<SolverOf<float>>(scene);
  return std::make_unique<SolverOf<double>>(scene);
}

/// One variant on its way to its end.
class RunningVariant {
 public:
  RunningVariant(const Scene& scene, int rows)
      : solver_(make_solver(scene)),
        limits_{scene.time.end, scene.time.steps, scene.units, false},
        bodies_(names_of(scene.bodies)),
        record_(rows > 0),
        between_rows_(1.0 / std::max(rows, 1)) {
    if (record_) curves_.columns = solver_->columns();
  }

  void keep_frames() { frames_due_ = true; }

  bool active() const { return active_; }
  std::int64_t elements() const { return solver_->elements(); }
  ProgressState state() const { return solver_->state(); }
  double done() const { return fraction_done(limits_, solver_->state()); }
  /// Mean part of the run that a step has been.
  double done_per_step() const {
    const std::int64_t steps = solver_->state().step;
    return steps > 0 ? done() / steps : 0.0;
  }

  /// Its turn: steps until this part of the run is done.
  void advance(double part) {
    try {
      while (!solver_->at_end() && done() < part) {
        run([this, part] { step_until(record_ ? std::min(part, next_row_) : part); });
        if (record_ && done() >= next_row_) record();
      }
      if (solver_->at_end()) {
        run([this] { solver_->finish(); });
        active_ = false;
        if (record_) record();
      }
    } catch (const RunError& error) {
      failure_ = error.what();
      active_ = false;
    }
  }

  const Curves& curves() const { return curves_; }
  std::string surface() const {
    if (!record_) return "";
    if (frames_.empty()) return "null";
    const FieldBase base = solver_->base();
    FrameSource source;
    for (const FieldSnapshot& frame : frames_) source.times.push_back(frame.time);
    source.frame = [&](std::size_t i) { return FieldFrame::of_snapshot(frames_[i], base); };
    return surface_json_of_frames(source, bodies_);
  }
  LastState last() const { return record_ ? last_state(solver_->snapshot(), solver_->base()) : LastState{}; }
  const std::string& failure() const { return failure_; }
  RunSummary summary() const {
    RunSummary summary;
    summary.wall_seconds = seconds_;
    solver_->fill_summary(summary);
    summary.status = failure_.empty() ? RunStatus::done : RunStatus::failed;
    summary.error = failure_;
    return summary;
  }

 private:
  /// Also what fails has taken time.
  template <class Work>
  void run(const Work& work) {
    struct Stop {
      double& seconds;
      Clock::time_point start;
      ~Stop() { seconds += std::chrono::duration<double>(Clock::now() - start).count(); }
    };
    const Stop stop{seconds_, Clock::now()};
    work();
  }
  /// At least one step, so that the first row of curves is that of the first.
  void step_until(double part) {
    do {
      solver_->step();
    } while (!solver_->at_end() && done() < part);
  }
  /// A row of the curves, in time that is not the variant's.
  void record() {
    curves_.rows.push_back(solver_->numbers());
    curves_.all_rows = curves_.rows.size();
    next_row_ = (std::floor(done() / between_rows_) + 1) * between_rows_;
    if (!frames_due_ || (active_ && done() < next_frame_)) return;
    frames_.push_back(solver_->snapshot());
    next_frame_ = (std::floor(done() / between_frames) + 1) * between_frames;
  }

  std::unique_ptr<AnySolver> solver_;
  ProgressSettings limits_;
  std::vector<std::string> bodies_;
  bool record_;
  double between_rows_;  ///< part of a run
  Curves curves_;
  std::vector<FieldSnapshot> frames_;
  bool frames_due_ = false;
  double next_frame_ = 0;  ///< part of the run at which the next one is due
  double next_row_ = 0;    ///< part of the run at which the next row is due
  bool active_ = true;
  double seconds_ = 0;
  std::string failure_;
};

/// Runs all variants to their ends, side by side.
class Race {
 public:
  /// rows: of the curves of each; 0: none are kept.
  Race(const std::vector<Variant>& variants, int rows) {
    for (const Variant& variant : variants) {
      try {
        runs_.emplace_back(variant.scene, rows);
      } catch (const InputError& error) {  // what only the mesh shows to be wrong
        if (variant.settings.empty()) throw;
        throw InputError(fmt::format("{} (with {})", error.what(), name_of(variant.settings)));
      }
    }
    if (all_elements() > most_elements_shown) return;
    for (RunningVariant& run : runs_) run.keep_frames();
  }

  void run(Progress& progress) {
    progress.begin(runs_.front().state());
    bool forwards = true;
    for (double part = 0; active(); forwards = !forwards) {
      part += turn();
      for (std::size_t i = 0; i < runs_.size(); ++i) {
        RunningVariant& run = runs_[forwards ? i : runs_.size() - 1 - i];
        if (run.active()) run.advance(part);
      }
      progress.update(runs_.front().state());
    }
    progress.finish(runs_.front().state());
  }

  const std::vector<RunningVariant>& runs() const { return runs_; }
  std::int64_t all_elements() const {
    std::int64_t all = 0;
    for (const RunningVariant& run : runs_) all += run.elements();
    return all;
  }
  std::int64_t most_elements() const {
    std::int64_t most = 0;
    for (const RunningVariant& run : runs_) most = std::max(most, run.elements());
    return most;
  }

 private:
  bool active() const {
    return std::any_of(runs_.begin(), runs_.end(), [](const RunningVariant& run) { return run.active(); });
  }

  /// The part of a run that is each variant's turn.
  double turn() const {
    double longest_step = 0;
    for (const RunningVariant& run : runs_) {
      if (run.active()) longest_step = std::max(longest_step, run.done_per_step());
    }
    return std::max(shortest_turn, fewest_steps * longest_step);
  }

  std::vector<RunningVariant> runs_;
};

}  // namespace

std::string name_of(const std::vector<std::string>& settings) {
  return settings.empty() ? "as it is" : fmt::format("{}", fmt::join(settings, ", "));
}

void check_repeat(const std::string& variant, const RunSummary& first, const RunSummary& again) {
  const auto without_times = [](RunSummary s) {
    s.wall_seconds = 0;
    s.started.clear();
    s.phases.clear();
    s.skipped_seconds = {};
    return summary_json(s);
  };
  if (without_times(first) == without_times(again)) return;
  throw RunError(
      fmt::format("{}: a repeated run gave another result, state {:016x} after {} steps in place of {:016x} after {}",
                  variant, again.state_hash, again.steps, first.state_hash, first.steps));
}

std::vector<VariantRuns> run_comparison(const std::vector<Variant>& variants, const ComparisonSettings& settings) {
  std::vector<VariantRuns> results;
  for (const Variant& variant : variants) results.push_back({variant.settings, {}, {}, ""});
  for (int repeat = 0; repeat < settings.repeats; ++repeat) {
    Race race(variants, settings.curves && repeat == 0 ? settings.rows : 0);
    const ThreadCount threads(settings.threads > 0 ? settings.threads : earned_threads(race.most_elements()));
    // All are at the same part of their runs: the first one speaks for all.
    const Scene& first = variants.front().scene;
    Progress progress({first.time.end, first.time.steps, first.units, settings.quiet, false});
    race.run(progress);
    for (std::size_t i = 0; i < variants.size(); ++i) {
      VariantRuns& result = results[i];
      result.repeats.push_back(race.runs()[i].summary());
      result.momentum_error = momentum_error(variants[i].scene, result.repeats.back());
      result.failure = race.runs()[i].failure();
      if (repeat == 0) {
        result.curves = race.runs()[i].curves();
        result.surface = race.runs()[i].surface();
        if (result.failure.empty()) result.last = race.runs()[i].last();
      }
      check_repeat(name_of(result.settings), result.repeats.front(), result.repeats.back());
    }
  }
  return results;
}

}  // namespace pinball
