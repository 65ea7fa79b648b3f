#pragma once

#include <optional>
#include <string>
#include <vector>

#include <solver/output/page/curves.hpp>

#include "other_history.hpp"

namespace pinball {

/// A quantity of this run beside that of another program, over the times that both have. Shares are of the largest size
/// that the other program's quantity has there.
struct CurveDifference {
  std::string name;                        ///< as the other program has it
  std::string columns;                     ///< of history.csv, "internal + bulk_viscosity"
  double end_time = 0;                     ///< the last time that both have [time]
  double here = 0, there = 0;              ///< at that time
  double scale = 0;                        ///< the largest size there
  std::optional<double> at_end;            ///< (here - there) / scale; none where all is zero there
  std::optional<double> largest;           ///< the largest of |here - there| / scale
  double largest_time = 0;                 ///< when that is [time]
  std::optional<double> root_mean_square;  ///< of (here - there) / scale over time
};

/// Of all quantities that both have. The run's curve is taken at the other's times, by straight lines between its rows;
/// times without a number there are left out. mass: of the model [mass]. Empty: there are none, or no times that both
/// have.
std::vector<CurveDifference> curve_differences(const Curves& curves, const OtherHistory& other, double mass);

/// Names of what the other program has and this one has not.
std::vector<std::string> without_meaning(const Curves& curves, const OtherHistory& other);

/// At a time between the first and the last of `times`, which rise: by a straight line.
double value_between(const std::vector<double>& times, const std::vector<double>& values, double time);

/// Whether the history has all that is meant.
bool has_columns(const Curves& curves, const Meaning& meaning);

/// What the meaning of a curve is in each row; empty where the history has not all of its columns.
std::vector<double> values_of(const Curves& curves, const Meaning& meaning, double mass);

}  // namespace pinball
