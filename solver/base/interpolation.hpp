#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pinball {

/// Value at x of the piecewise linear function through the points; that of the first or last point beyond them, and of
/// the last of several at one place.
/// xs: at least one, rising.
inline double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const std::size_t after = std::upper_bound(xs.begin(), xs.end(), x) - xs.begin();
  if (after == 0) return ys.front();
  if (after == xs.size()) return ys.back();
  const double part = (x - xs[after - 1]) / (xs[after] - xs[after - 1]);
  return ys[after - 1] + part * (ys[after] - ys[after - 1]);
}

}  // namespace pinball
