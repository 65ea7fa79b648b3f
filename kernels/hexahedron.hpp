#pragma once

#include <pinball/kernels/simd.hpp>
#include <pinball/kernels/tensor.hpp>

/// The uniform-strain hexahedron of Flanagan and Belytschko (Internat. J. Numer. Meths. Engrg. 17, 679-706, 1981) in its
/// modal form.
///
/// A trilinear field on the parent cube (xi, eta, zeta) in [-1,1]^3 with corner values a_I, I = 0..7, is
///
///     a = 1/8 sum_m M_m(xi,eta,zeta) A_m ,   A_m = sum_I M_mI a_I ,
///
/// with the eight modes M: constant 1; linear xi, eta, zeta; hourglass eta*zeta, zeta*xi, xi*eta, xi*eta*zeta. Their
/// corner values M_mI are +1 or -1 and orthogonal, so that the change between corner values and modes takes 24
/// additions per component. The mean gradient
///
///     B_iI = integral over the element of dN_I/dx_i dV
///
/// is exactly a combination of six of these modes,
///
///     B_I = sum_{m=xi,eta,zeta} M_mI C_m + sum_{a=1,2,3} G_aI D_a ,
///
///     C_1 = X_2 x X_3 + 1/3 H_3 x H_2 ,  D_1 = 1/3 (X_3 x H_2 + H_3 x X_2) , and cyclic in 1, 2, 3,
///
/// with X_m = (coordinate modes) / 8, H_a likewise for the hourglass modes, G_a the hourglass corner values. (Integrate
/// the cofactor columns of the Jacobian times dM/dxi over the cube: all products of odd powers vanish, and the
/// contributions of H_4 cancel.) This equals the closed form of the paper to round-off; it costs
/// twelve cross products instead of 24 sums of eighteen products, and neither velocity gradient nor forces ever need the
/// 24 values B_iI themselves.
///
/// Corner order: see pinball/solver/mesh.hpp; (-,-,-) (+,-,-) (+,+,-) (-,+,-) (-,-,+) (+,-,+) (+,+,+) (-,+,+).
namespace pinball {

/// Modal coefficients A_m = sum_I M_mI a_I of a vector field (not divided by 8).
template <class T>
struct HexahedronModes {
  Vec3<T> constant;
  Vec3<T> linear[3];     ///< xi, eta, zeta
  Vec3<T> hourglass[4];  ///< eta*zeta, zeta*xi, xi*eta, xi*eta*zeta: the vectors Gamma_1..4 of the paper
};

/// The eight modes of one scalar component, from its eight corner values. 24 additions.
template <class T>
PINBALL_FUNCTION void walsh_transform(const T& a0, const T& a1, const T& a2, const T& a3, const T& a4, const T& a5,
                                      const T& a6, const T& a7, T& constant, T& xi, T& eta, T& zeta, T& eta_zeta,
                                      T& zeta_xi, T& xi_eta, T& xi_eta_zeta) {
  const T s0 = a0 + a4, s1 = a1 + a5, s2 = a2 + a6, s3 = a3 + a7;  // sums along zeta
  const T d0 = a4 - a0, d1 = a5 - a1, d2 = a6 - a2, d3 = a7 - a3;  // differences along zeta
  const T s_low = s0 + s1, s_high = s3 + s2, s_low_xi = s1 - s0, s_high_xi = s2 - s3;
  const T d_low = d0 + d1, d_high = d3 + d2, d_low_xi = d1 - d0, d_high_xi = d2 - d3;
  constant = s_high + s_low;
  eta = s_high - s_low;
  xi = s_high_xi + s_low_xi;
  xi_eta = s_high_xi - s_low_xi;
  zeta = d_high + d_low;
  eta_zeta = d_high - d_low;
  zeta_xi = d_high_xi + d_low_xi;
  xi_eta_zeta = d_high_xi - d_low_xi;
}

template <class T>
PINBALL_FUNCTION HexahedronModes<T> to_modes(const Vec3<T> (&corner)[8]) {
  HexahedronModes<T> m;
#define PINBALL_COMPONENT(c)                                                                                       \
  walsh_transform(corner[0].c, corner[1].c, corner[2].c, corner[3].c, corner[4].c, corner[5].c, corner[6].c,       \
                  corner[7].c, m.constant.c, m.linear[0].c, m.linear[1].c, m.linear[2].c, m.hourglass[0].c,         \
                  m.hourglass[1].c, m.hourglass[2].c, m.hourglass[3].c)
  PINBALL_COMPONENT(x);
  PINBALL_COMPONENT(y);
  PINBALL_COMPONENT(z);
#undef PINBALL_COMPONENT
  return m;
}

/// Corner values sum_m M_mI A_m of modal coefficients without a constant part: the transpose of to_modes.
template <class T>
PINBALL_FUNCTION void from_modes(const Vec3<T> (&linear)[3], const Vec3<T> (&hourglass)[4], Vec3<T> (&corner)[8]) {
  const Vec3<T> low_xi = linear[0] - hourglass[2], high_xi = linear[0] + hourglass[2];  // xi slope at eta = -1, +1
  const Vec3<T> s0 = T(-1) * (linear[1] + low_xi), s1 = low_xi - linear[1];
  const Vec3<T> s2 = linear[1] + high_xi, s3 = linear[1] - high_xi;
  const Vec3<T> low = linear[2] - hourglass[0], high = linear[2] + hourglass[0];  // zeta slope at eta = -1, +1
  const Vec3<T> low_d = hourglass[1] - hourglass[3], high_d = hourglass[1] + hourglass[3];
  const Vec3<T> d0 = low - low_d, d1 = low + low_d, d2 = high + high_d, d3 = high - high_d;
  corner[0] = s0 - d0;
  corner[1] = s1 - d1;
  corner[2] = s2 - d2;
  corner[3] = s3 - d3;
  corner[4] = s0 + d0;
  corner[5] = s1 + d1;
  corner[6] = s2 + d2;
  corner[7] = s3 + d3;
}

/// The mean gradient operator as its six modal vectors [length^2]: B_I = sum M_mI linear[m] + sum G_aI hourglass[a].
template <class T>
struct UniformGradient {
  Vec3<T> linear[3];
  Vec3<T> hourglass[3];
};

/// x: modes of the corner coordinates.
template <class T>
PINBALL_FUNCTION UniformGradient<T> uniform_gradient(const HexahedronModes<T>& x) {
  UniformGradient<T> b;
  const T whole = number<T>(1.0 / 64.0);   // the factors 1/8 of two coordinate modes
  const T third = number<T>(1.0 / 192.0);  // a third of them
  PINBALL_UNROLL
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    b.linear[i] = whole * cross(x.linear[j], x.linear[k]) + third * cross(x.hourglass[k], x.hourglass[j]);
    b.hourglass[i] = third * (cross(x.linear[k], x.hourglass[j]) + cross(x.hourglass[k], x.linear[j]));
  }
  return b;
}

