#pragma once

#include <cstdint>

#include "corner_differences.hpp"
#include "hexahedron.hpp"

/// What keeps a hexahedron from turning inside out at a corner.
///
/// The volume of an element says nothing of its corners: stresses resist its change, and hourglass forces resist the
/// modes that turn corners over, but they yield. The Jacobian of a corner,
///
///     J_I = a_xi . (a_eta x a_zeta) ,    a_m: half of the edge at corner I along parent axis m ,
///
/// is V/8 for all corners of a parallelepiped of volume V. Corners whose share r_I = 8 J_I/V has become less than an
/// onset r_0 store an energy that grows without bound towards zero:
///
///     W = V_0 M/8 sum_I phi(r_I) ,   phi(r) = (r_0 - r)^2 / (2 r_0 r)   for r < r_0, else 0 ,
///     f = -dW/dx ,   dr_I = 8/V dJ_I - r_I/V dV .
///
/// Below r_0/64 phi goes on along its tangent, so that a corner that came there by a leap finds its way back. W depends
/// on places alone: what it takes it gives back, it has neither resultant nor moment, and a motion as a whole does not
/// change it.
///
/// Sub-zonal pressures of hydrocodes (Caramana and Shashkov, J. Comput. Phys. 142, 521-561, 1998) resist every
/// difference between the volumes at corners, and with it bending; the barrier of mesh optimisation, which grows
/// without bound as a Jacobian vanishes (Ivanenko, USSR Comput. Math. Math. Phys. 28(5), 141-146, 1988), is here out of
/// reach of elements that are not about to fold. Corners at an edge of no length, as collapsed elements have, are left
/// out.
namespace pinball {

/// A bound on how far the half edges of corners differ from those of the centre, X: they are X (1 + E), and this is not
/// less than |E|^2 V^2. largest_gradient_square: largest principal value of sum_I B_I (x) B_I [length^4].
template <class T>
PINBALL_FUNCTION T largest_distortion(const HexahedronModes<T>& x, const T& largest_gradient_square) {
  // |E|^2 <= sum over axes m of 3 (|H_j| + |H_k| + |H_4|)^2, times the largest principal value of (X X^T)^-1, which is
  // 8/V^2 that of B; and (a + b + c)^2 <= 2.2 (a^2 + b^2) + 11 c^2
  const auto square = [&x](int a) { return dot(x.hourglass[a], x.hourglass[a]); };
  return largest_gradient_square *
         (number<T>(105.6) * (square(0) + square(1) + square(2)) + number<T>(792) * square(3));
}

/// The same with the principal values that lie in the directions of the modes: less by the square of the ratio of the
/// edges where an element is flat and its modes lie in its plane. gradient_square: sum_I B_I (x) B_I [length^4].
template <class T>
PINBALL_FUNCTION T directed_distortion(const HexahedronModes<T>& x, const Symmetric<T>& gradient_square) {
  const Vec3<T>&a = x.hourglass[0], &b = x.hourglass[1], &c = x.hourglass[2], &d = x.hourglass[3];
  const Vec3<T> e = number<T>(7.5) * d;  // 792/105.6
  const Symmetric<T>& s = gradient_square;
  const T direct = (a.x * a.x + b.x * b.x + c.x * c.x + d.x * e.x) * s.xx +
                   (a.y * a.y + b.y * b.y + c.y * c.y + d.y * e.y) * s.yy +
                   (a.z * a.z + b.z * b.z + c.z * c.z + d.z * e.z) * s.zz;
  const T oblique = (a.x * a.y + b.x * b.y + c.x * c.y + d.x * e.y) * s.xy +
                    (a.y * a.z + b.y * b.z + c.y * c.z + d.y * e.z) * s.yz +
                    (a.z * a.x + b.z * b.x + c.z * c.x + d.z * e.x) * s.zx;
  return number<T>(105.6) * (direct + T(2) * oblique);
}

/// Where |E| is less than the root of this no corner has less than 0.3 of the mean.
template <class S>
inline constexpr S sound_distortion = S(0.0729);

/// Where it is less than the root of this no corner has less than twice the onset. Of E a determinant is at least that
/// of three equal parts of -|E|/sqrt3: (1 - 0.25/sqrt3)^3 = 0.626, and what V and B differ from those of the centre
/// takes 2 %.
template <class S>
inline constexpr S open_distortion = S(0.0625);

/// The onset r_0 of an element that is well shaped at the start [-].
template <class S>
inline constexpr S folding_onset = S(0.3);

/// The corner at the ends xi, eta, zeta of the parent axes, 0 or 1 each.
PINBALL_FUNCTION constexpr int corner_at(int xi, int eta, int zeta) { return 4 * zeta + (eta == 0 ? xi : 3 - xi); }

/// Half of each edge along the parent axes; number 2 b + a of those along axis m is at the ends a and b of the other
/// two axes, in their order.
template <class T>
struct HalfEdges {
  Vec3<T> along[3][4];
};

template <class T>
PINBALL_FUNCTION HalfEdges<T> half_edges(const Vec3<T> (&corner)[8]) {
  HalfEdges<T> half;
  const T scale = number<T>(0.5);
  for (int b = 0; b < 2; ++b) {
    for (int a = 0; a < 2; ++a) {
      half.along[0][2 * b + a] = scale * (corner[corner_at(1, a, b)] - corner[corner_at(0, a, b)]);
      half.along[1][2 * b + a] = scale * (corner[corner_at(a, 1, b)] - corner[corner_at(a, 0, b)]);
      half.along[2][2 * b + a] = scale * (corner[corner_at(a, b, 1)] - corner[corner_at(a, b, 0)]);
    }
  }
  return half;
}

/// The Jacobian of a corner and its derivatives with respect to the three half edges there.
template <class T>
struct CornerJacobian {
  Vec3<T> by_half_edge[3];  ///< [length^2]
  T value;                  ///< [length^3]
  MaskOf<T> is_there;       ///< all edges have a length
};

/// Square of a half edge that is none [length^2]: of two corners that are one node it may be what rounding has left of
/// the ways to them (corner_differences.hpp), some last digits of the longest edge.
template <class T>
PINBALL_FUNCTION T square_of_no_edge(const HalfEdges<T>& half) {
  using S = ScalarOf<T>;
  constexpr S digits = sizeof(S) == 8 ? S(0x1p-49) : S(0x1p-20);  // eight times the last
  T longest(0);
  for (const auto& axis : half.along) {
    for (const Vec3<T>& edge : axis) longest = maximum(longest, dot(edge, edge));
  }
  return T(digits * digits) * longest;
}

/// no_edge: square_of_no_edge().
template <class T>
PINBALL_FUNCTION CornerJacobian<T> corner_jacobian(const HalfEdges<T>& half, const T& no_edge, int xi, int eta,
                                                   int zeta) {
  const Vec3<T>&a = half.along[0][2 * zeta + eta], &b = half.along[1][2 * zeta + xi], &c = half.along[2][2 * eta + xi];
  CornerJacobian<T> j;
  j.by_half_edge[0] = cross(b, c);
  j.by_half_edge[1] = cross(c, a);
  j.by_half_edge[2] = cross(a, b);
  j.value = dot(a, j.by_half_edge[0]);
  j.is_there = dot(a, a) > no_edge && dot(b, b) > no_edge && dot(c, c) > no_edge;
  return j;
}

/// The least r_I of an element of any volume but zero; 8 where no corner has three edges [-].
template <class T>
PINBALL_FUNCTION T least_corner_share(const Vec3<T> (&corner)[8], const T& volume) {
  const HalfEdges<T> half = half_edges(corner);
  const T no_edge = square_of_no_edge(half);
  T least(8);
  for (int i = 0; i < 8; ++i) {
    const CornerJacobian<T> j = corner_jacobian(half, no_edge, i & 1, (i >> 1) & 1, i >> 2);
    least = select(j.is_there, minimum(least, T(8) * j.value / volume), least);
  }
  return least;
}

template <class T>
struct CornerResistance {
  T worst;           ///< least r_I; -1 where there is no volume [-]
  T energy;          ///< W [energy]
  T rate_square;     ///< bound on the square of its highest frequency [1/time^2]
  T closing_rate;    ///< largest -dJ_I/dt / J_I of a corner below twice its onset [1/time]
  Vec3<T> force[8];  ///< of the corners [force]
};

/// The same from the modes, but for how numbers are rounded.
template <class T>
PINBALL_FUNCTION HalfEdges<T> half_edges(const HexahedronModes<T>& x) {
  constexpr int other[3][2] = {{1, 2}, {0, 2}, {0, 1}};  // axes at whose ends edges lie, the first counts up first
  const T scale = number<T>(1.7320508075688772935);      // sqrt3
  const Vec3<T> all = scale * x.hourglass[3];
  HalfEdges<T> half;
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    // The mode of two axes is numbered by the third.
    const Vec3<T> first = scale * x.hourglass[other[m][1]], second = scale * x.hourglass[other[m][0]];
    PINBALL_UNROLL
    for (int a = 0; a < 2; ++a) {
      const Vec3<T> middle = a == 0 ? x.linear[m] - first : x.linear[m] + first;
      const Vec3<T> slope = a == 0 ? second - all : second + all;
      half.along[m][a] = middle - slope;
      half.along[m][2 + a] = middle + slope;
    }
  }
  return half;
}

