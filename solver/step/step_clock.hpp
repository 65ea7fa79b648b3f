#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/elements/schedule.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// What set the smallest step of a run: impact_speed is the way that bodies make in a step, or what stops them;
/// rigid_bodies that they turn or gain speed, or the length of a run in which nothing deforms.
enum class StepLimit { none, element, contact, impact_speed, rigid_bodies };

/// Where a run is in time, and how long its steps are. Between two steps positions belong to time(), forces, stresses
/// and energies to force_time(), velocities to the middle between the two.
class StepClock {
 public:
  /// damping: a of the force -a m v on every node [1/time]
  explicit StepClock(const TimeSettings& settings, double damping = 0);

  double time() const { return time_; }              ///< of the positions
  double force_time() const { return force_time_; }  ///< of the forces, stresses and energies
  double dt() const { return dt_; }                  ///< dt_(n+1/2), of the step under way or the last one
  double dt_before() const { return dt_before_; }    ///< dt_(n-1/2)
  StepLengths lengths() const { return {dt_before_, dt_}; }
  std::int64_t steps() const { return steps_; }                  ///< made so far
  double dt_min() const { return dt_min_; }                      ///< smallest stable step so far, 0 before the first
  double dt_max() const { return dt_max_; }                      ///< largest step so far
  StepLimit limited_by() const { return limited_by_; }           ///< at dt_min()
  std::int64_t limiting_slot() const { return limiting_slot_; }  ///< for StepLimit::element
  double remaining() const { return end_ - time_; }              ///< until time.end
  bool lost() const { return lost_; }  ///< the step is lost beside the end, or the time where steps are counted

  /// Whether time.end or time.steps will be reached by a cycle of steps of which the last is still to be made.
  bool at_end(std::int32_t cycle_steps) const;

  /// Times that time() has to the last digit where steps lead to them but for what sums of these are rounded by
  /// (same_time): so that what begins at the time of a step begins there. In order.
  void mark(std::vector<double> times) { marks_ = std::move(times); }

  /// No step is longer from now on, whatever is stable (longest_contact_step).
  void limit_by_impact_speed(double step);
  double longest_impact_step() const { return longest_impact_step_; }
  /// rate_of_closing: of SmallestStep [1/length].
  void expect_impacts(double rate_of_closing) { rate_of_closing_ = rate_of_closing; }
  /// The longest that the first step can be, by what elements allow [time].
  double first_step(double stable) const { return std::min({longest_step(stable), longest_impact_step_, end_}); }
  /// The forces of time() are known, and with them what bounds the coming step, or cycle of steps.
  /// closing: largest change of velocity that contact or a wall will give to what it stops first in the coming steps
  /// [length/time].
  void choose(const Due& due, const StepBound& bound, double closing);
  /// After the step. change: of MotionEnergy; in_motion: of EnergyLedger [energy].
  void take_change(double change, double in_motion);
  /// The positions have moved.
  void advance(const Due& due);

  void persist(StateArchive& archive);

 private:
  double longest_step(double stable) const;
  double step_into_impact(double stable, double closing) const;
  bool may_be_raised(double step) const;
  double at_mark(double time) const;

  double end_, cfl_, damping_;
  std::vector<double> marks_;
  std::int64_t steps_at_end_;
  double time_ = 0, force_time_ = 0, dt_ = 0, dt_before_ = 0;
  std::int64_t steps_ = 0;
  double longest_impact_step_;  ///< from the velocities at the start or after a change; infinite without contact [time]
  double rate_of_closing_ = 0;
  double change_ = 0;  ///< largest share of the energy in motion that velocities were changed by of late [-]
  double dt_min_ = 0, dt_max_ = 0;
  StepLimit limited_by_ = StepLimit::none;
  std::int64_t limiting_slot_ = -1;
  bool lost_ = false;
};

}  // namespace pinball
