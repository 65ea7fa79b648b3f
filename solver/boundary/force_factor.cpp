#include "force_factor.hpp"

#include <algorithm>
#include <utility>

namespace pinball {

namespace {

/// Of the straight pieces of a table between two times.
double integral_between(const TimeTable& table, double from, double to) {
  double sum = 0, begin = from, at_begin = table.value(from);
  const auto go_to = [&](double end) {
    const double at_end = table.value(end);
    sum += 0.5 * (end - begin) * (at_begin + at_end);
    begin = end;
    at_begin = at_end;
  };
  const auto first = std::ranges::upper_bound(table.times, from);
  for (auto point = first; point != table.times.end() && *point < to; ++point) go_to(*point);
  go_to(to);
  return sum;
}

/// The time over which the forces of a step change velocities.
std::pair<double, double> around(double time, const StepLengths& step) {
  return {time - 0.5 * step.before, time + 0.5 * step.after};
}

}  // namespace

double force_factor(const TimeTable& table, double time, const StepLengths& step) {
  const auto [from, to] = around(time, step);
  const auto point = std::ranges::upper_bound(table.times, from);
  if (point == table.times.end() || !(*point < to)) return table.value(time);
  return integral_between(table, from, to) / (to - from);
}

double force_factor(const TimeTable& table, double start, double time, const StepLengths& step) {
  const auto [from, to] = around(time, step);
  if (start <= 0 || from >= start) return force_factor(table, time - start, step);
  return to > start ? integral_between(table, 0, to - start) / (to - from) : 0.0;
}

}  // namespace pinball
