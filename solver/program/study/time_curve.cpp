#include "time_curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <solver/base/interpolation.hpp>

namespace pinball {

namespace {

/// 0 of an empty one.
double value_at(const TimeCurve& curve, double time) {
  return curve.times.empty() ? 0 : interpolate(curve.times, curve.values, time);
}

/// Rows of both within the range that both have, each once.
std::vector<double> times_of_both(const TimeCurve& a, const TimeCurve& b) {
  if (a.times.empty() || b.times.empty()) return {};
  const double first = std::max(a.times.front(), b.times.front()), last = std::min(a.times.back(), b.times.back());
  std::vector<double> times;
  std::merge(a.times.begin(), a.times.end(), b.times.begin(), b.times.end(), std::back_inserter(times));
  std::erase_if(times, [&](double t) { return t < first || t > last; });
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

double distance(const TimeCurve& a, const TimeCurve& b) {
  const std::vector<double> times = times_of_both(a, b);
  if (times.size() < 2) return 0;
  double sum = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double before = value_at(a, times[i - 1]) - value_at(b, times[i - 1]);
    const double after = value_at(a, times[i]) - value_at(b, times[i]);
    sum += (times[i] - times[i - 1]) * (before * before + before * after + after * after) / 3;
  }
  return std::sqrt(sum / (times.back() - times.front()));
}

double norm(const TimeCurve& a) { return distance(a, {a.times, std::vector<double>(a.times.size(), 0.0)}); }

TimeCurve beyond(const TimeCurve& fine, const TimeCurve& coarse, double share) {
  TimeCurve result = fine;
  for (std::size_t i = 0; i < fine.times.size(); ++i) {
    result.values[i] += share * (fine.values[i] - value_at(coarse, fine.times[i]));
  }
  return result;
}

TimeCurve mean_of(const std::vector<TimeCurve>& curves) {
  TimeCurve mean = curves.front();
  for (std::size_t i = 0; i < mean.times.size(); ++i) {
    double sum = 0;
    for (const TimeCurve& curve : curves) sum += value_at(curve, mean.times[i]);
    mean.values[i] = sum / curves.size();
  }
  return mean;
}

}  // namespace pinball
