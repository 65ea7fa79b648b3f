#pragma once

#include "../macros.hpp"

namespace pinball {

/// Work of one kind of outside force on the model [energy], in two parts: `now` up to the time t_n of the force,
/// `later` what the force does after it, up to t_(n+1).
///
/// The kinetic energy at t_n is K_n = m/2 v_(n-1/2).(v_(n-1/2) + dt_(n-1/2) a_n) (node_update.hpp). Of its change over
/// a step, the part of a force f_n is
///
///     before t_n:  dt_(n-1/2)/2 f_n.v_(n-1/2)
///     after t_n:   f_n.[ (dt_(n-1/2) + dt_(n+1/2))/4 (v_(n-1/2) + v_(n+1/2)) - dt_(n-1/2)/2 v_(n-1/2) ]
///
/// which is the trapezoidal rule where the step is constant, and keeps the energy balance closed to round-off also
/// where it is not, and in the first half step, in which a wall may stop a node at once.
struct ExternalWork {
  double now = 0, later = 0;

  PINBALL_FUNCTION void join(const ExternalWork& other) {
    now += other.now;
    later += other.later;
  }
};

/// Lengths of the steps before and after the time of the forces.
struct StepLengths {
  double before = 0;  ///< dt_(n-1/2), 0 in the first step [time]
  double after = 0;   ///< dt_(n+1/2), 0 in the last, which only completes the velocities [time]

  PINBALL_FUNCTION double velocity() const {
    return 0.5 * (before + after);
  }  ///< over which forces change velocities [time]
};

/// Work of a force along which its point moves with rate_before = rate of v_(n-1/2) and rate_after = rate of v_(n+1/2).
PINBALL_FUNCTION ExternalWork work_of(double force, double rate_before, double rate_after, const StepLengths& step) {
  const double now = 0.5 * step.before * force * rate_before;
  return {now, 0.5 * step.velocity() * force * (rate_before + rate_after) - now};
}

/// Work of a force on one node.
/// force: the part whose work is asked for; velocity: v_(n-1/2); acceleration: of all forces together.
template <class S>
PINBALL_FUNCTION ExternalWork work_of(const S* force, const S* velocity, const S* acceleration,
                                      const StepLengths& step) {
  ExternalWork work;
  for (int k = 0; k < 3; ++k) {
    const double v = velocity[k];
    work.join(work_of(force[k], v, v + step.velocity() * static_cast<double>(acceleration[k]), step));
  }
  return work;
}

}  // namespace pinball
