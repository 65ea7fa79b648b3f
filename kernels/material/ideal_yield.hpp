#pragma once

#include "von_mises.hpp"

namespace pinball {

/// Ideal plasticity at an effective stress that something else has said: the law of one step, as bending_yield.hpp and
/// return_generally() take it.
template <class T>
class IdealYield {
  using S = ScalarOf<T>;

 public:
  /// stress: effective [stress]
  PINBALL_FUNCTION IdealYield(const MaterialConstants<S>& material, const T& stress)
      : mu(material.mu), stress_(stress) {}
  PINBALL_FUNCTION void apply_rate() {}
  PINBALL_FUNCTION S modulus() const { return 3 * mu; }
  PINBALL_FUNCTION S kinematic_share() const { return 0; }
  /// [stress]
  PINBALL_FUNCTION T yield_stress(const T& /*plastic_strain*/) const { return stress_; }
  PINBALL_FUNCTION T increment(const T& q, const T& /*plastic_strain*/) const {
    return maximum(T(0), q - stress_) * T(1 / modulus());
  }

  const S mu;

 private:
  T stress_;
};

}  // namespace pinball
