#pragma once

#include <cstddef>
#include <cstdint>

namespace pinball {

/// Place of component c of number s in an array that lies in packs of W, n components each.
template <int W>
constexpr std::size_t place_in_packs(std::int64_t s, int c, int n) {
  return (s / W * n + c) * W + s % W;
}

}  // namespace pinball
