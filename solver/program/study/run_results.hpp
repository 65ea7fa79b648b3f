#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <solver/scene/units/units.hpp>
#include <solver/simulation.hpp>

#include "time_curve.hpp"

namespace pinball {

/// What a run has left in its folder, as numbers with names. A quantity is one of
///
/// - COLUMN, COLUMN:last, COLUMN:max, COLUMN:min, COLUMN:integral of the rows of history.csv; COLUMN alone is the last
///   one, and the integral is over time, by trapezia;
/// - length(PROBE,PROBE), the distance of two probes that record their positions, as a column;
/// - COLUMN:curve, a column as a whole, which is no number;
/// - energy.kinetic, bodies.bar.max_plastic_strain, contact.pairs.pair.impulse.x: a number of summary.json by its keys,
///   with names in the place of numbers in a list, and x, y, z of vectors.
struct RunResults {
  std::string status;                               ///< "done", "failed", ...
  std::map<std::string, double> numbers;            ///< of summary.json
  std::vector<std::string> columns;                 ///< of history.csv
  std::map<std::string, std::vector<double>> rows;  ///< by column
  std::vector<std::string> warnings;

  /// Of history.csv, or a length; none: there is none of that name, or it has no row.
  std::optional<std::vector<double>> column(const std::string& name) const;
  /// Of a quantity that is one; none: it is a number, or not there.
  std::optional<TimeCurve> curve(const std::string& quantity) const;
  /// Numbers only: not a null of summary.json, and no column without a row.
  std::optional<double> value(const std::string& quantity) const;
  /// What the quantity is measured by where it is small: the largest size over time of the vector that it is a
  /// component of, of all energies where it is one, of its column; at least its own.
  double scale(const std::string& quantity) const;
  /// That the run took, but for its files, of which runs of a study write different ones [s].
  double seconds() const;
  /// Columns and numbers.
  std::vector<std::string> known() const;
};

/// What a run will leave, by its names: all numbers are those before its first step, or 0.
RunResults results_to_come(const Simulation& simulation);

/// Whether a quantity is a curve: COLUMN:curve.
bool is_curve(const std::string& quantity);

/// Throws RunError where the folder has no summary.json or history.csv of a run, or they cannot be read.
RunResults read_run_results(const std::string& folder);

/// The unit of a quantity as the scene names it; empty: it has none, or none is named.
std::string unit_of_quantity(const std::string& quantity, const Units& units);

}  // namespace pinball
