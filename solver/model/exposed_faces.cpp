#include "exposed_faces.hpp"

#include <algorithm>

#include <kernels/hexahedron.hpp>

namespace pinball {

namespace {

bool in_plane(const Point& place, const PlaneConstraint& plane) {
  double distance = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = place[k] - plane.point[k];
    distance += d * plane.normal[k];
    size += d * d;
  }
  return distance * distance <= 1e-18 * (size + 1e-300);
}

}  // namespace

std::vector<std::uint8_t> find_exposed_faces(const ModelMesh& mesh, const std::vector<PlaneConstraint>& symmetry,
                                             const std::vector<std::array<std::int32_t, 6>>& neighbours) {
  std::vector<std::uint8_t> exposed(neighbours.size(), 0);
  for (std::size_t e = 0; e < neighbours.size(); ++e) {
    const std::string& body = mesh.body_of_element(e);
    for (unsigned f = 0; f < 6; ++f) {
      if (neighbours[e][f] != -1) continue;
      const auto continued_by = [&](const PlaneConstraint& plane) {
        if (!plane.body.empty() && plane.body != body) return false;
        return std::all_of(std::begin(face_nodes[f]), std::end(face_nodes[f]),
                           [&](int corner) { return in_plane(mesh.corner(e, corner), plane); });
      };
      if (std::none_of(symmetry.begin(), symmetry.end(), continued_by)) {
        exposed[e] |= static_cast<std::uint8_t>(1U << f);
      }
    }
  }
  return exposed;
}

}  // namespace pinball
