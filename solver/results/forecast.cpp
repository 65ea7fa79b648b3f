#include "forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pinball {

namespace {

constexpr double strain_share = 0.6, strain_of_impact = 3.5, most_strain = 3.72, wakes_within = 0.1;
constexpr double cost_of_contact = 0.2, cost_of_folds = 0.7, cost_of_yielding = 0.25;
constexpr double steps_of_lists = 20, usual_iterations = 10;
/// What a solution costs besides, in iterations.
constexpr double fixed_iterations = 3;
/// Pairs that later lists have, over those of the first ones, where nothing touches.
constexpr double of_later_lists = 0.25;
/// Part of the run after which its own last steps say all.
constexpr double settled = 0.7;

/// Of contact that is still to come, over a step; speed, surface: as the forecast has them.
double contact_to_come(const Scene& scene, double speed, double surface) {
  if (!(speed > 0)) return 0;
  return surface * (scene.bodies.size() > 1 ? cost_of_contact : cost_of_folds);
}

/// With which a material flows at the strains of an impact, as far as it says so by one number [stress].
double flow_stress(const Material& m) {
  if (const auto& brittle = m.johnson_holmquist) {
    return brittle->intact_strength * 1.5 * (brittle->elastic_limit - brittle->elastic_limit_pressure);
  }
  if (const auto& granular = m.drucker_prager) {  // at the pressure at which it is pressed with as much
    return std::sqrt(3 * (granular->constant + granular->linear * granular->linear));
  }
  if (const auto& foam = m.crushable_foam) return std::ranges::max(foam->yield_stress);
  return m.yield_stress + (m.johnson_cook ? m.johnson_cook->hardening_coefficient : 0.0);
}

/// Strain at which a material erodes, as far as one number says so: by Johnson and Cook's failure that of a bar under
/// tension, D1 + D2 exp(D3/3); infinite where nothing limits it [-].
double eroded_strain(const Material& m) {
  double least = HUGE_VAL;
  const auto take = [&least](double strain) {
    if (strain > 0) least = std::min(least, strain);
  };
  take(m.erosion_strain);
  if (m.johnson_cook && m.johnson_cook->failure.size() > 2) {
    const std::vector<double>& d = m.johnson_cook->failure;
    take(d[0] + d[1] * std::exp(d[2] / 3));
  }
  if (m.erosion) {
    take(m.erosion->principal_strain);
    take(m.erosion->shear_strain);
  }
  return least;
}

/// By how much the steps of a run are smaller than its first, in the mean.
double shrinking(const Scene& scene, double speed) {
  double most = 1;
  for (const Material& m : scene.materials) {
    if (!m.plastic || m.fluid) continue;
    double strain = strain_of_impact * m.density * speed * speed / flow_stress(m);
    const double most_of_it = eroded_strain(m);
    if (std::isfinite(most_of_it)) strain = speed > 0 ? std::min(strain, most_of_it) : most_of_it;
    most = std::max(most, std::exp(strain_share * std::min(strain, most_strain)));
  }
  return most;
}

}  // namespace

double StepPhases::settled(double waking) const {
  const double all = elements + searches + impulses + others;
  if (!(all > 0)) return waking;
  const double list = lists > 0 ? searches / lists : of_list;
  const double later = list > 0 ? list * steps / steps_of_lists : searches;
  const double iterations_part = std::min(1.0, (usual_iterations + fixed_iterations) / (iterations + fixed_iterations));
  return (elements * waking + later + impulses * (touching ? iterations_part : of_later_lists) + others) / all;
}

Forecast::Forecast(const Scene& scene, double speed, double surface)
    : end_(scene.time.end),
      shrinking_(shrinking(scene, speed)),
      strikes_(speed > 0),
      contact_(contact_to_come(scene, speed, surface)),
      most_steps_(scene.time.steps) {}

void Forecast::take(const RunPlace& place) { places_.push_back(place); }

double Forecast::seconds_per_step() const {
  const RunPlace &first = places_.front(), &now = places_.back();
  if (now.steps == first.steps) return now.seconds / std::max<std::int64_t>(now.steps, 1);
  return (now.seconds - first.seconds) / (now.steps - first.steps);
}

double Forecast::length_of_steps(double trust) const {
  const RunPlace &first = places_.front(), &now = places_.back();
  // Of the later half of what is known.
  const auto half = std::ranges::find_if(
      places_, [&](const RunPlace& place) { return place.seconds >= (first.seconds + now.seconds) / 2; });
  const RunPlace& from = half == places_.end() - 1 && places_.size() > 1 ? places_[places_.size() - 2] : *half;
  const bool known = now.steps > from.steps && now.time > from.time;
  const double last = known ? (now.time - from.time) / (now.steps - from.steps) : now.dt;
  // The first ones may be short for an impact, and what contact bounds is not what elements are stable with.
  const double longest = std::ranges::max(places_, {}, &RunPlace::dt).dt;
  return std::pow(last, trust) * std::pow(longest / shrinking_, 1 - trust);
}

ExpectedRun Forecast::expected(double at_rest, const StepPhases& phases) const {
  const RunPlace& now = places_.back();
  const double share = std::clamp(now.time / end_, 0.0, 1.0), trust = std::pow(std::min(1.0, share / settled), 2);
  const double step = length_of_steps(trust);
  double left = std::max(0.0, end_ - now.time) / step;
  if (most_steps_ >= 0) left = std::min(left, static_cast<double>(most_steps_ - now.steps));
  left = std::max(left, 0.0);
  at_rest = std::clamp(at_rest, 0.0, 0.95);
  const double will_rest = share > wakes_within ? at_rest : at_rest / 2;
  const double yielding = strikes_ && shrinking_ > 1 ? 1 + cost_of_yielding * (1 - trust) : 1;
  double cost = seconds_per_step() * phases.settled(yielding * (1 - will_rest) / (1 - at_rest));
  const bool touched = std::ranges::any_of(places_, [](const RunPlace& place) { return place.touching; });
  if (!touched) cost *= 1 + contact_ * (1 - trust);
  return {now.steps + left, now.seconds + left * cost, std::min(end_, now.time + left * step)};
}

}  // namespace pinball
