#include "reversed_faces.hpp"

#include <algorithm>
#include <map>

#include <kernels/hexahedron.hpp>
#include <solver/base/point.hpp>

namespace pinball {

namespace {

using Face = std::array<std::int32_t, 4>;

Face sorted(Face face) {
  std::ranges::sort(face);
  return face;
}

template <std::size_t size>
Point centre_of(const Mesh& mesh, const std::array<std::int32_t, size>& corners) {
  Point sum{};
  for (const std::int32_t corner : corners) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += mesh.nodes[static_cast<std::size_t>(corner)][k] / size;
  }
  return sum;
}

bool points_inwards(const Mesh& mesh, const Face& face, const std::array<std::int32_t, 8>& solid) {
  const auto at = [&](std::size_t corner) { return mesh.nodes[static_cast<std::size_t>(face[corner])]; };
  const Point normal = cross(minus(at(2), at(0)), minus(at(3), at(1)));
  return dot(normal, minus(centre_of(mesh, face), centre_of(mesh, solid))) < 0;
}

}  // namespace

std::size_t count_reversed(const Mesh& mesh, const std::vector<Face>& faces) {
  constexpr std::int32_t none = -1, several = -2;
  std::map<Face, std::int32_t> solids;
  for (const Face& face : faces) {
    if (std::ranges::none_of(face, [](std::int32_t corner) { return corner < 0; })) solids[sorted(face)] = none;
  }
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    for (const auto& corners : face_nodes) {
      Face face{};
      for (std::size_t i = 0; i < 4; ++i) face[i] = mesh.hexahedra[e][static_cast<std::size_t>(corners[i])];
      const auto found = solids.find(sorted(face));
      if (found != solids.end()) found->second = found->second == none ? static_cast<std::int32_t>(e) : several;
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(faces, [&](const Face& face) {
    const auto found = solids.find(sorted(face));
    return found != solids.end() && found->second >= 0 &&
           points_inwards(mesh, face, mesh.hexahedra[static_cast<std::size_t>(found->second)]);
  }));
}

}  // namespace pinball
