#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>

#include <solver/results.hpp>

namespace pinball {

struct ProgressSettings {
  double end_time = 0.0;    ///< time.end
  std::int64_t steps = -1;  ///< time.steps; -1: no limit
  std::string units;        ///< the scene's string: its last part names the time
  bool quiet = false;       ///< print nothing
  bool alone = true;        ///< the time is this run's: from it follows its speed
  double log_seconds = 60;  ///< after so long a log file gets a line in any case [s]
};

/// Of a whole run, 0 to 1: of the limit that ends it first.
double fraction_done(const ProgressSettings& settings, const ProgressState& state);

/// Shows how far a running job is: on a terminal one line, rewritten in place at most 10 times a second; elsewhere (a
/// log file) one plain line at the beginning, at every 10 % and after every minute; quiet: nothing.
class Progress {
 public:
  /// `stream`: where the lines go; it stays open and belongs to the caller.
  explicit Progress(ProgressSettings settings, std::FILE* stream = stderr);

  /// Ends a line left open on the terminal, so that an error message starts on its own line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows where the run begins; what is left to do, and how fast it goes, is counted from there.
  void begin(const ProgressState& state);

  /// Call after each step: costs one reading of the clock where nothing is to be shown.
  void update(const ProgressState& state);

  /// A line that stays above those of progress.
  void say(const std::string& text);

  /// Shows the last state, whatever the time since the line before.
  void finish(const ProgressState& state);

 private:
  using Clock = std::chrono::steady_clock;

  void show(const ProgressState& state, double done);
  std::string line(const ProgressState& state, double done) const;
  std::string time_left(double done, double elapsed) const;
  std::string speed(const ProgressState& state, double elapsed) const;

  ProgressSettings settings_;
  std::string time_unit_;
  std::FILE* stream_;
  bool terminal_ = false;
  bool line_open_ = false;
  int next_tenth_ = 1;  ///< plain lines: the next one at this many tenths
  Clock::time_point start_, last_shown_;
  double done_before_ = 0.0;       ///< at the beginning
  std::int64_t steps_before_ = 0;  ///< the same
};

/// "42 s", "3 min 05 s", "2 h 10 min": seconds for a reader; "?" where they are not finite.
std::string readable_duration(double seconds);

}  // namespace pinball
