#include "face_normals.hpp"

#include <algorithm>

#include <solver/base/face_corners.hpp>
#include <solver/base/point.hpp>

namespace pinball {

namespace {

constexpr std::int32_t none = -1, several = -2;

template <std::size_t size>
Point centre_of(const Mesh& mesh, const std::array<std::int32_t, size>& corners) {
  Point sum{};
  for (const std::int32_t corner : corners) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += mesh.nodes[corner][k] / size;
  }
  return sum;
}

}  // namespace

bool points_inwards(const Mesh& mesh, const DeckFace& face, const std::array<std::int32_t, 8>& solid) {
  const auto at = [&](std::size_t corner) { return mesh.nodes[face[corner]]; };
  const Point normal = cross(minus(at(2), at(0)), minus(at(3), at(1)));
  return dot(normal, minus(centre_of(mesh, face), centre_of(mesh, solid))) < 0;
}

std::map<DeckFace, std::int32_t> solids_of_faces(const Mesh& mesh, const std::vector<DeckFace>& faces) {
  std::map<DeckFace, std::int32_t> solids;
  std::vector<bool> has_face(mesh.nodes.size(), false);
  for (const DeckFace& face : faces) {
    if (std::ranges::any_of(face, [](std::int32_t corner) { return corner < 0; })) continue;
    solids[face_key(face)] = none;
    for (const std::int32_t corner : face) has_face[corner] = true;
  }
  for (std::size_t e = 0; !solids.empty() && e < mesh.hexahedra.size(); ++e) {
    const auto& solid = mesh.hexahedra[e];
    if (std::ranges::none_of(solid, [&](std::int32_t n) { return has_face[n]; })) continue;
    for (std::size_t f = 0; f < 6; ++f) {
      const auto found = solids.find(face_key(face_of(solid, f)));
      if (found != solids.end()) found->second = found->second == none ? e : several;
    }
  }
  return solids;
}

}  // namespace pinball
