#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "deck_scene.hpp"

namespace pinball {

/// What a deck gives elements at the start.
struct DeckStress {
  Point stress{}, shear_stress{};  ///< xx, yy, zz and xy, yz, zx [stress]
  double plastic_strain = 0;
  DeckCard card{};
};

/// The same by the numbers of the elements; of several of one the last counts.
class DeckStresses {
 public:
  DeckStress& of(std::int64_t element) { return all_[element]; }

  /// Elements with the same make one [[initial_stress]].
  void write(DeckScene& scene) const;

 private:
  std::map<std::int64_t, DeckStress> all_;
};

}  // namespace pinball
