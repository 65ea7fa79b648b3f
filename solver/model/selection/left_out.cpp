#include "left_out.hpp"

#include <fmt/core.h>

#include "named_nodes.hpp"
#include "node_selection.hpp"

namespace pinball {

namespace {

/// Looks at one use of a set after the other.
class LeftOutOfSets {
 public:
  explicit LeftOutOfSets(const ModelMesh& mesh) : mesh_(mesh) {}

  /// As nodes_of_set() looks for them: a set of nodes, or else of faces, or else of elements.
  void look_at_nodes(const NodeSelection& selection) {
    if (selection.set.empty()) return;
    const FileNodes& file = file_of(mesh_, selection.file, selection.where);
    if (tell(find_set(file.sets, selection.set), "node", selection.set, selection.where)) return;
    if (tell(find_set(file.face_sets, selection.set), selection.set, selection.where)) return;
    tell(find_set(file.element_sets, selection.set), "element", selection.set, selection.where);
  }
  /// A set of faces comes first.
  void look_at_faces(const NodeSelection& selection) {
    if (selection.set.empty()) return;
    const FileNodes& file = file_of(mesh_, selection.file, selection.where);
    if (!tell(find_set(file.face_sets, selection.set), selection.set, selection.where)) look_at_nodes(selection);
  }
  void look_at_side(const ContactSide& side, const std::string& where) {
    for (const MeshSetName& set : side.faces) tell(find_set(of(set, where).face_sets, set.set), set.set, where);
    for (const MeshSetName& set : side.elements)
      tell(find_set(of(set, where).element_sets, set.set), "element", set.set, where);
    for (const MeshSetName& set : side.nodes) tell(find_set(of(set, where).sets, set.set), "node", set.set, where);
  }

  const std::vector<std::string>& found() const { return found_; }

 private:
  const FileNodes& of(const MeshSetName& set, const std::string& where) const {
    return file_of(mesh_, set.file, where);
  }

  /// Both return whether there is such a set.
  bool tell(const MeshSet* set, const char* kind, const std::string& name, const std::string& where) {
    if (set != nullptr && set->left_out.count > 0)
      found_.push_back(sentence(set->left_out.count, set->members.size(), kind, name, where) +
                       fmt::format(", the first is {} {}", kind, set->left_out.first));
    return set != nullptr;
  }
  bool tell(const FaceSet* set, const std::string& name, const std::string& where) {
    if (set != nullptr && set->left_out > 0)
      found_.push_back(sentence(set->left_out, set->faces.size(), "face", name, where));
    return set != nullptr;
  }
  static std::string sentence(std::size_t left_out, std::size_t kept, const char* kind, const std::string& name,
                              const std::string& where) {
    return fmt::format("{}: {} of the {} {}s of the set {} {} of no body and left out", where, left_out,
                       left_out + kept, kind, name, left_out == 1 ? "is" : "are");
  }

  const ModelMesh& mesh_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> find_left_out(const Scene& scene, const ModelMesh& mesh) {
  LeftOutOfSets sets(mesh);
  for_each_selection_of_nodes(scene, [&](const NodeSelection& nodes) { sets.look_at_nodes(nodes); });
  for (const Pressure& pressure : scene.pressures) {
    if (pressure.corners.empty()) sets.look_at_faces(pressure.faces);
  }
  for (const ContactPair& pair : scene.contact_pairs) {
    sets.look_at_side(pair.first, pair.where + ".first");
    sets.look_at_side(pair.second, pair.where + ".second");
  }
  for (const TiedContact& tied : scene.tied_contacts) {
    sets.look_at_side(tied.first, tied.where + ".first");
    sets.look_at_side(tied.second, tied.where + ".second");
  }
  return sets.found();
}

}  // namespace pinball
