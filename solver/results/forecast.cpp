#include "forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

constexpr double strain_share = 0.55, strain_of_impact = 3.5, most_strain = 4, cost_of_contact = 0.3,
                 wakes_within = 0.1;
/// Part of the run after which its own last steps say all.
constexpr double settled = 0.7;

/// By how much the steps of a run are smaller than its first.
double shrinking(const Scene& scene, double speed) {
  double most = 1;
  for (const Material& m : scene.materials) {
    if (!m.plastic) continue;
    double strain = strain_of_impact * m.density * speed * speed / m.yield_stress;
    if (m.erosion_strain > 0) strain = speed > 0 ? std::min(strain, m.erosion_strain) : m.erosion_strain;
    most = std::max(most, std::exp(strain_share * std::min(strain, most_strain)));
  }
  return most;
}

}  // namespace

Forecast::Forecast(const Scene& scene, double speed)
    : end_(scene.time.end), shrinking_(shrinking(scene, speed)), most_steps_(scene.time.steps), meets_(speed > 0) {}

void Forecast::take(const RunPlace& place) { places_.push_back(place); }

ExpectedRun Forecast::expected(double at_rest) const {
  const RunPlace &first = places_.front(), &now = places_.back();
  // The later half of what is known.
  const auto half = std::ranges::find_if(
      places_, [&](const RunPlace& place) { return place.seconds >= (first.seconds + now.seconds) / 2; });
  const RunPlace& from = half == places_.end() - 1 && places_.size() > 1 ? places_[places_.size() - 2] : *half;
  const double steps = std::max(1.0, static_cast<double>(now.steps - from.steps));
  const double share = std::clamp(now.time / end_, 0.0, 1.0), trust = std::min(1.0, share / settled);
  const double last = now.time > from.time ? (now.time - from.time) / steps : now.dt;
  const double shrunk = std::min(last, first.dt / shrinking_);
  const double step = std::pow(last, trust) * std::pow(shrunk, 1 - trust);
  double left = std::max(0.0, end_ - now.time) / step;
  if (most_steps_ >= 0) left = std::min(left, static_cast<double>(most_steps_ - now.steps));
  at_rest = std::clamp(at_rest, 0.0, 0.95);
  const double will_rest = share > wakes_within ? at_rest : at_rest / 2;
  double cost = (now.seconds - from.seconds) / steps * (1 - will_rest) / (1 - at_rest);
  const bool touched = std::ranges::any_of(places_, [](const RunPlace& place) { return place.touching; });
  if (meets_ && !touched) cost *= 1 + cost_of_contact * (1 - trust);
  left = std::max(left, 0.0);
  return {static_cast<double>(now.steps) + left, now.seconds + left * cost};
}

}  // namespace pinball
