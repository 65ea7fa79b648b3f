#pragma once

#include <cmath>

#include "principal_values.hpp"
#include "von_mises.hpp"

/// When an element fails: what of a material and of its settings says that it is eroded (element/failure.hpp). Laws of
/// strength may have reasons of their own (johnson_cook.hpp).
///
/// Limits, each by itself. Of the stress sigma at the end of a step, without bulk viscosity, with the pressure
/// p = -tr sigma/3, the effective stress q and principal values s_1 >= s_2 >= s_3:
///
///     -p > tension ,   p > compression ,   s_1 > principal_stress ,   q > effective_stress .
///
/// Of the strain e, the sum of the strains of all steps, each of which turns from then on as the stress does: where its
/// axes stay in the material, the logarithmic one. With principal values e_1 >= e_2 >= e_3:
///
///     e_1 > principal_strain ,   (e_1 - e_3)/2 > shear_strain .
///
/// And  t > time ,  dt_e < smallest_step , with the stable step dt_e of the element.
namespace pinball {

/// Infinite, or zero for the step: none.
template <class S>
struct FailureLimits {
  bool any = false;                  ///< whether there is one
  S tension = S(INFINITY);           ///< [stress]
  S compression = S(INFINITY);       ///< [stress]
  S principal_stress = S(INFINITY);  ///< [stress]
  S effective_stress = S(INFINITY);  ///< [stress]
  S principal_strain = S(INFINITY);  ///< [-]
  S shear_strain = S(INFINITY);      ///< [-]
  S time = S(INFINITY);              ///< [time]
  S smallest_step = S(0);            ///< [time]
};

template <class S>
struct FailureConstants {
  S plastic_strain = S(INFINITY);  ///< beyond which an element fails; infinity: none does [-]
  bool negative_volume = false;    ///< an element without a volume fails; else it is counted as inverted
  bool inside_out = false;         ///< an element fails with a corner that has turned over
  FailureLimits<S> limits{};       ///< general yield only
};

/// Elements beyond a limit. strain: e; stable_rate: 2/dt_e [1/time]; time: t.
template <class T>
PINBALL_FUNCTION MaskOf<T> beyond_limits(const FailureLimits<ScalarOf<T>>& limits, const Symmetric<T>& stress,
                                         const Symmetric<T>& strain, const T& stable_rate, ScalarOf<T> time) {
  const T mean = number<T>(1.0 / 3.0) * trace(stress), effective = square_root(effective_square(deviator_of(stress)));
  const PrincipalValues<T> s = principal_values(stress), e = principal_values(strain);
  const MaskOf<T> by_stress = mean > T(limits.tension) || T(-1) * mean > T(limits.compression) ||
                              s.largest > T(limits.principal_stress) || effective > T(limits.effective_stress);
  const MaskOf<T> by_strain =
      e.largest > T(limits.principal_strain) || number<T>(0.5) * (e.largest - e.smallest) > T(limits.shear_strain);
  const MaskOf<T> by_time = T(time) > T(limits.time) || T(limits.smallest_step) * stable_rate > T(2);
  return by_stress || by_strain || by_time;
}

}  // namespace pinball