/// Exact volume of the trilinear hexahedron: V = 1/3 sum_I B_iI x_iI [length^3].
template <class T>
PINBALL_FUNCTION T hexahedron_volume(const UniformGradient<T>& b, const HexahedronModes<T>& x) {
  T sum = dot(b.linear[0], x.linear[0]) + dot(b.hourglass[0], x.hourglass[0]);
  sum += dot(b.linear[1], x.linear[1]) + dot(b.hourglass[1], x.hourglass[1]);
  sum += dot(b.linear[2], x.linear[2]) + dot(b.hourglass[2], x.hourglass[2]);
  return number<T>(1.0 / 3.0) * sum;
}

/// L_ij = 1/V sum_I v_iI B_jI [1/time]; v: modes of the corner velocities.
template <class T>
PINBALL_FUNCTION Tensor<T> velocity_gradient(const UniformGradient<T>& b, const HexahedronModes<T>& v,
                                             const T& inverse_volume) {
#define PINBALL_ROW(c)                                                                                      \
  (inverse_volume * (v.linear[0].c * b.linear[0] + v.linear[1].c * b.linear[1] + v.linear[2].c * b.linear[2] + \
                     v.hourglass[0].c * b.hourglass[0] + v.hourglass[1].c * b.hourglass[1] +                 \
                     v.hourglass[2].c * b.hourglass[2]))
  return {PINBALL_ROW(x), PINBALL_ROW(y), PINBALL_ROW(z)};
#undef PINBALL_ROW
}

/// B_iI B_iI summed over components and corners [length^4]; the modes are orthogonal with norm^2 8.
template <class T>
PINBALL_FUNCTION T gradient_norm_squared(const UniformGradient<T>& b) {
  T sum = dot(b.linear[0], b.linear[0]) + dot(b.hourglass[0], b.hourglass[0]);
  sum += dot(b.linear[1], b.linear[1]) + dot(b.hourglass[1], b.hourglass[1]);
  sum += dot(b.linear[2], b.linear[2]) + dot(b.hourglass[2], b.hourglass[2]);
  return T(8) * sum;
}

/// The 24 values B_iI themselves, for what needs them per corner (tests, other elements).
template <class T>
PINBALL_FUNCTION void expand(const UniformGradient<T>& b, Vec3<T> (&corner)[8]) {
  const Vec3<T> hourglass[4] = {b.hourglass[0], b.hourglass[1], b.hourglass[2], {T(0), T(0), T(0)}};
  from_modes(b.linear, hourglass, corner);
}

/// Outward area vectors of the two faces across parent axis i (0 xi, 1 eta, 2 zeta) [length^2], exact for bilinear faces:
/// A = +-1/16 (x_j +- h_k) x (x_k +- h_j), j, k the cyclic successors of i.
template <class T>
PINBALL_FUNCTION void face_areas(const HexahedronModes<T>& x, int i, Vec3<T>& minus, Vec3<T>& plus) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  const T sixteenth = number<T>(1.0 / 16.0);
  plus = sixteenth * cross(x.linear[j] + x.hourglass[k], x.linear[k] + x.hourglass[j]);
  minus = number<T>(-1.0 / 16.0) * cross(x.linear[j] - x.hourglass[k], x.linear[k] - x.hourglass[j]);
}

}  // namespace pinball
