#pragma once

#include "power.hpp"
#include "strain_rate.hpp"

/// Strength and failure of metals after Johnson and Cook (Proc. 7th Int. Symp. Ballistics, 541-547, 1983; Engrg. Fract.
/// Mech. 21, 31-48, 1985):
///
///     Y = (A + B e^n) (1 + C ln r) (1 - h^m) ,   r = max(1, rate/rate_0) ,   h = (T - T_room)/(T_melt - T_room) ,
///
/// with the plastic strain e and the rate of the strain, or of the plastic strain, and
///
///     dD = de/e_f ,   e_f = (D_1 + D_2 exp(D_3 p*)) (1 + D_4 ln r) (1 + D_5 h) ,   p* = mean stress/effective stress ;
///
/// an element fails at D = 1. It is heated by the plastic work, and none of the heat goes to its neighbours:
/// rho c_p dT = chi s : de_p. Its strength in a step is that of the temperature at the beginning of it.
///
/// Damage may weaken it before that (Boervik, Hopperstad, Berstad and Langseth, Eur. J. Mech. A/Solids 20, 685-712,
/// 2001, there with D from 0 to D_c and beta D_c = w; elasticity is not weakened here):
///
///     Y = (1 - w D) (A + B e_h^n) (1 + C ln r) (1 - h^m) ,   de_h = (1 - w D) de ,
///
/// with D as at the beginning of a step.
namespace pinball {

template <class S>
struct JohnsonCookConstants {
  bool used = false;
  S hardening = S(0), exponent = S(1);  ///< B [stress], n [-]; A is the yield stress of MaterialConstants
  S rate_sensitivity = S(0);            ///< C [-]
  S inverse_rate = S(0);                ///< 1/rate_0 [time]
  S inverse_melting = S(0);             ///< 1/(T_melt - T_room); 0: no softening [1/temperature]
  S softening_exponent = S(1);          ///< m [-]
  S heating = S(0);                     ///< chi/c_p: of temperature per work [temperature mass/energy]
  StrainRateMeasure measure = StrainRateMeasure::total;
  S failure[5] = {};   ///< D_1 ... D_5 [-]
  S weakening = S(0);  ///< w [-]
};

/// ln r.
template <class T>
PINBALL_FUNCTION T logarithm_of_rate(const JohnsonCookConstants<ScalarOf<T>>& law, const T& rate) {
  return logarithm(maximum(T(1), rate * T(law.inverse_rate)));
}

/// h: 0 cold, 1 melted.
template <class T>
PINBALL_FUNCTION T homologous(const JohnsonCookConstants<ScalarOf<T>>& law, const T& temperature) {
  return minimum(T(1), maximum(T(0), temperature * T(law.inverse_melting)));
}

/// 1 - w D: what damage leaves of the strength.
template <class T>
PINBALL_FUNCTION T left_by(const JohnsonCookConstants<ScalarOf<T>>& law, const T& damage) {
  return T(1) - T(law.weakening) * minimum(T(1), damage);
}

/// Most tries of the equation for the increment of plastic strain; 2 are usual.
inline constexpr int largest_johnson_cook_iterations = 60;

/// The law of one step, as bending_yield.hpp and return_generally() take it.
template <class T>
class JohnsonCookYield {
  using S = ScalarOf<T>;

 public:
  /// deformation: rate of it in the step [1/time]; dt: its length; plastic_strain, with which it hardens, and
  /// temperature above that of the room: at its beginning.
  PINBALL_FUNCTION JohnsonCookYield(const MaterialConstants<S>& material, const JohnsonCookConstants<S>& law,
                                    const Symmetric<T>& deformation, S dt, const T& plastic_strain,
                                    const T& temperature)
      : mu(material.mu),
        initial_(material.yield_stress),
        law_(&law),
        inverse_dt_(1 / dt),
        strain_(plastic_strain),
        hardened_(T(law.hardening) * power(plastic_strain, law.exponent)),
        softening_(1),
        factor_(1),
        rate_(strain_rate(law.measure, deformation)) {
    const auto strained = strain_ > T(0);
    inverse_strain_ = select(strained, T(1) / select(strained, strain_, T(1)), T(0));
    if (law.inverse_melting > 0) {
      const T h = homologous(law, temperature);
      softening_ = T(1) - (law.softening_exponent == S(1) ? h : power(h, law.softening_exponent));
    }
  }
  /// Takes the rate into account; until then the yield stress is least.
  PINBALL_FUNCTION void apply_rate() {
    if (law_->rate_sensitivity > 0 && law_->measure != StrainRateMeasure::plastic) factor_ = factor_at(rate_);
  }

  /// Takes damage into account.
  PINBALL_FUNCTION void weaken(const T& damage) { softening_ = softening_ * left_by(*law_, damage); }

  /// Of a step in which the plastic strain grows so [1/time].
  PINBALL_FUNCTION T rate(const T& increment) const {
    return law_->measure == StrainRateMeasure::plastic ? increment * T(inverse_dt_) : rate_;
  }
  PINBALL_FUNCTION S modulus() const { return 3 * mu; }
  PINBALL_FUNCTION S kinematic_share() const { return 0; }
  /// Least effective stress that yields, at the plastic strain of the beginning [stress].
  PINBALL_FUNCTION T yield_stress(const T& /*plastic_strain*/) const {
    return softening_ * factor_ * (T(initial_) + hardened_);
  }

