#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include <solver/mesh/mesh_format.hpp>

#include "machine.hpp"
#include "parts.hpp"

namespace pinball {

namespace {

/// Counts times `refine`, as int. Throws InputError if that overflows.
std::vector<int> refined(const SceneTable& table, std::string_view key, const std::vector<std::int64_t>& counts,
                         int refine) {
  std::vector<int> result;
  for (const auto count : counts) {
    if (count > std::numeric_limits<int>::max() / refine) {
      table.fail(key, fmt::format("{} elements in one direction are more than a mesh can hold",
                                  static_cast<double>(count) * refine));
    }
    result.push_back(static_cast<int>(count) * refine);
  }
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
  const auto lengths = table.lists("size", positive);
  const auto elements = table.integer_lists("elements", 1);
  double count = 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (lengths[k].size() != elements[k].size()) {
      table.fail("elements", fmt::format("expected as many sections as of size along {}, {}, got {}", "xyz"[k],
                                         lengths[k].size(), elements[k].size()));
    }
    const std::vector<int> counts = refined(table, "elements", elements[k], scale.refine);
    double along = 0.0;
    for (std::size_t s = 0; s < counts.size(); ++s) {
      mesh.size[k] += lengths[k][s];
      along += counts[s];
      if (counts.size() > 1) mesh.sections[k].push_back({lengths[k][s], counts[s]});
    }
    count *= along;
    check_count(table, "elements", count, scale);
    mesh.elements[k] = static_cast<int>(along);
  }
  return mesh;
}

MeshSettings read_rod(const SceneTable& table, const MeshScale& scale) {
  RoundNosedRodMesh mesh;
  mesh.radius = table.number("radius", positive);
  mesh.length = table.number("length", positive);
  if (mesh.length <= mesh.radius) {
    table.fail("length",
               fmt::format("expected a number > radius = {}, the depth of the nose, got {}", mesh.radius, mesh.length));
  }
  mesh.half = table.boolean("half", mesh.half);
  std::vector<std::int64_t> core(mesh.core.begin(), mesh.core.end());
  if (table.has("core")) core = table.integers("core", 2, 1);
  const auto core_counts = refined(table, "core", core, scale.refine);
  std::copy_n(core_counts.begin(), 2, mesh.core.begin());
  mesh.ring = refined(table, "ring", {table.integer("ring", 1, mesh.ring)}, scale.refine)[0];
  mesh.layers = refined(table, "layers", {table.integer("layers", 1)}, scale.refine)[0];
  const double across = (static_cast<double>(mesh.core[0]) + 2.0 * mesh.ring) * (mesh.core[1] + 2.0 * mesh.ring);
  check_count(table, "layers", across * (static_cast<double>(mesh.layers) + mesh.ring), scale);
  return mesh;
}

int refined_count(const SceneTable& table, std::string_view key, int fallback, int refine) {
  const std::int64_t count = fallback > 0 ? table.integer(key, 1, fallback) : table.integer(key, 1);
  return refined(table, key, {count}, refine)[0];
}

Section read_section(const SceneTable& table) {
  return table.choice<Section>(
      "section",
      {{"full", Section::full}, {"half", Section::half}, {"quarter", Section::quarter}, {"wedge", Section::wedge}},
      Section::full);
}

/// Keys that only wedges or only the other sections have are an error elsewhere.
void require_absent(const SceneTable& table, std::initializer_list<std::string_view> keys, std::string_view reason) {
  for (const auto key : keys)
    if (table.has(key)) table.fail(key, fmt::format("not used {}", reason));
}

double read_angle(const SceneTable& table) {
  return table.number("angle", {.low = 0.0, .low_open = true, .high = largest_wedge_angle});
}

/// Elements along a side of the full core; a cut goes between two of them.
int read_core(const SceneTable& table, Section section, int refine) {
  const std::int64_t count = table.integer("core", 1);
  if (section != Section::full && count % 2 != 0)
    table.fail("core", fmt::format("expected an even integer, since the section is cut through it, got {}", count));
  return refined(table, "core", {count}, refine)[0];
}

MeshSettings read_cylinder(const SceneTable& table, const MeshScale& scale) {
  CylinderMesh mesh;
  mesh.radius = table.number("radius", positive);
  mesh.length = table.number("length", positive);
  mesh.section = read_section(table);
  mesh.layers = refined_count(table, "layers", 0, scale.refine);
  double section = 0.0;
  if (mesh.section == Section::wedge) {
    require_absent(table, {"core", "ring"}, "where section = \"wedge\", which has radial");
    mesh.angle = read_angle(table);
    mesh.radial = refined_count(table, "radial", 0, scale.refine);
    section = mesh.radial;
  } else {
    require_absent(table, {"angle", "radial"}, "where section is not \"wedge\"");
    mesh.core = read_core(table, mesh.section, scale.refine);
    mesh.ring = refined_count(table, "ring", 1, scale.refine);
    section = mesh.core * (mesh.core + 4.0 * mesh.ring);
  }
  check_count(table, "layers", section * mesh.layers, scale);
  return mesh;
}

MeshSettings read_sphere(const SceneTable& table, const MeshScale& scale) {
  SphereMesh mesh;
  mesh.radius = table.number("radius", positive);
  mesh.section = read_section(table);
  mesh.ring = refined_count(table, "ring", 1, scale.refine);
  mesh.grading = table.number("grading", {.low = 0.0, .low_open = true, .high = 1.0}, mesh.grading);
  double elements = 0.0;
  if (mesh.section == Section::wedge) {
    mesh.angle = read_angle(table);
    const auto core = refined(table, "core", table.integers("core", 2, 1), scale.refine);
    std::copy_n(core.begin(), 2, mesh.core.begin());
    elements = (mesh.core[0] + static_cast<double>(mesh.ring)) * (mesh.core[1] + 2.0 * mesh.ring);
  } else {
    require_absent(table, {"angle"}, "where section is not \"wedge\"");
    const int core = read_core(table, mesh.section, scale.refine);
    mesh.core = {core, core};
    elements = static_cast<double>(core) * core * (core + 6.0 * mesh.ring);
  }
  check_count(table, "core", elements, scale);
  return mesh;
}

/// part_key: what the format calls a part.
MeshSettings read_file(const SceneTable& table, const MeshScale& scale, MeshFormat format, std::string_view part_key) {
  FileMesh mesh;
  mesh.format = format;
  mesh.file = table.text("file");
  mesh.part = table.text(part_key, "");
  mesh.scale = table.number("scale", positive, mesh.scale);
  if (format == MeshFormat::keyword && table.has("case")) mesh.chosen_case = table.integer("case", 0);
  if (format == MeshFormat::vtk) mesh.array = table.text("array", "");
  if (scale.refine > 1)
    table.fail("file", fmt::format("--refine {}: expected 1, a mesh from a file cannot be refined; Gmsh itself can "
                                   "(gmsh -refine)",
                                   scale.refine));
  return mesh;
}

MeshSettings read_gmsh(const SceneTable& table, const MeshScale& scale) {
  return read_file(table, scale, MeshFormat::gmsh, "physical");
}

template <MeshFormat Format>
MeshSettings read_parts(const SceneTable& table, const MeshScale& scale) {
  return read_file(table, scale, Format, "part");
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
  return read_file(table, scale, *format, "part");
}

}  // namespace

