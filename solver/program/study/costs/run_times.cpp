#include "run_times.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

constexpr double power_alone = 4, largest_power = 5;
constexpr double least_power = 3;       ///< runs of milliseconds, whose files count, show less
constexpr double least_seconds = 1e-4;  ///< what the clock says less of is no time

double seconds_of(const MadeRun& run) { return std::max(run.seconds, least_seconds); }

double elements_at(const MadeRun& run, double factor) { return run.elements * std::pow(factor / run.factor, 3); }

double by_power(const MadeRun& near, const MadeRun& other, double factor) {
  const double power = std::log(seconds_of(near) / seconds_of(other)) / std::log(near.factor / other.factor);
  return seconds_of(near) * std::pow(factor / near.factor, std::clamp(power, least_power, largest_power));
}

double by_step(const MadeRun& near, const MadeRun& other, double factor) {
  const double of_near = seconds_of(near) / near.steps, of_other = seconds_of(other) / other.steps;
  const double of_element =
      std::clamp((of_near - of_other) / (near.elements - other.elements), 0.0, of_near / near.elements);
  const double constant = of_near - of_element * near.elements;
  const double steps = near.steps * factor / near.factor;
  return steps * (constant + of_element * elements_at(near, factor));
}

}  // namespace

RunTimes::RunTimes(std::vector<MadeRun> made) : made_(std::move(made)) {
  std::sort(made_.begin(), made_.end(), [](const MadeRun& a, const MadeRun& b) { return a.factor < b.factor; });
}

std::optional<double> RunTimes::expected(double factor) const {
  if (made_.empty()) return std::nullopt;
  std::vector<MadeRun> nearest = made_;
  std::stable_sort(nearest.begin(), nearest.end(), [factor](const MadeRun& a, const MadeRun& b) {
    return std::abs(std::log(a.factor / factor)) < std::abs(std::log(b.factor / factor));
  });
  const MadeRun& near = nearest.front();
  if (near.factor == factor) return near.seconds;
  if (nearest.size() == 1) return seconds_of(near) * std::pow(factor / near.factor, power_alone);
  return std::sqrt(by_power(near, nearest[1], factor) * by_step(near, nearest[1], factor));
}

std::optional<double> RunTimes::elements(double factor) const {
  if (made_.empty()) return std::nullopt;
  return elements_at(made_.back(), factor);
}

}  // namespace pinball
