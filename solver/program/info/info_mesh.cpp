#include "info_mesh.hpp"

#include <fmt/core.h>

namespace pinball {

namespace {

/// Of each kind no more are listed.
constexpr std::size_t most_listed = 20;

std::string name_of(const MeshGroup& group) {
  if (group.name.empty()) return fmt::format("{}", group.id);
  return group.id == 0 ? group.name : fmt::format("{} ({})", group.name, group.id);
}

void print_groups(const FileNodes& file, MeshGroup::Kind kind, const char* plural, const char* members) {
  std::string list;
  std::size_t count = 0;
  for (const MeshGroup& group : file.groups) {
    if (group.kind != kind) continue;
    if (count++ < most_listed) list += fmt::format("{}{}: {}", list.empty() ? "" : ", ", name_of(group), group.members);
  }
  if (count == 0) return;
  if (count > most_listed) list += fmt::format(" and {} more", count - most_listed);
  fmt::print("    {}, with their {}: {}\n", plural, members, list);
}

}  // namespace

void print_mesh_files(const ModelMesh& mesh) {
  if (!mesh.files.empty()) fmt::print("mesh files\n");
  for (const FileNodes& file : mesh.files) {
    fmt::print("  {}\n", file.path);
    print_groups(file, MeshGroup::Kind::part, "parts", "elements");
    print_groups(file, MeshGroup::Kind::elements, "sets of elements", "elements");
    print_groups(file, MeshGroup::Kind::nodes, "sets of nodes", "nodes");
    print_groups(file, MeshGroup::Kind::faces, "sets of faces", "faces");
  }
  for (const std::string& warning : mesh.warnings) fmt::print("  warning: {}\n", warning);
}

}  // namespace pinball
