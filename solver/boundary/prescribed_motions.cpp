#include "prescribed_motions.hpp"

#include <algorithm>
#include <cmath>

#include <solver/base/point.hpp>

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
  return mean_factor(given.table, given.quantity, time, step);
}

/// Of the velocity of node n along a direction.
template <class S>
double along(const Model<S>& model, std::int32_t n, const S (&normal)[3]) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += record(model.nodes.velocity.data(), n)[k] * normal[k];
  return sum;
}

/// Where a displacement begins its velocity is not known before there is a step.
double starting_factor(const PrescribedVelocity& given) {
  return given.quantity == MotionQuantity::displacement ? 0.0 : mean_factor(given, 0, {});
}

bool accelerates(const PrescribedVelocity& given) { return given.quantity == MotionQuantity::acceleration; }

}  // namespace

double mean_factor(const TimeTable& table, MotionQuantity quantity, double time, const StepLengths& step) {
  if (step.after > 0)
    return (displacement(table, quantity, time + step.after) - displacement(table, quantity, time)) / step.after;
  if (quantity == MotionQuantity::velocity) return table.value(time);
  if (quantity == MotionQuantity::acceleration) return table.integral(time);
  return step.before > 0 ? (table.value(time) - table.value(time - step.before)) / step.before : 0.0;
}

double factor_change(const TimeTable& table, double time, const StepLengths& step) {
  const double now = mean_factor(table, MotionQuantity::acceleration, time, step);
  if (!(step.before > 0)) return now - table.integral(time);
  return now - mean_factor(table, MotionQuantity::acceleration, time - step.before, {0, step.before});
}

template <class S>
PrescribedMotions::PrescribedMotions(const Model<S>& model) : given_(model.scene.prescribed_velocities) {
  // The directions of a node are at right angles.
  const bool any = !model.constraints.empty() || !model.prescribed.empty();
  std::vector<double> squares(any ? model.nodes.count : 0, 0.0);
  const auto take = [&squares](std::int32_t node, double change) { squares[node] += change * change; };
  for (const NodeConstraint<S>& held : model.constraints) take(held.node, along(model, held.node, held.normal));
  for (const NodePrescription<S>& moved : model.prescribed) {
    const PrescribedVelocity& given = given_[moved.table];
    if (accelerates(given)) continue;
    take(moved.node, moved.speed * starting_factor(given) - along(model, moved.node, moved.normal));
  }
  for (const double square : squares) jump_at_start_ = std::max(jump_at_start_, std::sqrt(square));
}

std::vector<double> PrescribedMotions::factors(double time, const StepLengths& step) const {
  std::vector<double> found;
  for (const PrescribedVelocity& given : given_)
    found.push_back(accelerates(given) ? factor_change(given.table, time, step) : mean_factor(given, time, step));
  return found;
}

double PrescribedMotions::jump(double from, double to) const {
  double largest = 0;
  for (const PrescribedVelocity& given : given_) {
    if (!given.when.contains(to)) continue;
    const StepLengths step{to - from, to - from};
    const bool goes_on = accelerates(given) || given.when.contains(from);
    const double before = goes_on ? mean_factor(given, from, step) : 0.0;
    largest = std::max(largest, norm(given.velocity) * std::abs(mean_factor(given, to, step) - before));
  }
  return largest;
}

double PrescribedMotions::jump_now(double time, const StepLengths& step) const {
  double largest = 0;
  for (const PrescribedVelocity& given : given_) {
    if (!given.when.contains(time)) continue;
    double change = 0;
    if (accelerates(given)) {
      change = factor_change(given.table, time, step);
    } else {
      change = mean_factor(given, time, step);
      if (given.when.contains(time - step.before)) change -= mean_factor(given, time - step.before, {0, step.before});
    }
    largest = std::max(largest, norm(given.velocity) * std::abs(change));
  }
  return largest;
}

template PrescribedMotions::PrescribedMotions(const Model<double>&);
template PrescribedMotions::PrescribedMotions(const Model<float>&);

}  // namespace pinball
