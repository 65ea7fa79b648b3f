#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// Points, and vector algebra on them.
namespace pinball {

using Point = std::array<double, 3>;

inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double norm(const Point& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

/// Subtracts the parts along an orthonormal basis; returns the length of what is left, which becomes a unit vector.
inline double make_orthogonal(Point& d, const std::vector<Point>& basis) {
  for (const Point& b : basis) {
    const double along = dot(d, b);
    for (std::size_t k = 0; k < 3; ++k) d[k] -= along * b[k];
  }
  const double length = std::sqrt(dot(d, d));
  for (double& v : d) v /= length > 0 ? length : 1;
  return length;
}

}  // namespace pinball
