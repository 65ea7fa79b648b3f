#pragma once

#include <array>
#include <string>
#include <vector>

#include "deck_scene.hpp"

namespace pinball {

/// Constants of Johnson and Holmquist's law, as *MAT_110 and /MAT/LAW79 have them: nothing is over anything.
struct DeckBrittle {
  /// A strength and its exponent.
  struct Power {
    double factor = 0, exponent = 0;
  };

  Power intact;                          ///< A, N
  Power fractured;                       ///< B, M
  double most_fractured = 0;             ///< 0: no such limit
  double rate_coefficient = 0;           ///< C
  double reference_rate = 0;             ///< [1/time]
  double tensile_strength = 0;           ///< [stress]
  double limit = 0, limit_pressure = 0;  ///< HEL and the pressure there [stress]
  Power damage;                          ///< D1, D2
  double quadratic = 0, cubic = 0;       ///< K2, K3 [stress]
  double bulking = 0;                    ///< BETA
  bool erodes = false;                   ///< at damage 1

  InnerKeys<JohnsonHolmquistSettings> keys() const;

  struct WithoutEffect {
    std::string field, reason;
  };
  /// Of what is given; names: those of the rate, of M, of the limit of the strength of fragments and of D2.
  std::vector<WithoutEffect> without_effect(const std::array<std::string, 4>& names) const;
};

}  // namespace pinball
