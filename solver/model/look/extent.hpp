#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <solver/base/point.hpp>

namespace pinball {

/// A box of places, or of displacements.
struct Extent {
  Point low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};

  void take(const Point& x) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  void take(const Extent& other) {
    take(other.low);
    take(other.high);
  }
  bool empty() const { return low[0] > high[0]; }
  /// Longest edge; 0 of a box that holds nothing.
  double size() const { return empty() ? 0.0 : std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
  /// Distance of its furthest corner from the origin; 0 of a box that holds nothing.
  double reach() const {
    Point most{};
    for (std::size_t k = 0; k < 3 && !empty(); ++k) most[k] = std::max(std::abs(low[k]), std::abs(high[k]));
    return norm(most);
  }
};

/// All sums of a place of one and a place of the other.
inline Extent operator+(const Extent& a, const Extent& b) {
  return {{a.low[0] + b.low[0], a.low[1] + b.low[1], a.low[2] + b.low[2]},
          {a.high[0] + b.high[0], a.high[1] + b.high[1], a.high[2] + b.high[2]}};
}
inline Extent operator-(const Extent& a, const Extent& b) {
  return {{a.low[0] - b.high[0], a.low[1] - b.high[1], a.low[2] - b.high[2]},
          {a.high[0] - b.low[0], a.high[1] - b.low[1], a.high[2] - b.low[2]}};
}
inline Extent hull(Extent a, const Extent& b) {
  a.take(b);
  return a;
}

/// Whether they come closer to each other than a margin.
inline bool overlap(const Extent& a, const Extent& b, double margin) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.low[k] > b.high[k] + margin || b.low[k] > a.high[k] + margin) return false;
  }
  return true;
}

}  // namespace pinball
