#pragma once

#include "hourglass.hpp"

/// Assumed-strain stabilisation after Belytschko and Bindeman (Comp. Meths. Appl. Mech. Engrg. 105, 225-260, 1993,
/// "ASQBI"): the hourglass modes resist as the material does in bending and twisting, without a coefficient to tune.
///
/// In a box of half edges a_1..3 along xi_1..3 = xi, eta, zeta the hourglass modes h_1..4 (hourglass.hpp), times sqrt3,
/// strain linearly; e.g. of the mode xi eta, with h_(a,m) the component of h_a along edge m,
///
///     e_11 = sqrt3 eta h_(3,1) / a_1 ,   e_22 = sqrt3 xi h_(3,2) / a_2 ,
///     2 e_12 = sqrt3 (xi h_(3,1)/a_2 + eta h_(3,2)/a_1) .
///
/// What locks is left out: the shear of a bending mode, and the resistance of an element to narrowing where it is
/// stretched. So each of the coordinates xi_c goes with two bending strains, in a state of plane stress across c, and
/// with one twist:
///
///     s_mk = E/(1 - nu^2) (h_(a,m)/a_m + nu h_(b,k)/a_k)   m, k: the directions other than c;
///                                                          h_a ~ xi_m xi_c, h_b ~ xi_k xi_c
///
///     t_c = mu (h_(m,m)/a_k + h_(k,k)/a_m)                 of u_m ~ xi_k xi_c and u_k ~ xi_m xi_c
///
/// and the fourth mode, xi eta zeta, is stretched along one line at a time: E/3 h_(4,m)/a_m. The forces follow from the
/// energy: over the box the square of sqrt3 xi_c has the mean 1.
///
/// Distorted elements take X_m, the linear modes of the coordinates, for their half edges, of whatever directions; no
/// root and no frame are needed. The frequency of a stabilised mode stays below what element_stable_rate allows: its
/// mass is three times that of a linear mode, its stiffness no larger.
namespace pinball {

/// Moduli of the stabilisation.
template <class S>
struct AssumedStrainModuli {
  S bending;    ///< E/(1 - nu^2) [stress]
  S narrowing;  ///< nu E/(1 - nu^2) [stress]
  S twist;      ///< mu [stress]
  S fourth;     ///< E/3 [stress]
};

/// factor: of all of them, 1 unless one wants a softer element [-].
template <class S>
PINBALL_FUNCTION AssumedStrainModuli<S> assumed_strain_moduli(S lambda, S mu, S factor) {
  const S modulus = lambda + 2 * mu;
  return {factor * 4 * mu * (lambda + mu) / modulus, factor * 2 * mu * lambda / modulus, factor * mu,
          factor * mu * (3 * lambda + 2 * mu) / (3 * (lambda + mu))};
}

/// X_m of an element, and 1/|X_m|^2; zero where `whole` is false, and then nothing resists.
template <class T>
struct HalfEdges {
  Vec3<T> edge[3];
  T inverse_square[3];
};

template <class T>
PINBALL_FUNCTION HalfEdges<T> half_edges(const HexahedronModes<T>& x, const MaskOf<T>& whole) {
  const T xi = dot(x.linear[0], x.linear[0]), eta = dot(x.linear[1], x.linear[1]), zeta = dot(x.linear[2], x.linear[2]);
  const T eta_zeta = eta * zeta, product = xi * eta_zeta;
  const T inverse = select(whole && product > T(0), T(1) / select(product > T(0), product, T(1)), T(0));
  return {{x.linear[0], x.linear[1], x.linear[2]}, {inverse * eta_zeta, inverse * (zeta * xi), inverse * (xi * eta)}};
}

/// Stiffness times hourglass displacements: P_a [force] of h_a [length], or rates of rates. eighth: V/8 [length^3].
template <class T>
PINBALL_FUNCTION HourglassForce<T> assumed_strain_force(const AssumedStrainModuli<ScalarOf<T>>& moduli,
                                                        const HalfEdges<T>& half, const Vec3<T> (&h)[4],
                                                        const T& eighth) {
  const T bending = T(moduli.bending) * eighth, narrowing = T(moduli.narrowing) * eighth;
  const T twist = T(moduli.twist) * eighth, fourth = T(moduli.fourth) * eighth;
  const auto& r = half.inverse_square;
  T along[4][3];  // X_m.h_a, then the factor of X_m in P_a
  PINBALL_UNROLL
  for (int a = 0; a < 4; ++a) {
    PINBALL_UNROLL
    for (int m = 0; m < 3; ++m) along[a][m] = dot(half.edge[m], h[a]);
  }
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    const int m = (c + 1) % 3, k = (c + 2) % 3;  // mode m is xi_k xi_c, mode k is xi_m xi_c
    const T of_m = r[m] * along[k][m], of_k = r[k] * along[m][k];
    along[k][m] = r[m] * (bending * of_m + narrowing * of_k);
    along[m][k] = r[k] * (bending * of_k + narrowing * of_m);
  }
  // t_c acts on the modes m and k along their own edges.
  const T own[3] = {along[0][0], along[1][1], along[2][2]};
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    const int k = (m + 1) % 3, c = (m + 2) % 3;
    along[m][m] = twist * r[m] * (r[k] * (own[m] + own[k]) + r[c] * (own[m] + own[c]));
    along[3][m] = fourth * r[m] * (r[m] * along[3][m]);
  }
  HourglassForce<T> force;
  PINBALL_UNROLL
  for (int a = 0; a < 4; ++a) {
    force.p[a] = along[a][0] * half.edge[0] + along[a][1] * half.edge[1] + along[a][2] * half.edge[2];
  }
  return force;
}

}  // namespace pinball
