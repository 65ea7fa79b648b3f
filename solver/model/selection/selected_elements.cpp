#include "selected_elements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include <solver/base/error.hpp>

#include "named_nodes.hpp"
#include "node_selection.hpp"

namespace pinball {

namespace {

/// What a mesh splits has one number in all of its pieces.
std::vector<std::int32_t> numbered_elements(const ModelMesh& mesh, const InitialStress& given) {
  const FileNodes& file = file_of(mesh, given.nodes.file, given.nodes.where);
  const auto& known = file.element_numbers;
  std::vector<std::int32_t> elements;
  for (const std::int64_t number : given.elements) {
    auto found = std::lower_bound(known.begin(), known.end(), std::pair{number, std::int32_t{-1}});
    if (found == known.end() || found->first != number) {
      throw InputError(fmt::format("{}: {} has no element {} that a body uses", given.nodes.where, file.path, number));
    }
    for (; found != known.end() && found->first == number; ++found) elements.push_back(found->second);
  }
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  return elements;
}

/// The set of elements, or the part, that a selection names; null: it names something else, or nothing.
const MeshSet* elements_of_set(const ModelMesh& mesh, const NodeSelection& selection) {
  if (selection.set.empty()) return nullptr;
  const FileNodes& file = file_of(mesh, selection.file, selection.where);
  if (find_set(file.sets, selection.set) != nullptr || find_set(file.face_sets, selection.set) != nullptr)
    return nullptr;
  const MeshSet* set = find_set(file.element_sets, selection.set);
  return set != nullptr && set->problem.empty() ? set : nullptr;
}

void keep_body(const ModelMesh& mesh, const std::string& name, std::vector<std::int32_t>& elements) {
  const std::int64_t body = std::ranges::find(mesh.body_names, name) - mesh.body_names.begin();
  std::erase_if(elements, [&](std::int32_t e) { return mesh.body[e] != body; });
}

void keep_where_all_corners_are(const ModelMesh& mesh, const NodeSelection& selection,
                                std::vector<std::int32_t>& elements) {
  std::vector<bool> selected(mesh.nodes.size(), false);
  for (const std::int32_t n : matching_nodes(mesh, selection)) selected[n] = true;
  std::erase_if(elements, [&](std::int32_t e) {
    return !std::ranges::all_of(mesh.hexahedra[e], [&](std::int32_t n) { return selected[n]; });
  });
}

}  // namespace

std::vector<std::int32_t> select_elements(const ModelMesh& mesh, const InitialStress& given) {
  NodeSelection rest = given.nodes;
  std::vector<std::int32_t> elements;
  if (!given.elements.empty()) {
    elements = numbered_elements(mesh, given);
  } else if (const MeshSet* set = elements_of_set(mesh, rest)) {
    elements = set->members;
    rest.set.clear();
  } else {
    elements.resize(mesh.hexahedra.size());
    std::iota(elements.begin(), elements.end(), 0);
  }
  if (!rest.body.empty()) keep_body(mesh, std::exchange(rest.body, {}), elements);
  if (!rest.all() || !rest.without.empty()) keep_where_all_corners_are(mesh, rest, elements);
  if (elements.empty()) {
    throw InputError(
        fmt::format("{}: expected at least one element with all corners {}", given.nodes.where, describe(given.nodes)));
  }
  return elements;
}

}  // namespace pinball
