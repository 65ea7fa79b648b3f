#pragma once

#include "von_mises.hpp"

/// Yield of elements whose stress varies within them: radial return at two points beside the centre.
///
/// Hourglass stresses S (assumed_strain.hpp) add to the stress of the centre, of deviator s, what changes through the
/// element. Where von Mises' condition looks at the centre alone, an element in pure bending never yields; Puso
/// (Internat. J. Numer. Meths. Engrg. 49, 1029-1064, 2000) and others therefore scale hourglass stresses by a plastic
/// tangent. Here they yield: in bending the stress of one line through the element is s + sqrt3 xi S, and two points of
/// it, at xi = +-2/3, hold s +- k S, k = 2/sqrt3. Each is returned to the yield surface by itself,
///
///     s_+- = s +- k S ,   q_+-^2 = 3/2 s_+- : s_+- = q_s^2 + k^2 q_S^2 +- 2 k r ,   r = 3/2 s : S ,
///     dl_+- as of radial_return ,   f_+- = 1 - 3 mu dl_+- / q_+- ,
///
/// and what they hold afterwards, (f_+ s_+ + f_- s_-)/2 and (f_+ s_+ - f_- s_-)/(2 k), is the new state:
///
///     s <- f s + k g S ,   S <- f S + (g/k) s ,       f = (f_+ + f_-)/2 ,   g = (f_+ - f_-)/2 <= 0 .
///
/// The plastic strain grows by the mean of the two increments. Without S this is the radial return of s. The points are
/// those for which an element of height h that bends alone carries the moment of a plastic section, Y h^2/4 per width:
/// its moment is h^2 S/(2 sqrt3), and S ends at Y/k. (Gauss' points, k = 1, give 1.155 times as much.) In layers of
/// elements, which are stretched more than bent, S ends at zero and s at Y, which is exact, too. Only what S has in
/// common with s goes there: the rest, which holds the modes of an element that flows, shrinks with s.
///
/// Bending about several axes, S_1..3, counts with q_S^2 = sum q_c^2, the mean square through the element, and with the
/// direction in which the effective stress changes most: r^2 = sum r_c^2, and r_c/r of s goes to S_c, and of S_c to s.
namespace pinball {

/// The factors f and g of the two points.
template <class T>
struct YieldFactors {
  T mean, difference;
};

/// An element yields only where this exceeds the square of its yield stress: q_+-^2 <= 2 (q_s^2 + k^2 q_S^2).
template <class T>
PINBALL_FUNCTION T largest_effective_square(const T& mean, const T& variation) {
  return T(2) * mean + number<T>(8.0 / 3.0) * variation;
}

// What MaterialConstants have as functions of their own, of laws that are objects with increment() and modulus().

template <class T, class Law>
requires requires(const Law& law, const T& q) { law.increment(q, q); }
PINBALL_FUNCTION T plastic_increment(const Law& law, const T& q, const T& plastic_strain) {
  return law.increment(q, plastic_strain);
}
template <class Law>
requires requires(const Law& law) { law.modulus(); }
PINBALL_FUNCTION auto return_modulus(const Law& law) { return law.modulus(); }
template <class Law>
requires requires(const Law& law) { law.modulus(); }
PINBALL_FUNCTION auto half_return_modulus(const Law& law) { return law.modulus() / 2; }

/// Below this part of a modulus a stress is nothing [-].
template <class S>
inline constexpr S least_strain = sizeof(S) == sizeof(double) ? S(0x1p-300) : S(0x1p-40);

/// mean: q_s^2, variation: q_S^2, alignment: r [stress^2]. The edges of sheared elements are not orthogonal, and r may
/// seem larger than it can be.
/// law: MaterialConstants, or another with plastic_increment() and return_modulus().
template <class T, class Law>
PINBALL_FUNCTION YieldFactors<T> return_in_bending(const Law& law, const T& mean, const T& variation,
                                                   const T& alignment, T& plastic_strain) {
  const T sum = mean + number<T>(4.0 / 3.0) * variation;
  const T difference = minimum(number<T>(2.3094010767585030580) * alignment, sum);  // 2 k r
  const T q_plus = square_root(sum + difference), q_minus = square_root(sum - difference);
  const T dl_plus = plastic_increment(law, q_plus, plastic_strain);
  const T dl_minus = plastic_increment(law, q_minus, plastic_strain);
  plastic_strain += number<T>(0.5) * (dl_plus + dl_minus);
  // if (dl > 0) lost = 3 mu dl / q; else lost = 0 (q may be zero then)
  const auto plus_yields = dl_plus > T(0), minus_yields = dl_minus > T(0);
  const T half_modulus(half_return_modulus(law));
  // What has no strength loses all but round-off of its stress in each step. What is left in the end, where nothing
  // strains the element, is no divisor: the product of two of them would be zero.
  const T least(half_return_modulus(law) * least_strain<ScalarOf<T>>);
  const T used_plus = select(plus_yields, maximum(q_plus, least), T(1)),
          used_minus = select(minus_yields, maximum(q_minus, least), T(1));
  const T factor = half_modulus / (used_plus * used_minus);  // both quotients from one division
  const T plus = factor * used_minus * dl_plus, minus = factor * used_plus * dl_minus;
  return {T(1) - (plus + minus), minus - plus};
}

/// The same where nothing is known of the alignment, r = 0: both points lose the same. Returns f.
template <class T, class Law>
PINBALL_FUNCTION T return_in_bending_unaligned(const Law& law, const T& mean, const T& variation, T& plastic_strain) {
  const T q = square_root(mean + number<T>(4.0 / 3.0) * variation);
  const T dl = plastic_increment(law, q, plastic_strain);
  plastic_strain += dl;
  const auto yields = dl > T(0);
  return T(1) - select(yields, T(return_modulus(law)) * dl / select(yields, q, T(1)), T(0));
}

}  // namespace pinball
