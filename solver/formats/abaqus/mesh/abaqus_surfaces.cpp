#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/base/faces.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/mesh/file/shell_layers.hpp>

#include "abaqus_rigid_elements.hpp"
#include "abaqus_sets.hpp"

namespace pinball {

SolidShape given_shape(const std::vector<AbaqusElements>& types, std::int32_t element) {
  const auto next = std::ranges::upper_bound(types, static_cast<std::size_t>(element), {}, &AbaqusElements::first);
  return next == types.begin() ? SolidShape::hexahedron : std::prev(next)->shape;
}

int abaqus_face(const std::array<std::int32_t, 8>& hexahedron, SolidShape given, int number) {
  const SolidShape shape = given == SolidShape::hexahedron ? given : shape_of(hexahedron);
  return number < 1 || number > 6 ? -1 : known_shape(shape).abaqus_faces[number - 1];
}

bool is_face(const std::array<std::int32_t, 4>& corners) {
  std::array<std::int32_t, 4> sorted = corners;
  std::ranges::sort(sorted);
  return std::unique(sorted.begin(), sorted.end()) - sorted.begin() >= 3;
}

std::array<std::int32_t, 4> corners_of_face(const std::array<std::int32_t, 8>& hexahedron, int face) {
  std::array<std::int32_t, 4> corners{};
  for (std::size_t i = 0; i < 4; ++i) corners[i] = hexahedron[face_nodes[face][i]];
  for (int turns = 0; turns < 3; ++turns) {  // of a triangle the last corner stands twice
    const bool triangle = corners[0] == corners[1] || corners[1] == corners[2] || corners[3] == corners[0];
    if (triangle && corners[2] != corners[3]) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
  return corners;
}

const std::vector<std::array<std::int32_t, 6>>& AbaqusSets::neighbours() {
  if (!neighbours_.empty()) return neighbours_;
  if (std::ranges::none_of(file_.mesh.hexahedra, is_flat_layer))
    return neighbours_ = face_neighbours(file_.mesh.hexahedra);
  std::vector<std::array<std::int32_t, 8>> solids;
  for (const auto& hexahedron : file_.mesh.hexahedra) {
    if (!is_flat_layer(hexahedron)) solids.push_back(hexahedron);
  }
  const auto of_solids = face_neighbours(solids);  // whether there is one counts here, and not which
  for (std::size_t next = 0; const auto& hexahedron : file_.mesh.hexahedra)
    neighbours_.push_back(is_flat_layer(hexahedron) ? std::array<std::int32_t, 6>{} : of_solids[next++]);
  return neighbours_;
}

/// A set or an element, and which of its faces: "S1" to "S6", or those on the outside of the mesh. Without a set: all.
void AbaqusSets::add_faces(std::size_t component, const DataLine& card,
                           std::vector<std::array<std::int32_t, 4>>& faces) {
  const DataFields f(card);
  const std::string face = squeezed(f.text(1));
  std::vector<std::int32_t> all;
  if (f.blank(0)) {
    const std::size_t elements = file_.mesh.hexahedra.size();
    for (std::size_t e = 0; e < elements; ++e) all.push_back(e);
  }
  const std::vector<std::int32_t>& elements = f.blank(0) ? all : members(component, false, f.text(0), card.place);
  for (const std::int32_t e : elements) {
    const auto& hexahedron = file_.mesh.hexahedra[e];
    if (is_flat_layer(hexahedron)) {
      if (!face.empty() && face != "SPOS" && face != "SNEG")
        fail_at(card.place, fmt::format("*SURFACE: expected SPOS or SNEG of a rigid element, got \"{}\"", f.text(1)));
      if (face != "SNEG") faces.push_back(positive_side(hexahedron));
      if (face != "SPOS") faces.push_back(negative_side(hexahedron));
      continue;
    }
    if (face.empty()) {
      for (int k = 0; k < 6; ++k) {
        if (neighbours()[e][k] == -1) faces.push_back(corners_of_face(hexahedron, k));
      }
      continue;
    }
    const bool numbered = face.size() == 2 && face[0] == 'S';
    const int k = numbered ? abaqus_face(hexahedron, given_shape(types_, e), face[1] - '0') : -1;
    if (k < 0) fail_at(card.place, fmt::format("*SURFACE: expected a face S1 to S6 of a solid, got \"{}\"", f.text(1)));
    if (const auto corners = corners_of_face(hexahedron, k); is_face(corners)) faces.push_back(corners);
  }
}

void AbaqusSets::name_surface(std::size_t component, const Surface& surface) {
  const AbaqusBlock& block = *surface.block;
  const std::string type = block.option("TYPE");
  FaceSet faces;
  MeshSet nodes;
  try {
    if (block.has("COMBINE") || block.has("CROP") || (!type.empty() && type != "ELEMENT" && type != "NODE"))
      fail_at(block.place, "*SURFACE with TYPE=" + type + ", COMBINE or CROP is not read");
    DataLines lines(block);
    while (const auto card = lines.next()) {
      if (type != "NODE") {
        add_faces(component, *card, faces.faces);
        continue;
      }
      const std::vector<std::int32_t>& some = members(component, true, DataFields(*card).text(0), card->place);
      nodes.members.insert(nodes.members.end(), some.begin(), some.end());
    }
  } catch (const InputError& error) {
    faces.problem = nodes.problem = error.what();
  }
  for (const auto& [name, key] : names_in_file(component, surface.name, surface.key, surface_uses_)) {
    if (type != "NODE") {
      file_.face_sets.push_back({0, name, faces.faces, faces.problem});
      keys_.face_sets.push_back(key);
    } else if (!node_set_uses_.contains(surface.key)) {  // sets and surfaces may have one name
      std::sort(nodes.members.begin(), nodes.members.end());
      file_.node_sets.push_back({0, name, nodes.members, nodes.problem});
      keys_.node_sets.push_back(key);
    }
  }
}

}  // namespace pinball
