#include "mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>

#include "element_types.hpp"

namespace pinball {

namespace {

[[noreturn]] void fail_several(const std::string& name, std::int64_t first, std::int64_t second) {
  throw InputError(
      fmt::format("\"{}\" is the name of several parts or sets of a mesh file, of those with the numbers {} "
                  "and {}: expected a name of its own, or a number",
                  name, first, second));
}

/// The one of this name, or else of this number, of which the last one counts; null: none. Throws InputError for a name
/// of several.
template <class Named>
const Named* find_named(const std::vector<Named>& items, const std::string& name) {
  const Named* found = nullptr;
  for (const Named& item : items) {
    if (item.name != name || name.empty()) continue;
    if (found != nullptr && found->id != item.id) fail_several(name, found->id, item.id);
    found = &item;
  }
  std::int64_t number = 0;
  const char* const end = name.data() + name.size();
  if (found != nullptr || std::from_chars(name.data(), end, number).ptr != end || number == 0) return found;
  for (const Named& item : items) {
    if (item.id == number) found = &item;
  }
  return found;
}

template <class Named>
void add_names(const std::vector<Named>& items, std::vector<std::string>& names) {
  for (const Named& item : items) {
    if (!item.name.empty()) names.push_back(item.name);
    if (item.id != 0) names.push_back(std::to_string(item.id));
  }
}

[[noreturn]] void fail_unknown(const MeshFile& file, const char* what, const std::string& name,
                               const std::vector<std::string>& known) {
  throw InputError(fmt::format(
      "{}: no {} is named or numbered \"{}\": {}", file.path, what, name,
      known.empty() ? std::string("there are none") : fmt::format("nearest is \"{}\"", nearest(name, known))));
}

template <class Set>
void add_groups(const std::vector<Set>& sets, MeshGroup::Kind kind, std::vector<MeshGroup>& groups) {
  for (const Set& set : sets) {
    std::size_t members = 0;
    if constexpr (requires { set.members; }) {
      members = set.members.size();
    } else {
      members = set.faces.size();
    }
    groups.push_back({kind, set.id, set.name, members});
  }
}

}  // namespace

void append_element(MeshFile& file, const ElementType& type, std::span<const std::int32_t> nodes) {
  if (type.has_edge_nodes && type.shape == SolidShape::tetrahedron) {
    EdgeNodes& of = file.edge_nodes.emplace_back();
    of.element = static_cast<std::int32_t>(file.mesh.hexahedra.size());
    std::copy_n(nodes.begin() + 4, of.nodes.size(), of.nodes.begin());
  }
  if (type.has_edge_nodes && type.shape == SolidShape::hexahedron) {
    TwentyNodes& of = file.twenty_nodes.emplace_back();
    of.element = static_cast<std::int32_t>(file.mesh.hexahedra.size());
    std::copy_n(nodes.begin() + 8, of.nodes.size(), of.nodes.begin());
  }
  file.mesh.hexahedra.push_back(stored_corners(type, nodes));
}

void add_nodes_of_element(const MeshFile& file, std::int32_t element, std::vector<std::int32_t>& nodes) {
  const auto& corners = file.mesh.hexahedra[element];
  nodes.insert(nodes.end(), corners.begin(), corners.end());
  const auto add_those_of = [&](const auto& all, auto of_element) {
    const auto found = std::ranges::lower_bound(all, element, {}, of_element);
    if (found != all.end() && found->element == element)
      nodes.insert(nodes.end(), found->nodes.begin(), found->nodes.end());
  };
  add_those_of(file.edge_nodes, &EdgeNodes::element);
  add_those_of(file.twenty_nodes, &TwentyNodes::element);
}

std::vector<std::int32_t> elements_of_part(const MeshFile& file, const std::string& part) {
  std::vector<std::int32_t> elements;
  if (part.empty()) {
    elements.resize(file.mesh.hexahedra.size());
    std::iota(elements.begin(), elements.end(), 0);
    return elements;
  }
  if (const MeshPart* found = find_named(file.parts, part)) {
    const std::int32_t place = found - file.parts.data();
    for (std::size_t e = 0; e < file.part.size(); ++e) {
      if (file.part[e] == place) elements.push_back(e);
    }
    return elements;
  }
  if (const MeshSet* found = find_named(file.element_sets, part)) {
    if (!found->problem.empty()) throw InputError(found->problem);
    return found->members;
  }
  std::vector<std::string> known;
  add_names(file.parts, known);
  add_names(file.element_sets, known);
  fail_unknown(file, "part or set of elements", part, known);
}

const std::string& path_of_element(const MeshFile& file, std::int32_t element) {
  const std::string* path = &file.path;
  for (const MeshLines& lines : file.lines_of) {
    if (lines.first <= element) path = &lines.file;
  }
  return *path;
}

std::string place_of_element(const MeshFile& file, std::int32_t element) {
  return file.line.empty() ? file.path : fmt::format("{}:{}", path_of_element(file, element), file.line[element]);
}

const MeshSet* find_set(const std::vector<MeshSet>& sets, const std::string& name) { return find_named(sets, name); }
const FaceSet* find_set(const std::vector<FaceSet>& sets, const std::string& name) { return find_named(sets, name); }

std::vector<std::string> set_names(const std::vector<MeshSet>& sets) {
  std::vector<std::string> names;
  add_names(sets, names);
  return names;
}

std::vector<MeshGroup> groups_of(const MeshFile& file) {
  std::vector<MeshGroup> groups;
  for (const MeshPart& part : file.parts) groups.push_back({MeshGroup::Kind::part, part.id, part.name, 0});
  for (const std::int32_t part : file.part) {
    if (part >= 0) ++groups[part].members;
  }
  add_groups(file.element_sets, MeshGroup::Kind::elements, groups);
  add_groups(file.node_sets, MeshGroup::Kind::nodes, groups);
  add_groups(file.face_sets, MeshGroup::Kind::faces, groups);
  groups.insert(groups.end(), file.other_parts.begin(), file.other_parts.end());
  return groups;
}

std::vector<std::int32_t> nodes_of_faces(const std::vector<std::array<std::int32_t, 4>>& faces) {
  std::vector<std::int32_t> nodes;
  for (const auto& face : faces) nodes.insert(nodes.end(), face.begin(), face.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::erase(nodes, -1);
  return nodes;
}

void keep_used_nodes(MeshFile& file) {
  std::vector<std::int32_t> place(file.mesh.nodes.size(), -1);
  for (const auto& hexahedron : file.mesh.hexahedra) {
    for (const std::int32_t node : hexahedron) place[node] = 0;
  }
  for (const EdgeNodes& of : file.edge_nodes) {
    for (const std::int32_t node : of.nodes) place[node] = 0;
  }
  for (const TwentyNodes& of : file.twenty_nodes) {
    for (const std::int32_t node : of.nodes) place[node] = 0;
  }
  if (std::ranges::count(place, -1) == 0) return;
  for (MeshSet& set : file.node_sets) {
    for (const std::int32_t node : set.members) {
      if (place[node] < 0) set.left_out.add(number_of(file.node_ids, node));
    }
  }
  std::int32_t kept = 0;
  for (std::size_t n = 0; n < place.size(); ++n) {
    if (place[n] < 0) continue;
    file.mesh.nodes[kept] = file.mesh.nodes[n];
    if (!file.node_ids.empty()) file.node_ids[kept] = file.node_ids[n];
    place[n] = kept++;
  }
  file.mesh.nodes.resize(kept);
  file.layers.clear();
  if (!file.node_ids.empty()) file.node_ids.resize(kept);
  for (auto& hexahedron : file.mesh.hexahedra) {
    for (std::int32_t& node : hexahedron) node = place[node];
  }
  for (EdgeNodes& of : file.edge_nodes) {
    for (std::int32_t& node : of.nodes) node = place[node];
  }
  for (TwentyNodes& of : file.twenty_nodes) {
    for (std::int32_t& node : of.nodes) node = place[node];
  }
  for (MeshSet& set : file.node_sets) {
    for (std::int32_t& node : set.members) node = place[node];
    std::erase(set.members, -1);
  }
  for (FaceSet& set : file.face_sets) {
    for (auto& face : set.faces) {
      for (std::int32_t& node : face) node = place[node];
    }
  }
}

std::int64_t number_of(const std::vector<std::int64_t>& ids, std::int32_t place) {
  return ids.empty() ? place : ids[place];
}

std::string element_name(const MeshFile& file, std::int32_t e) {
  const std::string number = fmt::format("element {}", number_of(file.element_ids, e));
  return file.line.empty() ? number : fmt::format("{} (line {} of {})", number, file.line[e], path_of_element(file, e));
}

std::vector<std::string> set_names(const std::vector<FaceSet>& sets) {
  std::vector<std::string> names;
  add_names(sets, names);
  return names;
}

}  // namespace pinball
