#include <fmt/format.h>

#include <solver/base/error.hpp>
#include <solver/parallel/ranks.hpp>
#include <solver/recorded_run.hpp>
#include <solver/results/warnings.hpp>
#include <solver/run_page.hpp>

#include "first_moments.hpp"
#include "message.hpp"
#include "out_of_memory.hpp"
#include "progress.hpp"
#include "rank_pieces.hpp"
#include "recorder.hpp"
#include "run_folder.hpp"

namespace pinball {

namespace {

/// A copy of the state for the page, and its faces, take 300 bytes an element: of more, the most that a run takes would
/// be what its page does.
constexpr std::int64_t most_elements_copied = 100'000;

/// One run, from the first step to the last.
class RecordedRun {
 public:
  RecordedRun(const Scene& scene, const RecordOptions& options, RunFolder& folder)
      : options_(options),
        folder_(folder),
        simulation_(scene, {options.threads, options.ranks}),
        recorder_(simulation_, options, folder.continues()) {
    const RunSummary summary = simulation_.summary();
    folder_.begin(summary);
    impact_speed_ = summary.expected_impact;
    if (!options_.quiet) print_notes(summary);
    if (options_.silent) return;
    for (const std::string& warning : start_warnings(summary)) print_message("warning: " + warning);
  }

  RunSummary run() {
    try {
      make_steps();
    } catch (const RunError& error) {
      throw RunError(error.what() + leave_failed(error.what()));
    } catch (const std::bad_alloc&) {
      throw OutOfMemory(fmt::format("in step {} at time {:.6g}", simulation_.steps(), simulation_.time()), bytes());
    }
    const RunSummary summary = result(simulation_.complete() ? RunStatus::done : RunStatus::stopped);
    try {
      write_page(summary);
    } catch (const RunError& error) {  // a full disk, which a summary may still fit on: what was computed is kept
      folder_.end(result(RunStatus::failed, error.what()));
      throw;
    }
    folder_.end(summary);
    return summary;
  }

 private:
  static void print_notes(const RunSummary& summary) {
    if (const std::string added = added_mass_text(summary); !added.empty()) print_message(added);
    if (!summary.contact_because.empty()) print_message(summary.contact_because);
    for (const TiedResult& tied : summary.tied) print_message("contact.tied " + tied_text(tied));
  }

  double bytes() const {
    return static_cast<double>(simulation_.summary().bytes_per_element) * static_cast<double>(simulation_.elements());
  }

  void make_steps() {
    const Scene& scene = simulation_.scene();
    Progress progress({scene.time.end, scene.time.steps, scene.units, options_.quiet});
    progress.begin(simulation_.progress());
    FirstMoments first_moments(simulation_, impact_speed_);
    simulation_.on_step([&](Simulation& s) {
      if (const std::string expected = first_moments.expected(s); !expected.empty()) progress.say(expected);
      recorder_.record(s, s.complete());
      if (s.complete()) {
        progress.finish(s.progress());
        return AfterStep::go_on;
      }
      recorder_.checkpoint(s, s.at_end());
      progress.update(s.progress());
      if (s.at_end() || !options_.stop || !options_.stop()) return AfterStep::go_on;
      recorder_.stop(s);
      return AfterStep::stop;
    });
    simulation_.run();
  }

  RunSummary result(RunStatus status, const std::string& error = {}) const {
    RunSummary summary = simulation_.summary();
    summary.wall_seconds = recorder_.wall_seconds();
    summary.started = folder_.started();
    summary.status = status;
    summary.error = error;
    summary.notes = options_.deck.lines;
    return summary;
  }

  void write_page(const RunSummary& summary) const {
    if (options_.out.empty()) return;
    RunPageSettings settings{summary.error, options_.source, options_.converged};
    const OutputSettings& output = simulation_.scene().output;
    const bool has_fields = output.field_interval > 0 || !output.field_times.empty();
    if (has_fields || summary.status == RunStatus::failed || simulation_.elements() > most_elements_copied) {
      write_run_page(options_.out, simulation_.scene(), summary, settings);
      return;
    }
    const FieldSnapshot last = simulation_.snapshot();
    const FieldBase base = simulation_.field_base();
    settings.last = &last;
    settings.base = &base;
    write_run_page(options_.out, simulation_.scene(), summary, settings);
  }

  /// Returns what there is to say after the error; what cannot be written now is reported after it, not in place of it.
  std::string leave_failed(const std::string& error) {
    std::string more;
    const auto attempt = [&more](const char* loss, const auto& save) {
      try {
        save();
      } catch (const std::exception& also) {
        more += fmt::format("; {}: {}", loss, also.what());
      }
    };
    const RunSummary summary = result(RunStatus::failed, error);
    attempt("there is no summary", [&] { folder_.end(summary); });
    attempt("there is no page", [&] { write_page(summary); });
    attempt("the last good state is lost", [&] { more += recorder_.save_last_good(simulation_); });
    return more;
  }

  const RecordOptions& options_;
  RunFolder& folder_;
  Simulation simulation_;
  Recorder recorder_;
  double impact_speed_ = 0;
};

}  // namespace

namespace {

/// What fails with a memory that is full is reported with what was being done.
template <class Act>
auto with_memory_reported(const Scene& scene, const RunFolder& folder, const Act& act) {
  try {
    return act();
  } catch (const OutOfMemory&) {
    throw;
  } catch (const std::bad_alloc&) {
    if (folder.begun()) throw OutOfMemory("while results were written");
    throw OutOfMemory("while the scene was built", least_bytes(scene));
  }
}

/// What ranks other than 0 do.
RunSummary follow(const Scene& scene, const RecordOptions& options) {
  Simulation simulation(scene, {options.threads, options.ranks});
  if (options.restart != nullptr) take_state(*options.restart, simulation);
  simulation.follow_rank_0(answer_with_piece(options.out));
  RunSummary summary;
  summary.status = RunStatus::done;
  return summary;
}

}  // namespace

RunSummary run_recorded(const Scene& scene, const RecordOptions& options) {
  if (options.ranks != nullptr && options.ranks->number() > 0) return follow(scene, options);
  RunFolder folder(scene, options);
  if (!folder.warning().empty() && !options.silent) print_message("warning: " + folder.warning());
  try {
    return with_memory_reported(scene, folder, [&] { return RecordedRun(scene, options, folder).run(); });
  } catch (const InputError& error) {
    if (folder.begun()) folder.fail(error.what());
    throw;  // else the folder becomes what it was
  } catch (const std::exception& error) {
    folder.fail(error.what());
    throw;
  }
}

}  // namespace pinball
