#pragma once

#include <cstdint>

#include "macros.hpp"

/// Spatial hash: points are put into the cells of a grid without bounds, cells into buckets by a hash of their three
/// integer coordinates (report figure 3, steps 4 and 5). Entries of one bucket lie together, in the order of the
/// points, and carry their cell, so that cells that share a bucket are told apart.
///
/// Built by counting, scanning and filling: the order of the result never depends on timing.
namespace pinball {

/// Cell of a point: floor((x - origin) / size) per axis, packed to 21 bits each (offset 2^20). Coordinates outside
/// +-2^20 cells are clamped to the outermost cell, which stays right (they only meet more candidates).
struct CellGrid {
  double origin[3];
  double inverse_size;

  PINBALL_FUNCTION std::int32_t coordinate(double x, int axis) const {
    const double c = (x - origin[axis]) * inverse_size;
    const double limit = 1048575.0;
    const double clamped = c > -limit ? (c < limit ? c : limit) : -limit;  // also for NaN: the run stops elsewhere
    const std::int32_t truncated = static_cast<std::int32_t>(clamped);
    return truncated - (clamped < truncated ? 1 : 0);  // floor
  }
};

PINBALL_FUNCTION std::uint64_t pack_cell(std::int32_t i, std::int32_t j, std::int32_t k) {
  const std::uint64_t mask = 0x1FFFFF;
  return ((static_cast<std::uint64_t>(i + 1048576) & mask) << 42) |
         ((static_cast<std::uint64_t>(j + 1048576) & mask) << 21) | (static_cast<std::uint64_t>(k + 1048576) & mask);
}

/// Multiplicative hash of a packed cell to `bits` bits.
PINBALL_FUNCTION std::uint32_t hash_cell(std::uint64_t cell, int bits) {
  std::uint64_t h = cell;
  h ^= h >> 33;
  h *= 0xff51afd7ed558ccdULL;
  h ^= h >> 33;
  return static_cast<std::uint32_t>((h * 0x9e3779b97f4a7c15ULL) >> (64 - bits));
}

/// Memory of the hash; arrays belong to the caller.
template <class S>
struct SpatialHashView {
  CellGrid grid;
  int bits;                    ///< 2^bits buckets
  std::int32_t* bucket_start;  ///< 2^bits + 1 entries
  std::uint64_t* entry_cell;   ///< per entry: packed cell
  std::int32_t* entry_point;   ///< per entry: number of the point
  S* entry_record;             ///< per entry: the point's record of four, so that a bucket is read in one stream
};

/// Fills the hash with `count` points, whose records of four begin with their coordinates; cells: scratch of `count`.
template <class S>
void build_spatial_hash(const SpatialHashView<S>& hash, const S* records, std::int32_t count, std::uint64_t* cells) {
  const std::int64_t buckets = std::int64_t(1) << hash.bits;
  for (std::int64_t b = 0; b <= buckets; ++b) hash.bucket_start[b] = 0;
  for (std::int32_t i = 0; i < count; ++i) {  // count
    const S* p = records + 4 * static_cast<std::int64_t>(i);
    cells[i] = pack_cell(hash.grid.coordinate(p[0], 0), hash.grid.coordinate(p[1], 1), hash.grid.coordinate(p[2], 2));
    ++hash.bucket_start[hash_cell(cells[i], hash.bits) + 1];
  }
  for (std::int64_t b = 0; b < buckets; ++b) hash.bucket_start[b + 1] += hash.bucket_start[b];  // scan
  for (std::int32_t i = 0; i < count; ++i) {  // fill; moves each start to the end of its bucket
    const std::int64_t place = hash.bucket_start[hash_cell(cells[i], hash.bits)]++;
    hash.entry_cell[place] = cells[i];
    hash.entry_point[place] = i;
    for (int k = 0; k < 4; ++k) hash.entry_record[4 * place + k] = records[4 * static_cast<std::int64_t>(i) + k];
  }
  for (std::int64_t b = buckets; b > 0; --b) hash.bucket_start[b] = hash.bucket_start[b - 1];  // starts again
  hash.bucket_start[0] = 0;
}

/// Calls visit(j, record of j) for every point j in the 27 cells around a position, each once; these hold all points
/// within one cell size of it.
template <class S, class Visit>
PINBALL_FUNCTION void for_each_near(const SpatialHashView<S>& hash, const S* position, const Visit& visit) {
  const std::int32_t ci = hash.grid.coordinate(position[0], 0), cj = hash.grid.coordinate(position[1], 1),
                     ck = hash.grid.coordinate(position[2], 2);
  for (std::int32_t i = ci - 1; i <= ci + 1; ++i) {
    for (std::int32_t j = cj - 1; j <= cj + 1; ++j) {
      for (std::int32_t k = ck - 1; k <= ck + 1; ++k) {
        const std::uint64_t cell = pack_cell(i, j, k);
        const std::uint32_t bucket = hash_cell(cell, hash.bits);
        const std::int64_t end = hash.bucket_start[bucket + 1];
        for (std::int64_t e = hash.bucket_start[bucket]; e < end; ++e) {
          if (hash.entry_cell[e] == cell) visit(hash.entry_point[e], hash.entry_record + 4 * e);
        }
      }
    }
  }
}

}  // namespace pinball
