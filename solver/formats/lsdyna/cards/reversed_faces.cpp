#include "reversed_faces.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/base/face_corners.hpp>
#include <solver/formats/deck/face_normals.hpp>

namespace pinball {

void tell_reversed(const Mesh& mesh, const std::vector<DeckFaces>& all, DeckReport& report) {
  std::vector<DeckFace> faces;
  for (const DeckFaces& listed : all) faces.insert(faces.end(), listed.faces.begin(), listed.faces.end());
  const std::map<DeckFace, std::int32_t> solids = solids_of_faces(mesh, faces);
  const auto is_reversed = [&](const DeckFace& face) {
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