/// Whether all corners of a pack's elements have more than twice their onset, or than nothing where nothing resists:
/// the usual end of a look at elements that are only distorted. What is close to that is looked at as any other.
template <class T>
PINBALL_FUNCTION bool corners_are_open(const HexahedronModes<T>& x, const T& volume, const T& onset,
                                       const MaskOf<T>& there, CornerResistance<T>& out) {
  const HalfEdges<T> half = half_edges(x);
  T least = volume;
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) {
    const int xi = i & 1, eta = (i >> 1) & 1, zeta = i >> 2;
    const Vec3<T>&a = half.along[0][2 * zeta + eta], &b = half.along[1][2 * zeta + xi];
    least = minimum(least, dot(a, cross(b, half.along[2][2 * eta + xi])));
  }
  const T margin = number<T>(0.25 * 1.001);  // of the volume, an eighth of which is a whole share
  if (any_lane(there && !(least > margin * maximum(onset, number<T>(1e-4)) * volume))) return false;
  out.worst = select(there, T(8) * least / select(there, volume, T(1)), T(-1));
  out.energy = out.rate_square = out.closing_rate = T(0);
  return true;
}

/// scale: V_0 M/8 [energy]; onset: r_0; not positive: nothing resists [-]; inverse_inertia: 1/mass with which the
/// element's nodes move [1/mass]; shape, end_volume: of the elements [length], [length^3]; there: lanes that have an
/// element with a volume. Returns whether any corner may resist; where none does, `force` is left as it was: there is
/// none.
template <class T, int L, class N>
PINBALL_OUTLINED bool resist_folding(const N* position, const N* velocity, const std::int32_t* corner, const T& scale,
                                     const T& onset, const T& inverse_inertia, const HexahedronModes<T>& shape,
                                     const T& end_volume, const MaskOf<T>& there, CornerResistance<T>& out) {
  if (corners_are_open(shape, end_volume, onset, there, out)) return false;
  Vec3<T> x[8], v[8];
  gather_corners<T, L>(position, corner, x);
  const HalfEdges<T> half = half_edges(x);
  const T no_edge = square_of_no_edge(half);
  gather_corners<T, L>(velocity, corner, v);
  const HexahedronModes<T> modes = to_modes(x);
  const UniformGradient<T> b = uniform_gradient(modes);
  const T volume = hexahedron_volume(b, modes), zero(0);
  const T inverse_volume = select(there, T(1) / select(there, volume, T(1)), zero), to_share = T(8) * inverse_volume;
  const T size_square = inverse_volume * inverse_volume * trace(gradient_square(b));
  const HalfEdges<T> rate = half_edges(v);
  HalfEdges<T> on_edge;  // dW/da
  for (auto& axis : on_edge.along) {
    for (Vec3<T>& edge : axis) edge = {zero, zero, zero};
  }
  const auto resists = there && onset > zero;
  const T inverse_onset = T(1) / select(resists, onset, T(1)), floor = number<T>(1.0 / 64) * onset;
  T energy = zero, stiffness = zero, closing = zero, on_volume = zero, worst(8);
  for (int i = 0; i < 8; ++i) {
    const int end[3] = {i & 1, (i >> 1) & 1, i >> 2};
    const int edge[3] = {2 * end[2] + end[1], 2 * end[2] + end[0], 2 * end[1] + end[0]};
    const CornerJacobian<T> j = corner_jacobian(half, no_edge, end[0], end[1], end[2]);
    const T share = to_share * j.value;
    worst = select(j.is_there, minimum(worst, share), worst);
    const auto looked_at = j.is_there && resists && share < T(2) * onset;
    if (!any_lane(looked_at)) continue;
    const auto acts = looked_at && share < onset;
    // phi' and phi of `used`, and along the tangent from there
    const T used = select(acts, maximum(share, floor), T(1)), inverse = T(1) / used, below = onset - used;
    const T slope = number<T>(0.5) * (inverse_onset - onset * (inverse * inverse));
    energy += select(acts, number<T>(0.5) * (below * below * inverse * inverse_onset) + slope * (share - used), zero);
    const T pull = select(acts, slope, zero), on_jacobian = scale * to_share * pull;
    on_volume += pull * share;
    T around = zero, jacobian_rate = zero;
    Vec3<T> own{zero, zero, zero};
    for (int m = 0; m < 3; ++m) {
      const Vec3<T>& c = j.by_half_edge[m];
      on_edge.along[m][edge[m]] = on_edge.along[m][edge[m]] + on_jacobian * c;
      own = end[m] == 0 ? own - c : own + c;
      around += dot(c, c);
      jacobian_rate += dot(c, rate.along[m][edge[m]]);
    }
    // |dr/dx|^2: of J that of the corner and of its three neighbours, a quarter each; |a - b|^2 <= 5/4 a^2 + 5 b^2
    const T gradient_square =
        number<T>(0.3125) * (to_share * to_share) * (around + dot(own, own)) + T(5) * (share * share) * size_square;
    stiffness += select(acts, onset * (inverse * inverse * inverse) * gradient_square, zero);
    const T open = maximum(share, floor);
    closing = select(looked_at, maximum(closing, T(-1) * to_share * jacobian_rate / open), closing);
  }
  out.worst = select(there, worst, T(-1));
  out.energy = scale * energy;
  out.rate_square = T(8) * scale * inverse_inertia * stiffness;
  out.closing_rate = closing;
  const T pressure = scale * on_volume * inverse_volume;  // -dW/dV where the Jacobians stay
  Vec3<T> linear[3], hourglass[4];
  for (int m = 0; m < 3; ++m) {
    linear[m] = pressure * b.linear[m];
    hourglass[m] = pressure * b.hourglass[m];
  }
  hourglass[3] = {zero, zero, zero};
  from_modes(linear, hourglass, out.force);
  for (int i = 0; i < 8; ++i) {
    const int end[3] = {i & 1, (i >> 1) & 1, i >> 2};
    const int edge[3] = {2 * end[2] + end[1], 2 * end[2] + end[0], 2 * end[1] + end[0]};
    Vec3<T>& force = out.force[corner_at(end[0], end[1], end[2])];
    for (int m = 0; m < 3; ++m) {
      force = force + number<T>(end[m] == 0 ? 0.5 : -0.5) * on_edge.along[m][edge[m]];
    }
  }
  return true;
}

}  // namespace pinball
