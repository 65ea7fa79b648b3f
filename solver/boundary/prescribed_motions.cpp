#include "prescribed_motions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <solver/base/point.hpp>
#include <solver/base/same_time.hpp>

namespace pinball {

namespace {

double displacement(const TimeTable& table, MotionQuantity quantity, double time) {
  switch (quantity) {
    case MotionQuantity::velocity:
      return table.integral(time);
    case MotionQuantity::displacement:
      return table.value(time);
    case MotionQuantity::acceleration:
      return table.second_integral(time);
  }
  return 0;
}

double mean_factor(const PrescribedVelocity& given, double time, const StepLengths& step) {
  return mean_factor(given.table, given.quantity, given.when, time, step);
}

/// The part of the coming step's way that is the curve's: what it has done since `start` where that lies within the
/// step before, and nothing beyond `end`.
std::pair<double, double> span_of_way(const TimeSpan& when, double time, const StepLengths& step) {
  const bool begins = when.start > 0 && when.start <= time && when.start > time - (1 - same_time) * step.before;
  return {begins ? when.start : time, std::min(time + step.after, when.end)};
}

/// Of the velocity of node n along a direction.
template <class S>
double along(const Model<S>& model, std::int32_t n, const S (&normal)[3]) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += record(model.nodes.velocity.data(), n)[k] * normal[k];
  return sum;
}

/// Where the displacement of a run begins its velocity is not known before there is a step.
double starting_factor(const PrescribedVelocity& given, double time, const StepLengths& step) {
  const bool unknown = given.quantity == MotionQuantity::displacement && !(step.after > 0);
  return unknown ? 0.0 : mean_factor(given, time, step);
}

bool accelerates(const PrescribedVelocity& given) { return given.quantity == MotionQuantity::acceleration; }

}  // namespace

double mean_factor(const TimeTable& table, MotionQuantity quantity, const TimeSpan& when, double time,
                   const StepLengths& step) {
  if (step.after > 0) {
    const bool in_full = quantity == MotionQuantity::displacement;
    const auto [from, to] = in_full ? span_of_way(when, time, step) : std::pair(time, time + step.after);
    return (displacement(table, quantity, to) - displacement(table, quantity, from)) / step.after;
  }
  if (quantity == MotionQuantity::velocity) return table.value(time);
  if (quantity == MotionQuantity::acceleration) return table.integral(time);
  return step.before > 0 ? (table.value(time) - table.value(time - step.before)) / step.before : 0.0;
}

double factor_change(const TimeTable& table, MotionQuantity quantity, const TimeSpan& when, double time, double later,
                     const StepLengths& step) {
  const double then = mean_factor(table, quantity, when, later, step);
  if (step.before > 0) return then - mean_factor(table, quantity, when, time - step.before, {0, step.before});
  if (quantity == MotionQuantity::acceleration) return then - table.integral(time);
  return then - mean_factor(table, quantity, when, time, step);
}

template <class S>
PrescribedMotions::PrescribedMotions(const Model<S>& model) : given_(model.scene.prescribed_velocities) {
  leap_at_start_ = leap_of(model, {model.constraints, model.prescribed}, 0, {});
  for (const NodeConstraint<S>& held : model.constraints) {
    const double speed = along(model, held.node, held.normal);
    stopped_at_start_ += 0.5 * model.node_mass[held.node] * speed * speed;
  }
}

template <class S>
double PrescribedMotions::leap_of(const Model<S>& model, const HeldNodes<S>& held, double time,
                                  const StepLengths& step) const {
  const bool any = !held.constraints.empty() || !held.prescribed.empty();
  std::vector<double> squares(any ? model.nodes.count : 0, 0.0);
  const auto take = [&squares](std::int32_t node, double change) { squares[node] += change * change; };
  for (const NodeConstraint<S>& one : held.constraints) take(one.node, along(model, one.node, one.normal));
  for (const NodePrescription<S>& moved : held.prescribed) {
    const PrescribedVelocity& given = given_[moved.table];
    if (accelerates(given)) continue;
    take(moved.node, moved.speed * starting_factor(given, time, step) - along(model, moved.node, moved.normal));
  }
  double largest = 0;
  for (const double square : squares) largest = std::max(largest, square);
  return std::sqrt(largest);
}

std::vector<double> PrescribedMotions::factors(double time, const StepLengths& step) const {
  std::vector<double> found;
  for (const PrescribedVelocity& given : given_)
    found.push_back(accelerates(given) ? factor_change(given.table, given.when, time, step)
                                       : mean_factor(given, time, step));
  return found;
}

double PrescribedMotions::leap(double time, double later, const StepLengths& step) const {
  double largest = 0;
  for (const PrescribedVelocity& given : given_) {
    if (!given.when.contains(later)) continue;
    if (!accelerates(given) && !given.when.contains(time - step.before)) continue;
    const double from = std::max(time, std::min(later, given.when.start));
    const double change = factor_change(given.table, given.quantity, given.when, from, later, step);
    largest = std::max(largest, norm(given.velocity) * std::abs(change));
  }
  return largest;
}

template PrescribedMotions::PrescribedMotions(const Model<double>&);
template PrescribedMotions::PrescribedMotions(const Model<float>&);
template double PrescribedMotions::leap_of(const Model<double>&, const HeldNodes<double>&, double,
                                           const StepLengths&) const;
template double PrescribedMotions::leap_of(const Model<float>&, const HeldNodes<float>&, double,
                                           const StepLengths&) const;

}  // namespace pinball
