#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/piece_share.hpp>
#include <solver/contact/search/pair_order.hpp>

namespace pinball {

/// What the pieces of a search have found of what may touch, in any order.
struct FoundFeatures {
  using Pieces = std::array<std::vector<std::array<std::int32_t, 2>>, fixed_pieces>;

  PairOrder::Pieces& nodes;  ///< a slave and a segment
  PairOrder::Pieces& edges;
  Pieces& with_segments;  ///< a sphere and a segment
  Pieces& with_spheres;

  /// Adds what other processes have found in their pieces.
  void add_from_others(const PieceShare& share);
};

}  // namespace pinball
