#pragma once

#include <cstdint>

#include <kernels/element_update.hpp>

namespace pinball {

/// What all elements of a part report of a step, or some of them.
template <class S>
struct ElementTotals {
  double internal = 0, hourglass = 0, viscous = 0, eroded = 0;  ///< increments [energy]
  double hourglass_plastic = 0;                                 ///< of `internal` [energy]
  double folding = 0;                                           ///< stored now [energy]
  S stable_rate = 0;                                            ///< largest 2/dt of a stable step dt [1/time]
  std::int64_t place = -1;                                      ///< of the element that has it
  std::int64_t eroded_count = 0, inverted_count = 0, inside_out_count = 0;
  std::int64_t left_count = 0;  ///< packs that the kernel has left as they are, for one that knows rare cases

  /// other: of other elements. Of equal rates that of the first place counts, in whatever order they are joined.
  PINBALL_FUNCTION void join(const ElementTotals& other) {
    internal += other.internal;
    hourglass += other.hourglass;
    viscous += other.viscous;
    eroded += other.eroded;
    hourglass_plastic += other.hourglass_plastic;
    folding += other.folding;
    eroded_count += other.eroded_count;
    inverted_count += other.inverted_count;
    inside_out_count += other.inside_out_count;
    left_count += other.left_count;
    if (other.stable_rate > stable_rate || (other.stable_rate == stable_rate && is_before(other.place))) {
      stable_rate = other.stable_rate;
      place = other.place;
    }
  }

  /// Of one pack of elements, the first of them at this place, behind those that were added before.
  template <class T>
  PINBALL_FUNCTION void add(const ElementSums<T>& pack, std::int64_t first) {
    internal += static_cast<double>(lane_sum(pack.internal));
    hourglass += static_cast<double>(lane_sum(pack.hourglass));
    viscous += static_cast<double>(lane_sum(pack.viscous));
    eroded += static_cast<double>(lane_sum(pack.eroded));
    hourglass_plastic += static_cast<double>(lane_sum(pack.hourglass_plastic));
    folding += static_cast<double>(lane_sum(pack.folding));
    eroded_count += pack.eroded_count;
    inverted_count += pack.inverted_count;
    inside_out_count += pack.inside_out_count;
    for (int i = 0; i < width_of<T>; ++i) {
      if (!(lane(pack.stable_rate, i) > stable_rate)) continue;
      stable_rate = lane(pack.stable_rate, i);
      place = first + i;
    }
  }

 private:
  PINBALL_FUNCTION bool is_before(std::int64_t other) const { return other >= 0 && other < place; }
};

}  // namespace pinball
