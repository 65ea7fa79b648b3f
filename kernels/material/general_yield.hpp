#pragma once

#include "../kept_hourglass.hpp"
#include "yield_curve.hpp"

/// Von Mises plasticity beyond linear isotropic hardening: kinematic and mixed hardening, yield curves and strain
/// rates.
///
/// The yield surface is a sphere about the back stress a, a deviator that turns as the stress does (rotation.hpp):
///
///     q(s - a) = Y(e, rate) ,   da = 2/3 H_k de_p ,   de = sqrt(2/3 de_p:de_p) ,
///
/// after Prager and Ziegler, with Hodge's share beta of the plastic modulus H: Y hardens by beta H, a by
/// H_k = (1 - beta) H. The radial return of Krieg and Key (1976) keeps the direction of x = s_trial - a,
///
///     dl = (q(x) - Y)/(3 mu + H_k + Y') ,   s = s_trial - 3 mu dl x/q ,   a <- a + H_k dl x/q .
///
/// Rate laws: Y = Y_s (1 + r) or Y_s + Y_r r, r = (rate/C)^(1/p), with the static stress Y_s(e) of a curve; or curves
/// of several rates. The rate of the whole strain is that of the step, and known; that of the plastic strain is dl/dt,
/// an equation for dl.
///
/// Hourglass stresses have no back stress of their own: the sphere's points beside the centre (bending_yield.hpp) are
/// about that of the centre, and what they are returned by is taken from them as a whole.
namespace pinball {

/// Most tries of the equation for dl: seldom more than 8 are needed, and a bisection in each is the worst case.
inline constexpr int largest_rate_iterations = 60;

template <class T>
class GeneralYield {
  using S = ScalarOf<T>;

 public:
  /// deformation: rate of it in the step [1/time]; dt: length of the step [time].
  PINBALL_OUTLINED GeneralYield(const MaterialConstants<S>& material, const HardeningConstants<S>& hardening,
                                const Symmetric<T>& deformation, S dt)
      : mu(material.mu),
        h_(&hardening),
        dt_(dt),
        rate_(strain_rate(hardening.measure, deformation)),
        around_(curves_around(hardening, rate_)),
        factor_{T(1), T(0)} {}
  /// Takes the law of Cowper and Symonds into account; until then all is as at the rate 0, where the yield stress is
  /// least. A power takes longer than all else here.
  PINBALL_OUTLINED void apply_rate() {
    if (!(h_->rate_constant > 0) || of_plastic_strain()) return;
    factor_ = rate_factor(power(rate_ * T(1 / h_->rate_constant), 1 / h_->rate_exponent));
  }

  /// 3 mu + H_k: what an increment of plastic strain takes of q [stress].
  PINBALL_FUNCTION S modulus() const { return 3 * mu + h_->kinematic_modulus; }
  /// Part of what is taken that goes to the back stress [-].
  PINBALL_FUNCTION S kinematic_share() const { return h_->kinematic_modulus / modulus(); }

  /// Least effective stress that yields [stress].
  PINBALL_OUTLINED T yield_stress(const T& plastic_strain) const {
    return factor_.scale * piece_at(*h_, around_, plastic_strain).at(plastic_strain) + factor_.more;
  }

  PINBALL_OUTLINED T increment(const T& q, const T& plastic_strain) const {
    if (of_plastic_strain()) return viscoplastic_increment(q, plastic_strain);
    return increment_to_curve(*h_, around_, factor_, modulus(), q, plastic_strain);
  }

  const S mu;

 private:
  struct Residual {
    T value, slope;
  };

  PINBALL_FUNCTION bool of_plastic_strain() const { return h_->measure == StrainRateMeasure::plastic; }
  PINBALL_FUNCTION RateFactor<T> rate_factor(const T& r) const {
    return {T(1) + T(h_->rate_share) * r, T(h_->rate_stress) * r};
  }

