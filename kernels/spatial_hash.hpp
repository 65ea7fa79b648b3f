#pragma once

#include <cstdint>

#include "simd.hpp"

/// Spatial hash of boxes: a hierarchy of grids without bounds, whose cells are put into buckets by a hash of their
/// three integer coordinates and their level (report figure 3, steps 4 and 5, there for points).
///
/// Bounds of boxes are taken as whole multiples of a unit much smaller than a box. Cells of level l are 4^l units long;
/// a box belongs to the lowest level whose cells are not shorter than it, and lies in the cell of its lower corner, so
/// that it reaches into the next one at most. Boxes of a level that meet are then in the same or in neighbouring cells,
/// and a box meets none of a coarser level but those in the cells around it, however much larger they are.
///
/// Rounding to units keeps the order of numbers: boxes that meet do so in units, too.
namespace pinball {

inline constexpr int cell_coordinate_bits = 30;  ///< of coordinates in units; the coarsest level has one cell

struct CellGrid {
  double origin[3];     ///< of the units [length]
  double inverse_unit;  ///< [1/length]

  /// Coordinate in units: 0 ... 2^30 - 1. What lies outside is taken to the border, which keeps the order.
  PINBALL_FUNCTION std::int32_t coordinate(double x, int axis) const {
    const double c = (x - origin[axis]) * inverse_unit;
    constexpr double limit = (1 << cell_coordinate_bits) - 1;
    return static_cast<std::int32_t>(c > 0 ? (c < limit ? c : limit) : 0.0);
  }
};

/// A box in units, as the hash holds it: lower bounds; upper bounds with their sign changed; the box's number and
/// level. So one comparison of all numbers says whether boxes meet.
struct alignas(32) HashBox {
  std::int32_t value[8];

  PINBALL_FUNCTION std::int32_t low(int axis) const { return value[axis]; }
  PINBALL_FUNCTION std::int32_t high(int axis) const { return -value[3 + axis]; }
  PINBALL_FUNCTION std::int32_t number() const { return value[6]; }
  PINBALL_FUNCTION std::int32_t level() const { return value[7]; }
};

/// What no value of a HashBox may exceed for it to meet some box.
struct alignas(32) HashBoxLimits {
  std::int32_t value[8];
};
PINBALL_FUNCTION HashBoxLimits limits_of(const HashBox& box) {
  constexpr std::int32_t any = 0x7FFFFFFF;
  return {{box.high(0), box.high(1), box.high(2), -box.low(0), -box.low(1), -box.low(2), any, any}};
}

/// Whether a box keeps within limits.
PINBALL_FUNCTION bool meets(const HashBox& box, const HashBoxLimits& limits) {
  constexpr int W = native_width<std::int32_t> < 8 ? native_width<std::int32_t> : 8;
  using I = Pack<std::int32_t, W>;
  bool above = false;
  for (int first = 0; first < 8; first += W) {
    above |= any_lane(load<I>(box.value + first) > load<I>(limits.value + first));
  }
  return !above;
}

/// The level of a box whose longest side has this many units.
PINBALL_FUNCTION std::int32_t level_of(std::int32_t longest) {
  const std::int32_t side = longest > 1 ? longest : 1;
  const int bits = 31 - __builtin_clz(static_cast<std::uint32_t>(2 * side - 1));  // the fewest with side <= 2^bits
  return (bits + 1) / 2;
}

struct HashCell {
  std::int32_t level;
  std::int32_t at[3];
};

/// Coordinate in cells of a level, of one in units.
PINBALL_FUNCTION std::int32_t in_cells(std::int32_t units, std::int32_t level) { return units >> 2 * level; }

/// The cell that a box lies in.
PINBALL_FUNCTION HashCell cell_of(const HashBox& box) {
  const std::int32_t level = box.level();
  return {level, {in_cells(box.low(0), level), in_cells(box.low(1), level), in_cells(box.low(2), level)}};
}

PINBALL_FUNCTION bool is_in_cell(const HashBox& box, const HashCell& cell) {
  std::int32_t different = box.level() ^ cell.level;
  for (int k = 0; k < 3; ++k) different |= in_cells(box.low(k), cell.level) ^ cell.at[k];
  return different == 0;
}

/// Bucket of a cell, of 2^bits, bits > 3. The eight cells of a block of 2 x 2 x 2 have buckets side by side.
PINBALL_FUNCTION std::uint32_t bucket_of(const HashCell& cell, int bits) {
  const auto word = [](std::int32_t i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)); };
  std::uint64_t h = (word(cell.at[0] >> 1) << 32 | word(cell.at[1] >> 1)) * 0xff51afd7ed558ccdULL;
  h ^= h >> 32;
  h += word(cell.at[2] >> 1) << 8 | word(cell.level);
  h *= 0x9e3779b97f4a7c15ULL;
  h ^= h >> 32;
  h *= 0xc4ceb9fe1a85ec53ULL;
  const std::uint32_t in_block =
      static_cast<std::uint32_t>((cell.at[0] & 1) | (cell.at[1] & 1) << 1 | (cell.at[2] & 1) << 2);
  return static_cast<std::uint32_t>(h >> (64 - (bits - 3))) << 3 | in_block;
}

/// Memory of the hash; arrays belong to the caller.
struct SpatialHashView {
  CellGrid grid;
  int bits;                          ///< 2^bits buckets
  std::uint32_t levels;              ///< bit l: there are boxes of level l
  const std::int32_t* bucket_start;  ///< 2^bits + 1 entries
  const HashBox* box;                ///< those of a bucket side by side, and of it those of a cell; then by number
};

/// Copies those boxes of a bucket that are of a cell and keep within limits; returns the end of the copies. There is
/// room for all boxes of the bucket, and for one more.
PINBALL_FUNCTION HashBox* copy_cell(const SpatialHashView& hash, std::uint32_t bucket, const HashCell& cell,
                                    const HashBoxLimits& limits, HashBox* to) {
  const std::int32_t end = hash.bucket_start[bucket + 1];
  for (std::int32_t b = hash.bucket_start[bucket]; b < end; ++b) {
    const HashBox box = hash.box[b];
    *to = box;
    // if (it is of this cell and keeps within the limits) ++to
    to += is_in_cell(box, cell) & meets(box, limits);
  }
  return to;
}

}  // namespace pinball
