#include "file_nodes.hpp"

#include <algorithm>

namespace pinball {

namespace {

/// Members as places in the model, ascending, without those that it does not have. ids: their numbers in the file.
MeshSet set_of_model(const MeshSet& set, const std::vector<std::int32_t>& place, const std::vector<std::int64_t>& ids) {
  MeshSet of_model{set.id, set.name, {}, set.problem, set.left_out};
  for (const std::int32_t member : set.members) {
    if (place[member] >= 0) {
      of_model.members.push_back(place[member]);
    } else {
      of_model.left_out.add(number_of(ids, member));
    }
  }
  std::sort(of_model.members.begin(), of_model.members.end());
  return of_model;
}

FaceSet faces_of_model(const FaceSet& set, const std::vector<std::int32_t>& node) {
  FaceSet of_model{set.id, set.name, {}, set.problem};
  for (std::array<std::int32_t, 4> face : set.faces) {
    for (std::int32_t& corner : face) corner = corner < 0 ? -1 : node[corner];
    if (std::ranges::none_of(face, [](std::int32_t corner) { return corner < 0; })) of_model.faces.push_back(face);
  }
  of_model.left_out = set.faces.size() - of_model.faces.size();
  return of_model;
}

std::vector<MeshSet> parts_as_sets(const MeshFile& file, const std::vector<std::int32_t>& element) {
  std::vector<MeshSet> sets;
  for (const MeshPart& part : file.parts) sets.push_back({part.id, part.name, {}});
  for (std::size_t e = 0; e < file.part.size(); ++e) {
    if (file.part[e] < 0) continue;
    MeshSet& set = sets[file.part[e]];
    if (element[e] >= 0) {
      set.members.push_back(element[e]);
    } else {
      set.left_out.add(number_of(file.element_ids, e));
    }
  }
  for (MeshSet& set : sets) std::sort(set.members.begin(), set.members.end());
  return sets;
}

/// Each number with its place in the model, by number; without what the model does not have.
std::vector<std::pair<std::int64_t, std::int32_t>> numbers_of(const std::vector<std::int64_t>& ids,
                                                              const std::vector<std::int32_t>& place) {
  std::vector<std::pair<std::int64_t, std::int32_t>> numbers;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (place[i] >= 0) numbers.emplace_back(ids[i], place[i]);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace

FileNodes file_nodes(const MeshFile& file, const std::vector<std::int32_t>& node,
                     const std::vector<std::int32_t>& element) {
  FileNodes named;
  named.path = file.path;
  named.sources = file.sources;
  named.groups = groups_of(file);
  named.numbers = numbers_of(file.node_ids, node);
  named.element_numbers = numbers_of(file.element_ids, element);
  for (const MeshSet& set : file.node_sets) named.sets.push_back(set_of_model(set, node, file.node_ids));
  for (const FaceSet& set : file.face_sets) named.face_sets.push_back(faces_of_model(set, node));
  named.element_sets = parts_as_sets(file, element);
  for (const MeshSet& set : file.element_sets)
    named.element_sets.push_back(set_of_model(set, element, file.element_ids));
  return named;
}

}  // namespace pinball
