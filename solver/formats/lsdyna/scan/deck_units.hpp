#pragma once

namespace pinball {

/// *INCLUDE_TRANSFORM: what masses, times and lengths of an included file are multiplied by, so that they are in the
/// units of the deck. What has another dimension is multiplied by the same product of powers that its unit is.
struct DeckUnits {
  double mass = 1, time = 1, length = 1;  ///< fctmas, fcttim, fctlen

  bool are_own() const { return mass == 1 && time == 1 && length == 1; }
  double density() const { return mass / (length * length * length); }
  double stress() const { return mass / (length * time * time); }
  double rate() const { return 1 / time; }
  double velocity() const { return length / time; }
  double specific_heat() const { return velocity() * velocity(); }  ///< per degree, which all have alike
};

}  // namespace pinball
