#pragma once

#include "../simd.hpp"
#include "../tensor.hpp"

/// Largest and smallest principal value of a symmetric tensor, without a cosine.
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

template <class T>
PINBALL_FUNCTION PrincipalValues<T> principal_values(const Symmetric<T>& s) {
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
  const T apart = T(2) * c * m;
  // half the difference of the two others: sqrt(J2 - 3/4 x^2)
  const T half = c * square_root(maximum(T(0), T(3) - T(3) * m * m));
  const T near = number<T>(0.5) * apart + half, far = number<T>(-0.5) * apart - half;
  const auto upwards = j3 > T(0);
  return {mean + select(upwards, apart, near), mean + select(upwards, far, T(-1) * apart)};
}

}  // namespace pinball
