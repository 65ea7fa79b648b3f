#include <algorithm>

#include <solver/base/built_features.hpp>

#include "solver.hpp"

/// How long the coming step is, and what makes it short beforehand: velocities of nodes that leap (docs/theory.md,
/// 5.2). Whatever makes them leap tells by how much, and here is the largest of all.
namespace pinball {

namespace {

/// Steps, or cycles of them, in which leaps make the step short: the coming one, and two more.
constexpr int steps_ahead = 3;

/// Of an element whose nodes are given unequal velocities none is held, and bulk viscosity acts before the first step,
/// which takes 1/8 sum m (dt a)^2; by trial.
constexpr double both_give_way = 1.5;

}  // namespace

/// Before a step, or a cycle of them, while all is of one time: what begins to hold, move, stop or tie nodes in it or
/// in the two steps after that.
template <class S>
void Solver<S>::look_ahead(bool first) {
  leap_of_begun_ = 0;
  const bool acts = built::boundary_conditions && boundary_.any();
  if (!acts && !tied_.any()) return;
  const double dt = first ? clock_.first_step(smallest_step_) : clock_.dt(), time = clock_.time();
  const int steps = schedule_.cycle_steps();
  const double from = time - steps * clock_.dt(), to = time + (steps_ahead * steps - 1) * dt;
  if (first && acts) leap_of_begun_ = boundary_.leap_at_start(model_, dt);
  if (acts && boundary_.changes(from, to))
    leap_of_begun_ = std::max(leap_of_begun_, boundary_.leap_of_begun(model(), from, time, to, dt));
  if (tied_.begin(from, to)) leap_of_begun_ = std::max(leap_of_begun_, tied_.leap_of_begun(model(), from, to));
  if (domain_) domain_->go_on();
}

/// By what moves as given, from the step before to those ahead [length/time].
template <class S>
double Solver<S>::leap_of_motions(const StepLengths& step, int ahead) const {
  double largest = 0;
  for (int k = 0; k < ahead; ++k) {
    const double time = clock_.time(), later = time + k * step.after;
    largest = std::max({largest, boundary_.leap(time, later, step), rigid_.leap(time, later, step)});
  }
  return largest;
}

/// Largest change of velocity that nodes undergo at once in the coming steps. Velocities that they are given between
/// two steps, or begin with, have leapt [length/time].
template <class S>
double Solver<S>::leap(const Due& due, const InternalForceResult<S>& element, const ContactWork& springs) {
  if (due.first) {
    given_leap_.join(unequal_velocities(model_, model_.nodes.velocity.data()));
    given_leap_.join({equations_.leap(model_), 0});
  }
  const double dt = schedule_.cycle_steps() * (due.first ? clock_.first_step(element.time_step) : clock_.dt());
  const double impact = due.first ? std::max(model_.look.closing_speed, boundary_.leap_at_start())
                                  : std::max(springs.expected_change, boundary_.closing());
  const double motions = leap_of_motions({due.first ? 0.0 : dt, dt}, steps_ahead);
  return std::max({impact, motions, leap_of_begun_, both_give_way * given_leap_.speed});
}

/// The largest step that elements, contact and rigid bodies allow, for the whole cycle.
template <class S>
void Solver<S>::choose_time_step(const Due& due, const InternalForceResult<S>& element, const ContactWork& springs) {
  timers_.measure(Phase::time_step, [&] {
    double springs2 = springs.frequency2;
    if (springs2 > 0 && rigid_.any_light()) {
      space_->show(NodeNumbers::force);
      springs2 *= rigid_.lightness_in_springs(model_);
    }
    StepBound bound =
        schedule_.bound(model_, due, internal_forces_.tiles(), element.time_step, element.time_step_slot, springs2);
    if (rigid_.any()) {
      const double leap = rigid_.leap(clock_.time(), clock_.time(), clock_.lengths()), longest = rigid_.longest_step();
      bound.longest = std::min(longest, rigid_impacts_.longest_step(rigid_, leap, std::min(longest, bound.stable)));
    }
    clock_.choose(due, bound, due.all() && !due.last ? leap(due, element, springs) : 0.0);
  });
}

/// What may touch in the coming step is looked for before its length is known, and before motions change velocities.
template <class S>
ComingStep Solver<S>::coming_step(const Due& due, const InternalForceResult<S>& element) const {
  ComingStep coming;
  const double time = clock_.time(), before = clock_.dt();
  if (due.first) coming.dt = clock_.first_step(element.time_step);
  coming.leap = std::max({leap_of_motions({before, std::max(before, coming.dt)}, 1), leap_of_begun_,
                          due.first ? boundary_.leap_at_start() : 0.0});
  coming.stops = boundary_.changes(time);
  return coming;
}

template void Solver<double>::look_ahead(bool);
template void Solver<float>::look_ahead(bool);
template void Solver<double>::choose_time_step(const Due&, const InternalForceResult<double>&, const ContactWork&);
template void Solver<float>::choose_time_step(const Due&, const InternalForceResult<float>&, const ContactWork&);
template ComingStep Solver<double>::coming_step(const Due&, const InternalForceResult<double>&) const;
template ComingStep Solver<float>::coming_step(const Due&, const InternalForceResult<float>&) const;

}  // namespace pinball
