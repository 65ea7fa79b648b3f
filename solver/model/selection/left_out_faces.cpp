#include "left_out_faces.hpp"

#include <fmt/core.h>

#include "named_nodes.hpp"

namespace pinball {

namespace {

/// Sets of faces stand in the model in the order of the file.
std::size_t faces_in_file(const FileNodes& file, const FaceSet& set) {
  auto before = &set - file.face_sets.data();
  for (const MeshGroup& group : file.groups) {
    if (group.kind == MeshGroup::Kind::faces && before-- == 0) return group.members;
  }
  return set.faces.size();
}

}  // namespace

std::vector<std::string> find_left_out_faces(const Scene& scene, const ModelMesh& mesh) {
  std::vector<std::string> found;
  const auto look = [&](const std::string& file_name, const std::string& name, const std::string& where) {
    const FileNodes& file = file_of(mesh, file_name, where);
    const FaceSet* set = find_set(file.face_sets, name);
    if (set == nullptr) return;
    const std::size_t all = faces_in_file(file, *set), left_out = all - set->faces.size();
    if (left_out == 0) return;
    found.push_back(fmt::format("{}: {} of the {} faces of the set {} {} of no body and left out", where, left_out, all,
                                name, left_out == 1 ? "is" : "are"));
  };
  const auto look_at_side = [&](const ContactSide& side, const std::string& where) {
    for (const MeshSetName& set : side.faces) look(set.file, set.set, where);
  };
  for (const Pressure& pressure : scene.pressures) {
    const NodeSelection& faces = pressure.faces;
    if (pressure.corners.empty() && !faces.set.empty()) look(faces.file, faces.set, faces.where);
  }
  for (const ContactPair& pair : scene.contact_pairs) {
    look_at_side(pair.first, pair.where + ".first");
    look_at_side(pair.second, pair.where + ".second");
  }
  for (const TiedContact& tied : scene.tied_contacts) {
    look_at_side(tied.first, tied.where + ".first");
    look_at_side(tied.second, tied.where + ".second");
  }
  return found;
}

}  // namespace pinball
