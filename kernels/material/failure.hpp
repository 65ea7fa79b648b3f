#pragma once

#include <cmath>

/// When an element fails: what of a material and of its settings says that it is eroded (element/failure.hpp). Laws of
/// strength may have reasons of their own (johnson_cook.hpp).
namespace pinball {

template <class S>
struct FailureConstants {
  S plastic_strain = S(INFINITY);  ///< beyond which an element fails; infinity: none does [-]
  bool negative_volume = false;    ///< an element without a volume fails; else it is counted as inverted
  bool inside_out = false;         ///< an element fails with a corner that has turned over
};

}  // namespace pinball
