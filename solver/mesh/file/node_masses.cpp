#include "node_masses.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include <solver/mesh/quality.hpp>

namespace pinball {

std::vector<double> node_masses(const MeshFile& file, const std::vector<double>& density) {
  const Mesh& mesh = file.mesh;
  std::vector<double> masses(mesh.nodes.size(), 0.0);
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    std::array<Point, 8> corners;
    for (std::size_t c = 0; c < 8; ++c) corners[c] = mesh.nodes[mesh.hexahedra[e][c]];
    const double of_corner = density[file.part[e]] * volume_by_quadrature(corners) / 8;
    for (const std::int32_t node : mesh.hexahedra[e]) masses[node] += of_corner;
  }
  return masses;
}

}  // namespace pinball
