#include "tetrahedra.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <kernels/hexahedron.hpp>
#include <solver/base/hexahedron_of_points.hpp>

namespace pinball {

namespace {

/// The different nodes of a hexahedron, in the order in which they come first.
std::vector<std::int32_t> nodes_in_order(const Corners8& corners) {
  std::vector<std::int32_t> nodes;
  for (const std::int32_t node : corners) {
    if (std::ranges::find(nodes, node) == nodes.end()) nodes.push_back(node);
  }
  return nodes;
}

/// Adds the tetrahedra between a node and the two triangles of a face, which is counterclockwise seen from outside.
void add_fan(std::int32_t top, const std::array<std::int32_t, 4>& face, std::vector<Corners8>& tetrahedra) {
  const auto lowest = std::ranges::min_element(face) - face.begin();
  const auto at = [&](std::int64_t i) { return face[(lowest + i) % 4]; };
  for (const int i : {1, 2}) {
    // From outside a triangle is counterclockwise, from the node inside it is clockwise.
    const Corners8 added = tetrahedron(at(0), at(i + 1), at(i), top);
    if (is_tetrahedron(added)) tetrahedra.push_back(added);
  }
}

}  // namespace

std::optional<Corners8> as_tetrahedron(const Corners8& corners) {
  const std::vector<std::int32_t> nodes = nodes_in_order(corners);
  if (nodes.size() != 4) return std::nullopt;
  // The same hexahedron over a tetrahedron of volume 1/6.
  constexpr std::array<Point, 4> place{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<Point, 8> points;
  for (std::size_t i = 0; i < 8; ++i) points[i] = place[std::ranges::find(nodes, corners[i]) - nodes.begin()];
  // With n1 n2 n3 n4 n4 n4 n4 n4 the fourth node is in the base, too: that hexahedron fills a half.
  const double sixths = 6 * hexahedron_volume(points);
  if (std::abs(sixths) < 0.1) return std::nullopt;
  if (sixths < 0) return tetrahedron(nodes[1], nodes[0], nodes[2], nodes[3]);
  return tetrahedron(nodes[0], nodes[1], nodes[2], nodes[3]);
}

Mesh cut_into_tetrahedra(const Mesh& mesh) {
  Mesh cut{mesh.nodes, {}};
  cut.hexahedra.reserve(6 * mesh.hexahedra.size());
  for (const Corners8& hexahedron : mesh.hexahedra) {
    const std::int32_t lowest = std::ranges::min(hexahedron);
    for (const auto& corners : face_nodes) {
      std::array<std::int32_t, 4> face;
      for (std::size_t i = 0; i < 4; ++i) face[i] = hexahedron[corners[i]];
      if (std::ranges::find(face, lowest) == face.end()) add_fan(lowest, face, cut.hexahedra);
    }
  }
  return cut;
}

}  // namespace pinball