/// Peaks of memory of one step of an elastic cube of 10^6 elements (5 * 10^5 with contact), in single and double
/// precision: 279 and 433 bytes per element with viscous hourglass forces and nothing else, 370 and 618 with stiffness,
/// 573 and 850 with bulk viscosity and contact, too. What is assumed is a tenth less.
double least_bytes_of_element(const Scene& scene, const ElementSettings& element) {
  const double number = scene.precision == Precision::float32 ? sizeof(float) : sizeof(double);
  const bool state = element.hourglass != HourglassControl::none && element.hourglass != HourglassControl::viscous;
  const ContactMethod method = scene.contact.method;
  const bool contact = method == ContactMethod::pinball || method == ContactMethod::slideline;
  const double measured = 125 + 38 * number + (state ? 23 * number : 0) + (contact ? 165 + 6 * number : 0);
  return 0.9 * measured;
}

MeshSettings read_mesh(const SceneTable& body, const MeshScale& scale) {
  if (!body.has("mesh")) body.fail_missing("mesh", "a table such as { type = \"block\", size = ..., elements = ... }");
  using Reader = MeshSettings (*)(const SceneTable&, const MeshScale&);
  const std::vector<std::pair<std::string, Reader>> readers{{"block", read_block},
                                                            {"round_nosed_rod", read_rod},
                                                            {"cylinder", read_cylinder},
                                                            {"sphere", read_sphere},
                                                            {"file", read_by_ending},
                                                            {"gmsh", read_gmsh},
                                                            {"keyword", read_parts<MeshFormat::keyword>},
                                                            {"exodus", read_parts<MeshFormat::exodus>},
                                                            {"vtk", read_parts<MeshFormat::vtk>},
                                                            {"abaqus", read_parts<MeshFormat::abaqus>}};
  const SceneTable any = body.table("mesh", "mesh");
  const Reader reader = any.choice<Reader>("type", readers);
  // Read again as that kind, so that the keys of the others are unknown.
  return reader(body.table("mesh", any.text("type")), scale);
}

}  // namespace pinball
