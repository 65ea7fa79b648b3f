#include "reversed_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/base/face_corners.hpp>
#include <solver/base/point.hpp>

namespace pinball {

namespace {

using Face = std::array<std::int32_t, 4>;

constexpr std::int32_t none = -1, several = -2;

template <std::size_t size>
Point centre_of(const Mesh& mesh, const std::array<std::int32_t, size>& corners) {
  Point sum{};
  for (const std::int32_t corner : corners) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += mesh.nodes[corner][k] / size;
  }
  return sum;
}

bool points_inwards(const Mesh& mesh, const Face& face, const std::array<std::int32_t, 8>& solid) {
  const auto at = [&](std::size_t corner) { return mesh.nodes[face[corner]]; };
  const Point normal = cross(minus(at(2), at(0)), minus(at(3), at(1)));
  return dot(normal, minus(centre_of(mesh, face), centre_of(mesh, solid))) < 0;
}

/// The solid of each face, by its key, or none or several.
std::map<Face, std::int32_t> solids_of(const Mesh& mesh, const std::vector<DeckFaces>& all) {
  std::map<Face, std::int32_t> solids;
  std::vector<bool> has_face(mesh.nodes.size(), false);
  for (const DeckFaces& listed : all) {
    for (const Face& face : listed.faces) {
      if (std::ranges::any_of(face, [](std::int32_t corner) { return corner < 0; })) continue;
      solids[face_key(face)] = none;
      for (const std::int32_t corner : face) has_face[corner] = true;
    }
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

}  // namespace

void tell_reversed(const Mesh& mesh, const std::vector<DeckFaces>& all, DeckReport& report) {
  const std::map<Face, std::int32_t> solids = solids_of(mesh, all);
  const auto is_reversed = [&](const Face& face) {
    const auto found = solids.find(face_key(face));
    return found != solids.end() && found->second >= 0 && points_inwards(mesh, face, mesh.hexahedra[found->second]);
  };
  for (const DeckFaces& listed : all) {
    const auto count = std::ranges::count_if(listed.faces, is_reversed);
    if (count == 0) continue;
    report.unused(listed.place, fmt::format("{} of {} face{}", listed.what, count, count == 1 ? "" : "s"),
                  "their normal points into the solid, where pressure would pull; here it presses on it all the same");
  }
}

}  // namespace pinball
