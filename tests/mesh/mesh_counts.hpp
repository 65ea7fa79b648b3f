#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <solver/mesh.hpp>

/// What tests count in generated meshes.
namespace pinball::test {

inline std::size_t count_used_nodes(const Mesh& mesh) {
  std::set<std::int32_t> used;
  for (const auto& hexahedron : mesh.hexahedra) used.insert(hexahedron.begin(), hexahedron.end());
  return used.size();
}

/// Number of distinct points when coordinates are rounded to 1e-6.
inline std::size_t count_distinct_points(const std::vector<Point>& nodes) {
  std::set<std::array<std::int64_t, 3>> cells;
  for (const Point& x : nodes)
    cells.insert({std::llround(x[0] * 1e6), std::llround(x[1] * 1e6), std::llround(x[2] * 1e6)});
  return cells.size();
}

}  // namespace pinball::test
