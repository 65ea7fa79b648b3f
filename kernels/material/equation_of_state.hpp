#pragma once

#include "power.hpp"
#include "von_mises.hpp"

/// Equations of state: the pressure of a material that is compressed too far for a constant bulk modulus,
///
///     p = A(mu) + B(mu) e ,   mu = rho/rho_0 - 1 ,
///
/// with the internal energy e per volume of the undeformed material, zero at rest. What belongs to a form are A,
/// B and their slopes; all else follows:
///
///     rho c^2 = (1 + mu) (A' + B' e + B p/(1 + mu)^2)          at constant entropy: de = p dmu/(1 + mu)^2
///     e_new = e_old + w - 1/2 (p_old + p_new) dV/V_0           w: work of deviator and bulk viscosity, over V_0
///
/// and p_new, which is linear in e_new, from one division. (Wilkins, Methods in Computational Physics 3, 1964.)
///
/// Mie and Grueneisen, about a shock whose speed is u_s = c + s_1 u_p + s_2 (u_p/u_s) u_p + s_3 (u_p/u_s)^2 u_p, with
/// Gamma rho = Gamma_0 rho_0 + a (rho - rho_0) (Steinberg, UCRL-MA-106439, 1996):
///
///     A = rho_0 c^2 mu (1 + (1 - Gamma_0/2) mu - a/2 mu^2) / D^2   where mu > 0 ,    else  rho_0 c^2 mu ,
///     D = 1 - (s_1 - 1) mu - s_2 mu^2/(1 + mu) - s_3 mu^3/(1 + mu)^2 ,
///     B = Gamma_0 + a mu .
///
/// D vanishes at a compression that no shock reaches; before that it stays at 0.01.
///
/// Polynomial: A = c_0 + c_1 mu + c_2 mu^2 + c_3 mu^3, B = c_4 + c_5 mu + c_6 mu^2; where mu < 0 without c_2 and c_6.
///
/// Tabulated: A and B over a volumetric strain x, ln(1 + mu) or mu, in straight pieces of which the first and the last
/// go on.
///
/// What crushes, foams and soils, goes back along other ways than it came (LS-DYNA's EOS_008 and MAT_005, Radioss'
/// LAW21 and LAW10). With the x of a table, or x = mu of a polynomial, and m, the largest x so far, from 0 to x_full,
///
///     A is that of the curve where x >= m ,   else  min(A(x), A(m) - K(m) (m - x)) ,
///
/// with the bulk modulus K of unloading, a number or straight between the points of a table, which is also that of
/// tension; as long as m is no larger than x_elastic, A is that of the curve. In rho c^2 the larger of A' and K dx/dmu
/// takes the place of A': the next step may unload.
///
/// What tears bears no tension after it has come to its limit once.
///
/// At rest p = 0.
namespace pinball {

enum class PressureLaw { linear, mie_grueneisen, polynomial, tabulated };

inline constexpr int most_table_pieces = 15;

template <class S>
struct EquationOfState {
  PressureLaw law = PressureLaw::linear;  ///< linear: that of MaterialConstants, without any of this
  S modulus = S(0);                       ///< rho_0 c^2 of Mie and Grueneisen [stress]
  S slope[3] = {};                        ///< s_1, s_2, s_3 [-]
  S gamma = S(0), gamma_slope = S(0);     ///< Gamma_0, a [-]
  S polynomial[7] = {};                   ///< c_0 ... c_3 [stress], c_4 ... c_6 [-]
  int pieces = 0;                         ///< of the table
  bool logarithmic = true;                ///< x of the table is ln(1 + mu), else mu
  S strain[most_table_pieces] = {};       ///< x at which each begins, rising [-]
  S cold[most_table_pieces] = {}, cold_rise[most_table_pieces] = {};        ///< A there, dA/dx [stress]
  S thermal[most_table_pieces] = {}, thermal_rise[most_table_pieces] = {};  ///< B there, dB/dx [-]
  bool crushes = false;
  S unloading[most_table_pieces] = {}, unloading_rise[most_table_pieces] = {};  ///< K there, dK/dx [stress]
  S last = S(INFINITY);      ///< x behind which K does not change [-]
  S full = S(INFINITY);      ///< x_full [-]
  S elastic = S(-INFINITY);  ///< x_elastic [-]
  S tension_limit = S(0);    ///< the pressure is never below minus this; infinity: no such limit [stress]
  bool tears = false;        ///< the limit is 0 for what has come to it
};

/// A and B of a pressure that is linear in the energy, and their slopes over mu.
template <class T>
struct PressureParts {
  T cold, cold_slope;        ///< A, A' [stress]
  T thermal, thermal_slope;  ///< B, B' [-]
};

template <class T>
PINBALL_FUNCTION PressureParts<T> mie_grueneisen(const EquationOfState<ScalarOf<T>>& eos, const T& mu) {
  using S = ScalarOf<T>;
  const T modulus(eos.modulus), a(eos.gamma_slope), linear(S(1) - S(0.5) * eos.gamma);
  const T numerator = modulus * mu * (T(1) + mu * (linear - T(S(0.5)) * a * mu));
  const T numerator_slope = modulus * (T(1) + mu * (T(2) * linear - T(S(1.5)) * a * mu));
  const T x = mu / (T(1) + mu);  // u_p/u_s
  const T s1(eos.slope[0]), s2(eos.slope[1]), s3(eos.slope[2]);
  const T shrinking = T(1) - (s1 - T(1)) * mu - x * mu * (s2 + s3 * x), least = number<T>(1e-2);
  const auto shrinks = shrinking > least;
  const T denominator = select(shrinks, shrinking, least);
  // d(mu^2/(1+mu)) = x (2 - x) dmu and d(mu^3/(1+mu)^2) = x^2 (3 - 2 x) dmu
  const T denominator_slope = select(shrinks, T(1) - s1 - x * (s2 * (T(2) - x) + s3 * x * (T(3) - T(2) * x)), T(0));
  const T inverse = T(1) / denominator, inverse2 = inverse * inverse;
  const T shocked = numerator * inverse2;
  const T shocked_slope = (numerator_slope - T(2) * numerator * inverse * denominator_slope) * inverse2;
  const auto compressed = mu > T(0);
  return {select(compressed, shocked, modulus * mu), select(compressed, shocked_slope, modulus), T(eos.gamma) + a * mu,
          a};
}

template <class T>
PINBALL_FUNCTION PressureParts<T> polynomial_pressure(const EquationOfState<ScalarOf<T>>& eos, const T& mu) {
  using S = ScalarOf<T>;
  const auto& c = eos.polynomial;
  const auto compressed = mu > T(0);
  const T c2 = select(compressed, T(c[2]), T(0)), c6 = select(compressed, T(c[6]), T(0));
  return {T(c[0]) + mu * (T(c[1]) + mu * (c2 + mu * T(c[3]))), T(c[1]) + mu * (T(2) * c2 + mu * T(S(3) * c[3])),
          T(c[4]) + mu * (T(c[5]) + mu * c6), T(c[5]) + T(2) * mu * c6};
}

/// x of a table, and dx/dmu.
template <class T>
struct TableStrain {
  T value, slope;  ///< [-]
};
template <class T>
PINBALL_FUNCTION TableStrain<T> table_strain(const EquationOfState<ScalarOf<T>>& eos, const T& mu) {
  if (!eos.logarithmic) return {mu, T(1)};
  const T density = T(1) + mu;
  return {logarithm(density), T(1) / density};
}

/// Parts at a strain, and their slopes over it.
template <class T>
PINBALL_FUNCTION PressureParts<T> table_at(const EquationOfState<ScalarOf<T>>& eos, const T& strain) {
  T begin(eos.strain[0]), cold(eos.cold[0]), rise(eos.cold_rise[0]), thermal(eos.thermal[0]),
      thermal_rise(eos.thermal_rise[0]);
  for (int k = 1; k < eos.pieces; ++k) {
    const auto reached = strain >= T(eos.strain[k]);
    begin = select(reached, T(eos.strain[k]), begin);
    cold = select(reached, T(eos.cold[k]), cold);
    rise = select(reached, T(eos.cold_rise[k]), rise);
    thermal = select(reached, T(eos.thermal[k]), thermal);
    thermal_rise = select(reached, T(eos.thermal_rise[k]), thermal_rise);
  }
  const T beyond = strain - begin;
  return {cold + rise * beyond, rise, thermal + thermal_rise * beyond, thermal_rise};
}

template <class T>
PINBALL_FUNCTION PressureParts<T> tabulated_pressure(const EquationOfState<ScalarOf<T>>& eos, const T& mu) {
  const TableStrain<T> x = table_strain(eos, mu);
  const PressureParts<T> at = table_at(eos, x.value);
  return {at.cold, at.cold_slope * x.slope, at.thermal, at.thermal_slope * x.slope};
}

template <class T>
PINBALL_FUNCTION PressureParts<T> pressure_parts(const EquationOfState<ScalarOf<T>>& eos, const T& mu) {
  if (eos.law == PressureLaw::tabulated) return tabulated_pressure(eos, mu);
  return eos.law == PressureLaw::polynomial ? polynomial_pressure(eos, mu) : mie_grueneisen(eos, mu);
}

/// K(m) [stress]
template <class T>
PINBALL_FUNCTION T unloading_modulus(const EquationOfState<ScalarOf<T>>& eos, const T& most) {
  const T strain = minimum(most, T(eos.last));
  T begin(eos.strain[0]), modulus(eos.unloading[0]), rise(eos.unloading_rise[0]);
  for (int k = 1; k < eos.pieces; ++k) {
    const auto reached = strain >= T(eos.strain[k]);
    begin = select(reached, T(eos.strain[k]), begin);
    modulus = select(reached, T(eos.unloading[k]), modulus);
    rise = select(reached, T(eos.unloading_rise[k]), rise);
  }
  return modulus + rise * (strain - begin);
}

/// m after a step to x.
template <class T>
PINBALL_FUNCTION T most_after(const EquationOfState<ScalarOf<T>>& eos, const T& strain, const T& most) {
  return minimum(maximum(most, strain), T(eos.full));
}

/// The parts of what has been compressed as far as `most`, m, before.
template <class T>
PINBALL_FUNCTION PressureParts<T> parts_of_crushed(const EquationOfState<ScalarOf<T>>& eos, const T& mu,
                                                   const T& most) {
  PressureParts<T> at = pressure_parts(eos, mu);
  if (!eos.crushes) return at;
  const TableStrain<T> x = table_strain(eos, mu);
  const T reached = most_after(eos, x.value, most), modulus = unloading_modulus(eos, reached);
  const T top =
      eos.law == PressureLaw::polynomial ? polynomial_pressure(eos, reached).cold : table_at(eos, reached).cold;
  const T line = top - modulus * (reached - x.value);
  at.cold = select(x.value < most && most > T(eos.elastic), minimum(line, at.cold), at.cold);
  at.cold_slope = maximum(at.cold_slope, modulus * x.slope);
  return at;
}

/// Where tension ends. torn: 1 of what has come to the limit before, and tears.
template <class T>
PINBALL_FUNCTION T least_pressure(const EquationOfState<ScalarOf<T>>& eos, const T& torn) {
  return eos.tears ? select(torn > T(0), T(0), T(-eos.tension_limit)) : T(-eos.tension_limit);
}

/// The pressure at a compression with the energy that a step begins with: of strength that depends on it, before the
/// work of the step is known [stress].
template <class T>
PINBALL_FUNCTION T pressure_of_energy(const EquationOfState<ScalarOf<T>>& eos, const T& mu, const T& most,
                                      const T& torn, const T& energy) {
  const PressureParts<T> at = parts_of_crushed(eos, mu, most);
  return maximum(at.cold + at.thermal * energy, least_pressure(eos, torn));
}

/// What a step does to the pressure.
template <class T>
struct PressureStep {
  T compression;   ///< mu at its end [-]
  T volumetric;    ///< dV/V_0 [-]
  T work;          ///< w: of deviator and bulk viscosity, per volume of the undeformed material [stress]
  T pressure_old;  ///< [stress]
  T most{0};       ///< m at its beginning, of what crushes [-]
  T torn{0};       ///< 1: of least_pressure [-]
};

template <class T>
struct PressureState {
  T value, energy, bulk_modulus;  ///< p, e, rho c^2 [stress]
  T torn;                         ///< as of the step, at its end [-]
};

/// energy_old: e at its beginning [stress].
template <class T>
PINBALL_FUNCTION PressureState<T> pressure_after(const EquationOfState<ScalarOf<T>>& eos, const PressureStep<T>& step,
                                                 const T& energy_old) {
  using S = ScalarOf<T>;
  const PressureParts<T> at = parts_of_crushed(eos, step.compression, step.most);
  const T half = T(S(0.5)) * step.volumetric;
  const T before = energy_old + step.work - half * step.pressure_old;  // all but the work of p_new
  const T energy = (before - half * at.cold) / (T(1) + half * at.thermal);
  const T unlimited = at.cold + at.thermal * energy, least = least_pressure(eos, step.torn);
  const T pressure = maximum(unlimited, least);
  const T density = T(1) + step.compression;  // over that at rest
  const T stiffness = density * (at.cold_slope + at.thermal_slope * energy) + at.thermal * pressure / density;
  return {pressure, before - half * pressure, stiffness, select(unlimited <= least, T(1), step.torn)};
}

}  // namespace pinball
