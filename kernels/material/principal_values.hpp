#pragma once

#include "../simd.hpp"
#include "../tensor.hpp"

/// Principal values of a symmetric tensor, without a cosine: the largest and the smallest, and bounds for all three.
///
/// Those of its deviator solve  x^3 - J2 x - J3 = 0 . With x = 2 c m, c = sqrt(J2/3), and rho = |J3|/(2 c^3) <= 1, the
/// root of the sign of J3, which is the one that stands apart, is that of
///
///     4 m^3 - 3 m = rho ,   sqrt(3)/2 <= m <= 1 ,
///
/// where the slope is at least 6: Newton's method from m = 1 falls towards it, and five steps find it to the last
/// digit. The two others then follow from their sum and their product, -x and x^2 - J2.
namespace pinball {

template <class T>
struct PrincipalValues {
  T largest, smallest;
};

/// The principal value that stands apart, mean + 2 c m where `upwards`, else mean - 2 c m.
template <class T>
struct PrincipalRoot {
  T mean;
  T c, inverse;        ///< sqrt(J2/3) and its inverse, 1 where c is zero
  T m;                 ///< [-]
  MaskOf<T> upwards;   ///< it is the largest
  MaskOf<T> deviates;  ///< c is not zero
};

template <class T>
PINBALL_FUNCTION PrincipalRoot<T> principal_root(const Symmetric<T>& s) {
  const T mean = number<T>(1.0 / 3.0) * trace(s);
  const T xx = s.xx - mean, yy = s.yy - mean, zz = s.zz - mean;
  const T j2 = number<T>(0.5) * (xx * xx + yy * yy + zz * zz) + s.xy * s.xy + s.yz * s.yz + s.zx * s.zx;
  const auto deviates = j2 > T(0);
  const T c = square_root(number<T>(1.0 / 3.0) * j2), inverse = T(1) / select(deviates, c, T(1));
  // J3/(2 c^3), of a tensor of the size of one
  const T a = inverse * xx, b = inverse * yy, d = inverse * zz;
  const T xy = inverse * s.xy, yz = inverse * s.yz, zx = inverse * s.zx;
  const T j3 = a * (b * d - yz * yz) - xy * (xy * d - yz * zx) + zx * (xy * yz - b * zx);
  const T rho = minimum(T(1), number<T>(0.5) * absolute(j3));
  T m(1);
  PINBALL_UNROLL
  for (int i = 0; i < 5; ++i) m = m - (m * (T(4) * m * m - T(3)) - rho) / (T(12) * m * m - T(3));
  return {mean, c, inverse, m, j3 > T(0), deviates};
}

template <class T>
PINBALL_FUNCTION PrincipalValues<T> values_at(const PrincipalRoot<T>& root) {
  const T apart = T(2) * root.c * root.m;
  // half the difference of the two others: sqrt(J2 - 3/4 x^2)
  const T half = root.c * square_root(maximum(T(0), T(3) - T(3) * root.m * root.m));
  const T near = number<T>(0.5) * apart + half, far = number<T>(-0.5) * apart - half;
  return {root.mean + select(root.upwards, apart, near), root.mean + select(root.upwards, far, T(-1) * apart)};
}

template <class T>
PINBALL_FUNCTION PrincipalValues<T> principal_values(const Symmetric<T>& s) {
  return values_at(principal_root(s));
}

/// Unit vector along the principal direction of that value: the rows of N - x I, N = deviator/c, lie in the plane
/// across it, and the largest product of two of them is along it, however near the two other values are.
template <class T>
PINBALL_FUNCTION Vec3<T> direction_apart(const PrincipalRoot<T>& root, const Symmetric<T>& s) {
  const T shift = root.inverse * root.mean + select(root.upwards, T(2), T(-2)) * root.m;
  const Vec3<T> a{root.inverse * s.xx - shift, root.inverse * s.xy, root.inverse * s.zx},
      b{root.inverse * s.xy, root.inverse * s.yy - shift, root.inverse * s.yz},
      d{root.inverse * s.zx, root.inverse * s.yz, root.inverse * s.zz - shift};
  Vec3<T> along = cross(a, b);
  T size = dot(along, along);
  const auto take = [&](const Vec3<T>& other) __attribute__((always_inline)) {
    const T of_other = dot(other, other);
    const auto larger = of_other > size;
    along = select(larger, other, along);
    size = select(larger, of_other, size);
  };
  take(cross(b, d));
  take(cross(d, a));
  const auto there = root.deviates && size > T(0);
  return select(there, (T(1) / square_root(select(there, size, T(1)))) * along, Vec3<T>{T(0), T(0), T(1)});
}

/// What is beyond [low, high]: of which sign, and how much.
template <class T>
PINBALL_FUNCTION T excess_of(const T& value, const T& low, const T& high) {
  return maximum(T(0), value - high) + minimum(T(0), value - low);
}

/// All principal values with their directions: the unit vector v that stands apart, and u, w across it (Duff et al., J.
/// Computer Graphics Techniques 6(1), 2017); the other two values are those of the 2 x 2 tensor of u and w, in which
/// any function of them is linear.
template <class T>
struct PrincipalAxes {
  Vec3<T> v, u, w;
  T a, b, radius;         ///< of the 2 x 2 tensor: half the difference of its diagonal, the other one, hypot(a, b)
  T apart, above, below;  ///< the values: along v, and the two others
};

template <class T>
PINBALL_FUNCTION PrincipalAxes<T> principal_axes(const PrincipalRoot<T>& root, const Symmetric<T>& s) {
  const Vec3<T> v = direction_apart(root, s);
  const T sign = select(v.z < T(0), T(-1), T(1)), scale = T(-1) / (sign + v.z), product = v.x * v.y * scale;
  const Vec3<T> u{T(1) + sign * v.x * v.x * scale, sign * product, T(-1) * sign * v.x},
      w{product, sign + v.y * v.y * scale, T(-1) * v.y};
  const T half = number<T>(0.5);
  const Symmetric<T> deviator{s.xx - root.mean, s.yy - root.mean, s.zz - root.mean, s.xy, s.yz, s.zx};
  const Vec3<T> of_u = deviator * u;
  const T of_uu = dot(u, of_u), of_ww = dot(w, deviator * w), b = dot(w, of_u);
  const T centre = half * (of_uu + of_ww), a = half * (of_uu - of_ww), radius = square_root(a * a + b * b);
  return {v,
          u,
          w,
          a,
          b,
          radius,
          root.mean + select(root.upwards, T(2), T(-2)) * root.c * root.m,
          root.mean + (centre + radius),
          root.mean + (centre - radius)};
}

/// The tensor of these axes that has other principal values.
template <class T>
PINBALL_FUNCTION Symmetric<T> along_axes(const PrincipalAxes<T>& axes, const T& apart, const T& above, const T& below) {
  const Vec3<T>&v = axes.v, &u = axes.u, &w = axes.w;
  const T half = number<T>(0.5);
  const auto differ = axes.radius > T(0);
  const T share = select(differ, half * (above - below) / select(differ, axes.radius, T(1)), T(0));
  const T common = half * (above + below), a_share = share * axes.a, b_share = share * axes.b, more = apart - common;
  const auto entry = [&](const T& v2, const T& u2, const T& w2, const T& uw) __attribute__((always_inline)) {
    return more * v2 + a_share * (u2 - w2) + b_share * uw;
  };
  return {common + entry(v.x * v.x, u.x * u.x, w.x * w.x, T(2) * u.x * w.x),
          common + entry(v.y * v.y, u.y * u.y, w.y * w.y, T(2) * u.y * w.y),
          common + entry(v.z * v.z, u.z * u.z, w.z * w.z, T(2) * u.z * w.z),
          entry(v.x * v.y, u.x * u.y, w.x * w.y, u.x * w.y + u.y * w.x),
          entry(v.y * v.z, u.y * u.z, w.y * w.z, u.y * w.z + u.z * w.y),
          entry(v.z * v.x, u.z * u.x, w.z * w.x, u.z * w.x + u.x * w.z)};
}

/// Brings the principal values of a tensor into [low, high], low <= high; the directions stay. Returns what it takes;
/// where nothing is beyond that is zero, whatever other lanes do.
template <class T>
PINBALL_OUTLINED Symmetric<T> limit_principal_values(const T& low, const T& high, Symmetric<T>& s) {
  const Symmetric<T> none{T(0), T(0), T(0), T(0), T(0), T(0)};
  const PrincipalRoot<T> root = principal_root(s);
  const PrincipalValues<T> values = values_at(root);
  const auto beyond = values.largest > high || values.smallest < low;
  if (!any_lane(beyond)) return none;
  const PrincipalAxes<T> axes = principal_axes(root, s);
  const T apart = excess_of(axes.apart, low, high), above = excess_of(axes.above, low, high),
          below = excess_of(axes.below, low, high);
  const Symmetric<T> taken = select(beyond, along_axes(axes, apart, above, below), none);
  s = s - taken;
  return taken;
}

}  // namespace pinball
