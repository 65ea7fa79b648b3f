#pragma once

#include <cmath>

#include <kernels/macros.hpp>
#include <kernels/tensor.hpp>

/// The point of a face that is nearest to another point. A face with four corners is taken for the four triangles
/// between its edges and the mean of its corners: the same surface where it is flat, without a gap to its neighbours in
/// any case, and there is always a nearest point, however the face is warped or collapsed. (Point against triangle: C.
/// Ericson, Real-Time Collision Detection, 2005, section 5.1.5.)
namespace pinball {

template <class S>
struct NearestOnFace {
  S weight[4];   ///< of the corners, at the point; together 1 [-]
  Vec3<S> away;  ///< from the point to the other one [length]
  S distance;    ///< [length]
  /// Corners between which the point lies on the rim, the same twice where it is a corner; -1 inside the face.
  int rim[2];
};

/// Weights of the corners of a triangle at its point that is nearest to the origin.
template <class S>
PINBALL_FUNCTION void nearest_on_triangle(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c, S (&weight)[3]) {
  const auto set = [&weight](S wa, S wb, S wc) {
    weight[0] = wa;
    weight[1] = wb;
    weight[2] = wc;
  };
  // A part of two numbers that are not negative; 0 where both are zero.
  const auto part = [](S some, S other) { return some + other > S(0) ? some / (some + other) : S(0); };
  const Vec3<S> ab = b - a, ac = c - a;
  const S a1 = S(0) - dot(ab, a), a2 = S(0) - dot(ac, a);
  if (a1 <= S(0) && a2 <= S(0)) return set(1, 0, 0);
  const S b1 = S(0) - dot(ab, b), b2 = S(0) - dot(ac, b);
  if (b1 >= S(0) && b2 <= b1) return set(0, 1, 0);
  const S of_c = a1 * b2 - b1 * a2;
  if (of_c <= S(0) && a1 >= S(0) && b1 <= S(0)) {
    const S v = part(a1, S(0) - b1);
    return set(1 - v, v, 0);
  }
  const S c1 = S(0) - dot(ab, c), c2 = S(0) - dot(ac, c);
  if (c2 >= S(0) && c1 <= c2) return set(0, 0, 1);
  const S of_b = c1 * a2 - a1 * c2;
  if (of_b <= S(0) && a2 >= S(0) && c2 <= S(0)) {
    const S w = part(a2, S(0) - c2);
    return set(1 - w, 0, w);
  }
  const S of_a = b1 * c2 - c1 * b2;
  if (of_a <= S(0) && b2 >= b1 && c1 >= c2) {
    const S w = part(b2 - b1, c1 - c2);
    return set(0, 1 - w, w);
  }
  const S all = S(1) / (of_a + of_b + of_c);
  set(1 - (of_b + of_c) * all, of_b * all, of_c * all);
}

/// x: corners of the face.
template <class S>
PINBALL_FUNCTION NearestOnFace<S> nearest_on_face(const Vec3<S> (&x)[4], const Vec3<S>& point) {
  constexpr S on_the_rim = S(1e-6);  // part of a triangle [-]
  const Vec3<S> y[4] = {x[0] - point, x[1] - point, x[2] - point, x[3] - point};
  const Vec3<S> middle = S(0.25) * (y[0] + y[1] + y[2] + y[3]);
  NearestOnFace<S> nearest{};
  S least = INFINITY;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    S w[3];
    nearest_on_triangle(middle, y[k], y[next], w);
    const Vec3<S> to = w[0] * middle + w[1] * y[k] + w[2] * y[next];
    const S distance2 = dot(to, to);
    if (!(distance2 < least)) continue;
    least = distance2;
    nearest.away = S(-1) * to;
    for (S& weight : nearest.weight) weight = S(0.25) * w[0];
    nearest.weight[k] += w[1];
    nearest.weight[next] += w[2];
    const bool rim = w[0] < on_the_rim;
    nearest.rim[0] = !rim ? -1 : w[2] > S(1) - on_the_rim ? next : k;
    nearest.rim[1] = !rim ? -1 : w[1] > S(1) - on_the_rim ? k : next;
  }
  nearest.distance = std::sqrt(least);
  return nearest;
}

}  // namespace pinball
