#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace pinball {

/// Place of component c of number s in an array that lies in packs of W, n components each.
template <int W>
constexpr std::size_t place_in_packs(std::int64_t s, int c, int n) {
  return (s / W * n + c) * W + s % W;
}

/// The same for packs of a width that is known when the program runs, a power of two.
constexpr std::size_t place_in_packs(int width, std::int64_t s, int c, int n) {
  const int shift = std::countr_zero(static_cast<unsigned>(width));
  return (((s >> shift) * n + c) << shift) + (s & (width - 1));
}

}  // namespace pinball
