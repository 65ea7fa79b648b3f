#pragma once

#include "tensor.hpp"

/// The nearest points of two edges: of their straight lines, at the fractions s and t of their lengths,
///
///     r = p1(s) - p2(t) ,    r . u = r . v = 0 ,    p1 = a + s u , p2 = c + t v .
///
/// (C. Ericson, Real-Time Collision Detection, 2005, section 5.1.8.)
namespace pinball {

template <class T>
struct EdgePair {
  T s, t;  ///< of the nearest points, beyond 0 and 1 where they lie outside; not numbers for parallel edges [-]
  Vec3<T> between;  ///< r, from edge 2 to edge 1 [length]
  T sine2;          ///< square of the sine of the angle between the edges [-]
};

/// a, b: ends of edge 1; c, d: of edge 2.
template <class T>
PINBALL_FUNCTION EdgePair<T> nearest_points(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& d) {
  const Vec3<T> u = b - a, v = d - c, w = a - c;
  const T uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const T determinant = uu * vv - uv * uv;
  EdgePair<T> pair;
  pair.sine2 = determinant / (uu * vv);
  pair.s = (uv * vw - vv * uw) / determinant;
  pair.t = (uu * vw - uv * uw) / determinant;
  pair.between = w + pair.s * u - pair.t * v;
  return pair;
}

}  // namespace pinball
