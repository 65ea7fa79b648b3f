#include <algorithm>

#include <solver/base/interpolation.hpp>
#include <solver/scene_boundary.hpp>

namespace pinball {

double TimeTable::value(double time) const {
  if (times.empty()) return 1.0;
  return interpolate(times, factors, time);
}

namespace {

/// The pieces of a table between two times, in order: begin, end, value at the begin, slope.
template <class Visit>
void for_each_piece(const TimeTable& table, double from, double to, const Visit& visit) {
  double begin = from;
  for (const double point : table.times) {
    if (point <= begin) continue;
    const double end = std::min(point, to);
    if (begin >= to) return;
    visit(begin, end, table.value(begin), (table.value(end) - table.value(begin)) / (end - begin));
    begin = end;
  }
  if (begin < to) visit(begin, to, table.value(begin), 0.0);
}

}  // namespace

double TimeTable::integral(double time) const {
  if (times.empty()) return time;
  // From the first point on; then the same for time 0, whichever comes first.
  const auto from_first = [this](double t) {
    if (t <= times.front()) return (t - times.front()) * factors.front();
    double sum = 0;
    for (std::size_t i = 1; i < times.size() && times[i - 1] < t; ++i) {
      const double end = std::min(t, times[i]);
      sum += 0.5 * (value(times[i - 1]) + value(end)) * (end - times[i - 1]);
    }
    return sum + std::max(0.0, t - times.back()) * factors.back();
  };
  return from_first(time) - from_first(0.0);
}

double TimeTable::second_integral(double time) const {
  if (times.empty()) return 0.5 * time * time;
  double first = 0, second = 0;
  for_each_piece(*this, 0.0, time, [&](double begin, double end, double value, double slope) {
    const double h = end - begin;
    second += h * (first + h * (value / 2 + h * slope / 6));
    first += h * (value + h * slope / 2);
  });
  return second;
}

}  // namespace pinball
