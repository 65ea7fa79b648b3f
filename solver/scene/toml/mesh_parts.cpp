#include <fmt/format.h>

#include <functional>

#include <solver/mesh/mesh_format.hpp>
#include <solver/scene/machine.hpp>
#include <solver/scene/schema/choices.hpp>
#include <solver/scene/schema/kinds.hpp>

#include "parts.hpp"
#include "read_keys.hpp"

namespace pinball {

namespace {

/// Times `refine`. Throws InputError if that is no int.
int refined(const SceneTable& table, std::string_view key, std::int64_t count, int refine) {
  int result = to_count(table, key, count);
  refine_count(table, key, refine, result);
  return result;
}

/// A mesh that could never be run. `elements` is a product that may not fit an integer.
void check_count(const SceneTable& table, std::string_view key, double elements, const MeshScale& scale) {
  constexpr double most = 5e8;  // nodes are numbered with 32 bits, and have four numbers each
  if (elements > most) table.fail(key, fmt::format("{:.3g} elements are more than a mesh can hold", elements));
  const double memory = memory_bytes(), needed = elements * scale.least_bytes;
  if (memory > 0 && needed > memory) {
    table.fail(key, fmt::format("{:.3g} elements are more than this machine's memory can hold: expected at most {:.3g} "
                                "for {:.3g} GiB",
                                elements, memory / scale.least_bytes, memory / 1073741824.0));
  }
}

MeshSettings read_block(const SceneTable& table, const MeshScale& scale) {
  BlockMesh mesh;
  const auto lengths = table.lists("size", schema::about<BlockMesh>("size").bound);
  const auto elements = table.integer_lists("elements", schema::lowest(schema::about<BlockMesh>("elements")));
  double count = 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (lengths[k].size() != elements[k].size()) {
      table.fail("elements", fmt::format("expected as many sections as of size along {}, {}, got {}", "xyz"[k],
                                         lengths[k].size(), elements[k].size()));
    }
    double along = 0.0;
    for (std::size_t s = 0; s < lengths[k].size(); ++s) {
      const int sections = refined(table, "elements", elements[k][s], scale.refine);
      mesh.size[k] += lengths[k][s];
      along += sections;
      if (lengths[k].size() > 1) mesh.sections[k].push_back({lengths[k][s], sections});
    }
    count *= along;
    check_count(table, "elements", count, scale);
    mesh.elements[k] = static_cast<int>(along);
  }
  return mesh;
}

MeshSettings read_rod(const SceneTable& table, const MeshScale& scale) {
  RoundNosedRodMesh mesh;
  read_keys(table, mesh, scale.refine);
  if (mesh.length <= mesh.radius) {
    table.fail("length",
               fmt::format("expected a number > radius = {}, the depth of the nose, got {}", mesh.radius, mesh.length));
  }
  const double across = (mesh.core[0] + 2.0 * mesh.ring) * (mesh.core[1] + 2.0 * mesh.ring);
  check_count(table, "layers", across * (static_cast<double>(mesh.layers) + mesh.ring), scale);
  return mesh;
}

/// A cut goes between two elements of the core, as it is without --refine.
void check_core(const SceneTable& table, Section section, std::int64_t core) {
  if (section != Section::full && section != Section::wedge && core % 2 != 0)
    table.fail("core", fmt::format("expected an even integer, since the section is cut through it, got {}", core));
}

MeshSettings read_cylinder(const SceneTable& table, const MeshScale& scale) {
  CylinderMesh mesh;
  read_keys(table, mesh, scale.refine);
  check_core(table, mesh.section, mesh.core / scale.refine);
  const double section = mesh.section == Section::wedge ? mesh.radial : mesh.core * (mesh.core + 4.0 * mesh.ring);
  check_count(table, "layers", section * mesh.layers, scale);
  return mesh;
}

MeshSettings read_sphere(const SceneTable& table, const MeshScale& scale) {
  SphereMesh mesh;
  read_keys(table, mesh, scale.refine);
  const std::int64_t least = schema::lowest(schema::about<SphereMesh>("core"));
  double elements = 0.0;
  if (mesh.section == Section::wedge) {
    const std::vector<std::int64_t> core = table.integers("core", 2, least);
    for (std::size_t k = 0; k < 2; ++k) mesh.core[k] = refined(table, "core", core[k], scale.refine);
    elements = (mesh.core[0] + static_cast<double>(mesh.ring)) * (mesh.core[1] + 2.0 * mesh.ring);
  } else {
    const std::int64_t given = table.integer("core", least);
    check_core(table, mesh.section, given);
    const int core = refined(table, "core", given, scale.refine);
    mesh.core = {core, core};
    elements = static_cast<double>(core) * core * (core + 6.0 * mesh.ring);
  }
  check_count(table, "core", elements, scale);
  return mesh;
}

MeshSettings read_file(const SceneTable& table, const MeshScale& scale, MeshFormat format) {
  FileMesh mesh;
  mesh.format = format;
  read_keys(table, mesh);
  if (scale.refine > 1)
    table.fail("file", fmt::format("--refine {}: expected 1, a mesh from a file cannot be refined; Gmsh itself can "
                                   "(gmsh -refine)",
                                   scale.refine));
  return mesh;
}

/// Any file, whose ending says what it is.
MeshSettings read_by_ending(const SceneTable& table, const MeshScale& scale) {
  const std::string file = table.text("file");
  const auto format = format_by_ending(file);
  if (!format) {
    table.fail("file", fmt::format("expected a file that ends in {}, or a type that says what it is, got \"{}\"",
                                   known_endings(), file));
  }
  if (*format != MeshFormat::vtk && table.has("array")) table.fail("array", "is for files of VTK alone");
  if (*format != MeshFormat::keyword && table.has("case")) table.fail("case", "is for LS-DYNA keyword files alone");
  return read_file(table, scale, *format);
}

}  // namespace

MeshSettings read_mesh(const SceneTable& body, const MeshScale& scale) {
  if (!body.has("mesh")) body.fail_missing("mesh", "a table such as { type = \"block\", size = ..., elements = ... }");
  using Reader = std::function<MeshSettings(const SceneTable&, const MeshScale&)>;
  std::vector<std::pair<std::string, Reader>> readers{{kind(schema::Of<BlockMesh>{}).name, read_block},
                                                      {kind(schema::Of<RoundNosedRodMesh>{}).name, read_rod},
                                                      {kind(schema::Of<CylinderMesh>{}).name, read_cylinder},
                                                      {kind(schema::Of<SphereMesh>{}).name, read_sphere},
                                                      {"file", read_by_ending}};
  for (const auto& format : schema::choices(schema::Of<MeshFormat>{})) {
    readers.emplace_back(format.name, [format](const SceneTable& table, const MeshScale& by) {
      return read_file(table, by, format.value);
    });
  }
  const SceneTable any = body.table("mesh", "mesh");
  const auto reader = any.choice<Reader>("type", readers);
  return reader(any.as(any.text("type")), scale);
}

}  // namespace pinball
