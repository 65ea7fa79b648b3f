#pragma once

#include <vector>

namespace pinball {

/// A column of a history over time, linear between its rows.
struct TimeCurve {
  std::vector<double> times, values;  ///< as many of both; times rise
};

/// Root of the mean over time of the square of the difference, over the range that both have; of one and no other, of
/// its own square. Exact for curves that are linear between rows, whose times need not be the same. 0 without a range.
double distance(const TimeCurve& a, const TimeCurve& b);
double norm(const TimeCurve& a);

/// fine + share (fine - coarse), at the times of fine.
TimeCurve beyond(const TimeCurve& fine, const TimeCurve& coarse, double share);

/// The mean of curves, at the times of the first; at least one.
TimeCurve mean_of(const std::vector<TimeCurve>& curves);

}  // namespace pinball
