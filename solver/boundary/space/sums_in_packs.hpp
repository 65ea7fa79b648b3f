#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include <kernels/exec.hpp>
#include <kernels/simd.hpp>

/// Sums of the host over lists of nodes of which most add nothing, told a pack at a time: the order, and with it the
/// bits, of PartialSums (kernels/exec/sums.hpp), whose members these have.
namespace pinball {

/// Packs of the numbers of a functor that has such.
template <class Functor>
using PackOfFunctor = Pack<typename Functor::Number, native_width<typename Functor::Number>>;

/// Of a functor that can say of a pack of indices, first and those behind it, that calls for them would add nothing and
/// leave all as it is but for numbers of its own, which it then sets.
template <class Functor>
concept PassesPacks = requires(const Functor& functor) {
  functor.template passes<PackOfFunctor<Functor>>(std::int64_t());
};

/// Packs that the functor lets pass are passed by.
template <class Value, PassesPacks Functor>
struct SumsOfFewPacks {
  using T = PackOfFunctor<Functor>;
  static constexpr int W = width_of<T>;

  std::int64_t begin, count, pieces;
  Value* partial;
  const Functor& functor;

  void operator()(std::int64_t p) const {
    const SumPiece piece = sum_piece(count, p, pieces);
    Value lane[sum_lanes];
    bool any = false;
    for (std::int64_t first = piece.begin; first < piece.end; first += W) {
      const std::int64_t end = std::min(first + W, piece.end);
      if (end - first == W && functor.template passes<T>(begin + first)) continue;
      if (!std::exchange(any, true)) std::fill(lane, lane + sum_lanes, Value{});
      for (std::int64_t i = first; i < end; ++i) functor(begin + i, lane[i % sum_lanes]);
    }
    const auto of_lane = [&lane](std::int64_t l, Value& sum) { join_to(sum, lane[l]); };
    partial[p] = any ? sum_of_piece<Value>({0, sum_lanes}, of_lane) : Value{};
  }
};

template <class Value, class Functor>
struct ChooseSums {
  using Type = PartialSums<Value, Functor>;
};
template <class Value, PassesPacks Functor>
struct ChooseSums<Value, Functor> {
  using Type = SumsOfFewPacks<Value, Functor>;
};
template <class Value, class Functor>
using SumsOfHost = typename ChooseSums<Value, Functor>::Type;

}  // namespace pinball
