#pragma once

#include "hexahedron.hpp"

/// Stable step of central differences from a bound on the element's own highest eigenvalue: by Fried's theorem no
/// eigenvalue of the assembled model is larger than the largest of any element, so that also a single eroded fragment
/// in flight is safe (the usual L/c with L = V / largest face area is not: it overestimates the step of a free cube by
/// 36 % at a Poisson ratio of 0.3).
///
/// With lumped mass m/8 per corner and S_ij = sum_I B_iI B_jI / V^2 [1/length^2] of principal values s_1..3, the
/// stiffness C = lambda 1 (x) 1 + 2 mu I has exactly the eigenvalues of
///     8 V/m ( 2 mu diag(s) + lambda sqrt(s) (x) sqrt(s) )   and   8 V/m mu (s_i + s_j)
/// so that
///     omega^2 <= 8 V/m ( 2 mu s_max + lambda tr S ) ,
/// with equality for a cube (s equal) and for a thin plate (one s). A negative lambda (Poisson ratio below 0) lowers
/// the modes with a change of volume alone: it counts as 0. The bulk viscosity eta is a damping 8 V/m eta tr S. A mode
/// of frequency omega and damping d is stable with lagged damping if omega^2 dt^2/4 + d dt/2 <= 1, hence
///     dt = 2 / ( d/2 + sqrt(d^2/4 + omega^2) ) .
namespace pinball {

/// Largest principal value of a symmetric positive tensor, from above.
///
/// With q^2 = J2/3 and rho = J3/(2 q^3) of the deviator it is mean + 2 q cos(acos(rho)/3). The cosine is a concave
/// function of rho, so that each of its tangents bounds it; the two at rho = 1 and rho = -1/2 are used. Exact where the
/// two smaller values are equal (cube, flat element) or rho = -1/2; the largest excess, 9.5 % of the value, is where
/// the two larger ones are equal and the third vanishes (a long rod).
template <class T>
PINBALL_FUNCTION T bounded_principal_value(const Symmetric<T>& s) {
  const T mean = number<T>(1.0 / 3.0) * trace(s);
  const T xx = s.xx - mean, yy = s.yy - mean, zz = s.zz - mean;
  const T j2 = number<T>(0.5) * (xx * xx + yy * yy + zz * zz) + s.xy * s.xy + s.yz * s.yz + s.zx * s.zx;
  const T j3 = xx * (yy * zz - s.yz * s.yz) - s.xy * (s.xy * zz - s.yz * s.zx) + s.zx * (s.xy * s.yz - yy * s.zx);
  const T floor = number<T>(1e-8) * mean * mean;  // keeps the quotient finite for a cube: J2 = 0
  const T q2 = number<T>(1.0 / 3.0) * j2 + floor;
  const T q = square_root(q2), quotient = j3 / q2;  // quotient = 2 q rho
  // cos <= (8 + rho)/9 ;  cos <= cos 40 + (rho + 1/2) sin 40 / (3 sin 120)
  const T at_one = number<T>(16.0 / 9.0) * q + number<T>(1.0 / 9.0) * quotient;
  const T at_minus_half = number<T>(1.7794979525608) * q + number<T>(0.2474090663229) * quotient;
  return mean + minimum(at_one, at_minus_half);
}

/// The same for tensors of any size. J3 has the power 12 of a length where S_ij has the power 4: in single precision it
/// is nothing for elements of a millimetre in metres, and beyond all numbers for such of two kilometres.
template <class T>
PINBALL_FUNCTION T largest_principal_value(const Symmetric<T>& s) {
  if constexpr (sizeof(ScalarOf<T>) == sizeof(double)) {
    return bounded_principal_value(s);
  } else {
    const T sum = trace(s), size = select(sum > T(0), sum, T(1));
    return size * bounded_principal_value((T(1) / size) * s);
  }
}

/// Rate 2/dt of the largest stable step dt of one element [1/time]: d/2 + sqrt(d^2/4 + omega^2).
/// largest, trace: largest principal value and trace of S_ij [1/length^2]; viscosity: bulk viscosity eta [stress time].
template <class T>
PINBALL_FUNCTION T element_stable_rate(const T& largest, const T& trace, const T& volume, const T& inverse_mass,
                                       const T& lambda, const T& mu, const T& viscosity) {
  const T factor = T(8) * volume * inverse_mass;
  const T omega2 = factor * (T(2) * mu * largest + maximum(T(0), lambda) * trace);
  const T half_damping = number<T>(0.5) * factor * viscosity * trace;
  return half_damping + square_root(half_damping * half_damping + omega2);
}

}  // namespace pinball
