#include "pressed_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/base/error.hpp>
#include <solver/base/face_corners.hpp>
#include <solver/base/faces.hpp>
#include <solver/model/exposed_faces.hpp>

#include "named_nodes.hpp"
#include "node_selection.hpp"

namespace pinball {

namespace {

using Corners = std::array<std::int32_t, 4>;

/// A face that is a line or a point has no area.
bool has_area(const Corners& corners) { return face_key(corners)[2] >= 0; }

std::vector<bool> marks(const ModelMesh& mesh, const std::vector<std::int32_t>& nodes) {
  std::vector<bool> marked(mesh.nodes.size(), false);
  for (const std::int32_t n : nodes) marked[n] = true;
  return marked;
}

template <class Marks>
bool all_marked(const Corners& corners, const Marks& marked) {
  return std::ranges::all_of(corners, [&](std::int32_t n) { return marked[n]; });
}

std::string text(const ModelMesh& mesh, const Corners& corners) {
  std::vector<std::string> places;
  for (const std::int32_t n : corners) {
    if (n >= 0)
      places.push_back(fmt::format("({:.6g}, {:.6g}, {:.6g})", mesh.nodes[n][0], mesh.nodes[n][1], mesh.nodes[n][2]));
  }
  return fmt::format("{}", fmt::join(places, " "));
}

/// How many elements have each face of a set.
struct Wanted {
  std::map<Corners, int> found;
  std::vector<bool> nodes;  ///< that any of them has
};

Wanted wanted_faces(const ModelMesh& mesh, const FaceSet& set) {
  Wanted wanted{{}, std::vector<bool>(mesh.nodes.size(), false)};
  for (const Corners& face : set.faces) {
    wanted.found[face_key(face)] = 0;
    for (const std::int32_t n : face) wanted.nodes[n] = true;
  }
  return wanted;
}

void require_one_element_each(const ModelMesh& mesh, const Wanted& wanted, const NodeSelection& selection) {
  for (const auto& [corners, elements] : wanted.found) {
    if (elements == 1) continue;
    throw InputError(fmt::format("{}: the face with the corners {} {}", selection.where, text(mesh, corners),
                                 elements == 0 ? "is one of no hexahedron" : "lies between two hexahedra"));
  }
}

/// Whether some elements have triangles for faces, and some quadrangles.
bool has_both_faces(const ModelMesh& mesh) {
  bool triangles = false, quadrangles = false;
  for (std::array<std::int32_t, 8> corners : mesh.hexahedra) {
    std::ranges::sort(corners);
    const auto different = std::unique(corners.begin(), corners.end()) - corners.begin();
    triangles = triangles || different < 8;
    quadrangles = quadrangles || different > 4;
  }
  return triangles && quadrangles;
}

std::vector<PressedFace> faces_of(const ModelMesh& mesh, const FaceSet& set, const NodeSelection& selection) {
  Wanted wanted = wanted_faces(mesh, set);
  std::vector<std::uint8_t> split(mesh.hexahedra.size(), 0);
  if (has_both_faces(mesh)) split = find_split_faces(mesh, face_neighbours(mesh.hexahedra));
  std::vector<PressedFace> faces;
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    if (std::ranges::none_of(mesh.hexahedra[e], [&](std::int32_t n) { return wanted.nodes[n]; })) continue;
    for (unsigned f = 0; f < 6; ++f) {
      const Corners corners = face_of(mesh.hexahedra[e], f);
      if (!all_marked(corners, wanted.nodes) || !has_area(corners)) continue;
      const auto found = wanted.found.find(face_key(corners));
      if (found == wanted.found.end()) continue;
      found->second += (split[e] >> f & 1U) != 0 ? 2 : 1;
      faces.push_back({static_cast<std::int64_t>(e), corners});
    }
  }
  require_one_element_each(mesh, wanted, selection);
  return faces;
}

FaceSet listed_faces(const ModelMesh& mesh, const Pressure& pressure) {
  FaceSet listed{0, "", {}, ""};
  for (const auto& numbers : pressure.corners) {
    Corners& corners = listed.faces.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) corners[i] = node_of_number(mesh, pressure.faces, numbers[i]);
  }
  return listed;
}

std::vector<PressedFace> exposed_faces_of(const ModelMesh& mesh, const std::vector<PlaneConstraint>& symmetry) {
  const std::vector<std::array<std::int32_t, 6>> neighbours = face_neighbours(mesh.hexahedra);
  const std::vector<std::uint8_t> exposed = find_exposed_faces(mesh, symmetry, neighbours);
  const std::vector<std::uint8_t> split = find_split_faces(mesh, neighbours);
  std::vector<PressedFace> faces;
  for (std::size_t e = 0; e < exposed.size(); ++e) {
    for (unsigned f = 0; f < 6; ++f) {
      const Corners corners = face_of(mesh.hexahedra[e], f);
      const unsigned outside = exposed[e] & ~static_cast<unsigned>(split[e]);
      if ((outside >> f & 1U) != 0 && has_area(corners)) faces.push_back({static_cast<std::int64_t>(e), corners});
    }
  }
  return faces;
}

}  // namespace

std::vector<PressedFace> pressed_faces(const ModelMesh& mesh, const std::vector<PlaneConstraint>& symmetry,
                                       const Pressure& pressure) {
  const NodeSelection& selection = pressure.faces;
  const FaceSet* set = selection.set.empty() ? nullptr : faces_of_set(mesh, selection);
  std::vector<PressedFace> faces = !pressure.corners.empty() ? faces_of(mesh, listed_faces(mesh, pressure), selection)
                                   : set != nullptr          ? faces_of(mesh, *set, selection)
                                                             : exposed_faces_of(mesh, symmetry);
  NodeSelection corners = selection;
  if (set != nullptr) corners.set.clear();
  const std::vector<bool> selected = marks(mesh, matching_nodes(mesh, corners));
  std::erase_if(faces, [&](const PressedFace& face) {
    const bool other = !selection.body.empty() && mesh.body_of_element(face.element) != selection.body;
    return other || !all_marked(face.corners, selected);
  });
  if (faces.empty()) {
    throw InputError(
        fmt::format("{}: expected at least one face, there is none {}", selection.where, describe(selection)));
  }
  return faces;
}

}  // namespace pinball
