#include "abaqus_outside.hpp"

#include <algorithm>

#include <solver/base/faces.hpp>

namespace pinball {

Share share_of(const AbaqusFaces& faces, const AbaqusFaces& other, std::size_t body) {
  const std::vector<std::int64_t>&own = faces.of_body[body], &others = other.of_body[body];
  if (own.empty() || others.empty()) return Share::none;
  if (other.whole[body]) return Share::all;
  if (faces.of_nodes || other.of_nodes || faces.whole[body]) return Share::some;  // erosion may expose what is inside
  if (std::ranges::includes(others, own)) return Share::all;
  const bool common = std::ranges::any_of(own, [&](std::int64_t f) { return std::ranges::binary_search(others, f); });
  return common ? Share::some : Share::none;
}

AbaqusOutside::AbaqusOutside(const AbaqusData& data) : data_(data), body_of_part_(data.mesh.file.parts.size(), -1) {
  for (std::size_t b = 0; b < data.bodies.size(); ++b) body_of_part_[data.bodies[b].section] = b;
  find_outside();
}

void AbaqusOutside::find_outside() {
  const MeshFile& file = data_.mesh.file;
  const auto neighbours = face_neighbours(file.mesh.hexahedra);
  outside_.of_body.resize(data_.bodies.size());
  outside_.whole.assign(data_.bodies.size(), true);
  for (std::size_t e = 0; e < neighbours.size(); ++e) {
    const std::size_t body = body_of_part_[file.part[e]];
    for (std::size_t k = 0; k < 6; ++k) {
      if (neighbours[e][k] == -1) outside_.of_body[body].push_back(6 * e + k);
    }
  }
}

const AbaqusFaces& AbaqusOutside::faces(const std::string& label, const DeckPlace& place) {
  if (label.empty()) return outside_;
  const auto [found, is_new] = known_.try_emplace(label_key(label));
  if (!is_new) return found->second;
  const FaceSet* set = data_.find_faces(label);
  return found->second = set != nullptr ? of_faces(*set) : of_nodes(data_.nodes(label, place).members);
}

AbaqusFaces AbaqusOutside::of_faces(const FaceSet& set) const {
  const auto sorted = [](std::array<std::int32_t, 4> corners) {
    std::ranges::sort(corners);
    return corners;
  };
  std::vector<std::array<std::int32_t, 4>> wanted;
  for (const auto& face : set.faces) wanted.push_back(sorted(face));
  std::ranges::sort(wanted);
  AbaqusFaces faces;
  faces.of_body.resize(data_.bodies.size());
  const MeshFile& file = data_.mesh.file;
  for (std::size_t e = 0; e < file.part.size(); ++e) {
    for (int k = 0; k < 6; ++k) {
      if (!std::ranges::binary_search(wanted, sorted(corners_of_face(file.mesh.hexahedra[e], k)))) continue;
      const std::size_t body = body_of_part_[file.part[e]];
      faces.of_body[body].push_back(static_cast<std::int64_t>(6 * e) + k);
    }
  }
  return complete(std::move(faces));
}

AbaqusFaces AbaqusOutside::of_nodes(const std::vector<std::int32_t>& nodes) const {
  std::vector<bool> member(data_.used.size(), false);
  for (const std::int32_t node : nodes) member[node] = true;
  AbaqusFaces faces;
  faces.of_nodes = true;
  faces.of_body.resize(data_.bodies.size());
  const MeshFile& file = data_.mesh.file;
  for (std::size_t e = 0; e < file.part.size(); ++e) {
    const auto has = [&](std::int32_t node) { return member[node]; };
    if (!std::ranges::any_of(file.mesh.hexahedra[e], has)) continue;
    faces.of_body[body_of_part_[file.part[e]]] = {-1};
  }
  return complete(std::move(faces));
}

AbaqusFaces AbaqusOutside::complete(AbaqusFaces faces) const {
  for (std::size_t b = 0; b < faces.of_body.size(); ++b)
    faces.whole.push_back(!faces.of_nodes && std::ranges::includes(faces.of_body[b], outside_.of_body[b]));
  return faces;
}

}  // namespace pinball
