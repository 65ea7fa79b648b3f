#pragma once

#include <optional>
#include <string>
#include <vector>

#include <solver/program/study/convergence_study.hpp>

/// What the runs of a study took, and how wrong they are.
namespace pinball {

/// A run as a point of time against error. Errors are |value - extrapolated| over |extrapolated|, or over the scale of
/// the quantity where that is a thousand times as large; none: the quantity has no band, or the run no value.
struct CostPoint {
  std::string settings;   ///< "mesh 2", "mesh 1, float"
  std::string what;       ///< "bar: core 8, ring 4, layers 80; precision = \"float\""
  std::string variation;  ///< of the scene's settings: "float"; empty: none
  MeshFactor factor;
  bool of_chance = false;        ///< another run of an ensemble, which nobody would choose
  bool other_precision = false;  ///< of the run alone
  double seconds = 0;            ///< of the run, but for its files [s]
  double bytes = 0;              ///< of the arrays of its state
  double elements = 0;
  std::vector<std::optional<double>> values;  ///< of each quantity of the study
  std::vector<std::optional<double>> errors;  ///< of these
  /// The largest of that and those of all finer runs with the same settings: a coarse mesh may be right by chance. In
  /// another precision also that of the same mesh in its own: round-off makes nothing better.
  std::vector<std::optional<double>> held;
};

/// Of all runs that came to their ends, from coarse to fine, those with other settings behind.
std::vector<CostPoint> cost_points(const ConvergenceStudy& study);

/// Indices of the points that no other is both as fast and as good as (by `held`), from the fastest to the best.
std::vector<std::size_t> frontier(const std::vector<CostPoint>& points, std::size_t quantity);

/// The fastest point that holds this error in each of the quantities.
std::optional<std::size_t> cheapest(const std::vector<CostPoint>& points, const std::vector<std::size_t>& quantities,
                                    double error);

/// The largest held error of the quantities; none: one has none.
std::optional<double> worst_error(const CostPoint& point, const std::vector<std::size_t>& quantities);

/// The least error that a study can tell.
struct KnownTo {
  double error = 0;     ///< as of CostPoint
  bool chance = false;  ///< the deviation of the ensemble; else what the extrapolated value itself may err by
};

/// None: the quantity has no band.
std::optional<KnownTo> known_to(const ConvergenceStudy& study, const StudyQuantity& quantity);

}  // namespace pinball
