#include "info_mesh.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include <solver/base/counted.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/model/look/extent.hpp>
#include <solver/scene/schema/choices.hpp>

#include "info_material.hpp"

namespace pinball {

namespace {

/// Of each kind no more are listed.
constexpr std::size_t most_listed = 20;

std::string name_of(const MeshGroup& group) {
  if (group.name.empty()) return fmt::format("{}", group.id);
  return group.id == 0 ? group.name : fmt::format("{} ({})", group.name, group.id);
}

void print_groups(const std::vector<MeshGroup>& groups, MeshGroup::Kind kind, const char* plural, const char* members) {
  std::string list;
  std::size_t count = 0;
  for (const MeshGroup& group : groups) {
    if (group.kind != kind) continue;
    if (count++ < most_listed) list += fmt::format("{}{}: {}", list.empty() ? "" : ", ", name_of(group), group.members);
  }
  if (count == 0) return;
  if (count > most_listed) list += fmt::format(" and {} more", count - most_listed);
  fmt::print("    {}, with their {}: {}\n", plural, members, list);
}

void print_all_groups(const std::vector<MeshGroup>& groups) {
  print_groups(groups, MeshGroup::Kind::part, "parts", "elements");
  print_groups(groups, MeshGroup::Kind::elements, "sets of elements", "elements");
  print_groups(groups, MeshGroup::Kind::nodes, "sets of nodes", "nodes");
  print_groups(groups, MeshGroup::Kind::faces, "sets of faces", "faces");
}

/// Parts of which no body has an element: of a body that was forgotten, or one that is not wanted.
void print_parts_of_no_body(const FileNodes& file) {
  std::vector<std::string> names;
  for (const MeshGroup& group : file.groups) {
    if (group.kind != MeshGroup::Kind::part || group.members == 0) continue;
    const bool is_there = std::ranges::any_of(file.element_sets, [&group](const MeshSet& set) {
      return set.id == group.id && set.name == group.name && !set.members.empty();
    });
    if (!is_there) names.push_back(name_of(group));
  }
  if (names.empty()) return;
  const std::size_t listed = std::min(names.size(), most_listed);
  fmt::print("    no body has parts {}{}\n", fmt::join(names.begin(), names.begin() + listed, ", "),
             names.size() > listed ? fmt::format(" and {} more", names.size() - listed) : "");
}

void print_shape(const Mesh& mesh) {
  Extent box;
  for (const Point& node : mesh.nodes) box.take(node);
  const MeshQuality q = measure_quality(mesh);
  fmt::print("  from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}), volume {:.10g}\n", box.low[0], box.low[1],
             box.low[2], box.high[0], box.high[1], box.high[2], q.volume);
  fmt::print("  {}\n", quality_text(q, ""));
}

}  // namespace

std::string quality_text(const MeshQuality& q, const std::string& length) {
  return fmt::format(
      "edges {:.6g} to {}, largest aspect ratio {:.3g}, scaled Jacobian {:.3g} at worst, {:.3g} on average", q.min_edge,
      with_unit(q.max_edge, length), q.max_aspect_ratio, q.min_scaled_jacobian, q.mean_scaled_jacobian);
}

std::string other_shapes(const std::vector<Corners8>& elements) {
  std::vector<std::string> all;
  for (const KnownShape& shape : known_shapes()) {
    if (shape.shape == SolidShape::hexahedron) continue;
    const auto is_it = [&shape](const Corners8& corners) { return shape_of(corners) == shape.shape; };
    const auto count = std::ranges::count_if(elements, is_it);
    if (count > 0) all.push_back(fmt::format("{} {}{}", count, all.empty() ? "of them " : "", shape.plural));
  }
  return all.empty() ? "" : fmt::format(" ({})", fmt::join(all, ", "));
}

void print_mesh_files(const ModelMesh& mesh) {
  if (!mesh.files.empty()) fmt::print("mesh files\n");
  for (const FileNodes& file : mesh.files) {
    fmt::print("  {}\n", file.path);
    print_all_groups(file.groups);
    print_parts_of_no_body(file);
  }
  for (const std::string& warning : mesh.warnings) fmt::print("  warning: {}\n", warning);
}

void print_mesh_file(const std::string& path, MeshFormat format) {
  FileMesh settings;
  settings.file = path;
  settings.format = format;
  const MeshFile file = read_mesh_file(settings, {});
  fmt::print("{}: a mesh ({}) of {}{} and {}\n", path, schema::name_of(format),
             counted(file.mesh.hexahedra.size(), "element"), other_shapes(file.mesh.hexahedra),
             counted(file.mesh.nodes.size(), "node"));
  if (!file.mesh.hexahedra.empty()) print_shape(file.mesh);
  print_all_groups(groups_of(file));
  for (const std::string& note : file.notes) fmt::print("  note: {}\n", note);
  fmt::print("  a body of a scene takes it: mesh = {{ type = \"file\", file = \"{}\" }}\n", path);
}

}  // namespace pinball
