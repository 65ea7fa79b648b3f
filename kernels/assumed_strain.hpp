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
/// with one twist; m, k are the directions other than c, h_a ~ xi_m xi_c, h_b ~ xi_k xi_c:
///
///     e_mc = h_(a,m)/a_m ,   e_kc = h_(b,k)/a_k ,   g_c = h_(m,m)/a_k + h_(k,k)/a_m
///     s_mc = E/(1 - nu^2) (e_mc + nu e_kc) ,        t_c = mu g_c
///
/// The fourth mode, xi eta zeta, is stretched along one line at a time: e_m4 = h_(4,m)/(sqrt3 a_m), s_m4 = E e_m4. The
/// stress of an element is then sigma + sqrt3 sum_c xi_c S_c + ..., with S_c the tensor of s_mc, s_kc and t_c.
///
/// These twelve stresses are what an element keeps. They are components along its own edges, which turn with it: they
/// need no rotation. Strains go by increments, dS = C de with constant C, so that the energy
///
///     U = V_0/2 sum S e = V_0/(2 E) ( sum s_mc^2 + s_kc^2 - 2 nu s_mc s_kc + 2 (1 + nu) t_c^2 + sum_m s_m4^2 )
///
/// is a function of what is kept, never negative, and all work that is put into the modes comes back out of them: per
/// volume V_0 of the undeformed element, since a stiffness that went with the present volume and were integrated
/// would give back more, or less, than it took. The forces P_a follow from 8 sum_a P_a.h_a = V_0 sum S e.
///
/// Distorted elements take X_m, the linear modes of the coordinates, for their half edges, of whatever directions: no
/// frame is needed. The frequency of a stabilised mode stays below what element_stable_rate allows: its mass is three
/// times that of a linear mode, its stiffness no larger (where an element has less than a third of its volume V_0,
/// three times its volume takes the place of V_0).
namespace pinball {

/// Moduli of the stabilisation.
template <class S>
struct AssumedStrainModuli {
  S bending;     ///< E/(1 - nu^2) [stress]
  S narrowing;   ///< nu E/(1 - nu^2) [stress]
  S twist;       ///< mu [stress]
  S fourth;      ///< E [stress]
  S compliance;  ///< 1/E [1/stress]
  S ratio;       ///< nu [-]
};

/// factor: of all of them, 1 unless one wants a softer element [-].
template <class S>
PINBALL_FUNCTION AssumedStrainModuli<S> assumed_strain_moduli(S lambda, S mu, S factor) {
  const S modulus = lambda + 2 * mu, young = mu * (3 * lambda + 2 * mu) / (lambda + mu);
  return {factor * 4 * mu * (lambda + mu) / modulus, factor * 2 * mu * lambda / modulus, factor * mu, factor * young,
          factor > 0 ? 1 / (factor * young) : S(0),  lambda / (2 * (lambda + mu))};
}

/// The edges of an element.
template <class T>
struct ElementEdges {
  Vec3<T> edge[3];       ///< X_m [length]
  T square[3];           ///< |X_m|^2
  T inverse_square[3];   ///< 1/|X_m|^2; zero where an element has no volume: then nothing resists
  T inverse_product[3];  ///< of the lengths of the edges other than c
};

template <class T>
PINBALL_FUNCTION void set_edges(ElementEdges<T>& edges, const HexahedronModes<T>& x) {
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    edges.edge[m] = x.linear[m];
    edges.square[m] = dot(x.linear[m], x.linear[m]);
  }
}

/// One division and two roots.
template <class T>
PINBALL_FUNCTION ElementEdges<T> edges_of(const HexahedronModes<T>& x, const MaskOf<T>& whole) {
  ElementEdges<T> edges;
  set_edges(edges, x);
  const T xi = edges.square[0], eta = edges.square[1], zeta = edges.square[2];
  const T eta_zeta = eta * zeta, product = xi * eta_zeta;
  const auto resists = whole && product > T(0);
  const T inverse = select(resists, T(1) / select(resists, product, T(1)), T(0));
  const T of_xi = inverse * eta_zeta, of_eta = inverse * (zeta * xi), of_zeta = inverse * (xi * eta);
  edges.inverse_square[0] = of_xi;
  edges.inverse_square[1] = of_eta;
  edges.inverse_square[2] = of_zeta;
  edges.inverse_product[0] = square_root(of_eta * of_zeta);
  edges.inverse_product[1] = square_root(of_zeta * of_xi);
  edges.inverse_product[2] = edges.inverse_product[0] * edges.inverse_product[1] * zeta;
  return edges;
}

