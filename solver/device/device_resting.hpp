#pragma once

#include <cstdint>
#include <vector>

#include <kernels/macros.hpp>

namespace pinball {

/// What is done with the elements of a tile. Of several ranks, packs that are another's have numbers of tiles behind
/// those of the model.
struct TileWork {
  static constexpr std::uint8_t awake = 0;
  static constexpr std::uint8_t rests = 1;
  static constexpr std::uint8_t for_sums = 2;  ///< worked, for this rank forms their sum; their rank knows the step
  static constexpr std::uint8_t none = 3;

  static constexpr std::int32_t number_for_sums(std::int32_t tiles) { return tiles; }
  static constexpr std::int32_t number_of_none(std::int32_t tiles) { return tiles + 1; }
  static constexpr std::int32_t numbers = 2;  ///< behind those of the model
};

/// Some of a resting tile's nodes, first ... end - 1: the work of one thread.
struct RestingPiece {
  std::int32_t first, end;
  std::int32_t tile;  ///< its index in the list of tiles
};

/// Tiles at rest (resting_tiles.hpp), as a device gets them.
template <class S>
struct DeviceResting {
  std::vector<std::int32_t> tile;         ///< their numbers, ascending
  std::vector<std::int32_t> elements;     ///< of each
  std::vector<std::int32_t> record;       ///< of each: a node that has its velocity
  std::vector<S> time_step;               ///< of each: the stable step that it keeps [time]
  std::vector<std::int32_t> first_piece;  ///< [tiles + 1]
  std::vector<RestingPiece> pieces;
  bool updated = false;  ///< they are updated all the same (skip.resting = false)
};

/// What tiles at rest have in common.
template <class S>
struct RestingTotals {
  S time_step = 0;            ///< smallest stable step; 0: nothing rests [time]
  std::int32_t index = -1;    ///< in the list of tiles: who has it
  std::int64_t elements = 0;  ///< of all of them

  /// other: of tiles behind these, or before them.
  PINBALL_FUNCTION void join(const RestingTotals& other) {
    elements += other.elements;
    if (other.index < 0) return;
    if (index >= 0 && time_step < other.time_step) return;
    if (index >= 0 && time_step == other.time_step && index < other.index) return;
    time_step = other.time_step;
    index = other.index;
  }
};

}  // namespace pinball
