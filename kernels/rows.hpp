#pragma once

#include <cstdint>

#include "simd.hpp"

/// Numbers that lie in packs of several lanes, n components each: component c of number s at
/// [(s / row * n + c) * row + s % row]. Whole packs are as wide as a row; a lane that is worked alone, as a thread of a
/// device does it, finds its numbers in rows of any width.
namespace pinball {

/// Distance between two components. row: of a lane alone.
template <class T>
PINBALL_FUNCTION int row_of(int row) {
  return width_of<T> > 1 ? width_of<T> : row;
}

/// Place of the first component of pack i, or of lane i.
template <class T>
PINBALL_FUNCTION std::int64_t first_in_rows(int row, std::int64_t i, int n) {
  constexpr int W = width_of<T>;
  if constexpr (W > 1) {
    return i * n * W;
  } else {
    return i / row * n * row + i % row;
  }
}

}  // namespace pinball