  /// Solves  Y(e + dl, dl/dt) + 3 mu dl = q , whose left side grows with dl: Newton's method, from the tangent at the
  /// beginning, between bounds that each try narrows. Once a try moves by less than the root of the last digit, the
  /// next would by less than that digit. A lane that has its solution keeps it, whatever its neighbours need.
  PINBALL_OUTLINED T increment(const T& q, const T& /*plastic_strain*/) const {
    const T m(modulus()), exponent(law_->exponent);
    const bool of_plastic_rate = law_->measure == StrainRateMeasure::plastic && law_->rate_sensitivity > 0;
    const T over = q - yield_stress(strain_);
    auto open = over > T(0);
    T low(0), high = select(open, over * T(1 / modulus()), T(0)), dl = high;
    if (of_plastic_rate) {
      const T factor = factor_at(high * T(inverse_dt_));
      dl = first_try(q - softening_ * factor * (T(initial_) + hardened_), factor);
    } else {
      dl = first_try(over, factor_);
    }
    dl = minimum(high, maximum(T(0), dl));
    constexpr S root_of_digit = sizeof(S) == 8 ? S(0x1p-26) : S(0x1p-12);
    for (int i = 0; i < largest_johnson_cook_iterations && any_lane(open); ++i) {
      const T hardened = hardened_after(dl, open), strain = strain_ + dl;
      T factor = factor_, factor_slope(0);
      if (of_plastic_rate) {
        const T rate = dl * T(inverse_dt_);
        factor = factor_at(rate);
        const auto beyond = rate * T(law_->inverse_rate) > T(1);
        factor_slope = select(beyond, T(law_->rate_sensitivity) / select(beyond, dl, T(1)), T(0));
      }
      const T stress = T(initial_) + hardened;
      const T value = softening_ * factor * stress + m * dl - q;
      const T slope =
          softening_ * (factor * exponent * hardened / select(strain > T(0), strain, T(1)) + factor_slope * stress) + m;
      const auto above = value > T(0);
      high = select(open && above, dl, high);
      low = select(open && !above, dl, low);
      T next = dl - value / slope;
      next = select(next >= low && next <= high, next, number<T>(0.5) * (low + high));
      const auto moved = absolute(next - dl) > T(root_of_digit) * next;
      dl = select(open, next, dl);
      open = open && moved;
    }
    return dl;
  }

  const S mu;

 private:
  PINBALL_FUNCTION T factor_at(const T& rate) const {
    return T(1) + T(law_->rate_sensitivity) * logarithm_of_rate(*law_, rate);
  }
  PINBALL_FUNCTION T first_try(const T& over, const T& factor) const {
    return over / (T(modulus()) + softening_ * factor * T(law_->exponent) * hardened_ * inverse_strain_);
  }
  /// B (e + dl)^n: where dl is less than e/64 by the binomial series of (1 + dl/e)^n, to the last digit.
  PINBALL_FUNCTION T hardened_after(const T& dl, const MaskOf<T>& open) const {
    const T x = dl * inverse_strain_;
    const auto near = strain_ > T(0) && x < number<T>(1.0 / 64);
    constexpr int terms = sizeof(S) == 8 ? 8 : 4;
    T series(1);
    PINBALL_UNROLL
    for (int k = terms; k > 0; --k) series = T(1) + T((law_->exponent - S(k - 1)) / S(k)) * x * series;
    const T by_series = hardened_ * series;
    if (!any_lane(open && !near)) return by_series;
    return select(near, by_series, T(law_->hardening) * power(strain_ + dl, law_->exponent));
  }

  const S initial_;
  const JohnsonCookConstants<S>* law_;
  S inverse_dt_;
  T strain_, inverse_strain_, hardened_, softening_, factor_, rate_;
};

/// What a step adds to the damage. increment: of the plastic strain; rate: of the strain [1/time]; temperature: above
/// that of the room.
template <class T>
PINBALL_FUNCTION T damage_increment(const JohnsonCookConstants<ScalarOf<T>>& law, const Symmetric<T>& stress,
                                    const T& increment, const T& rate, const T& temperature) {
  const auto& d = law.failure;
  const Symmetric<T> deviator = deviator_of(stress);
  const T effective = square_root(effective_square(deviator)), mean = number<T>(1.0 / 3.0) * trace(stress);
  const auto strained = effective > T(0) && increment > T(0);
  // Beyond a triaxiality of 1.5 no test was made, and the fit is not followed.
  const T triaxiality = minimum(T(ScalarOf<T>(1.5)), mean / select(strained, effective, T(1)));
  const T strain = (T(d[0]) + T(d[1]) * exponential(T(d[2]) * triaxiality)) *
                   (T(1) + T(d[3]) * logarithm_of_rate(law, rate)) * (T(1) + T(d[4]) * homologous(law, temperature));
  return select(strained, increment / maximum(strain, number<T>(1e-6)), T(0));
}

}  // namespace pinball
