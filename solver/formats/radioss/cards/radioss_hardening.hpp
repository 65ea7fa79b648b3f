#pragma once

#include <solver/formats/deck/deck_scene.hpp>

namespace pinball {

/// Yield stress over plastic strain, A + B e^n up to a largest stress.
struct RadiossHardening {
  double yield = 0, factor = 0, exponent = 1;
  double limit = 0;  ///< largest stress; 0: none [stress]

  /// A power of 0 is 1.
  RadiossHardening(double a, double b, double n, double largest)
      : yield(a), factor(b), exponent(n == 0 ? 1 : n), limit(largest) {}

  /// Iflag 1: B is the ultimate engineering stress and n its strain, from which both follow as Considere says: there
  /// true stress and its slope over true strain are the same. Throws InputError where no B > 0 is so.
  void take_ultimate(double young, const DeckPlace& place);
  bool is_line() const { return factor == 0 || exponent == 1; }
  /// Points of the curve, dense enough that straight pieces differ from it by 1e-4 of B at most.
  GivenValue curve() const;
};

}  // namespace pinball
