#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../kernels/exec.hpp"

/// Lists by count, scan and fill: made by all threads, with the same order for any number of them, and none longer than
/// what it holds. What several indices may change at once has a result that does not depend on who was first.
namespace pinball {

/// Fewer numbers than these are looked at before another thread is there.
inline constexpr std::int64_t worth_a_thread = 4096;

/// parallel_for, by the calling thread alone where `numbers`, of all indices together, are too few for others.
template <class Body>
void for_all_of(const char* name, std::int64_t count, std::int64_t numbers, const Body& body) {
  if (numbers < worth_a_thread) {
    parallel_for(name, RangePolicy<Serial>{0, count}, body);
  } else {
    parallel_for(name, RangePolicy<>{0, count}, body);
  }
}

/// Of each piece the sum of those before it; returns that of all.
inline std::int64_t sums_before(std::array<std::int64_t, fixed_pieces>& pieces) {
  std::int64_t whole = 0;
  for (std::int64_t& sum : pieces) {
    const std::int64_t here = sum;
    sum = whole;
    whole += here;
  }
  return whole;
}

/// Turns counts into where each begins: [i] becomes the sum of those before it. Returns the sum of all.
template <class Number>
std::int64_t make_offsets(std::vector<Number>& counts) {
  std::array<std::int64_t, fixed_pieces> sums{};
  const std::int64_t count = std::ssize(counts);
  const auto begin_of = [count](std::int64_t piece) { return count * piece / fixed_pieces; };
  for_all_of("sums of counts", fixed_pieces, count, [&](std::int64_t piece) {
    std::int64_t sum = 0;
    for (std::int64_t i = begin_of(piece); i < begin_of(piece + 1); ++i) sum += counts[i];
    sums[piece] = sum;
  });
  const std::int64_t whole = sums_before(sums);
  for_all_of("offsets", fixed_pieces, count, [&](std::int64_t piece) {
    std::int64_t next = sums[piece];
    for (std::int64_t i = begin_of(piece); i < begin_of(piece + 1); ++i) {
      const std::int64_t here = counts[i];
      counts[i] = static_cast<Number>(next);
      next += here;
    }
  });
  return whole;
}

/// The numbers below `count` for which is(number), from the lowest up. It is asked twice.
template <class Number, class Is>
void list_where(const char* name, std::int64_t count, std::vector<Number>& list, const Is& is) {
  std::array<std::int64_t, fixed_pieces> place{};
  const auto for_each = [&](std::int64_t piece, const auto& visit) {
    const std::int64_t end = count * (piece + 1) / fixed_pieces;
    for (std::int64_t i = count * piece / fixed_pieces; i < end; ++i) {
      if (is(i)) visit(i);
    }
  };
  for_all_of(name, fixed_pieces, count, [&](std::int64_t piece) {
    std::int64_t found = 0;
    for_each(piece, [&](std::int64_t) { ++found; });
    place[piece] = found;
  });
  list.resize(sums_before(place));
  for_all_of(name, fixed_pieces, count, [&](std::int64_t piece) {
    std::int64_t next = place[piece];
    for_each(piece, [&](std::int64_t i) { list[next++] = static_cast<Number>(i); });
  });
}

/// The lowest number below `count` for which is(number); `count`: there is none.
template <class Is>
std::int64_t first_where(const char* name, std::int64_t count, const Is& is) {
  std::int64_t first = count;
  parallel_reduce(
      name, RangePolicy<>{0, count}, first,
      [&](std::int64_t begin, std::int64_t end, std::int64_t& found) {
        found = count;
        for (std::int64_t i = begin; i < end && found == count; ++i) {
          if (is(i)) found = i;
        }
      },
      [](std::int64_t& whole, std::int64_t found) { whole = found < whole ? found : whole; });
  return first;
}

/// Sets a mark that others may set at the same time.
inline void set_mark(std::uint8_t& mark) { std::atomic_ref(mark).store(1, std::memory_order_relaxed); }

/// Sets some bits of marks of which others may set some at the same time.
inline void set_bits(std::uint8_t& marks, std::uint8_t bits) {
  std::atomic_ref(marks).fetch_or(bits, std::memory_order_relaxed);
}

/// Counts one more, and returns how many there were: the next place of those that are brought into order later.
inline std::int32_t count_one(std::int32_t& count) {
  return std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed);
}

/// Keeps the lowest number that anybody gives.
inline void keep_lowest(std::int32_t& lowest, std::int32_t number) {
  const std::atomic_ref of(lowest);
  std::int32_t before = of.load(std::memory_order_relaxed);
  while (number < before && !of.compare_exchange_weak(before, number, std::memory_order_relaxed)) {
  }
}

}  // namespace pinball
