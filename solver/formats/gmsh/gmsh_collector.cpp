#include "gmsh_collector.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>

namespace pinball {

GmshCollector::GmshCollector(const std::string& path, std::vector<Point> nodes, std::vector<std::int64_t> node_ids,
                             NumberIndex index)
    : index_(std::move(index)) {
  file_.path = path;
  file_.mesh.nodes = std::move(nodes);
  file_.node_ids = std::move(node_ids);
}

void GmshCollector::begin_elements(std::vector<std::int64_t> wanted, std::int64_t expected, bool repeats) {
  wanted_ = std::move(wanted);
  repeats_ = repeats;
  if (repeats_) known_.emplace(static_cast<std::size_t>(expected));
  // The memory of what is not there is never touched.
  file_.mesh.hexahedra.reserve(expected);
  file_.element_ids.reserve(expected);
}

bool GmshCollector::wants(std::span<const std::int64_t> groups) const {
  return wanted_.empty() ||
         std::ranges::any_of(groups, [&](std::int64_t group) { return std::ranges::count(wanted_, group) > 0; });
}

void GmshCollector::add_volume(const ElementType& type, std::span<const std::int32_t> nodes,
                               std::span<const std::int64_t> groups, std::int64_t id, int line) {
  const std::int32_t next = file_.mesh.hexahedra.size();
  std::int32_t place = next;
  const std::int64_t first = groups.empty() ? 0 : groups.front();
  if (repeats_) {
    // The same element of the same group is no repetition for another group: it is there twice.
    const Corners8 corners = stored_corners(type, nodes);
    place = known_->find_or_add(key_of_nodes(corners), next, [&](std::int32_t other) {
      return file_.mesh.hexahedra[other] == corners && first_group_[other] != first;
    });
  }
  if (place == next) {
    append_element(file_, type, nodes);
    file_.element_ids.push_back(id);
    if (line > 0) file_.line.push_back(line);
    if (repeats_) first_group_.push_back(first);
  }
  overlapping_ |= place != next || groups.size() > 1;
  for (const std::int64_t group : groups) add_to_group(group, place);
}

void GmshCollector::add_to_group(std::int64_t group, std::int32_t place) {
  if (group == 0 || (!wanted_.empty() && std::ranges::count(wanted_, group) == 0)) return;
  std::vector<std::int32_t>& members = members_[group];
  if (members.empty() || members.back() != place) members.push_back(place);
}

void GmshCollector::add_boundary(int dimension, std::span<const std::int32_t> nodes,
                                 std::span<const std::int64_t> groups, const std::string& problem) {
  for (const std::int64_t group : groups) {
    if (group == 0) continue;
    Boundary& boundary = boundaries_[{dimension, group}];
    if (boundary.problem.empty()) boundary.problem = problem;
    boundary.nodes.insert(boundary.nodes.end(), nodes.begin(), nodes.end());
    if (dimension == 2 && nodes.size() >= 3)
      boundary.faces.push_back({nodes[0], nodes[1], nodes[2], nodes[nodes.size() == 4 ? 3 : 2]});
  }
}

void GmshCollector::leave_out(std::span<const std::int64_t> groups) {
  for (const std::int64_t group : groups) ++left_out_[group];
}

MeshFile GmshCollector::finish(const GmshGroups& groups, const std::vector<std::string>& names) {
  require_elements(names);
  if (overlapping_) {
    name_sets(groups);
  } else {
    name_parts(groups);
  }
  name_boundaries(groups);
  for (const auto& [group, elements] : left_out_)
    file_.other_parts.push_back({MeshGroup::Kind::part, group, groups.name_of(3, group), elements});
  keep_used_nodes(file_);
  return std::move(file_);
}

void GmshCollector::require_elements(const std::vector<std::string>& names) const {
  const auto none = [this](const std::string& where) {
    throw InputError(fmt::format("{}: expected {}{}, got none", file_.path, names_of_shapes(), where));
  };
  if (file_.mesh.hexahedra.empty() && names.empty()) none("");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!members_.contains(wanted_[i])) none(fmt::format(" in the physical volume \"{}\"", names[i]));
  }
}

/// Groups that have no element in common are parts.
void GmshCollector::name_parts(const GmshGroups& groups) {
  const std::size_t count = file_.mesh.hexahedra.size();
  file_.part.assign(count, -1);
  std::size_t named = 0;
  for (const auto& [group, elements] : members_) {
    for (const std::int32_t e : elements) file_.part[e] = file_.parts.size();
    file_.parts.push_back({group, groups.name_of(3, group)});
    named += elements.size();
  }
  if (named == count) return;
  std::replace(file_.part.begin(), file_.part.end(), -1, static_cast<std::int32_t>(file_.parts.size()));
  file_.parts.push_back({0, ""});
}

void GmshCollector::name_sets(const GmshGroups& groups) {
  for (auto& [group, elements] : members_) {
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    file_.element_sets.push_back({group, groups.name_of(3, group), std::move(elements)});
  }
}

/// Points first, surfaces last: of two groups of one number that of more dimensions counts.
void GmshCollector::name_boundaries(const GmshGroups& groups) {
  for (auto& [key, boundary] : boundaries_) {
    const auto [dimension, group] = key;
    std::vector<std::int32_t>& nodes = boundary.nodes;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const std::string name = groups.name_of(dimension, group);
    file_.node_sets.push_back({group, name, std::move(nodes), boundary.problem});
    if (dimension == 2) file_.face_sets.push_back({group, name, std::move(boundary.faces), boundary.problem});
  }
}

}  // namespace pinball
