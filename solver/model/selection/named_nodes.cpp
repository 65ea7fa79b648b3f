#include "named_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>

namespace pinball {

const FileNodes& file_of(const ModelMesh& mesh, const std::string& name, const std::string& where) {
  const auto fail = [&](const std::string& problem) { throw InputError(fmt::format("{}: {}", where, problem)); };
  if (mesh.files.empty()) fail("sets and numbers of nodes are those of a mesh file, and no body is from one");
  if (name.empty()) {
    if (mesh.files.size() > 1)
      fail("expected file, the mesh file that the set or the numbers are of: there are several");
    return mesh.files.front();
  }
  std::vector<std::string> known;
  for (const FileNodes& file : mesh.files) {
    if (file.path.ends_with(name)) return file;
    known.push_back(file.path);
  }
  fail(fmt::format("no body is from a mesh file {}, nearest is {}", name, nearest(name, known)));
  return mesh.files.front();
}

std::vector<std::int32_t> nodes_of_body(const ModelMesh& mesh, const std::string& name) {
  const auto found = std::ranges::find(mesh.body_names, name);
  if (found == mesh.body_names.end()) return {};
  const std::int32_t body = found - mesh.body_names.begin();
  std::vector<std::int32_t> nodes = mesh.shared[body];
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.body_of_node[n] == body) nodes.push_back(n);
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

namespace {

const FileNodes& file_of(const ModelMesh& mesh, const NodeSelection& selection) {
  return file_of(mesh, selection.file, selection.where);
}

template <class Set>
const Set& sound(const Set& set, const NodeSelection& selection) {
  if (!set.problem.empty()) throw InputError(fmt::format("{}: {}", selection.where, set.problem));
  return set;
}

/// What is there several times stands once; what is not in the model (-1) not at all.
std::vector<std::int32_t> each_once(std::vector<std::int32_t> nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (!nodes.empty() && nodes.front() < 0) nodes.erase(nodes.begin());
  return nodes;
}

[[noreturn]] void fail_unknown(const FileNodes& file, const NodeSelection& selection, const std::string& name) {
  std::vector<std::string> known = set_names(file.sets);
  for (const auto& more : {set_names(file.face_sets), set_names(file.element_sets)})
    known.insert(known.end(), more.begin(), more.end());
  throw InputError(fmt::format("{}: {} has no set of nodes, faces or elements, and no part, \"{}\"{}", selection.where,
                               file.path, name,
                               known.empty() ? "" : fmt::format(", nearest is \"{}\"", nearest(name, known))));
}

}  // namespace

std::vector<std::int32_t> nodes_of_set(const ModelMesh& mesh, const NodeSelection& selection, const std::string& name) {
  const FileNodes& file = file_of(mesh, selection);
  if (const MeshSet* set = find_set(file.sets, name)) return sound(*set, selection).members;
  std::vector<std::int32_t> nodes;
  if (const FaceSet* set = find_set(file.face_sets, name)) {
    for (const auto& face : sound(*set, selection).faces) nodes.insert(nodes.end(), face.begin(), face.end());
    return each_once(std::move(nodes));
  }
  const MeshSet* set = find_set(file.element_sets, name);
  if (set == nullptr) fail_unknown(file, selection, name);
  for (const std::int32_t e : sound(*set, selection).members)
    nodes.insert(nodes.end(), mesh.hexahedra[e].begin(), mesh.hexahedra[e].end());
  return each_once(std::move(nodes));
}

namespace {

/// Place in the model; -1: no body has it.
std::int32_t find_number(const std::vector<std::pair<std::int64_t, std::int32_t>>& numbers, std::int64_t number) {
  const auto found = std::lower_bound(numbers.begin(), numbers.end(), std::pair{number, std::int32_t{-1}});
  return found == numbers.end() || found->first != number ? -1 : found->second;
}

const FileNodes& file_of(const ModelMesh& mesh, const Probe& probe) {
  const auto fail = [&](const char* problem) { throw InputError(fmt::format("{}: {}", probe.where, problem)); };
  if (mesh.files.empty()) fail("numbers of nodes and elements are those of a mesh file, and no body is from one");
  if (probe.body.empty()) {
    if (mesh.files.size() > 1) fail("expected body, from whose mesh file the number is: there are several");
    return mesh.files.front();
  }
  const auto body = std::ranges::find(mesh.body_names, probe.body) - mesh.body_names.begin();
  const std::int32_t file = mesh.file_of_body[body];
  if (file < 0) fail("numbers of nodes and elements are those of a mesh file, and its body is from none");
  return mesh.files[file];
}

}  // namespace

std::int32_t node_of_number(const ModelMesh& mesh, const NodeSelection& selection, std::int64_t number) {
  const FileNodes& file = file_of(mesh, selection);
  const std::int32_t node = find_number(file.numbers, number);
  if (node < 0)
    throw InputError(fmt::format("{}: {} has no node {} that a body uses", selection.where, file.path, number));
  return node;
}

std::int32_t place_of_number(const ModelMesh& mesh, const Probe& probe) {
  const FileNodes& file = file_of(mesh, probe);
  const bool node = probe.kind == ProbeKind::node;
  const std::int32_t place = find_number(node ? file.numbers : file.element_numbers, probe.number.value_or(0));
  const auto fail = [&](const std::string& owner) {
    throw InputError(fmt::format("{}: {} has no {} {} that {}", probe.where, file.path, node ? "node" : "element",
                                 probe.number.value_or(0), owner));
  };
  if (place < 0) fail("a body uses");
  if (probe.body.empty()) return place;
  const auto body = std::ranges::find(mesh.body_names, probe.body) - mesh.body_names.begin();
  const auto& body_of = node ? mesh.body_of_node : mesh.body;
  const auto& shared = mesh.shared[body];
  const bool theirs = body_of[place] == body || (node && std::binary_search(shared.begin(), shared.end(), place));
  if (!theirs) fail("body " + probe.body + " uses");
  return place;
}

std::vector<std::int32_t> numbered_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  std::vector<std::int32_t> nodes;
  for (const std::int64_t number : selection.nodes) nodes.push_back(node_of_number(mesh, selection, number));
  return each_once(std::move(nodes));
}

const FaceSet* faces_of_set(const ModelMesh& mesh, const NodeSelection& selection) {
  const FileNodes& file = file_of(mesh, selection);
  const FaceSet* set = find_set(file.face_sets, selection.set);
  return set == nullptr ? nullptr : &sound(*set, selection);
}

}  // namespace pinball
