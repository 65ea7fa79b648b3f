#pragma once

#include "tensor.hpp"

/// Points of two edges that face each other along a direction n, on their straight lines at the fractions s and t of
/// their lengths,
///
///     r = p1(s) - p2(t) ,    r x n = 0 ,    p1 = a + s u , p2 = c + t v .
///
/// Those with n = u x v are the nearest (C. Ericson, Real-Time Collision Detection, 2005, section 5.1.8; products of
/// vectors in the place of his of numbers, whose round-off grows with the square of how near to parallel edges are).
namespace pinball {

template <class T>
struct EdgePair {
  T s, t;           ///< beyond 0 and 1 where the points lie outside; not numbers for parallel edges [-]
  Vec3<T> between;  ///< r, from edge 2 to edge 1 [length]
  T sine2;          ///< square of the sine of the angle between the edges [-]
};

/// a, b: ends of edge 1; c, d: of edge 2; n: not along the plane of both, of any length.
template <class T>
PINBALL_FUNCTION EdgePair<T> facing_points(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& d,
                                           const Vec3<T>& n) {
  const Vec3<T> u = b - a, v = d - c, w = a - c, across = cross(u, v);
  const T product = dot(across, n);
  EdgePair<T> pair;
  pair.sine2 = dot(across, across) / (dot(u, u) * dot(v, v));
  pair.s = dot(cross(v, w), n) / product;
  pair.t = dot(cross(u, w), n) / product;
  pair.between = w + pair.s * u - pair.t * v;
  return pair;
}

/// The nearest points of both.
template <class T>
PINBALL_FUNCTION EdgePair<T> nearest_points(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& d) {
  return facing_points(a, b, c, d, cross(b - a, d - c));
}

}  // namespace pinball
