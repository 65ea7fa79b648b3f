#pragma once

#include <pinball/kernels/hexahedron.hpp>

/// Stable step of central differences from a bound on the element's own highest eigenvalue: by Fried's theorem no
/// eigenvalue of the assembled model is larger than the largest of any element, so that also a single eroded fragment in
/// flight is safe (the usual L/c with L = V / largest face area is not: it overestimates the step of a free cube by 36 %
/// at a Poisson ratio of 0.3).
///
/// With lumped mass m/8 per corner and S_ij = sum_I B_iI B_jI / V^2 [1/length^2] of principal values s_1..3, the
/// stiffness C = lambda 1 (x) 1 + 2 mu I has exactly the eigenvalues of
///     8 V/m ( 2 mu diag(s) + lambda sqrt(s) (x) sqrt(s) )   and   8 V/m mu (s_i + s_j)
/// so that
///     omega^2 <= 8 V/m ( 2 mu s_max + lambda tr S ) ,
/// with equality for a cube (s equal) and for a thin plate (one s). The bulk viscosity eta is a damping 8 V/m eta tr S.
/// A mode of frequency omega and damping d is stable with lagged damping if omega^2 dt^2/4 + d dt/2 <= 1, hence
///     dt = 2 / ( d/2 + sqrt(d^2/4 + omega^2) ) .
namespace pinball {

/// Largest root of a symmetric 3x3 matrix, from above: Newton's method on the characteristic cubic of the deviator,
/// started right of its largest root, where the cubic is convex, so that every iterate is a
/// bound. Three steps leave less than 1 % except near a double largest root, where the bound stays within 6 %.
template <class T>
PINBALL_FUNCTION T largest_principal_value(const Symmetric<T>& s) {
  const T mean = number<T>(1.0 / 3.0) * trace(s);
  const T xx = s.xx - mean, yy = s.yy - mean, zz = s.zz - mean;
  const T j2 = number<T>(0.5) * (xx * xx + yy * yy + zz * zz) + s.xy * s.xy + s.yz * s.yz + s.zx * s.zx;
  const T j3 = xx * (yy * zz - s.yz * s.yz) - s.xy * (s.xy * zz - s.yz * s.zx) + s.zx * (s.xy * s.yz - yy * s.zx);
  // r^3 - j2 r - j3 = 0 for r = s_max - mean; the largest root lies in [sqrt(j2/3), 2 sqrt(j2/3)].
  const T floor = number<T>(1e-6) * mean * mean;  // keeps the divisions finite for a cube, where j2 = 0
  const T low2 = number<T>(1.0 / 3.0) * j2 + floor;
  T r = T(2) * square_root(low2);
  PINBALL_UNROLL
  for (int i = 0; i < 3; ++i) {
    // The derivative is positive right of the root; a larger one only shortens the step, so r stays a bound.
    const T derivative = maximum(T(3) * r * r - j2, low2);
    r -= ((r * r - j2) * r - j3) / derivative;
  }
  return mean + r;
}

/// Square of the largest frequency and the damping of the volumetric modes of one element, as a step [time].
/// volume_per_mass: V/m; viscosity: bulk viscosity eta [stress time].
template <class T>
PINBALL_FUNCTION T element_stable_time_step(const UniformGradient<T>& b, const T& inverse_volume,
                                            const T& volume_per_mass, const T& lambda, const T& mu,
                                            const T& viscosity) {
  Symmetric<T> s{T(0), T(0), T(0), T(0), T(0), T(0)};
  const auto add = [&s](const Vec3<T>& c) {
    s.xx += c.x * c.x;
    s.yy += c.y * c.y;
    s.zz += c.z * c.z;
    s.xy += c.x * c.y;
    s.yz += c.y * c.z;
    s.zx += c.z * c.x;
  };
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    add(b.linear[m]);
    add(b.hourglass[m]);
  }
  // S [1/length^2] before its invariants are formed: their powers of B alone leave the range of float below 0.1 mm in SI.
  s = (T(8) * inverse_volume * inverse_volume) * s;  // modes have norm^2 8
  const T factor = T(8) * volume_per_mass;
  const T tr = trace(s);
  const T omega2 = factor * (T(2) * mu * largest_principal_value(s) + lambda * tr);
  const T half_damping = number<T>(0.5) * factor * viscosity * tr;
  return T(2) / (half_damping + square_root(half_damping * half_damping + omega2));
}

}  // namespace pinball
