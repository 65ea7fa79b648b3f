#include "node_masses.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include <solver/mesh/quality.hpp>
#include <solver/mesh/shapes/wedges.hpp>

namespace pinball {

std::vector<double> node_masses(const MeshFile& file, const std::vector<double>& density) {
  const Mesh& mesh = file.mesh;
  std::vector<double> masses(mesh.nodes.size(), 0.0);
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    std::array<Point, 8> corners;
    for (std::size_t c = 0; c < 8; ++c) corners[c] = mesh.nodes[mesh.hexahedra[e][c]];
    const double mass = density[file.part[e]] * volume_by_quadrature(corners);
    const CornerShares share = corner_shares(worked_as(mesh.hexahedra[e]), mesh.hexahedra[e]);
    for (std::size_t c = 0; c < 8; ++c) masses[mesh.hexahedra[e][c]] += mass * share[c];
  }
  return masses;
}

}  // namespace pinball
