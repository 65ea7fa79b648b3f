#pragma once

#include "mooney_rivlin.hpp"
#include "power.hpp"
#include "principal_values.hpp"

/// Rubber and foam after Ogden (Proc. R. Soc. A 326, 565-584 and 328, 567-583, 1972; Holzapfel, Nonlinear Solid
/// Mechanics, section 6.5): an energy of powers of the principal stretches l_i, per initial volume
///
///     W = sum_p m_p/a_p (l_1^a_p + l_2^a_p + l_3^a_p - 3) + U ,     mu = 1/2 sum_p m_p a_p of small strains ,
///
/// with either the stretches of shape alone, J^(-1/3) l_i, and U = K/2 (J - 1)^2, or the whole ones and
/// U = sum_p m_p/(a_p beta) (J^(-a_p beta) - 1), beta = nu/(1 - 2 nu) (Storakers, J. Mech. Phys. Solids 34, 125-145,
/// 1986), with which a bar of nu = 0 does not contract. Its principal Cauchy stresses
///
///     shape:  J sigma_i = sum_p m_p J^(-a_p/3) (l_i^a_p - 1/3 sum_j l_j^a_p) + K J (J - 1)
///     whole:  J sigma_i = sum_p m_p (l_i^a_p - J^(-a_p beta))
///
/// lie along those of E = b - I, which elements keep (mooney_rivlin.hpp): l_i^a = (1 + E_i)^(a/2), of which what is
/// beyond 1 is worked out by itself, so that small strains have all their digits.
namespace pinball {

template <class S>
struct OgdenConstants {
  static constexpr int most = 10;
  bool used = false;
  bool whole = false;  ///< stretches are the whole ones
  int terms = 0;
  S modulus[most]{};   ///< m_p [stress]
  S exponent[most]{};  ///< a_p [-]
  S bulk = S(0);       ///< K; of those of shape [stress]
  S coupling = S(0);   ///< beta; of the whole ones [-]
};

/// Sums over the terms: J times stresses and moduli, and what bounds them.
template <class T>
struct OgdenSums {
  T apart{0}, above{0}, below{0};  ///< J sigma_i without K
  T normal{0};                     ///< sum of |m a| times the largest power
  T shear{0};                      ///< the same, each power times b_1/b_i
  T volume{0};                     ///< of the whole ones: sum of |m a| beta J^(-a beta)
};

/// values: E_i of the axes.
template <class T>
PINBALL_FUNCTION OgdenSums<T> ogden_sums(const OgdenConstants<ScalarOf<T>>& law, const PrincipalAxes<T>& values,
                                         const T& volume) {
  using S = ScalarOf<T>;
  const T least = number<T>(-0.999999);  // what is pressed to a thousandth of its length is as stiff as that
  const T e1 = maximum(least, values.apart), e2 = maximum(least, values.above), e3 = maximum(least, values.below);
  const T l1 = logarithm_of_one_and(e1), l2 = logarithm_of_one_and(e2), l3 = logarithm_of_one_and(e3);
  const T b = T(1) + maximum(e1, e2);
  const T b1 = b / (T(1) + e1), b2 = b / (T(1) + e2), b3 = b / (T(1) + e3);
  OgdenSums<T> sums;
  for (int p = 0; p < law.terms; ++p) {
    const S a = law.exponent[p], half = S(0.5) * a, stiffness = law.modulus[p] * a;
    const T y1 = exponential_less_one(T(half) * l1), y2 = exponential_less_one(T(half) * l2),
            y3 = exponential_less_one(T(half) * l3);
    T scale(1), mean(0);
    const T size(stiffness < S(0) ? -stiffness : stiffness);
    if (law.whole) {
      mean = exponential_less_one(T(-a * law.coupling) * volume);
      sums.volume += size * T(law.coupling) * (T(1) + mean);
    } else {
      scale = T(1) + exponential_less_one(T(-a * S(1.0 / 3.0)) * volume);
      mean = number<T>(1.0 / 3.0) * (y1 + y2 + y3);
    }
    const T modulus = T(law.modulus[p]) * scale;
    sums.apart += modulus * (y1 - mean);
    sums.above += modulus * (y2 - mean);
    sums.below += modulus * (y3 - mean);
    const T x1 = T(1) + y1, x2 = T(1) + y2, x3 = T(1) + y3;
    sums.normal += size * scale * maximum(x1, maximum(x2, x3));
    sums.shear += size * scale * maximum(x1 * b1, maximum(x2 * b2, x3 * b3));
  }
  return sums;
}

/// Stress of the strain E and the volume ratio J, and moduli of a linear material that is at least as stiff.
///
/// Twice the energy of a small motion of gradient H, per volume, is along the principal axes, t = tr H, x_i = l_i^a,
///
///     1/J sum_p m a sum_i x_i (H_ii - t/3)^2 + K (2 J - 1) t^2 - sum_i sigma_i H_ii^2 ,
///
/// of the whole ones without t/3 and with 1/J sum_p m a beta J^(-a beta) for K (2 J - 1); and across them, for each
/// pair, with g = (sigma_i - sigma_j)/(b_i - b_j) <= 1/J sum_p |m a|/2 max x/b,
///
///     g (b_j H_ij^2 + b_i H_ji^2) + 2 (g b_j - sigma_j) H_ij H_ji .
///
/// With X = sum_p |m a| max x and Y = sum_p |m a| max(x/b) b_1 it is no more than P H : H + Q t^2,
///
///     P = Y/J + max |sigma_i| ,   Q = K (2 J - 1) - X/(3 J) or 1/J sum_p |m a| beta J^(-a beta) ,
///
/// exact without strain: there P = 2 mu, Q = lambda.
template <class T>
PINBALL_FUNCTION NeoHookeanState<T> ogden_state(const OgdenConstants<ScalarOf<T>>& law, const Symmetric<T>& e,
                                                const T& ratio) {
  using S = ScalarOf<T>;
  const PrincipalAxes<T> axes = principal_axes(principal_root(e), e);
  const T change = ratio - T(1), inverse = T(1) / ratio;
  const OgdenSums<T> sums = ogden_sums(law, axes, logarithm_of_one_and(change));
  const T inflation = T(law.bulk) * change;
  const T apart = inverse * sums.apart + inflation, above = inverse * sums.above + inflation,
          below = inverse * sums.below + inflation;
  NeoHookeanState<T> now;
  now.stress = along_axes(axes, apart, above, below);
  const T largest = maximum(absolute(apart), maximum(absolute(above), absolute(below)));
  now.mu = T(S(0.5)) * (inverse * sums.shear + largest);
  const T of_shape = T(law.bulk) * (T(2) * ratio - T(1)) - number<T>(1.0 / 3.0) * inverse * sums.normal;
  now.lambda = maximum(T(0), law.whole ? inverse * sums.volume : of_shape);
  return now;
}

/// Over a step, as update_mooney_rivlin().
template <class T>
PINBALL_OUTLINED void update_ogden(const OgdenConstants<ScalarOf<T>>& law, const Tensor<T>& half,
                                   const VolumeChange<T>& volume, const MaskOf<T>& whole, const Symmetric<T>& old,
                                   Symmetric<T>& strain, NeoHookeanState<T>& now) {
  strain = select(whole, strain_after(half, strain), strain);
  const T ratio = select(whole, maximum(volume.end * volume.inverse_initial, number<T>(1e-3)), T(1));
  now = ogden_state(law, strain, ratio);
  now.stress = select(whole, now.stress, old);
}

}  // namespace pinball
