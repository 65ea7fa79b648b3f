#include "error_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

bool has_band(const StudyQuantity& quantity) { return quantity.convergence && quantity.convergence->has_band(); }

/// What errors of the quantity are divided by.
double reference_size(const StudyQuantity& quantity) {
  const double value = std::abs(quantity.convergence->extrapolated);
  return value > small_value * quantity.scale ? value : quantity.scale;
}

double over_reference(double error, const StudyQuantity& quantity) {
  const double size = reference_size(quantity);
  return size > 0 ? std::abs(error) / size : 0;
}

CostPoint point_of(const ConvergenceStudy& study, const StudyRun& run, const MeshFactor& factor) {
  CostPoint point;
  point.factor = factor;
  point.settings = "mesh " + factor.text();
  point.seconds = run.results->seconds();
  point.elements = run.results->value("elements").value_or(0);
  point.bytes = run.results->value("bytes_per_element").value_or(0) * point.elements;
  for (const StudyQuantity& quantity : study.quantities) {
    const auto value = quantity.value_in(*run.results);
    point.values.push_back(value);
    point.errors.push_back(value && has_band(quantity)
                               ? std::optional(over_reference(*value - quantity.convergence->extrapolated, quantity))
                               : std::nullopt);
  }
  return point;
}

void add_variation(const std::string& counts, const StudySource& source, CostPoint& point) {
  point.variation = source.name;
  point.settings += ", " + source.name;
  point.what = counts + "; " + source.what;
  point.of_chance = source.source == ErrorSource::chance;
  point.other_precision = source.source == ErrorSource::precision;
}

/// Whether a run is no better than another one, whatever its error says.
bool holds(const CostPoint& point, const CostPoint& other) {
  const bool rounded = point.other_precision && other.variation.empty() && other.factor == point.factor;
  const bool finer = other.variation == point.variation && other.factor.value() > point.factor.value();
  return rounded || finer;
}

void hold(std::vector<CostPoint>& points) {
  for (CostPoint& point : points) {
    point.held = point.errors;
    for (const CostPoint& other : points) {
      if (!holds(point, other)) continue;
      for (std::size_t q = 0; q < point.held.size(); ++q) {
        if (point.held[q] && other.errors[q]) point.held[q] = std::max(*point.held[q], *other.errors[q]);
      }
    }
  }
}

}  // namespace

std::vector<CostPoint> cost_points(const ConvergenceStudy& study) {
  std::vector<CostPoint> points;
  for (const StudyMesh& mesh : study.meshes) {
    if (!mesh.run.results) continue;
    points.push_back(point_of(study, mesh.run, mesh.factor));
    points.back().what = mesh.counts;
  }
  for (const StudySource& source : study.sources) {
    const StudyMesh& mesh = study.meshes[study.sources_mesh];
    for (const StudyRun& run : source.runs) {
      if (!run.results) continue;
      points.push_back(point_of(study, run, mesh.factor));
      add_variation(mesh.counts, source, points.back());
    }
  }
  for (const StudyTrial& trial : study.trials) {
    if (!trial.run.results) continue;
    points.push_back(point_of(study, trial.run, trial.factor));
    add_variation(trial.counts, study.sources[trial.source], points.back());
  }
  hold(points);
  return points;
}

std::optional<double> worst_error(const CostPoint& point, const std::vector<std::size_t>& quantities) {
  double worst = 0;
  for (const std::size_t q : quantities) {
    if (!point.held[q]) return std::nullopt;
    worst = std::max(worst, *point.held[q]);
  }
  return worst;
}

std::vector<std::size_t> frontier(const std::vector<CostPoint>& points, std::size_t quantity) {
  std::vector<std::size_t> sorted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].held[quantity] && !points[i].of_chance) sorted.push_back(i);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](std::size_t a, std::size_t b) { return points[a].seconds < points[b].seconds; });
  std::vector<std::size_t> kept;
  for (const std::size_t i : sorted) {
    if (kept.empty() || *points[i].held[quantity] < *points[kept.back()].held[quantity]) kept.push_back(i);
  }
  return kept;
}

std::optional<std::size_t> cheapest(const std::vector<CostPoint>& points, const std::vector<std::size_t>& quantities,
                                    double error) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto worst = worst_error(points[i], quantities);
    if (points[i].of_chance || !worst || *worst > error) continue;
    if (!best || points[i].seconds < points[*best].seconds) best = i;
  }
  return best;
}

std::optional<KnownTo> known_to(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  if (!has_band(quantity)) return std::nullopt;
  const GridConvergence& c = *quantity.convergence;
  const double beyond = quantity.limit ? c.high * (1 - 1 / std::max(c.safety_factor, 1.0))
                                       : std::min(c.high - c.extrapolated, c.extrapolated - c.low);
  KnownTo known{over_reference(beyond, quantity), false};
  for (std::size_t s = 0; s < study.sources.size(); ++s) {
    if (study.sources[s].source != ErrorSource::chance || s >= quantity.moved.size() || !quantity.moved[s]) continue;
    const double of_chance = over_reference(*quantity.moved[s], quantity);
    if (of_chance > known.error) known = {of_chance, true};
  }
  return known;
}

}  // namespace pinball
