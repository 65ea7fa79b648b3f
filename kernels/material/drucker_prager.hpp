#pragma once

#include "ideal_yield.hpp"

/// Strength that grows with the pressure, of soils, foams and concrete: ideal plasticity with
///
///     s:s/2 <= J(p) = min(a_0 + a_1 p + a_2 p^2, J_most) ,
///
/// after Krieg (A simple constitutive description for cellular concrete, SC-DR-72-0883, Sandia 1972). Drucker and
/// Prager's cone (Quart. Appl. Math. 10, 157-165, 1952), sqrt(s:s/2) <= k + b p, is a_0 = k^2, a_1 = 2 k b, a_2 = b^2.
/// Where the polynomial is below zero there is no strength; below its least value it keeps that, as strength does not
/// grow with tension. At the pressure p_none and below there is none, whatever the polynomial.
///
/// Stresses return along the deviator, at the pressure of the end of the step: flow does not dilate.
namespace pinball {

template <class S>
struct DruckerPragerConstants {
  bool used = false;
  S constant = S(0);      ///< a_0 [stress^2]
  S linear = S(0);        ///< a_1 [stress]
  S quadratic = S(0);     ///< a_2 [-]
  S most = S(INFINITY);   ///< J_most [stress^2]
  S none = S(-INFINITY);  ///< p_none [stress]
  S apex = S(-INFINITY);  ///< -a_1/(2 a_2): where the polynomial is least [stress]
};

/// J(p) [stress^2]
template <class T>
PINBALL_FUNCTION T strength_square(const DruckerPragerConstants<ScalarOf<T>>& law, const T& pressure) {
  const T p = maximum(pressure, T(law.apex));
  const T given = T(law.constant) + p * (T(law.linear) + T(law.quadratic) * p);
  return select(pressure > T(law.none), maximum(T(0), minimum(given, T(law.most))), T(0));
}

/// Effective stress at which it yields at a pressure, which is that of the end of the step (IdealYield) [stress].
template <class T>
PINBALL_FUNCTION T effective_strength(const DruckerPragerConstants<ScalarOf<T>>& law, const T& pressure) {
  return square_root(T(ScalarOf<T>(3)) * strength_square(law, pressure));
}

}  // namespace pinball