/// The same half a step later than `before`, up to the square of the strain in between: with q = a^2/a_before^2,
/// 1/q = 2 - q and sqrt(q) = (1 + q)/2.
template <class T>
PINBALL_FUNCTION ElementEdges<T> edges_later(const HexahedronModes<T>& x, const ElementEdges<T>& before) {
  ElementEdges<T> edges;
  set_edges(edges, x);
  T left[3];  // 2 - q; edges that have become longer by more than sqrt2 resist no more
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    left[m] = maximum(T(0), T(2) - edges.square[m] * before.inverse_square[m]);
    edges.inverse_square[m] = left[m] * before.inverse_square[m];
  }
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    edges.inverse_product[c] = number<T>(0.5) * (left[(c + 1) % 3] + left[(c + 2) % 3]) * before.inverse_product[c];
  }
  return edges;
}

/// Twelve strains or stresses: for each c the two of bending, along m = c + 1 and k = c + 2 (mod 3), and the twist;
/// then the three of the fourth mode.
template <class T>
struct AssumedField {
  T c[12];
};

/// Strains of hourglass displacements h [length], or rates of rates.
template <class T>
PINBALL_FUNCTION AssumedField<T> assumed_strain(const ElementEdges<T>& edges, const Vec3<T> (&h)[4]) {
  AssumedField<T> e;
  const T own[3] = {dot(edges.edge[0], h[0]), dot(edges.edge[1], h[1]), dot(edges.edge[2], h[2])};
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    const int m = (c + 1) % 3, k = (c + 2) % 3;  // mode m is xi_k xi_c, mode k is xi_m xi_c
    e.c[3 * c] = edges.inverse_square[m] * dot(edges.edge[m], h[k]);
    e.c[3 * c + 1] = edges.inverse_square[k] * dot(edges.edge[k], h[m]);
    e.c[3 * c + 2] = edges.inverse_product[c] * (own[m] + own[k]);
    e.c[9 + c] = number<T>(0.57735026918962576451) * edges.inverse_square[c] * dot(edges.edge[c], h[3]);  // 1/sqrt3
  }
  return e;
}

/// Stresses of strains.
template <class T>
PINBALL_FUNCTION AssumedField<T> assumed_stress(const AssumedStrainModuli<ScalarOf<T>>& moduli,
                                                const AssumedField<T>& e) {
  AssumedField<T> s;
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    s.c[3 * c] = T(moduli.bending) * e.c[3 * c] + T(moduli.narrowing) * e.c[3 * c + 1];
    s.c[3 * c + 1] = T(moduli.bending) * e.c[3 * c + 1] + T(moduli.narrowing) * e.c[3 * c];
    s.c[3 * c + 2] = T(moduli.twist) * e.c[3 * c + 2];
    s.c[9 + c] = T(moduli.fourth) * e.c[9 + c];
  }
  return s;
}

/// sum S e [stress].
template <class T>
PINBALL_FUNCTION T contract(const AssumedField<T>& s, const AssumedField<T>& e) {
  T sum = s.c[0] * e.c[0];
  PINBALL_UNROLL
  for (int i = 1; i < 12; ++i) sum += s.c[i] * e.c[i];
  return sum;
}

/// s : C^-1 : t, for C of assumed_stress [stress]: twice the energy per volume if s and t are the same stresses, and of
/// their sum and difference the difference of their energies, doubled.
template <class T>
PINBALL_FUNCTION T compliance_product(const AssumedStrainModuli<ScalarOf<T>>& moduli, const AssumedField<T>& s,
                                      const AssumedField<T>& t) {
  T direct(0), lateral(0), twist(0);
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    const int m = 3 * c, k = m + 1;
    direct += s.c[m] * t.c[m] + s.c[k] * t.c[k] + s.c[9 + c] * t.c[9 + c];
    lateral += s.c[m] * t.c[k] + s.c[k] * t.c[m];
    twist += s.c[k + 1] * t.c[k + 1];
  }
  const ScalarOf<T> nu = moduli.ratio;
  return T(moduli.compliance) * (direct - T(nu) * lateral + T(2 + 2 * nu) * twist);
}

/// Forces P_a of the stresses; eighth: V_0/8 [length^3].
template <class T>
PINBALL_FUNCTION HourglassForce<T> assumed_strain_force(const ElementEdges<T>& edges, const AssumedField<T>& s,
                                                        const T& eighth) {
  const auto& edge = edges.edge;
  T bending[3], fourth[3], twist[3];  // factors of a stress
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    bending[c] = eighth * edges.inverse_square[c];
    fourth[c] = number<T>(0.57735026918962576451) * bending[c] * s.c[9 + c];
    twist[c] = eighth * edges.inverse_product[c] * s.c[3 * c + 2];
  }
  HourglassForce<T> force;
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    const int m = (c + 1) % 3, k = (c + 2) % 3;
    // Mode c is xi_m xi_k: bending along m varies along k, bending along k varies along m.
    force.p[c] =
        (bending[m] * s.c[3 * k + 1]) * edge[m] + (bending[k] * s.c[3 * m]) * edge[k] + (twist[m] + twist[k]) * edge[c];
  }
  force.p[3] = fourth[0] * edge[0] + fourth[1] * edge[1] + fourth[2] * edge[2];
  return force;
}

