#include "time_course.hpp"

#include <algorithm>
#include <iterator>

namespace pinball {

namespace {

constexpr std::size_t pieces = 128;           ///< pieces that the time of the run is cut into
constexpr std::size_t most_times = 4096;      ///< of one mover
constexpr std::size_t most_places = 500'000;  ///< of all movers
constexpr double same = 1e-9;                 ///< times that are nearer are one, over the time of the run [-]

/// Puts those of some points that lie within the run, and at none of its times yet, between these.
void put_between(std::vector<double>& times, std::vector<double> points) {
  const double end = times.back(), near = same * end;
  std::erase_if(points, [&](double p) {
    if (!(p > 0 && p < end)) return true;
    const auto above = std::ranges::lower_bound(times, p);
    return *above - p < near || p - *std::prev(above) < near;
  });
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end(), [near](double a, double b) { return b - a < near; }),
               points.end());
  const auto middle = times.insert(times.end(), points.begin(), points.end());
  std::inplace_merge(times.begin(), middle, times.end());
}

/// Where a table bends, and where it changes its sign: a way has its ends there. twice: it is integrated twice, and so
/// bends in between.
void add_points(std::vector<double>& points, const TimeTable& table, bool twice, double start = 0) {
  for (std::size_t i = 0; i < table.times.size(); ++i) {
    points.push_back(start + table.times[i]);
    if (i == 0) continue;
    const double begin = start + table.times[i - 1], length = table.times[i] - table.times[i - 1];
    const double a = table.factors[i - 1], b = table.factors[i];
    if (a * b < 0) points.push_back(begin + length * a / (a - b));
    for (const double share : {0.25, 0.5, 0.75}) {
      if (twice) points.push_back(begin + share * length);
    }
  }
}

template <class Motion>
MotionCourse motion_course(const Motion& given, const std::vector<double>& times) {
  std::vector<double> all = times, points{given.when.start, given.when.end};
  add_points(points, given.table, given.quantity == MotionQuantity::acceleration);
  put_between(all, points);
  const TimeCourse factor = time_course(given.table, all);
  MotionCourse course;
  course.from = std::max(0.0, given.when.start);
  course.to = std::min(given.when.end, times.back());
  const auto place = [&all](double time) {
    const auto found = std::ranges::lower_bound(all, time - same * all.back());
    return std::min<std::size_t>(found - all.begin(), all.size() - 1);
  };
  const std::size_t from = place(course.from), to = std::max(from, place(course.to));
  double low = 0, high = 0;
  for (std::size_t i = 0, j = 0; i < all.size(); ++i) {
    const std::size_t now = std::clamp(i, from, to);
    double way = 0, rate = 0;
    switch (given.quantity) {
      case MotionQuantity::velocity:
        way = factor.first[now] - factor.first[from];
        rate = factor.value[now];
        break;
      case MotionQuantity::displacement:
        way = factor.value[now] - factor.value[from];
        if (now > from) rate = (factor.value[now] - factor.value[now - 1]) / (all[now] - all[now - 1]);
        break;
      case MotionQuantity::acceleration:
        rate = factor.first[now] - factor.first[from];
        way = factor.second[now] - factor.second[from] - (all[now] - all[from]) * factor.first[from] +
              (all[i] - all[now]) * rate;
        break;
    }
    if (i < from || to == from) way = rate = 0;
    low = std::min(low, way);
    high = std::max(high, way);
    if (all[i] != times[j]) continue;
    course.way.push_back(way);
    course.rate.push_back(rate);
    course.low.push_back(low);
    course.high.push_back(high);
    low = high = way;
    ++j;
  }
  return course;
}

}  // namespace

TimeCourse time_course(const TimeTable& table, const std::vector<double>& times) {
  TimeCourse course;
  double now = 0, value = table.value(0), first = 0, second = 0;
  const auto go = [&](double to) {
    const double h = to - now, then = table.value(to);
    second += h * (first + h * (value / 3 + then / 6));
    first += h * (value + then) / 2;
    value = then;
    now = to;
  };
  auto next = std::ranges::upper_bound(table.times, 0.0);
  for (const double time : times) {
    for (; next != table.times.end() && *next < time; ++next) go(*next);
    if (time > now && !table.times.empty()) go(time);
    const bool plain = table.times.empty() && time > 0;
    course.value.push_back(value);
    course.first.push_back(plain ? time : first);
    course.second.push_back(plain ? 0.5 * time * time : second);
  }
  return course;
}

MotionCourse course_of(const PrescribedVelocity& given, const std::vector<double>& times) {
  return motion_course(given, times);
}
MotionCourse course_of(const RigidMotion& given, const std::vector<double>& times) {
  return motion_course(given, times);
}

std::vector<double> look_times(const Scene& scene, std::size_t movers) {
  std::vector<double> times, spans, points;
  for (std::size_t j = 0; j <= pieces; ++j)
    times.push_back(scene.time.end * static_cast<double>(j) / static_cast<double>(pieces));
  const TimeTable* before = nullptr;  // cards of one curve follow each other
  const auto add = [&](const TimeTable& table, bool twice, double start = 0) {
    const bool again = before != nullptr && start == 0 && before->times == table.times;
    if (!again || before->factors != table.factors) add_points(points, table, twice, start);
    before = &table;
  };
  const auto add_motion = [&](const auto& given) {
    spans.push_back(given.when.start);
    spans.push_back(given.when.end);
    add(given.table, given.quantity == MotionQuantity::acceleration);
  };
  for (const PrescribedVelocity& given : scene.prescribed_velocities) add_motion(given);
  for (const RigidMotion& given : scene.rigid_motions) add_motion(given);
  before = nullptr;
  for (const Gravity& gravity : scene.gravities) add(gravity.table, true);
  for (const NodalLoad& load : scene.loads) add(load.table, true);
  before = nullptr;
  for (const RigidWall& wall : scene.rigid_walls) add(wall.table, false);
  for (const Pressure& pressure : scene.pressures) {
    spans.push_back(pressure.start);
    before = nullptr;
    add(pressure.table, true, pressure.start);
  }
  put_between(times, spans);
  std::vector<double> all = times;
  put_between(all, points);
  const std::size_t most = std::max(times.size(), std::min(most_times, most_places / std::max<std::size_t>(movers, 1)));
  if (all.size() <= most) return all;
  points.clear();
  const std::size_t take = most - times.size();
  for (std::size_t i = 0; i < take; ++i) points.push_back(all[i * all.size() / take]);
  put_between(times, points);
  return times;
}

}  // namespace pinball
