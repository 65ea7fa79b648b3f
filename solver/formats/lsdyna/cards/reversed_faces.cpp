#include "reversed_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

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
  struct Reversed {
    std::int64_t faces = 0;
    DeckPlace first{};
  };
  std::map<std::string, Reversed> reversed;  // one line of each kind, however many cards a deck has
  for (const DeckFaces& listed : all) {
    const auto count = std::ranges::count_if(listed.faces, is_reversed);
    if (count == 0) continue;
    Reversed& of_kind = reversed[listed.what];
    if (of_kind.faces == 0) of_kind.first = listed.place;
    of_kind.faces += count;
  }
  for (const auto& [what, of_kind] : reversed) {
    report.unused(of_kind.first, fmt::format("{} of {} face{}", what, of_kind.faces, of_kind.faces == 1 ? "" : "s"),
                  "their normal points into the solid, where pressure would pull; here it presses on it all the same");
  }
}

}  // namespace pinball
