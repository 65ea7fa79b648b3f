#pragma once

#include "power.hpp"
#include "strain_rate.hpp"

/// Strength, pressure and damage of brittle materials, ceramics, glass and rock, after Johnson and Holmquist
/// (High-Pressure Science and Technology 1993, 981-984, AIP 1994; "JH-2"). Pressures are over that of the Hugoniot
/// elastic limit, P = p/p_H and T = tensile strength/p_H, effective stresses over sigma_H = 3/2 (HEL - p_H) there:
///
///     Y = sigma_H ((1 - D) A (P + T)^N R + D min(B P^M R, F)) ,    R = 1 + C ln max(1, rate/rate_0) ,
///     dD = de/e_f ,   e_f = D_1 (P + T)^D_2 ,
///
/// with the plastic strain e and the damage D, from 0 to 1, at which it is all fragments. Powers of what is not
/// positive are zero, but for an exponent of zero. Where e_f is zero it breaks at once. The pressure is
///
///     p = K_1 mu + K_2 mu^2 + K_3 mu^3 + b ,   mu = rho/rho_0 - 1 ,
///     p = K_1 mu + b >= -(1 - D) T p_H                                   in tension ,
///
/// with b, by which fragments press. Damage sets free dU = (Y^2 - Y'^2)/(6 G) of the elastic energy of the deviator;
/// the share beta of it goes there, not in tension:
///
///     (K_1 mu + b')^2 = (K_1 mu + b)^2 + 2 beta K_1 dU .
///
/// Strength in a step is that of the damage before it.
namespace pinball {

template <class S>
struct JohnsonHolmquistConstants {
  bool used = false;
  S intact = S(0), intact_exponent = S(0);        ///< A, N [-]
  S fractured = S(0), fractured_exponent = S(0);  ///< B, M [-]
  S most_fractured = S(INFINITY);                 ///< F [-]
  S rate_sensitivity = S(0);                      ///< C [-]
  S inverse_rate = S(0);                          ///< 1/rate_0 [time]
  StrainRateMeasure measure = StrainRateMeasure::total;
  S tension = S(0);                           ///< tensile strength T p_H [stress]
  S inverse_pressure = S(0);                  ///< 1/p_H [1/stress]
  S stress = S(0);                            ///< sigma_H [stress]
  S failure = S(0), failure_exponent = S(0);  ///< D_1, D_2 [-]
  S modulus[3] = {};                          ///< K_1, K_2, K_3 [stress]
  S bulking = S(0);                           ///< beta [-]
  bool erodes = false;                        ///< an element fails at D = 1
};

/// coefficient x^exponent: zero where x is not positive, the coefficient everywhere for an exponent of zero.
template <class T>
PINBALL_FUNCTION T strength_of_pressure(ScalarOf<T> coefficient, ScalarOf<T> exponent, const T& x) {
  if (coefficient == 0 || exponent == 0) return T(coefficient);
  return T(coefficient) * power(maximum(x, T(0)), exponent);
}

/// Pressure without that of fragments, and its slope over mu.
template <class T>
struct BrittlePressure {
  T value, slope;  ///< [stress]
};
template <class T>
PINBALL_FUNCTION BrittlePressure<T> brittle_pressure(const JohnsonHolmquistConstants<ScalarOf<T>>& law, const T& mu) {
  using S = ScalarOf<T>;
  const auto& k = law.modulus;
  const T compressed = maximum(mu, T(0));
  return {T(k[0]) * mu + compressed * compressed * (T(k[1]) + T(k[2]) * compressed),
          T(k[0]) + compressed * (T(S(2) * k[1]) + T(S(3) * k[2]) * compressed)};
}

/// The law of one step, as bending_yield.hpp and return_generally() take it: the yield stress depends on nothing that
/// the step changes.
template <class T>
class JohnsonHolmquistYield {
  using S = ScalarOf<T>;

 public:
  /// pressure: at the end of the step [stress]; damage: at its beginning.
  PINBALL_FUNCTION JohnsonHolmquistYield(const MaterialConstants<S>& material, const JohnsonHolmquistConstants<S>& law,
                                         const Symmetric<T>& deformation, const T& pressure, const T& damage)
      : mu(material.mu), law_(&law), damage_(damage), rate_(strain_rate(law.measure, deformation)) {
    const T over(law.inverse_pressure), tensile(law.tension * law.inverse_pressure);
    above_tension_ = over * pressure + tensile;
    intact_ = strength_of_pressure(law.intact, law.intact_exponent, above_tension_);
    fractured_ = strength_of_pressure(law.fractured, law.fractured_exponent, T(over * pressure));
  }
  /// Takes the rate into account; until then the yield stress is least.
  PINBALL_FUNCTION void apply_rate() {
    if (law_->rate_sensitivity > 0) {
      factor_ = T(1) + T(law_->rate_sensitivity) * logarithm(maximum(T(1), rate_ * T(law_->inverse_rate)));
    }
  }
  PINBALL_FUNCTION S modulus() const { return 3 * mu; }
  PINBALL_FUNCTION S kinematic_share() const { return 0; }
  /// [stress]
  PINBALL_FUNCTION T yield_stress(const T& /*plastic_strain*/) const { return strength_at(damage_); }
  PINBALL_FUNCTION T strength_at(const T& damage) const {
    const T broken = minimum(factor_ * fractured_, T(law_->most_fractured));
    return T(law_->stress) * ((T(1) - damage) * factor_ * intact_ + damage * broken);
  }
  PINBALL_FUNCTION T increment(const T& q, const T& plastic_strain) const {
    return maximum(T(0), q - yield_stress(plastic_strain)) * T(1 / modulus());
  }
  /// The damage after a plastic strain.
  PINBALL_FUNCTION T damaged_by(const T& plastic_increment) const {
    const T strain = strength_of_pressure(law_->failure, law_->failure_exponent, above_tension_);
    const auto lasts = strain > T(0);
    const T more = select(lasts, plastic_increment / select(lasts, strain, T(1)), T(1));
    return minimum(T(1), damage_ + select(plastic_increment > T(0), more, T(0)));
  }

  const S mu;

 private:
  const JohnsonHolmquistConstants<S>* law_;
  T damage_, rate_, above_tension_{0}, intact_{0}, fractured_{0}, factor_{1};
};

/// b after a step in which the damage grows and the yield stress falls so. elastic: K_1 mu [stress].
template <class T>
PINBALL_FUNCTION T bulking_after(const JohnsonHolmquistConstants<ScalarOf<T>>& law, ScalarOf<T> shear_modulus,
                                 const T& elastic, const T& bulking, const T& yield_before, const T& yield_after) {
  using S = ScalarOf<T>;
  const T freed = (yield_before * yield_before - yield_after * yield_after) * T(S(1) / (6 * shear_modulus));
  const T pressed = elastic + bulking;
  const T after = square_root(pressed * pressed + T(2 * law.bulking * law.modulus[0]) * maximum(T(0), freed)) - elastic;
  return select(freed > T(0) && elastic > T(0), after, bulking);
}

}  // namespace pinball