/// Mean over the element of the square of the effective stress of sqrt3 sum_c xi_c S_c + ... [stress^2].
template <class T>
PINBALL_FUNCTION T effective_square(const AssumedField<T>& s) {
  T sum(0);
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    const T m = s.c[3 * c], k = s.c[3 * c + 1], t = s.c[3 * c + 2];
    sum += m * m + k * k - m * k + T(3) * (t * t) + s.c[9 + c] * s.c[9 + c];
  }
  return sum;
}

/// What the stress of the centre, of deviator s, and S have in common (bending_yield.hpp): a share r_c/r of each S_c.
template <class T>
struct CommonStress {
  T alignment;   ///< r = sqrt(sum_c r_c^2), r_c = 3/2 s : S_c [stress^2]
  T share[3];    ///< r_c/r [-]
  T of_mean[9];  ///< of each plane stress across c that has, but for shear across c, the deviator s
};

/// unit: any stress of the size of a modulus, so that fourth powers of stresses stay numbers in single precision.
template <class T>
PINBALL_FUNCTION CommonStress<T> common_stress(const ElementEdges<T>& edges, const Symmetric<T>& deviator,
                                               const AssumedField<T>& s, const ScalarOf<T>& unit) {
  const Vec3<T> acting[3] = {deviator * edges.edge[0], deviator * edges.edge[1], deviator * edges.edge[2]};
  const T direct[3] = {edges.inverse_square[0] * dot(edges.edge[0], acting[0]),
                       edges.inverse_square[1] * dot(edges.edge[1], acting[1]),
                       edges.inverse_square[2] * dot(edges.edge[2], acting[2])};
  const T scale(ScalarOf<T>(1.5) / unit);
  T shear[3], product[3], sum(0);
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    const int m = (c + 1) % 3, k = (c + 2) % 3;
    shear[c] = edges.inverse_product[c] * dot(edges.edge[m], acting[k]);
    product[c] = scale * (s.c[3 * c] * direct[m] + s.c[3 * c + 1] * direct[k] + T(2) * s.c[3 * c + 2] * shear[c]);
    sum += product[c] * product[c];
  }
  const T root = square_root(sum);
  const auto aligned = root > T(0);
  const T inverse = select(aligned, T(1) / select(aligned, root, T(1)), T(0));
  CommonStress<T> common;
  common.alignment = T(unit) * root;
  PINBALL_UNROLL
  for (int c = 0; c < 3; ++c) {
    const int m = (c + 1) % 3, k = (c + 2) % 3;
    const T share = inverse * product[c];
    common.share[c] = share;
    common.of_mean[3 * c] = share * (direct[m] - direct[c]);
    common.of_mean[3 * c + 1] = share * (direct[k] - direct[c]);
    common.of_mean[3 * c + 2] = share * shear[c];
  }
  return common;
}

/// Deviator of sum_c share_c S_c [stress].
template <class T>
PINBALL_FUNCTION Symmetric<T> deviator_of_shares(const ElementEdges<T>& edges, const AssumedField<T>& s,
                                                 const T (&share)[3]) {
  // sum_m X_m (x) y_m, symmetric part
  T along[3], across[3];
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    const int k = (m + 1) % 3, c = (m + 2) % 3;  // along m: the first stress of c, the second of k
    along[m] = edges.inverse_square[m] * (share[c] * s.c[3 * c] + share[k] * s.c[3 * k + 1]);
    across[c] = T(2) * edges.inverse_product[c] * (share[c] * s.c[3 * c + 2]);  // of m and k
  }
  const T half = number<T>(0.5);
  Symmetric<T> field{T(0), T(0), T(0), T(0), T(0), T(0)};
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    const int k = (m + 1) % 3, c = (m + 2) % 3;
    const Vec3<T> x = edges.edge[m], y = along[m] * edges.edge[m] + across[c] * edges.edge[k];
    field.xx += x.x * y.x;
    field.yy += x.y * y.y;
    field.zz += x.z * y.z;
    field.xy += half * (x.x * y.y + x.y * y.x);
    field.yz += half * (x.y * y.z + x.z * y.y);
    field.zx += half * (x.z * y.x + x.x * y.z);
  }
  const T mean = number<T>(1.0 / 3.0) * trace(field);
  return {field.xx - mean, field.yy - mean, field.zz - mean, field.xy, field.yz, field.zx};
}

}  // namespace pinball
