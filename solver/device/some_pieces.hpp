#pragma once

#include <cstdint>
#include <vector>

#include <kernels/exec/pieces.hpp>

#include "element_totals.hpp"

namespace pinball {

/// Of the sum over a part the pieces that a rank works.
template <class S>
struct SomePieces {
  std::int64_t all = 0;                          ///< pieces of the part
  std::vector<PieceRange> worked;                ///< with any element that this rank works
  std::vector<ElementTotals<S>> usual, of_left;  ///< of each piece of the part: those of the two sweeps

  void clear() {
    usual.assign(all, {});
    of_left.assign(all, {});
  }
};

}  // namespace pinball
