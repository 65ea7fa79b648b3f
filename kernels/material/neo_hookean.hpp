#pragma once

#include "von_mises.hpp"

/// Elasticity that gives back what it was given: the compressible neo-Hookean solid of Simo and Pister (1984; Bonet and
/// Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, section 6.4), with the energy per initial volume
///
///     W = mu/2 (tr b - 3) - mu ln J + lambda/2 ((J^2 - 1)/2 - ln J) ,     b = F F^T ,  J = det F ,
///
/// and its Cauchy stress
///
///     sigma = mu/J (b - I) + u I ,     u = lambda/2 (J - 1/J) .
///
/// Hooke's law for small strains. Closed forms: (lambda + 2 mu) sinh(ln J) in uniaxial strain, which is the rate law's
/// (lambda + 2 mu) ln J but for a sixth of the strain's square; mu k and mu k^2 in simple shear by k.
///
/// Nothing is kept but sigma: with J, which the nodes know, it says what b is, so that a step is exact for any strain
/// and rotation. With the half increment h = L dt/2 of the mid-step configuration its deformation gradient is
///
///     f = (I - h)^-1 (I + h) = I + g ,   g = 2 ((1 - tr h) h + h^2 + det h I)/det(I - h)     (Cayley and Hamilton)
///
/// and b <- f b f^T becomes, with E = sigma - u I = mu/J (b - I) of the old state and M = (J_old E + mu I)/J,
///
///     sigma <- (u_old + du) I + J_old/J E + g M + (g M)^T + (g M) g^T .
///
/// du follows from h, not from the difference of two volumes: an error of J_old by round-off, as positions far from the
/// origin bring it in single precision, leaves E as it came into it, but for a part as small as the increment.
namespace pinball {

/// State after a step.
template <class T>
struct NeoHookeanState {
  Symmetric<T> stress;  ///< Cauchy stress [stress]
  /// Moduli of a linear material that is at least as stiff in any small motion (element_stable_rate) [stress].
  T lambda, mu;
};

/// Geometry of a step as the constitutive law needs it.
template <class T>
struct VolumeChange {
  T initial;          ///< V of the element without strain [length^3]
  T inverse_initial;  ///< [1/length^3]
  T middle;           ///< in the middle of the step [length^3]
  T end;              ///< at the end of the step [length^3]
  T inverse_end;      ///< [1/length^3]
};

/// g, the deformation gradient of a step less I. half: h = L dt/2, of the mid-step configuration [-].
template <class T>
PINBALL_FUNCTION Tensor<T> gradient_of_step(const Tensor<T>& half) {
  const Vec3<T>&a = half.row_x, &b = half.row_y, &c = half.row_z;
  const T tr = a.x + b.y + c.z;
  const Vec3<T> b_c = cross(b, c);
  const T det = dot(a, b_c);
  const T minors = b_c.x + (a.x * b.y - a.y * b.x) + (c.z * a.x - c.x * a.z);
  const T factor = T(2) / ((T(1) + minors) - (tr + det));  // 2/det(I - h)
  const T linear = T(1) - tr, none(0);
  const auto row = [&](const Vec3<T>& h, const Vec3<T>& unit) __attribute__((always_inline)) {
    return factor * (linear * h + (h.x * a + h.y * b + h.z * c) + unit);
  };
  return {row(a, {det, none, none}), row(b, {none, det, none}), row(c, {none, none, det})};
}

/// lambda, mu: Lame's constants without strain [stress]; half: h = L dt/2, of the mid-step configuration [-]; old: the
/// Cauchy stress before the step [stress]. Where `whole` is not set, half must be zero, and the stress stays.
template <class T>
PINBALL_FUNCTION NeoHookeanState<T> neo_hookean_step(const ScalarOf<T>& lambda, const ScalarOf<T>& mu,
                                                     const Tensor<T>& half, const VolumeChange<T>& volume,
                                                     const MaskOf<T>& whole, const Symmetric<T>& old) {
  const Vec3<T>&a = half.row_x, &b = half.row_y, &c = half.row_z;
  // Invariants of h
  const T tr = a.x + b.y + c.z;
  const Vec3<T> b_c = cross(b, c);
  const T det = dot(a, b_c);
  const T minors = b_c.x + (a.x * b.y - a.y * b.x) + (c.z * a.x - c.x * a.z);
  const T odd = tr + det;
  const T det_minus = (T(1) + minors) - odd;  // det(I - h)

  // The volume is a cubic of the time in the step: this is exact but for hourglass modes, whose part is of third order.
  const T more = (T(2) * volume.middle) * odd;
  const T before = select(whole, maximum(volume.end - more, number<T>(1e-3) * volume.end), T(1));
  const T inverse_both = T(1) / (before * det_minus);
  const T j_old = before * volume.inverse_initial, inverse_j_old = volume.initial * (inverse_both * det_minus);
  const T j = volume.end * volume.inverse_initial, inverse_j = volume.initial * volume.inverse_end;

  // g = s a, a = h ((1 - tr h) I + h) + det h I
  const T s = (T(2) * before) * inverse_both, linear = T(1) - tr;
  const T ax = a.x + linear, by = b.y + linear, cz = c.z + linear;
  const auto row = [&](const Vec3<T>& h) {
    return Vec3<T>{h.x * ax + h.y * b.x + h.z * c.x, h.x * a.y + h.y * by + h.z * c.y,
                   h.x * a.z + h.y * b.z + h.z * cz};
  };
  Vec3<T> ga = row(a), gb = row(b), gc = row(c);
  ga.x += det;
  gb.y += det;
  gc.z += det;

  const T half_lambda(ScalarOf<T>(0.5) * lambda);
  const T u_old = half_lambda * (j_old - inverse_j_old);
  const T u = u_old + (half_lambda * (more * volume.inverse_initial)) * (T(1) + inverse_j * inverse_j_old);
  const T shear = T(mu) * inverse_j, kept = T(1) - more * volume.inverse_end;  // mu/J, J_old/J
  const T s_shear = s * shear, s_kept = s * kept;
  const Symmetric<T> e{old.xx - u_old, old.yy - u_old, old.zz - u_old, old.xy, old.yz, old.zx};
  const Symmetric<T> m{s_kept * e.xx + s_shear, s_kept * e.yy + s_shear, s_kept * e.zz + s_shear,
                       s_kept * e.xy,           s_kept * e.yz,           s_kept * e.zx};
  const Vec3<T> na = m * ga, nb = m * gb, nc = m * gc;  // rows of g M
  NeoHookeanState<T> now;
  now.stress = {
      (u + kept * e.xx) + (T(2) * na.x + s * dot(na, ga)), (u + kept * e.yy) + (T(2) * nb.y + s * dot(nb, gb)),
      (u + kept * e.zz) + (T(2) * nc.z + s * dot(nc, gc)), kept * e.xy + (na.y + nb.x + s * dot(na, gb)),
      kept * e.yz + (nb.z + nc.y + s * dot(nb, gc)),       kept * e.zx + (nc.x + na.z + s * dot(nc, ga))};

  // Twice the energy of a small motion of gradient H, per volume, is
  //   mu/J (H b : H + tr HH) + lambda J (tr H)^2 + lambda/2 (1/J - J) tr HH ,
  // and H:H, with the largest principal value of b, bounds the first two; tr HH is no more than what bounds (tr H)^2.
  // The largest principal value of mu/J (b - I) is no more than its mean and sqrt(2/3) of its deviator's norm.
  const T mean = number<T>(1.0 / 3.0) * trace(now.stress);
  const Symmetric<T> deviator = deviator_of(now.stress);
  const T to_strain = T(1 / mu) * j,
          square = number<T>(2.0 / 3.0) * (to_strain * to_strain) * contract(deviator, deviator);
  now.mu = shear + number<T>(0.5) * (mean - u + shear * square_root(square));
  now.lambda = T(lambda) * maximum(j, number<T>(0.5) * (j + inverse_j));
  return now;
}

/// The same, called: for kernels that are made for other laws.
template <class T>
PINBALL_OUTLINED void update_neo_hookean(const ScalarOf<T>& lambda, const ScalarOf<T>& mu, const Tensor<T>& half,
                                         const VolumeChange<T>& volume, const MaskOf<T>& whole, const Symmetric<T>& old,
                                         NeoHookeanState<T>& now) {
  now = neo_hookean_step<T>(lambda, mu, half, volume, whole, old);
}

}  // namespace pinball