  /// Solves  Y(e + dl, dl/dt) + (3 mu + H_k) dl = q  for r = (dl/(C dt))^(1/p), in which the equation is smooth, also
  /// where the rate vanishes; of several curves C = p = 1, and r is the rate. Newton's method, from above, between
  /// bounds that every try narrows: over several curves, straight between their rates, it can lead from one bound to
  /// the other and back. A lane that has its solution keeps it, whatever its neighbours need.
  PINBALL_FUNCTION T viscoplastic_increment(const T& q, const T& plastic_strain) const {
    const bool law = h_->rate_constant > 0;
    const S p = law ? h_->rate_exponent : S(1), inverse_p = 1 / p, m = modulus();
    const S unit = law ? h_->rate_constant * dt_ : dt_, inverse_unit = 1 / (m * unit);
    const T stress = piece_at(*h_, around_, plastic_strain).at(plastic_strain);  // without any rate
    const T over = q - stress;
    auto open = over > T(0);
    T low(0), high = select(open, power(select(open, q * T(inverse_unit), T(0)), inverse_p), T(0));
    T r = high;
    if (law) {  // what is over goes to the rate or to the strain: to each of them, no more than all
      const T of_rate = T(h_->rate_share) * stress + T(h_->rate_stress);
      r = minimum(
          r, select(open, minimum(over / of_rate, power(select(open, over * T(inverse_unit), T(0)), inverse_p)), T(0)));
    }
    constexpr S last_digits = sizeof(S) == 8 ? S(0x1p-50) : S(0x1p-21);
    for (int i = 0; i < largest_rate_iterations && any_lane(open); ++i) {
      const T dl = T(unit) * power(r, p);
      const Residual f = law ? residual_of_law(q, plastic_strain, r, dl) : residual_of_curves(q, plastic_strain, r, dl);
      const auto above = f.value > T(0);
      high = select(open && above, r, high);
      low = select(open && !above, r, low);
      T next = r - f.value / f.slope;
      const auto rounded = absolute(f.value) <= T(4 * last_digits) * q;
      next = select(next > low && next < high, next, select(rounded, r, number<T>(0.5) * (low + high)));
      const auto moved = absolute(next - r) > T(last_digits) * r;
      r = select(open, next, r);
      open = open && moved;
    }
    return T(unit) * power(r, p);
  }

  /// Left side less right side, and its slope over r.
  PINBALL_FUNCTION Residual residual_of_law(const T& q, const T& plastic_strain, const T& r, const T& dl) const {
    const T strain = plastic_strain + dl;
    const YieldPiece<T> piece = piece_at(*h_, around_, strain);
    const RateFactor<T> factor = rate_factor(r);
    const T stress = piece.at(strain), growth = T(h_->rate_exponent) * dl / select(r > T(0), r, T(1));  // d(dl)/dr
    return {factor.scale * stress + factor.more + T(modulus()) * dl - q,
            (factor.scale * piece.slope + T(modulus())) * growth + T(h_->rate_share) * stress + T(h_->rate_stress)};
  }
  PINBALL_FUNCTION Residual residual_of_curves(const T& q, const T& plastic_strain, const T& rate, const T& dl) const {
    const T strain = plastic_strain + dl;
    const CurvesAround<T> around = curves_around(*h_, rate);
    const YieldPiece<T> piece = piece_at(*h_, around, strain);
    const T below = piece_at(*h_, CurvesAround<T>{around.below, T(0), T(0)}, strain).at(strain);
    const T above = piece_at(*h_, CurvesAround<T>{around.below, T(1), T(0)}, strain).at(strain);
    T over_rate = around.inverse_distance * (above - below);
    if (h_->logarithmic) over_rate = over_rate / select(rate > T(0), rate, T(1));
    return {piece.at(strain) + T(modulus()) * dl - q, (piece.slope + T(modulus())) * T(dt_) + over_rate};
  }

  const HardeningConstants<S>* h_;
  S dt_;
  T rate_;
  CurvesAround<T> around_;
  RateFactor<T> factor_;
};

/// Returns the trial stress along the radius from the back stress; relative: deviator of the stress less back stress.
/// law: GeneralYield, or another with increment() and modulus().
template <class T, class Law>
PINBALL_FUNCTION void radial_return(const Law& law, const Symmetric<T>& relative, const T& q, Symmetric<T>& stress,
                                    T& plastic_strain) {
  const T dl = law.increment(q, plastic_strain);
  const auto yields = dl > T(0);
  reduce(stress, select(yields, T(law.modulus()) * dl / select(yields, q, T(1)), T(0)), relative);
  plastic_strain += dl;
}

/// law: GeneralYield, or another with its functions. Returns the stress, and hourglass stresses that are kept, to the
/// yield surface, and moves that. Whether any lane may have yielded.
template <HourglassKind kind, class T, class Law>
PINBALL_FUNCTION bool return_generally(Law& law, KeptHourglass<T, kind>& kept, Symmetric<T>& stress, Symmetric<T>& back,
                                       T& plastic_strain, LostHourglassEnergy<T>& lost) {
  const Symmetric<T> trial = stress, relative = deviator_of(stress) - back;
  const T square = effective_square(relative), yield = law.yield_stress(plastic_strain);
  [[maybe_unused]] T variation(0);
  T largest = square;
  if constexpr (keeps_hourglass_state(kind)) {
    variation = kept.variation();
    largest = largest_effective_square(square, variation);
  }
  if (!any_lane(largest > yield * yield)) return false;
  law.apply_rate();
  if constexpr (keeps_hourglass_state(kind)) {
    lost = kept.yield(law, relative, square, variation, stress, plastic_strain);
  } else {
    radial_return(law, relative, square_root(square), stress, plastic_strain);
  }
  // Of what the return has taken, a part moves the surface instead: back to the stress, and to the back stress.
  const Symmetric<T> moved = T(law.kinematic_share()) * (trial - stress);
  stress = stress + moved;
  back = back + moved;
  return true;
}

}  // namespace pinball
