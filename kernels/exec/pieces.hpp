#pragma once

#include <cstdint>

#include "sums.hpp"

/// The sum of a range of which one process forms some pieces, and others the rest: the same bits as by parallel_reduce.
namespace pinball {

/// Some of the pieces into which a range is cut (sum_pieces): first ... last - 1.
struct PieceRange {
  std::int64_t first, last;
};

/// Of the sum that parallel_reduce forms some pieces: partial[p] for each p of them, on the host. Who has all of them
/// calls join_pieces.
template <class Space, class Functor, class Value>
void reduce_pieces(const char* name, RangePolicy<Space> range, PieceRange pieces, const Functor& functor,
                   Value* partial) {
  static_assert(std::is_trivially_copyable_v<Value> && fits_space<Space, Functor>);
  const std::int64_t count = range.end - range.begin;
  const PartialSums<Value, Functor> sums{range.begin, count, sum_pieces(count), partial, functor};
  parallel_for(name, RangePolicy<Space>{pieces.first, pieces.last}, sums);
}

/// The sum of a range of which all pieces are there.
template <class Value>
Value join_pieces(const Value* partial, std::int64_t pieces) {
  return sum_of_piece<Value>({0, pieces}, [&](std::int64_t p, Value& sum) { join_to(sum, partial[p]); });
}

}  // namespace pinball
