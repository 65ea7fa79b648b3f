#include <solver/scene/schema/scene.hpp>

#include "entries.hpp"
#include "list_keys.hpp"

namespace pinball {

namespace {

/// Sizes and numbers of elements, in lists along a direction that is cut into sections.
void list_mesh(Entries& table, const BlockMesh& mesh) {
  std::string size, elements;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) {
      size += ", ";
      elements += ", ";
    }
    std::vector<double> lengths;
    std::vector<int> counts;
    for (const BlockSection& section : mesh.sections[k]) {
      lengths.push_back(section.length);
      counts.push_back(section.elements);
    }
    size += lengths.empty() ? toml_text(mesh.size[k]) : toml_text(lengths);
    elements += counts.empty() ? toml_text(mesh.elements[k]) : toml_text(counts);
  }
  table.add("type", "block");
  table.add_words("size", fmt::format("[{}]", size), false, "L");
  table.add_words("elements", fmt::format("[{}]", elements), false, "-");
}

void list_mesh(Entries& table, const RoundNosedRodMesh& mesh) {
  table.add("type", "round_nosed_rod");
  list_keys(table, mesh);
}

void list_mesh(Entries& table, const CylinderMesh& mesh) {
  table.add("type", "cylinder");
  list_keys(table, mesh);
}

void list_mesh(Entries& table, const SphereMesh& mesh) {
  table.add("type", "sphere");
  list_keys(table, mesh);
  const bool wedge = mesh.section == Section::wedge;
  table.add_words("core", wedge ? toml_text(mesh.core) : toml_text(mesh.core[0]), false, "-");
}

void list_mesh(Entries& table, const FileMesh& mesh) {
  table.add("type", schema::name_of(mesh.format));
  list_keys(table, mesh);
}

void list_mesh(Entries& table, const ArrayMesh&) {
  table.add_words("type", "arrays in the memory of the program that ran it", false);
}

}  // namespace

void list_bodies(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const Body& body : scene.bodies) {
    Entries table(all, "body." + body.name);
    list_keys(table, body);
    if (body.element) list_element(*body.element, "body." + body.name + ".element", all);
    Entries mesh(all, "body." + body.name + ".mesh");
    std::visit([&mesh](const auto& settings) { list_mesh(mesh, settings); }, body.mesh);
  }
}

}  // namespace pinball
