#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "../../kernels/hexahedron.hpp"

namespace pinball {

/// Nodes of face 0 to 5 of a hexahedron, in the order of face_nodes.
inline std::array<std::int32_t, 4> face_of(const std::array<std::int32_t, 8>& hexahedron, std::size_t face) {
  std::array<std::int32_t, 4> corners{};
  for (std::size_t i = 0; i < 4; ++i) corners[i] = hexahedron[face_nodes[face][i]];
  return corners;
}

/// The corners of a face as what it is found by: the same for every order of the corners, and for every way to give a
/// triangle four of them. -2 stands behind those that are there.
inline std::array<std::int32_t, 4> face_key(std::array<std::int32_t, 4> corners) {
  std::sort(corners.begin(), corners.end());
  const auto end = std::unique(corners.begin(), corners.end());
  std::fill(end, corners.end(), -2);
  return corners;
}

}  // namespace pinball
