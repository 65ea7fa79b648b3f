#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <solver/recorded_run.hpp>
#include <solver/simulation.hpp>

#include "checkpoint.hpp"
#include "field_output.hpp"
#include "history.hpp"

namespace pinball {

/// The next of a sequence of output times: every interval, or a list.
class Schedule {
 public:
  /// times: in any order
  Schedule(double interval, std::vector<double> times) : interval_(interval), times_(std::move(times)) {
    std::sort(times_.begin(), times_.end());
  }

  bool due(double time) const {
    const double tolerance = 1e-9 * interval_;
    return (interval_ > 0 && time >= count_ * interval_ - tolerance) ||
           (next_ < times_.size() && reached(times_[next_], time));
  }
  void passed(double time) {
    // The count may be any number; of one that is not finite every step stays due.
    const double count = interval_ > 0 ? std::floor(time / interval_ + 1e-9) + 1 : 0;
    if (std::isfinite(count)) count_ = std::max(count_, count);
    while (next_ < times_.size() && reached(times_[next_], time)) ++next_;
  }

 private:
  /// A run ends at time.end but for round-off (StepClock::at_end).
  static bool reached(double asked, double time) { return time >= asked * (1 - 1e-12); }

  double interval_;
  std::vector<double> times_;
  double count_ = 0;  ///< a whole number
  std::size_t next_ = 0;
};

/// What a run has written and taken when a state was saved: with the state of the solver what a run goes on from.
struct RunRecord {
  double wall_seconds = 0;
  HistoryPart history;
  FieldWriter::Written fields;

  void persist(StateArchive& archive) { archive(wall_seconds, history, fields); }
};

/// Brings a simulation of the same scene to the state of a checkpoint. Throws InputError that names the file.
RunRecord take_state(const Checkpoint& checkpoint, Simulation& simulation);

/// What a running scene writes; nothing for an empty folder. Keeps a copy of a state from before any trouble.
class Recorder {
 public:
  /// With options.restart also brings the simulation to that state; continues: in the folder that has its files. Throws
  /// InputError where it does not fit.
  Recorder(Simulation& simulation, const RecordOptions& options, bool continues);

  /// Called after each step; last: also writes what is not due.
  void record(Simulation& simulation, bool last);
  /// Writes the checkpoint after each options.checkpoint_every calls, and where the run is about to end.
  void checkpoint(Simulation& simulation, bool last);
  /// Writes all that there is of a run that is asked to end between two steps. Returns the checkpoint; empty: without
  /// the source of the scene there can be none.
  std::string stop(Simulation& simulation);
  /// Writes the state that was kept, for a restart and as a picture, for which the simulation goes back to it. Returns
  /// a sentence that names the files, or nothing.
  std::string save_last_good(Simulation& simulation);

  double wall_seconds() const;  ///< of the whole run, also before a restart

 private:
  using Clock = std::chrono::steady_clock;

  RunRecord restart(const Checkpoint& checkpoint, Simulation& simulation);
  void open_files(const Simulation& simulation, const std::optional<RunRecord>& kept);
  void write_fields(Simulation& simulation);
  void save(Simulation& simulation);
  void keep_state(Simulation& simulation);
  void write_state(Simulation& simulation);
  void write_file(const char* name, const Simulation& simulation);
  std::string path(const char* name) const;

  std::string folder_;
  Schedule history_times_;
  bool every_step_;
  Schedule field_times_;
  std::string units_;
  std::unique_ptr<HistoryWriter> history_;
  std::optional<double> last_row_;  ///< its time
  std::unique_ptr<FieldWriter> fields_;
  bool in_pieces_;                      ///< each rank writes one of the fields
  std::optional<CheckpointHead> head_;  ///< only for a scene whose source is known; fingerprint: 0 until it is needed
  StateBytes last_good_;                ///< RunRecord and Simulation
  Clock::time_point start_ = Clock::now(), next_copy_{};
  double wall_seconds_before_ = 0;
  std::int64_t checkpoint_every_, since_checkpoint_ = 0;
};

}  // namespace pinball
