#pragma once

#include "../simd.hpp"
#include "power.hpp"
#include "strain_rate.hpp"

/// Yield stress over plastic strain and strain rate: curves of straight pieces, one for each of some rates, or a power
/// of the strain, and the rate law of Cowper and Symonds (1957).
///
/// All curves have the same plastic strains e_0 = 0 < e_1 < ...: those of any of them, so that each has straight pieces
/// between. At a rate in between, the curve is interpolated between its neighbours, and has straight pieces at the same
/// plastic strains again: the return to it is exact. Beyond the last point its slope goes on. Below the lowest rate and
/// above the highest, the curve is that of the nearest.
///
/// A power: Y = K (e_0 + e)^n, with the strain e_0 = (Y_0/K)^(1/n) at which it is the yield stress Y_0 (Swift, J. Mech.
/// Phys. Solids 1, 1-18, 1952).
namespace pinball {

/// Entry number `index`, a whole number, of an array whose entries are `stride` apart.
PINBALL_FUNCTION double look_up(const double* array, double index, int stride) {
  return array[static_cast<int>(index) * stride];
}
PINBALL_FUNCTION float look_up(const float* array, float index, int stride) {
  return array[static_cast<int>(index) * stride];
}

#if !defined(PINBALL_DEVICE_COMPILER)

template <class T, class Abi>
PINBALL_FUNCTION stdx::simd<T, Abi> look_up(const T* array, const stdx::simd<T, Abi>& index, int stride) {
  return stdx::simd<T, Abi>([&](auto i) { return look_up(array, T(index[i]), stride); });
}

#endif

/// What MaterialConstants do not say of hardening. The arrays belong to the model.
template <class S>
struct HardeningConstants {
  S kinematic_modulus;  ///< of the back stress [stress]
  int points, curves;   ///< of each curve; curves: at least 1 of both
  const S* strain;      ///< e_k [-]
  const S* stress;      ///< curve after curve [stress]
  const S* slope;       ///< of the piece that begins at the point; of the last what goes on [stress]
  const S* rate;        ///< of each curve, ascending; its logarithm where interpolation is logarithmic [1/time]
  bool logarithmic;     ///< interpolation between curves in the logarithm of the rate
  StrainRateMeasure measure;
  S rate_constant;             ///< C; 0: no law of Cowper and Symonds [1/time]
  S rate_exponent;             ///< p [-]
  S rate_share;                ///< 1: the law scales the yield stress, 0: it adds to it [-]
  S rate_stress;               ///< what the law then adds times (rate/C)^(1/p) [stress]
  S power_coefficient = S(0);  ///< K, in the place of curves; 0: no power [stress]
  S power_exponent = S(1);     ///< n [-]
  S power_strain = S(0);       ///< e_0 [-]
};

/// A straight piece: stress + slope (e - strain).
template <class T>
struct YieldPiece {
  T strain, stress, slope;

