#pragma once

#include <cstdint>
#include <type_traits>

#include "../macros.hpp"
#include "array.hpp"
#include "host_loops.hpp"

/// Sums over a range, in an order that depends on its length alone and is the same on every space: the range is cut
/// into pieces, a piece into lanes (index i belongs to lane i mod 128); each lane adds its indices in their order,
/// lanes are joined in pairs (l, l + 64), then (l, l + 32), ..., and the sums of the pieces in the same way.
namespace pinball {

inline constexpr int sum_lanes = 128;
inline constexpr std::int64_t most_sum_pieces = 1024;

/// Pieces of a range of so many indices; at least one.
PINBALL_FUNCTION std::int64_t sum_pieces(std::int64_t count) {
  const std::int64_t rounds = (count + sum_lanes - 1) / sum_lanes;
  return rounds < 1 ? 1 : rounds < most_sum_pieces ? rounds : most_sum_pieces;
}

/// Piece p of so many: it begins at a multiple of the lanes.
struct SumPiece {
  std::int64_t begin, end;
};
PINBALL_FUNCTION SumPiece sum_piece(std::int64_t count, std::int64_t p, std::int64_t pieces) {
  const std::int64_t rounds = (count + sum_lanes - 1) / sum_lanes;
  const std::int64_t begin = rounds * p / pieces * sum_lanes, end = rounds * (p + 1) / pieces * sum_lanes;
  return {begin, end < count ? end : count};
}

/// Numbers are added; anything else says how by join(other).
template <class Value>
PINBALL_FUNCTION void join_to(Value& value, const Value& other) {
  if constexpr (std::is_arithmetic_v<Value>) {
    value += other;
  } else {
    value.join(other);
  }
}

/// Sum of term(i, partial) for the indices of a piece, by one thread in place of one for each lane.
template <class Value, class Term>
Value sum_of_piece(SumPiece piece, const Term& term) {
  Value lane[sum_lanes]{};
  for (std::int64_t i = piece.begin; i < piece.end; ++i) term(i, lane[i % sum_lanes]);
  for (int width = sum_lanes / 2; width > 0; width /= 2) {
    for (int l = 0; l < width; ++l) join_to(lane[l], lane[l + width]);
  }
  return lane[0];
}

/// Whether a functor can be called on a space: on that of a device as a copy of its bytes.
template <class Space, class Functor>
inline constexpr bool fits_space =
    std::is_same_v<typename Space::memory_space, HostSpace> || std::is_trivially_copyable_v<Functor>;

template <class Value, class Functor>
struct PartialSums {
  std::int64_t begin, count, pieces;
  Value* partial;
  const Functor& functor;
  void operator()(std::int64_t p) const {
    partial[p] = sum_of_piece<Value>(sum_piece(count, p, pieces),
                                     [this](std::int64_t i, Value& sum) { functor(begin + i, sum); });
  }
};

/// result = sum of what functor(i, partial) adds to partial results. These begin as Value{}, which must add nothing;
/// numbers are added, other values joined by their join(const Value&). What result was before does not count. The same
/// bits for any number of threads, from run to run and, where the compiler fuses nothing, on every space.
template <class Space, class Functor, class Value>
void parallel_reduce(const char* name, RangePolicy<Space> range, const Functor& functor, Value& result) {
  static_assert(std::is_trivially_copyable_v<Value> && fits_space<Space, Functor>);
  const std::int64_t count = range.end - range.begin, pieces = sum_pieces(count);
  Array<Value> partial;
  partial.renew(pieces);
  const PartialSums<Value, Functor> sums{range.begin, count, pieces, partial.data(), functor};
  parallel_for(name, RangePolicy<Space>{0, pieces}, sums);
  result = sum_of_piece<Value>({0, pieces}, [&](std::int64_t p, Value& sum) { join_to(sum, partial[std::size_t(p)]); });
}

template <class Value, class Functor>
struct ScannedPieces {
  std::int64_t begin, count;
  Value* before;  ///< of each piece
  const Functor& functor;
  bool final;
  void operator()(std::int64_t p) const {
    const std::int64_t end = count * (p + 1) / fixed_pieces;
    Value update = before[p];
    for (std::int64_t i = count * p / fixed_pieces; i < end; ++i) functor(begin + i, update, final);
    if (!final) before[p] = update;
  }
};

/// Running sums. functor(i, update, final) adds the term of i to update, which holds the sum of the terms of all
/// indices before i when it is called with final = true: once for each index. It may be called with final = false as
/// often as this takes, to learn the term alone. total: the sum of all. The terms are whole numbers, or values of such
/// with join as in parallel_reduce; sums of others depend on the space.
template <class Space, class Functor, class Value>
void parallel_scan(const char* name, RangePolicy<Space> range, const Functor& functor, Value& total) {
  static_assert(std::is_trivially_copyable_v<Value> && fits_space<Space, Functor>);
  Value before[fixed_pieces]{};
  ScannedPieces<Value, Functor> pieces{range.begin, range.end - range.begin, before, functor, false};
  parallel_for(name, RangePolicy<Space>{0, fixed_pieces}, pieces);
  Value sum{};
  for (Value& of_piece : before) {
    const Value own = of_piece;
    of_piece = sum;
    join_to(sum, own);
  }
  pieces.final = true;
  parallel_for(name, RangePolicy<Space>{0, fixed_pieces}, pieces);
  total = sum;
}

}  // namespace pinball
