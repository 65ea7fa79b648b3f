#include "comparison_times.hpp"

#include <algorithm>

#include <solver/results/timers.hpp>

namespace pinball {

namespace {

double seconds_in(const RunSummary& run, Phase phase) { return run.phases.at(static_cast<std::size_t>(phase)).seconds; }

template <class Time>
Spread spread_of(const VariantRuns& variant, const Time& time) {
  std::vector<double> seconds;
  for (const RunSummary& run : variant.repeats) seconds.push_back(time(run));
  std::sort(seconds.begin(), seconds.end());
  const std::size_t n = seconds.size();
  return {0.5 * (seconds.at((n - 1) / 2) + seconds.at(n / 2)), seconds.front(), seconds.back()};
}

}  // namespace

VariantTimes times_of(const VariantRuns& variant) {
  const auto surface = [](const RunSummary& run) { return seconds_in(run, Phase::pinballs); };
  const auto search = [](const RunSummary& run) { return seconds_in(run, Phase::contact_search); };
  const auto forces = [](const RunSummary& run) {
    return seconds_in(run, Phase::contact_forces) + seconds_in(run, Phase::contact_scatter);
  };
  VariantTimes times;
  times.total = spread_of(variant, [](const RunSummary& run) { return run.wall_seconds; });
  times.contact = spread_of(variant, [&](const RunSummary& run) { return surface(run) + search(run) + forces(run); });
  times.surface = spread_of(variant, surface);
  times.search = spread_of(variant, search);
  times.forces = spread_of(variant, forces);
  if (times.total.median > 0) times.contact_share = times.contact.median / times.total.median;
  return times;
}

TimeRatios first_over(const VariantRuns& first, const VariantRuns& other) {
  if (!first.failure.empty() || !other.failure.empty()) return {};
  const VariantTimes a = times_of(first), b = times_of(other);
  const auto ratio = [](const Spread& of_first, const Spread& of_other) {
    return of_other.median > 0 ? std::optional(of_first.median / of_other.median) : std::nullopt;
  };
  return {ratio(a.total, b.total), ratio(a.contact, b.contact)};
}

}  // namespace pinball
