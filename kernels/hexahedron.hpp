#pragma once

#include "simd.hpp"
#include "tensor.hpp"

/// The uniform-strain hexahedron of Flanagan and Belytschko (Internat. J. Numer. Meths. Engrg. 17, 679-706, 1981) in
/// its modal form.
///
/// A trilinear field on the parent cube (xi, eta, zeta) in [-1,1]^3 is a sum over eight modes,
///
///     a = A_0 + A_1 xi + A_2 eta + A_3 zeta + sqrt3 (A_4 eta zeta + A_5 zeta xi + A_6 xi eta + A_7 xi eta zeta) ,
///
/// one constant, three linear, four hourglass modes. Their corner values are +1 or -1 (times sqrt3) and orthogonal, so
/// that the coefficients A_m follow from the eight corner values a_I with 24 additions per component. The sqrt3 gives
/// the modes 1 to 6 the same mean square on the cube, and with it the mean gradient
///
///     B_iI = integral over the element of dN_I/dx_i dV
///
/// has no factors: with X_m, H_m = X_(m+3) the coefficients of the coordinates,
///
///     B_I = sum_m L_mI C_m + 1/sqrt3 sum_m G_mI D_m ,     m = 1, 2, 3 ,
///     C_1 = X_2 x X_3 + H_3 x H_2 ,   D_1 = X_3 x H_2 + H_3 x X_2 ,   and cyclic,
///
/// where L_m and G_m are the corner values (+-1) of the linear and hourglass modes. (Integrate the cofactor columns of
/// the Jacobian times the derivatives of the modes over the cube: all odd powers vanish, and what X_7 contributes
/// cancels.) For a field v with coefficients V_m the sum over corners becomes sum_I v_iI B_jI = 8 sum_(m=1..6) V_m,i
/// (C, D)_m,j.
///
/// This equals the closed form of the paper to round-off; it costs twelve cross products instead of 24 sums of eighteen
/// products, and neither velocity gradient nor forces ever need the 24 values B_iI themselves.
///
/// Corners 0 to 7 have the parent coordinates (-,-,-) (+,-,-) (+,+,-) (-,+,-) (-,-,+) (+,-,+) (+,+,+) (-,+,+): 0 to 3
/// go counterclockwise around the bottom seen from the top, 4 to 7 lie above them.
namespace pinball {

/// Local nodes of the six faces in the order xi-, xi+, eta-, eta+, zeta-, zeta+; each counterclockwise seen from
/// outside, so that the area vector (x2 - x0) x (x3 - x1) / 2 points outward.
inline constexpr int face_nodes[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                         {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};

/// Modal coefficients of a vector field.
template <class T>
struct HexahedronModes {
  Vec3<T> constant;      ///< the mean of the corners
  Vec3<T> linear[3];     ///< xi, eta, zeta
  Vec3<T> hourglass[4];  ///< sqrt3 times eta zeta, zeta xi, xi eta, xi eta zeta (the paper's Gamma_1..4)
};

/// The sums of one scalar component over the corners with the signs of each mode. 24 additions.
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
#define PINBALL_COMPONENT(c)                                                                                 \
  walsh_transform(corner[0].c, corner[1].c, corner[2].c, corner[3].c, corner[4].c, corner[5].c, corner[6].c, \
                  corner[7].c, m.constant.c, m.linear[0].c, m.linear[1].c, m.linear[2].c, m.hourglass[0].c,  \
                  m.hourglass[1].c, m.hourglass[2].c, m.hourglass[3].c)
  PINBALL_COMPONENT(x);
  PINBALL_COMPONENT(y);
  PINBALL_COMPONENT(z);
#undef PINBALL_COMPONENT
  const T eighth = number<T>(0.125), hourglass = number<T>(0.072168783648703220564);  // 1/8, 1/(8 sqrt3)
  m.constant = eighth * m.constant;
  PINBALL_UNROLL
  for (int i = 0; i < 3; ++i) m.linear[i] = eighth * m.linear[i];
  PINBALL_UNROLL
  for (int i = 0; i < 4; ++i) m.hourglass[i] = hourglass * m.hourglass[i];
  return m;
}

/// Corner values f_I = sum_m L_mI linear[m] + 1/sqrt3 sum_a G_aI hourglass[a]: nodal forces from modal ones, so that
/// sum_I f_I.v_I = 8 (sum_m linear[m].V_m + sum_a hourglass[a].V_(a+4)) for every velocity field.
template <class T>
PINBALL_FUNCTION void from_modes(const Vec3<T> (&linear)[3], const Vec3<T> (&hourglass)[4], Vec3<T> (&corner)[8]) {
  const T scale = number<T>(0.57735026918962576451);  // 1/sqrt3
  const Vec3<T> eta_zeta = scale * hourglass[0], zeta_xi = scale * hourglass[1], xi_eta = scale * hourglass[2],
                xi_eta_zeta = scale * hourglass[3];
  const Vec3<T> low_xi = linear[0] - xi_eta, high_xi = linear[0] + xi_eta;  // xi slope at eta = -1, +1
  const Vec3<T> s0 = linear[1] + low_xi, s1 = low_xi - linear[1];           // s0 with its sign turned
  const Vec3<T> s2 = linear[1] + high_xi, s3 = linear[1] - high_xi;
  const Vec3<T> low = linear[2] - eta_zeta, high = linear[2] + eta_zeta;  // zeta slope at eta = -1, +1
  const Vec3<T> low_d = zeta_xi - xi_eta_zeta, high_d = zeta_xi + xi_eta_zeta;
  const Vec3<T> d0 = low - low_d, d1 = low + low_d, d2 = high + high_d, d3 = high - high_d;
  corner[0] = T(-1) * (s0 + d0);
  corner[1] = s1 - d1;
  corner[2] = s2 - d2;
  corner[3] = s3 - d3;
  corner[4] = d0 - s0;
  corner[5] = s1 + d1;
  corner[6] = s2 + d2;
  corner[7] = s3 + d3;
}

/// The mean gradient operator as its six modal vectors C_1..3 and D_1..3 [length^2].
template <class T>
struct UniformGradient {
  Vec3<T> linear[3];
  Vec3<T> hourglass[3];
};

/// a x b + c x d
template <class T>
PINBALL_FUNCTION Vec3<T> sum_of_cross_products(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& d) {
  return {a.y * b.z - a.z * b.y + c.y * d.z - c.z * d.y, a.z * b.x - a.x * b.z + c.z * d.x - c.x * d.z,
          a.x * b.y - a.y * b.x + c.x * d.y - c.y * d.x};
}

/// x: modes of the corner coordinates.
template <class T>
PINBALL_FUNCTION UniformGradient<T> uniform_gradient(const HexahedronModes<T>& x) {
  UniformGradient<T> b;
  PINBALL_UNROLL
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    b.linear[i] = sum_of_cross_products(x.linear[j], x.linear[k], x.hourglass[k], x.hourglass[j]);
    b.hourglass[i] = sum_of_cross_products(x.linear[k], x.hourglass[j], x.hourglass[k], x.linear[j]);
  }
  return b;
}

