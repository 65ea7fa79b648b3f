#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include <solver/base/state_archive.hpp>

namespace pinball {

/// The timed stages of a step, in the order in which they run.
enum class Phase {
  internal_forces,
  pinballs,
  contact_search,
  contact_forces,
  contact_scatter,
  time_step,
  boundary_conditions,
  integration,
  output,
  count
};

inline constexpr std::array<const char*, static_cast<std::size_t>(Phase::count)> phase_names = {
    "internal_forces",     "pinballs",    "contact_search", "contact_forces", "contact_scatter", "time_step",
    "boundary_conditions", "integration", "output"};

/// Seconds spent in each phase.
class Timers {
 public:
  /// Runs a stage and adds its time to a phase.
  template <class Stage>
  auto measure(Phase phase, const Stage& stage) {
    const Stop stop{*this, phase, Clock::now()};
    return stage();
  }
  void persist(StateArchive& archive) { archive(seconds_); }
  double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Stop {
    Timers& timers;
    Phase phase;
    Clock::time_point start;
    ~Stop() {
      timers.seconds_[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(Clock::now() - start).count();
    }
  };
  std::array<double, static_cast<std::size_t>(Phase::count)> seconds_{};
};

}  // namespace pinball