  PINBALL_FUNCTION T at(const T& plastic_strain) const { return stress + slope * (plastic_strain - strain); }
};

/// The curves that each lane lies between: number `below` and the next, with this weight of the next.
template <class T>
struct CurvesAround {
  T below, weight;
  T inverse_distance;  ///< of the rates of both, or of their logarithms; 0 where the nearest curve is taken [time]
};

template <class T>
PINBALL_FUNCTION CurvesAround<T> curves_around(const HardeningConstants<ScalarOf<T>>& h, const T& rate) {
  CurvesAround<T> around{T(0), T(0), T(0)};
  if (h.curves == 1) return around;
  T place = rate;
  if (h.logarithmic) {
    const auto moves = rate > T(0);
    place = select(moves, logarithm(select(moves, rate, T(1))), T(h.rate[0]));
  }
  for (int c = 0; c + 1 < h.curves; ++c) {
    const ScalarOf<T> inverse = 1 / (h.rate[c + 1] - h.rate[c]);
    const auto between = place > T(h.rate[c]);  // or beyond: then a later one takes its place
    const auto beyond = place >= T(h.rate[c + 1]);
    around.below = select(between, T(static_cast<ScalarOf<T>>(c)), around.below);
    around.weight = select(between, minimum(T(1), (place - T(h.rate[c])) * T(inverse)), around.weight);
    around.inverse_distance = select(between, select(beyond, T(0), T(inverse)), around.inverse_distance);
  }
  return around;
}

/// Entry `point` of an array of all curves, between the curves around.
template <class T>
PINBALL_FUNCTION T between_curves(const HardeningConstants<ScalarOf<T>>& h, const ScalarOf<T>* array,
                                  const CurvesAround<T>& around, int point) {
  if (h.curves == 1) return T(array[point]);
  const T below = look_up(array + point, around.below, h.points);
  const T above = look_up(array + point + h.points, around.below, h.points);
  return below + around.weight * (above - below);
}

template <class T>
PINBALL_FUNCTION YieldPiece<T> piece_from(const HardeningConstants<ScalarOf<T>>& h, const CurvesAround<T>& around,
                                          int point) {
  return {T(h.strain[point]), between_curves(h, h.stress, around, point), between_curves(h, h.slope, around, point)};
}

/// Whether the yield stress is a formula, in the place of curves.
template <class S>
PINBALL_FUNCTION bool is_formula(const HardeningConstants<S>& h) {
  return h.power_coefficient > 0;
}

/// The tangent of the formula at a plastic strain.
template <class T>
PINBALL_OUTLINED YieldPiece<T> tangent_of_formula(const HardeningConstants<ScalarOf<T>>& h, const T& plastic_strain) {
  const T strain = T(h.power_strain) + plastic_strain;
  const T stress = T(h.power_coefficient) * power(strain, h.power_exponent);
  return {plastic_strain, stress, T(h.power_exponent) * stress / strain};
}

/// The piece at a plastic strain.
template <class T>
PINBALL_FUNCTION YieldPiece<T> piece_at(const HardeningConstants<ScalarOf<T>>& h, const CurvesAround<T>& around,
                                        const T& plastic_strain) {
  if (is_formula(h)) return tangent_of_formula(h, plastic_strain);
  YieldPiece<T> piece = piece_from(h, around, 0);
  for (int k = 1; k < h.points; ++k) {
    const auto behind = plastic_strain >= T(h.strain[k]);
    if (!any_lane(behind)) break;  // nor of any later point
    const YieldPiece<T> next = piece_from(h, around, k);
    piece = {select(behind, next.strain, piece.strain), select(behind, next.stress, piece.stress),
             select(behind, next.slope, piece.slope)};
  }
  return piece;
}

/// How the yield stress at a rate follows from the curve there: scale times it, plus `more`.
template <class T>
struct RateFactor {
  T scale, more;
};

/// Most tries of the equation for dl: of a power 4 or 5 are usual.
inline constexpr int largest_formula_iterations = 60;

/// Increment dl of plastic strain that brings an effective trial stress q to the formula,
///
///     modulus dl + scale Y(e + dl) + more = q ,
///
/// by Newton's method. The left side grows and bends one way all along: from dl = 0 the tries are below the solution
/// where Y bends down, or from the second on above it, and need no bounds. A lane that has its solution keeps it,
/// whatever its neighbours need. Zero where q is inside the surface.
template <class T>
PINBALL_OUTLINED T increment_to_formula(const HardeningConstants<ScalarOf<T>>& h, const RateFactor<T>& factor,
                                        ScalarOf<T> modulus, const T& q, const T& plastic_strain) {
  using S = ScalarOf<T>;
  // Once a try moves by less than the root of the last digit, the next would by less than that digit.
  constexpr S root_of_digit = sizeof(S) == 8 ? S(0x1p-26) : S(0x1p-12);
  T dl(0);
  MaskOf<T> open = q == q;
  for (int i = 0; i < largest_formula_iterations && any_lane(open); ++i) {
    const YieldPiece<T> piece = tangent_of_formula(h, T(plastic_strain + dl));
    const T over = q - factor.more - factor.scale * piece.stress - T(modulus) * dl;
    const T next = maximum(T(0), dl + over / (T(modulus) + factor.scale * piece.slope));
    const auto moved = absolute(next - dl) > T(root_of_digit) * next;
    dl = select(open, next, dl);
    open = open && moved;
  }
  return dl;
}

/// Increment dl of plastic strain that brings an effective trial stress q to the curve,
///
///     modulus dl = q - scale Y(e + dl) - more ,
///
/// exactly, also across any number of points: what is left of the trial stress at e_k, q - modulus (e_k - e), falls
/// with e_k faster than Y may (slopes are greater than -3 mu), so that the curve is met on the piece behind the last
/// point whose yield stress is below it. Zero where q is inside the surface.
template <class T>
PINBALL_FUNCTION T increment_to_curve(const HardeningConstants<ScalarOf<T>>& h, const CurvesAround<T>& around,
                                      const RateFactor<T>& factor, ScalarOf<T> modulus, const T& q,
                                      const T& plastic_strain) {
  if (is_formula(h)) return increment_to_formula(h, factor, modulus, q, plastic_strain);
  YieldPiece<T> piece = piece_from(h, around, 0);
  for (int k = 1; k < h.points; ++k) {
    const T left = q - factor.more - T(modulus) * (T(h.strain[k]) - plastic_strain);
    if (!any_lane(left > T(0))) break;  // yield stresses are positive, and it falls
    const YieldPiece<T> next = piece_from(h, around, k);
    const auto beyond = left > factor.scale * next.stress;
    piece = {select(beyond, next.strain, piece.strain), select(beyond, next.stress, piece.stress),
             select(beyond, next.slope, piece.slope)};
  }
  const T over = q - factor.more - factor.scale * piece.at(plastic_strain);
  return maximum(T(0), over / (T(modulus) + factor.scale * piece.slope));
}

}  // namespace pinball
