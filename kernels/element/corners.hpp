#pragma once

#include "../element_results.hpp"
#include "../folding.hpp"
#include "element_pack.hpp"
#include "stability.hpp"
#include "step_geometry.hpp"

/// Corners of a pack's elements that are about to turn over, and those that have (folding.hpp).
namespace pinball {

/// Elements whose corners are looked at: where they may be near turning over, also where a number is none. closely:
/// with another bound, where the first fails, which costs twice as much.
template <bool closely, class T>
PINBALL_FUNCTION MaskOf<T> may_fold(const HexahedronModes<T>& x, const EndGeometry<T>& end, const MaskOf<T>& alive) {
  using S = ScalarOf<T>;
  const T in_any_direction = largest_distortion(x, end.largest_square), volume_square = end.volume * end.volume;
  MaskOf<T> may = alive && !(in_any_direction < T(sound_distortion<S>) * volume_square);
  if (closely && any_lane(may)) {
    // Terms of both signs: of the largest principal value some digits may be left.
    constexpr S few_digits = sizeof(S) == 8 ? S(0x1p-48) : S(0x1p-19);
    const T distortion = directed_distortion(x, end.square) + T(few_digits) * in_any_direction;
    may = may && !(distortion < T(open_distortion<S>) * volume_square && end.volume > T(0));
  }
  return may;
}

/// Lets corners resist, and bounds the stable rate by theirs. any_resists: whether there is anything in `corners` but
/// zero. Returns elements that are inside out at a corner.
template <class T, int L, class N>
PINBALL_FUNCTION MaskOf<T> resist_at_corners(const ElementPack<T, L>& own, const NodeView<N>& nodes,
                                             ScalarOf<T> folding_energy, const StabilityBound<T>& bound,
                                             const HexahedronModes<T>& x, const MaskOf<T>& whole,
                                             CornerResistance<T>& corners, bool& any_resists, T& stable_rate) {
  using S = ScalarOf<T>;
  T onset(folding_energy > S(0) ? folding_onset<S> : S(0));
  if (own.arrays.folding_onset != nullptr) onset = minimum(onset, load<T>(own.arrays.folding_onset + own.first));
  const T inverse_inertia = bound.inverse_inertia;  // of their own: what is called sees them in memory
  const T end_volume = bound.end.volume;
  const HexahedronModes<T> shape = x;
  const MaskOf<T> there = whole;
  any_resists = resist_folding<T, L>(nodes.position, nodes.velocity, own.corner(), T(folding_energy) * own.mass, onset,
                                     inverse_inertia, shape, end_volume, there, corners);
  // A corner takes at least two steps to close by half of what it is open.
  if (any_resists) {
    stable_rate = maximum(square_root(stable_rate * stable_rate + corners.rate_square), T(4) * corners.closing_rate);
  }
  return own.alive && !(corners.worst > T(0));
}

/// Adds their forces, and counts the energy that they hold. weight: of ElementStep.
template <class T>
PINBALL_FUNCTION void add_resistance(const CornerResistance<T>& corners, const T& weight, Vec3<T> (&value)[8],
                                     ElementSums<T>& sums) {
  sums.folding += corners.energy;
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) value[i] = value[i] + weight * corners.force[i];
}

}  // namespace pinball
