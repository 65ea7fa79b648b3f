#include "settings_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "error_costs.hpp"

namespace pinball {

namespace {

constexpr int most_meshes = 8, most_trials = 2;  ///< beyond those that were asked for; of each of the sources
constexpr double finer = 1.2, finest_step = 2;   ///< a mesh between others is at least so much finer, at most that
/// The least ratio of sizes from which extrapolation follows: Celik and others (2008). Beyond the finest one.
constexpr double much_finer = 1.3;
constexpr double worth = 0.9;  ///< part of the least time that other settings have to be expected in

/// Meshes that a run is made on next; none of them where it holds nothing.
struct Range {
  double least = 0, most = 0;
};

std::vector<std::size_t> all_quantities(const ConvergenceStudy& study) {
  std::vector<std::size_t> all(study.quantities.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<CostPoint> points_of_meshes(const ConvergenceStudy& study) {
  std::vector<CostPoint> points = cost_points(study);
  std::erase_if(points, [](const CostPoint& point) { return !point.variation.empty(); });
  return points;
}

/// Of the quantity whose order is least: what the factor has to grow by for an error that many times smaller.
double refinement_for(const ConvergenceStudy& study, double ratio) {
  double order = 2;
  for (const StudyQuantity& quantity : study.quantities) {
    const auto& c = quantity.convergence;
    if (c && c->verdict == Convergence::monotone) order = std::min(order, c->order);
  }
  return std::pow(ratio, 1 / order);
}

/// Whether no mesh helps: what chance does is more than the error.
bool chance_decides(const ConvergenceStudy& study, double error) {
  return std::any_of(study.quantities.begin(), study.quantities.end(), [&](const StudyQuantity& quantity) {
    const auto known = known_to(study, quantity);
    return known && known->chance && known->error > error;
  });
}

/// The largest part that an extrapolated value may err by; none: a quantity has no band.
std::optional<double> known_to_all(const ConvergenceStudy& study) {
  double largest = 0;
  for (const StudyQuantity& quantity : study.quantities) {
    const auto known = known_to(study, quantity);
    if (!known) return std::nullopt;
    largest = std::max(largest, known->error);
  }
  return largest;
}

Range beyond(double finest, double wanted) {
  return {finest * std::clamp(wanted, much_finer, finest_step), finest * finest_step};
}

/// Where the next mesh for an error is.
Range next_mesh(const ConvergenceStudy& study, double error) {
  const std::vector<CostPoint> points = points_of_meshes(study);
  const double finest = points.back().factor.value();
  const auto known = known_to_all(study);
  if (!known) return beyond(finest, finest_step);
  if (*known > error) return beyond(finest, refinement_for(study, *known / error));
  const auto all = all_quantities(study);
  const auto reaches = [&](const CostPoint& point) {
    const auto worst = worst_error(point, all);
    return worst && *worst <= error;
  };
  const auto first = std::find_if(points.begin(), points.end(), reaches);
  if (first == points.end()) {
    return beyond(finest, refinement_for(study, worst_error(points.back(), all).value_or(HUGE_VAL) / error));
  }
  const double good = first->factor.value();
  const double wanted = good * refinement_for(study, std::max(*worst_error(*first, all), 1e-12) / error);
  const double bad = first == points.begin() ? good / finest_step / finer : std::prev(first)->factor.value();
  const bool between = wanted > bad * finer || first == points.begin();
  return {between ? std::max(wanted, bad * finer) : std::sqrt(bad * good), good / finer};
}

/// The finest mesh in a range that is expected to fit into the time that is left.
std::optional<MeshFactor> finest_that_fits(const StudyMaker& maker, const Range& range) {
  std::optional<MeshFactor> found;
  for (double least = range.least; least <= range.most;) {
    const auto factor = least_mesh_factor(maker.scene(), least, range.most);
    if (!factor || maker.expected_seconds(*factor).value_or(0) > maker.seconds_left()) break;
    found = factor;
    least = factor->value() * (1 + 1e-6);
  }
  return found;
}

/// The coarsest mesh in a range; where that does not fit into the time, the finest that does and is finer than all.
std::optional<MeshFactor> mesh_in(const StudyMaker& maker, const Range& range) {
  if (!(range.least <= range.most)) return std::nullopt;
  const auto factor = least_mesh_factor(maker.scene(), range.least, range.most);
  const double finest = points_of_meshes(maker.study()).back().factor.value();
  const bool fits = factor && maker.expected_seconds(*factor).value_or(0) <= maker.seconds_left();
  if (!factor || fits || factor->value() < finest) return factor;
  const auto coarser = finest_that_fits(maker, {finest * much_finer, factor->value()});
  return coarser ? coarser : factor;
}

/// false: it was looked at before, does not fit into the time, or a signal ended it.
bool run_on(StudyMaker& maker, const std::optional<MeshFactor>& factor) {
  if (!factor) return false;
  const auto& meshes = maker.study().meshes;
  const auto is_it = [&factor](const StudyMesh& mesh) { return mesh.factor == *factor; };
  if (std::any_of(meshes.begin(), meshes.end(), is_it)) return false;
  maker.run_mesh(*factor);
  if (maker.study().stopped()) return false;
  const bool made = std::find_if(meshes.begin(), meshes.end(), is_it)->run.results.has_value();
  maker.draw();
  return made;
}

void search_meshes(StudyMaker& maker, double error) {
  for (int k = 0; k < most_meshes && !chance_decides(maker.study(), error); ++k) {
    if (!run_on(maker, mesh_in(maker, next_mesh(maker.study(), error)))) return;
  }
}

/// The point of a source on its mesh; none: its run failed.
std::optional<CostPoint> point_of_source(const ConvergenceStudy& study, std::size_t source) {
  for (const CostPoint& point : cost_points(study)) {
    if (point.variation == study.sources[source].name && point.factor == study.meshes[study.sources_mesh].factor) {
      return point;
    }
  }
  return std::nullopt;
}

/// Runs with other settings on the mesh on which these should reach the error, and where they do not on a finer one.
void search_source(StudyMaker& maker, std::size_t source, double error) {
  const auto all = all_quantities(maker.study());
  const auto point = point_of_source(maker.study(), source);
  const auto errs = point ? worst_error(*point, all) : std::nullopt;
  if (!errs) return;
  const double own = point->factor.value();
  const double grows = refinement_for(maker.study(), std::max(*errs, 1e-12) / error);
  Range range{own * std::max(grows, 1 / finest_step), own * finest_step};
  for (int k = 0; k < most_trials; ++k) {
    const auto factor = least_mesh_factor(maker.scene(), range.least, range.most);
    if (!factor || *factor == point->factor) return;
    const std::vector<CostPoint> points = cost_points(maker.study());
    const auto best = cheapest(points, all, error);
    const auto expected = maker.expected_seconds(*factor, source);
    if (best && expected && *expected > worth * points[*best].seconds) return;
    maker.run_trial(source, *factor);
    const StudyRun& made = maker.study().trials.back().run;
    if (!made.results) return;
    const std::vector<CostPoint> with = cost_points(maker.study());
    const auto worst = worst_error(with.back(), all);
    if (worst && *worst <= error) return;
    range.least = factor->value() * finer;
  }
}

void search_sources(StudyMaker& maker, double error) {
  for (std::size_t s = 0; s < maker.study().sources.size() && !maker.study().stopped(); ++s) {
    const ErrorSource source = maker.study().sources[s].source;
    if (source != ErrorSource::chance && source != ErrorSource::body) search_source(maker, s, error);
  }
}

void spend_time(StudyMaker& maker) {
  for (int k = 0; k < most_meshes; ++k) {
    const std::vector<CostPoint> points = points_of_meshes(maker.study());
    const double finest = points.back().factor.value(), coarsest = points.front().factor.value();
    auto factor = finest_that_fits(maker, {finest * much_finer, finest * finest_step});
    if (!factor && points.size() == 2) factor = finest_that_fits(maker, {coarsest * finer, finest / finer});
    if (!factor && points.size() < 3) factor = finest_that_fits(maker, {coarsest / finest_step, coarsest / finer});
    if (!run_on(maker, factor)) return;
  }
}

}  // namespace

void search_settings(StudyMaker& maker) {
  const StudyLimits& limits = maker.study().limits;
  if (points_of_meshes(maker.study()).empty() || maker.study().quantities.empty()) return;
  if (limits.error) {
    search_meshes(maker, *limits.error);
    if (!maker.study().stopped()) search_sources(maker, *limits.error);
  } else if (limits.seconds) {
    spend_time(maker);
  }
}

}  // namespace pinball