/// Exact volume of the trilinear hexahedron: V = 1/3 sum_I B_iI x_iI [length^3].
template <class T>
PINBALL_FUNCTION T hexahedron_volume(const UniformGradient<T>& b, const HexahedronModes<T>& x) {
  T sum = dot(b.linear[0], x.linear[0]) + dot(b.hourglass[0], x.hourglass[0]);
  sum += dot(b.linear[1], x.linear[1]) + dot(b.hourglass[1], x.hourglass[1]);
  sum += dot(b.linear[2], x.linear[2]) + dot(b.hourglass[2], x.hourglass[2]);
  return number<T>(8.0 / 3.0) * sum;
}

/// L_ij = 1/V sum_I v_iI B_jI [1/time]; v: modes of the corner velocities.
template <class T>
PINBALL_FUNCTION Tensor<T> velocity_gradient(const UniformGradient<T>& b, const HexahedronModes<T>& v,
                                             const T& inverse_volume) {
  const T scale = T(8) * inverse_volume;
#define PINBALL_ROW(c)                                                                        \
  (scale *                                                                                    \
   (v.linear[0].c * b.linear[0] + v.linear[1].c * b.linear[1] + v.linear[2].c * b.linear[2] + \
    v.hourglass[0].c * b.hourglass[0] + v.hourglass[1].c * b.hourglass[1] + v.hourglass[2].c * b.hourglass[2]))
  return {PINBALL_ROW(x), PINBALL_ROW(y), PINBALL_ROW(z)};
#undef PINBALL_ROW
}

/// s += c (x) c
template <class T>
PINBALL_FUNCTION void add_square(const Vec3<T>& c, Symmetric<T>& s) {
  s.xx += c.x * c.x;
  s.yy += c.y * c.y;
  s.zz += c.z * c.z;
  s.xy += c.x * c.y;
  s.yz += c.y * c.z;
  s.zx += c.z * c.x;
}

/// sum_I B_iI B_jI [length^4]; L_m and G_m have norm^2 8.
template <class T>
PINBALL_FUNCTION Symmetric<T> gradient_square(const UniformGradient<T>& b) {
  Symmetric<T> linear{T(0), T(0), T(0), T(0), T(0), T(0)}, hourglass = linear;
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    add_square(b.linear[m], linear);
    add_square(b.hourglass[m], hourglass);
  }
  return T(8) * linear + number<T>(8.0 / 3.0) * hourglass;
}

/// The area of a face where the element is a cube [length^2]: sqrt(2/3 B:B), with b_b = B_jJ B_jJ [length^4].
template <class T>
PINBALL_FUNCTION T face_area(const T& b_b) {
  return square_root(number<T>(2.0 / 3.0) * b_b);
}

/// Outward area vectors of the two faces across parent axis i (0 xi, 1 eta, 2 zeta) [length^2], exact for bilinear
/// faces: A = +-4 (X_j +- sqrt3 H_k) x (X_k +- sqrt3 H_j), j, k the cyclic successors of i.
template <class T>
PINBALL_FUNCTION void face_areas(const HexahedronModes<T>& x, int i, Vec3<T>& minus, Vec3<T>& plus) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  const T sqrt3 = number<T>(1.7320508075688772935);
  const Vec3<T> hj = sqrt3 * x.hourglass[j], hk = sqrt3 * x.hourglass[k];
  plus = T(4) * cross(x.linear[j] + hk, x.linear[k] + hj);
  minus = T(-4) * cross(x.linear[j] - hk, x.linear[k] - hj);
}

}  // namespace pinball
