#pragma once

#include "../element_results.hpp"
#include "../stable_time_step.hpp"
#include "element_pack.hpp"
#include "step_geometry.hpp"

/// The stable step of a pack's elements, once their moduli are known.
namespace pinball {

template <class T>
struct StabilityBound {
  /// 2/dt of moduli of a linear material that is at least as stiff in any small motion [1/time].
  PINBALL_FUNCTION T rate(const T& lambda, const T& mu) const {
    return element_stable_rate(inverse_square * end.largest_square, inverse_square * end.trace_square, end.volume,
                               inverse_inertia, lambda, mu, viscosity);
  }

  const EndSize<T>& end;
  T inverse_square;   ///< 1/V^2 [1/length^6]
  T inverse_inertia;  ///< 1/mass with which the element's nodes move [1/mass]
  T viscosity;        ///< of bulk_viscosity [stress time]
};

/// inverse_volume: at the end of the step, zero where there is none.
template <class T, int L>
PINBALL_FUNCTION StabilityBound<T> stability_bound(const ElementPack<T, L>& own, const EndSize<T>& end,
                                                   const T& inverse_volume, const T& viscosity) {
  StabilityBound<T> bound{end, inverse_volume * inverse_volume, end.inverse_mass, viscosity};
  if (own.arrays.mass_share != nullptr) {
    bound.inverse_inertia = bound.inverse_inertia * load<T>(own.arrays.mass_share + own.first);
  }
  return bound;
}

/// Keeps the largest rate of a tile, and where it is. carries: elements that are there after the step.
template <class T>
PINBALL_FUNCTION void keep_largest(const T& stable_rate, const MaskOf<T>& carries, int pack_in_tile,
                                   ElementSums<T>& sums) {
  const auto larger = carries && stable_rate > sums.stable_rate;
  sums.stable_rate = select(larger, stable_rate, sums.stable_rate);
  sums.stable_rate_pack = select(larger, T(static_cast<ScalarOf<T>>(pack_in_tile)), sums.stable_rate_pack);
}

}  // namespace pinball
