#pragma once

#include <cstdint>

namespace pinball {

/// Elements of a tile of a mesh with so many: large enough that few of its nodes belong to other tiles, small enough
/// that a small scene has several tiles per colour and thread.
inline std::int64_t tile_size(std::int64_t elements) {
  std::int64_t size = 32;
  while (size < 2048 && size * 64 < elements) size *= 2;
  return size;
}

}  // namespace pinball
