#include "curve_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

/// The integral of the square of a line from a to b, over its length.
double mean_square(double a, double b) { return (a * a + a * b + b * b) / 3; }

}  // namespace

double value_between(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto after = std::lower_bound(times.begin(), times.end(), time) - times.begin();
  if (after == 0 || times[after] == time) return values[after];
  const double part = (time - times[after - 1]) / (times[after] - times[after - 1]);
  return values[after - 1] + part * (values[after] - values[after - 1]);
}

bool has_columns(const Curves& curves, const Meaning& meaning) {
  const auto is_there = [&](const std::string& name) { return std::ranges::count(curves.columns, name) > 0; };
  return !meaning.columns.empty() && std::ranges::all_of(meaning.columns, is_there);
}

std::vector<double> values_of(const Curves& curves, const Meaning& meaning, double mass) {
  if (!has_columns(curves, meaning)) return {};
  std::vector<double> values(curves.rows.size(), 0.0);
  for (const std::string& name : meaning.columns) {
    const auto column = std::ranges::find(curves.columns, name);
    for (std::size_t row = 0; row < values.size(); ++row) {
      values[row] += curves.rows[row][column - curves.columns.begin()];
    }
  }
  if (meaning.per_mass) {
    for (double& value : values) value /= mass;
  }
  return values;
}

std::vector<CurveDifference> curve_differences(const Curves& curves, const OtherHistory& other, double mass) {
  std::vector<CurveDifference> differences;
  const std::vector<double> times = values_of(curves, {{"time"}}, mass);
  if (times.empty()) return {};
  for (const OtherCurve& curve : other.curves) {
    const std::vector<double> values = values_of(curves, curve.meaning, mass);
    if (values.empty()) continue;
    CurveDifference d;
    d.name = curve.name;
    d.columns = fmt::format("{}{}", fmt::join(curve.meaning.columns, " + "), curve.meaning.per_mass ? " / mass" : "");
    double before = 0, time_before = 0, squares = 0, most = -1, length = 0;
    bool first = true;
    for (std::size_t i = 0; i < other.times.size(); ++i) {
      const double time = other.times[i], there = curve.values[i];
      if (time < times.front() || time > times.back() || !std::isfinite(there)) continue;
      const double here = value_between(times, values, time), difference = here - there;
      if (!std::isfinite(here)) continue;
      if (!first) {
        squares += (time - time_before) * mean_square(before, difference);
        length += time - time_before;
      }
      if (std::abs(difference) > most) {
        most = std::abs(difference);
        d.largest_time = time;
      }
      d.scale = std::max(d.scale, std::abs(there));
      d.end_time = time;
      d.here = here;
      d.there = there;
      before = difference;
      time_before = time;
      first = false;
    }
    if (first) continue;
    if (d.scale > 0) {
      d.at_end = (d.here - d.there) / d.scale;
      d.largest = most / d.scale;
      d.root_mean_square = length > 0 ? std::sqrt(squares / length) / d.scale : most / d.scale;
    }
    differences.push_back(d);
  }
  return differences;
}

std::vector<std::string> without_meaning(const Curves& curves, const OtherHistory& other) {
  std::vector<std::string> names;
  for (const OtherCurve& curve : other.curves) {
    if (!has_columns(curves, curve.meaning)) names.push_back(curve.name);
  }
  return names;
}

}  // namespace pinball
