#pragma once

#include "ideal_yield.hpp"
#include "principal_values.hpp"
#include "yield_curve.hpp"

/// Foams that crush: the skeleton yields where a principal stress reaches a curve over the compaction x = 1 - V/V_0
/// (LS-DYNA Theory Manual, material model 63; Radioss' LAW33, after Neilsen, Morgan and Krieg, SAND86-2927, 1987),
///
///     -Y(x) <= sigma_1, sigma_2, sigma_3 <= T ,     T: the tension cutoff, or Y(x) ,
///
/// and each is brought back to that by itself, in its direction: a bar that is pressed does not swell, and with a
/// Poisson's ratio of zero yields in each direction as if alone. Unloading is elastic; Y is that of the present volume.
/// The plastic strain is e_p of what is taken of Hooke's trial stress, de = sqrt(2/3 de_p:de_p).
///
/// Beside the skeleton's there are the pressure of air in closed cells, at constant temperature (Gibson and Ashby,
/// Cellular Solids, section 5.3), with the share phi of the volume that is solid, and a damping of all rates,
///
///     p = P_0 x/(1 - phi - x)  where x > 0 ,     sigma_v = zeta L/c (lambda tr D I + 2 mu D) ,
///
/// L = volume over face_area, c the speed of a wave along one axis, sqrt((lambda + 2 mu)/rho_0). Elements keep both, so
/// that the skeleton's stress is what is left.
namespace pinball {

template <class S>
struct CrushableFoamConstants {
  bool used = false;
  S cutoff = S(INFINITY);  ///< T; infinite: Y [stress]
  S damping = S(0);        ///< zeta/c [time/length]
  S air_pressure = S(0);   ///< P_0 [stress]
  S open_share = S(1);     ///< 1 - phi [-]
};

/// The least part of the volume that air is pressed into [-].
inline constexpr double least_air = 1e-3;

/// Yield stress at a compaction, and its slope.
template <class T>
PINBALL_OUTLINED YieldPiece<T> foam_strength(const HardeningConstants<ScalarOf<T>>& curve, const T& compaction) {
  const T x = maximum(compaction, T(curve.strain[0]));
  const YieldPiece<T> piece = piece_at(curve, CurvesAround<T>{T(0), T(0), T(0)}, x);
  return {x, maximum(T(0), piece.at(x)), piece.slope};
}

/// Pressure of the air, and its slope over the compaction [stress].
template <class T>
struct AirPressure {
  T value, slope;
};
template <class T>
PINBALL_FUNCTION AirPressure<T> air_pressure(const CrushableFoamConstants<ScalarOf<T>>& law, const T& compaction) {
  const T pressed = maximum(T(0), compaction), open(law.open_share);
  const T inverse = T(1) / maximum(open - pressed, number<T>(least_air));
  const T per_open = T(law.air_pressure) * inverse;
  return {per_open * pressed, per_open * open * inverse};
}

/// Bulk modulus, from above, at a compaction: any of its principal stresses may go along the curve, and the air with
/// it.
template <class T>
PINBALL_FUNCTION T foam_bulk_modulus(const CrushableFoamConstants<ScalarOf<T>>& law,
                                     const HardeningConstants<ScalarOf<T>>& curve, ScalarOf<T> elastic,
                                     const T& compaction) {
  const T volume = T(1) - compaction;
  T modulus = maximum(T(elastic), volume * foam_strength(curve, compaction).slope);
  if (law.air_pressure > 0) modulus += volume * air_pressure(law, compaction).slope;
  return modulus;
}

/// A bulk viscosity that damps any motion at least as much as the damping [stress time]: of principal values s_i of
/// S_ij (stable_time_step.hpp) the latter is zeta L/c (lambda sum s_i + 2 mu s_max). length: L.
template <class T>
PINBALL_FUNCTION T damping_viscosity(const CrushableFoamConstants<ScalarOf<T>>& law,
                                     const MaterialConstants<ScalarOf<T>>& material, const T& length) {
  using S = ScalarOf<T>;
  const S lambda = material.lambda > 0 ? material.lambda : S(0);
  return T(law.damping * (lambda + 2 * material.mu)) * length;
}

/// The increment of plastic strain that goes with what is taken of a trial stress.
template <class T>
PINBALL_FUNCTION T crushing_increment(const MaterialConstants<ScalarOf<T>>& material, const Symmetric<T>& taken) {
  using S = ScalarOf<T>;
  const Symmetric<T> deviator = deviator_of(taken);
  const T sum = trace(taken);
  const S shear = S(1) / (2 * material.mu), bulk = S(1) / (3 * material.lambda + 2 * material.mu);
  return square_root(T(S(2.0 / 3.0) * shear * shear) * contract(deviator, deviator) +
                     T(S(2.0 / 9.0) * bulk * bulk) * sum * sum);
}

}  // namespace pinball
