#include "step_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/base/same_time.hpp>

namespace pinball {

namespace {

/// Beyond so many steps a step is lost in the sum of them.
constexpr double countable_steps = 0x1p53;

}  // namespace

StepClock::StepClock(const TimeSettings& settings, double damping)
    : end_(settings.end),
      cfl_(settings.cfl),
      damping_(damping),
      steps_at_end_(settings.steps),
      longest_impact_step_(std::numeric_limits<double>::infinity()) {}

bool StepClock::at_end(std::int32_t cycle_steps) const {
  // What the last cycle has still to do
  const std::int64_t steps = steps_ > 0 ? cycle_steps - 1 : 0;
  return time_ + steps * dt_ >= end_ * (1 - 1e-12) || (steps_at_end_ >= 0 && steps_ + steps >= steps_at_end_);
}

void StepClock::limit_by_impact_speed(double step) { longest_impact_step_ = std::min(longest_impact_step_, step); }

/// The mass damping a is lagged: a mode of frequency w is stable if w^2 dt^2/4 + a dt/2 <= 1. Where cfl leaves no room
/// for that, the step is shorter, by 5 % more than has to be; and never so long that damping turns a motion round (a dt
/// > 1).
double StepClock::longest_step(double stable) const {
  const double undamped = cfl_ * stable;
  if (damping_ == 0 || cfl_ * cfl_ + 0.5 * damping_ * undamped <= 1) return undamped;
  const double half = 0.5 * damping_, frequency = 2 / stable;
  const double damped = 2 / (half + std::hypot(half, frequency));
  return std::min({undamped, std::max(cfl_, 0.95) * damped, 1 / damping_});
}

/// Kept for some steps, for vibrations pass through velocities that do not change.
void StepClock::take_change(double change, double in_motion) {
  constexpr double forgotten = 1.0 / 16;
  const double share = change < in_motion ? change / in_motion : change > 0 ? 1.0 : 0.0;
  change_ = std::max(share, (1 - forgotten) * change_);
}

/// The energy that central differences keep is K = m/2 v_(n-1/2).(v_(n-1/2) + dt a_n) with what is stored, and at
/// velocities v_n K = m/2 (|v_n|^2 - |dt a_n|^2/4): where dt changes to r dt it loses (r^2 - 1)/4 of 1/2 m |dt a_n|^2.
bool StepClock::may_be_raised(double step) const {
  constexpr double harmless = 1e-3;  // of the energy in motion
  const double ratio = step / dt_;
  return 0.25 * (ratio * ratio - 1) * change_ <= harmless;
}

/// A step that becomes shorter where forces act gives energy as a longer one takes it: 85 % of all that there was to a
/// cube of one element that met a wall at 1 km/s. So it becomes as short as what is about to be stopped will have it
/// before that is stopped.
double StepClock::step_into_impact(double stable, double closing) const {
  return 2 / (2 / stable + rate_of_closing_ * closing);
}

void StepClock::choose(const Due& due, const StepBound& bound, double closing) {
  force_time_ = time_;
  dt_before_ = dt_;
  if (!due.all()) return;
  if (due.last) {
    dt_ = 0;
    return;
  }
  const double stable = step_into_impact(bound.stable, closing);
  // Impacts are seen two steps ahead.
  const double most = dt_ > 0 ? 2 * dt_ : std::numeric_limits<double>::infinity();
  const double chosen = std::min({longest_step(stable), longest_impact_step_, most, bound.longest});
  // A step that followed the vibrations of its element would feed them: a free cube at strains of 1e-3 gained half its
  // energy in 70,000 steps. So the step is kept until it is too long, or well below what is allowed.
  constexpr double raised_from = 1.05;
  const bool keeps = dt_ > 0 && dt_ <= chosen && (chosen < raised_from * dt_ || !may_be_raised(chosen));
  // What remains is divided into equal steps (cycles), so that the last ones are not cut: a sudden change of the step
  // changes the energy of the fast modes that central differences keep, by the square of (dt x frequency).
  const double remaining = (end_ - time_) / bound.cycle_steps;
  const double step = keeps ? dt_ : chosen, steps = std::ceil(remaining / step - 1e-9);
  dt_ = steps < countable_steps ? remaining / std::max(1.0, steps) : step;  // beyond, time.steps ends the run
  const double beside = steps_at_end_ < 0 ? end_ : time_;
  lost_ = end_ - time_ > 1e-12 * end_ && !(beside + dt_ > beside);
  dt_max_ = std::max(dt_max_, dt_);
  // The division says nothing about stability.
  if (dt_min_ == 0 || chosen < dt_min_) {
    dt_min_ = chosen;
    const bool by_leap = 2 * stable < bound.stable;  // the larger part of the rate 2/dt
    limited_by_ = chosen == longest_impact_step_ || by_leap ? StepLimit::impact_speed
                  : chosen == bound.longest                 ? StepLimit::rigid_bodies
                  : bound.by_contact                        ? StepLimit::contact
                                                            : StepLimit::element;
    limiting_slot_ = bound.slot;
  }
}

double StepClock::at_mark(double time) const {
  const double far = same_time * dt_;
  const auto mark = std::ranges::lower_bound(marks_, time - far);
  return mark != marks_.end() && *mark <= time + far ? *mark : time;
}

void StepClock::advance(const Due& due) {
  if (due.last) return;
  time_ = at_mark(time_ + dt_);
  ++steps_;
}

void StepClock::persist(StateArchive& archive) {
  archive(time_, force_time_, dt_, dt_before_, steps_, longest_impact_step_, change_, dt_min_, dt_max_, limited_by_,
          limiting_slot_);
  archive.require(std::isfinite(time_) && time_ >= 0 && force_time_ >= 0 && force_time_ <= time_ && steps_ >= 0);
  archive.require(std::isfinite(dt_) && dt_ >= 0 && dt_before_ >= 0 && longest_impact_step_ > 0 && change_ >= 0);
  archive.require(limited_by_ >= StepLimit::none && limited_by_ <= StepLimit::rigid_bodies);
}

}  // namespace pinball
