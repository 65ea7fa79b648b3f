#include <solver/mesh/mesh_format.hpp>

#include "entries.hpp"

namespace pinball {

namespace {

const char* name_of(Section section) {
  return section == Section::full      ? "full"
         : section == Section::half    ? "half"
         : section == Section::quarter ? "quarter"
                                       : "wedge";
}

void add_section(Entries& table, Section section) {
  table.add_words("section", toml_text(name_of(section)), section == Section::full);
}

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
  table.add("length", mesh.length, "L");
  table.add("radius", mesh.radius, "L");
  table.add("half", mesh.half, true, "");
  table.add("core", mesh.core, "-");
  table.add("ring", mesh.ring, 1, "-");
  table.add("layers", mesh.layers, "-");
}

void list_mesh(Entries& table, const CylinderMesh& mesh) {
  table.add("type", "cylinder");
  table.add("radius", mesh.radius, "L");
  table.add("length", mesh.length, "L");
  add_section(table, mesh.section);
  table.add("layers", mesh.layers, "-");
  if (mesh.section == Section::wedge) {
    table.add("angle", mesh.angle, "degree");
    table.add("radial", mesh.radial, "-");
  } else {
    table.add("core", mesh.core, "-");
    table.add("ring", mesh.ring, 1, "-");
  }
}

void list_mesh(Entries& table, const SphereMesh& mesh) {
  const bool wedge = mesh.section == Section::wedge;
  table.add("type", "sphere");
  table.add("radius", mesh.radius, "L");
  add_section(table, mesh.section);
  if (wedge) table.add("angle", mesh.angle, "degree");
  table.add_words("core", wedge ? toml_text(mesh.core) : toml_text(mesh.core[0]), false, "-");
  table.add("ring", mesh.ring, 1, "-");
  table.add("grading", mesh.grading, 1.0, "-");
}

void list_mesh(Entries& table, const FileMesh& mesh) {
  const bool gmsh = mesh.format == MeshFormat::gmsh;
  table.add("type", name_of(mesh.format));
  table.add("file", mesh.file);
  table.add_name(gmsh ? "physical" : "part", mesh.part, gmsh ? "all volumes" : "all elements");
  if (mesh.chosen_case) table.add("case", *mesh.chosen_case);
  if (mesh.format == MeshFormat::vtk) table.add_name("array", mesh.array, "the first of known names");
  table.add("scale", mesh.scale, 1.0, "-");
}

void list_mesh(Entries& table, const ArrayMesh&) {
  table.add_words("type", "arrays in the memory of the program that ran it", false);
}

}  // namespace

void list_bodies(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const Body& body : scene.bodies) {
    Entries table(all, "body." + body.name);
    table.add("material", body.material);
    table.add_numbers(body, {});
    table.add_words("axis", body.axis ? toml_text(*body.axis) : "not turned", !body.axis, "-");
    table.add("velocity_gradient", body.velocity_gradient, {}, "1/T");
    table.add_words("element", body.element ? "its own, below" : "that of the scene", !body.element);
    if (body.element) list_element(*body.element, "body." + body.name + ".element", all);
    Entries mesh(all, "body." + body.name + ".mesh");
    std::visit([&mesh](const auto& settings) { list_mesh(mesh, settings); }, body.mesh);
  }
}

}  // namespace pinball
