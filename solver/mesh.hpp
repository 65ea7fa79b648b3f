#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/point.hpp"

namespace pinball {

/// What a generator or a reader produces: points and hexahedra, nothing else.
///
/// Node order of a hexahedron: 0-3 counterclockwise around the bottom seen from the top, 4-7 above them, so that the
/// parent coordinates (xi, eta, zeta) of nodes 0..7 are (-,-,-) (+,-,-) (+,+,-) (-,+,-) (-,-,+) (+,-,+) (+,+,+)
/// (-,+,+).
///
/// A hexahedron may be collapsed: a node that stands at two ends of an edge makes a wedge, {0, 1, 2, 2, 4, 5, 6, 6},
/// and so on. All formulas hold for it; such a node has the mass of all its corners. Of four different nodes it is a
/// tetrahedron, {0, 0, 1, 1, 2, 3, 3, 2}, and worked as one (solver/mesh/tetrahedra.hpp).
struct Mesh {
  std::vector<Point> nodes;                            ///< coordinates, length unit of the scene
  std::vector<std::array<std::int32_t, 8>> hexahedra;  ///< node indices into `nodes`
};

/// A file that a mesh is from, with the hash of its bytes as they were read.
struct MeshSource {
  std::string path;
  std::uint64_t hash = 0;
};

}  // namespace pinball
