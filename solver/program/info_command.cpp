#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/base/thread_count.hpp>
#include <solver/formats/deck_reader.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/mesh_format.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/output/history.hpp>
#include <solver/results/warnings.hpp>
#include <solver/scene/units/units.hpp>
#include <solver/scene_rules.hpp>
#include <solver/step/report.hpp>
#include <solver/step/solver.hpp>

#include "commands.hpp"
#include "info/info_boundary.hpp"
#include "info/info_cost.hpp"
#include "info/info_devices.hpp"
#include "info/info_material.hpp"
#include "info/info_mesh.hpp"
#include "info/info_ranks.hpp"
#include "info/info_rigid.hpp"
#include "info/info_skipped.hpp"
#include "scene_input.hpp"

namespace pinball {

namespace {

std::string volume_text(double volume, const Units& units) {
  return fmt::format("volume {:.10g}{}", volume, units.length.empty() ? "" : " " + units.length + "^3");
}

/// Of a body from a file as it lies in the model: the file is not read again.
MeshQuality quality_of(const ModelMesh& mesh, const Body& body, std::int32_t number, Mesh& all_nodes) {
  if (!std::holds_alternative<FileMesh>(body.mesh)) return measure_quality(generate(body.mesh));
  if (all_nodes.nodes.empty()) all_nodes.nodes = mesh.nodes;
  all_nodes.hexahedra.clear();
  for (std::size_t e = 0; e < mesh.body.size(); ++e) {
    if (mesh.body[e] == number) all_nodes.hexahedra.push_back(mesh.hexahedra[e]);
  }
  return measure_quality(all_nodes);
}

/// Those that it shares among them.
std::int64_t nodes_of_body(const ModelMesh& mesh, std::int32_t number) {
  return std::ranges::count(mesh.body_of_node, number) + std::ssize(mesh.shared[number]);
}

std::string velocity_text(const Body& body, const Units& units) {
  std::string text = "velocity " + vector_text(body.velocity, units.velocity);
  if (body.angular_velocity != Point{}) text += ", turning with " + vector_text(body.angular_velocity, per_time(units));
  if (body.velocity_gradient != std::array<Point, 3>{}) {
    const auto& [x, y, z] = body.velocity_gradient;
    text += fmt::format(", with a gradient of rows {}, {}, {}", vector_text(x, ""), vector_text(y, ""),
                        vector_text(z, per_time(units)));
  }
  if (body.velocity_noise > 0) text += ", noise of up to " + with_unit(body.velocity_noise, units.velocity);
  return text;
}

template <class S>
void print_bodies(const Model<S>& model, const Units& units) {
  fmt::print("bodies\n");
  double volume = 0;
  Mesh all_nodes;
  for (std::size_t b = 0; b < model.scene.bodies.size(); ++b) {
    const Body& body = model.scene.bodies[b];
    const std::int32_t number = b;
    double mass = 0, added = 0;
    for (std::size_t e = 0; e < model.mesh.body.size(); ++e) {
      if (model.mesh.body[e] != number) continue;
      mass += model.element_mass[e];
      if (!model.added_mass.empty()) added += model.added_mass[e];
    }
    fmt::print("  {}: {}, {}, mass {}, of {}\n", body.name,
               counted(std::count(model.mesh.body.begin(), model.mesh.body.end(), number), "element"),
               counted(nodes_of_body(model.mesh, number), "node"), with_unit(mass, units.mass), body.material);
    if (added != 0) {
      fmt::print("    of its mass {} is added (time.smallest_step), {:.3g} % of that of its material\n",
                 with_unit(added, units.mass), 100 * added / (mass - added));
    }
    const MeshQuality q = quality_of(model.mesh, body, number, all_nodes);
    volume += q.volume;
    fmt::print("    {}\n", volume_text(q.volume, units));
    fmt::print("    mesh: {}\n", quality_text(q, units.length));
    fmt::print("    {}\n", velocity_text(body, units));
  }
  if (model.scene.bodies.size() > 1) fmt::print("  all: {}\n", volume_text(volume, units));
}

void print_materials(const Scene& scene, const Units& units) {
  fmt::print("materials\n");
  for (const Material& m : scene.materials) {
    const double wave_modulus = m.bulk_modulus + 4.0 / 3.0 * m.shear_modulus;
    fmt::print("  {} ({}): density {}, bulk modulus {}, shear modulus {}\n", m.name,
               m.fluid               ? "fluid"
               : m.johnson_holmquist ? "brittle"
               : m.drucker_prager    ? "granular"
               : m.crushable_foam    ? "foam"
               : m.plastic           ? "von Mises"
                                     : "elastic",
               with_unit(m.density, units.density), with_unit(m.bulk_modulus, units.stress),
               with_unit(m.shear_modulus, units.stress));
    fmt::print("    velocity of longitudinal waves {}\n",
               with_unit(std::sqrt(wave_modulus / m.density), units.velocity));
    if (m.mooney_rivlin)
      fmt::print("    Mooney-Rivlin: A {}, B {}\n", with_unit(m.mooney_rivlin->a, units.stress),
                 with_unit(m.mooney_rivlin->b, units.stress));
    if (const auto& law = m.ogden)
      fmt::print("    Ogden: {} of {}\n", counted(law->moduli.size(), "power"),
                 law->whole ? "the stretches" : "the stretches of shape");
    if (const auto& law = m.orthotropic)
      fmt::print("    orthotropic: E {}, {}, {}\n", with_unit(law->young_moduli[0], units.stress),
                 with_unit(law->young_moduli[1], units.stress), with_unit(law->young_moduli[2], units.stress));
    if (m.plastic) print_hardening(m, units);
    if (m.erosion) print_limits(*m.erosion, units);
  }
}

std::string hourglass_text(double coefficient, HourglassKind kind) {
  if (kind == HourglassKind::assumed_strain) {
    return coefficient == 1 ? "assumed-strain hourglass control"
                            : fmt::format("assumed-strain hourglass control, factor {:.4g}", coefficient);
  }
  const char* form = kind == HourglassKind::stiffness ? "stiffness" : "viscous";
  return coefficient >= 0 ? fmt::format("hourglass control, {} form, coefficient {:.4g}", form, coefficient)
                          : fmt::format("hourglass control, {} form", form);
}

/// The bodies that have these settings in the place of the scene's.
std::string own_settings_text(const Scene& scene, const ElementSettings& settings, const std::string& material) {
  std::string names;
  for (const Body& body : scene.bodies) {
    if (body.material != material || !body.element || *body.element != settings) continue;
    names += (names.empty() ? " in " : ", ") + body.name;
  }
  return names;
}

std::string output_text(const Scene& scene, const Units& units) {
  const OutputSettings& o = scene.output;
  const double interval = o.interval > 0 ? o.interval : scene.time.end / 200;
  std::string text = o.every_step ? "summary, history of every step"
                                  : fmt::format("summary, history every {}", with_unit(interval, units.time));
  if (!scene.probes.empty()) {
    text += fmt::format(" with {}", counted(scene.probes.size(), "probe"));
  }
  std::string when;
  if (o.field_interval > 0) when = fmt::format("every {}", with_unit(o.field_interval, units.time));
  if (!o.field_times.empty()) {
    when += fmt::format("{}at {} given time{}", when.empty() ? "" : " and ", o.field_times.size(),
                        o.field_times.size() == 1 ? "" : "s");
  }
  if (when.empty()) return text;
  std::string fields;
  for (const std::string& field : o.fields) fields += (fields.empty() ? "" : ", ") + field;
  return text + fmt::format(", fields {} ({})", when, fields);
}

template <class S>
void print_contact(const ContactAlgorithm<S>& contact, const Scene& scene, std::int64_t elements) {
  const ContactSettings& c = scene.contact;
  const bool pinball = c.method == ContactMethod::pinball;
  std::string how;
  if (c.enforcement == Enforcement::penalty) {
    how = fmt::format(", beta {:.4g}, damping {:.4g} of critical", c.beta, c.damping);
  } else if (pinball) {
    how = fmt::format(", gap between {}", c.gap == ContactGap::face ? "faces" : "pinballs");
  }
  if (pinball) how += c.radius == ContactRadius::initial ? ", initial radius" : ", current radius";
  if (c.static_friction > c.friction) {
    how += fmt::format(", friction {:.4g} at rest and {:.4g} sliding", c.static_friction, c.friction);
  } else if (c.friction > 0) {
    how += fmt::format(", friction {:.4g}", c.friction);
  }
  if (c.self && scene.contact_pairs.empty()) how += ", bodies may touch themselves";
  fmt::print("  contact: {} on {}, {} enforcement{}\n", pinball ? "pinballs" : "slideline: nodes against faces",
             counted_of(contact.surface_elements(), elements, "element"), enforcement_name(c.enforcement), how);
}

void print_search(const Scene& scene) {
  const ContactSettings& c = scene.contact;
  const char* how = c.method == ContactMethod::slideline || c.search == ContactSearch::tree ? "by a tree"
                    : c.search == ContactSearch::hash                                       ? "by a hash"
                                                                                            : "by what suits the scene";
  if (scene.skip.contact_search) {
    fmt::print("  contact search: {}, when a node has strayed from its straight way, skin {:.4g} radii\n", how, c.skin);
  } else {
    fmt::print("  contact search: {}, at every step\n", how);
  }
}

/// Elements by the steps that they make.
template <class S>
void print_steps(const Subcycling<S>& subcycling) {
  const std::vector<std::int64_t> elements = subcycling.elements_of_levels();
  std::string text;
  double all = 0, computed = 0;
  for (std::size_t level = 0; level < elements.size(); ++level) {
    all += elements[level];
    computed += std::ldexp(static_cast<double>(elements[level]), -static_cast<int>(level));
    if (elements[level] == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counted(elements[level], "element makes", "elements make"),
                        level == 0 ? "the smallest step" : fmt::format("{} times it", 1 << level));
  }
  fmt::print("  steps: {}; {:.3g} % of the element steps are computed\n", text, 100 * computed / all);
}

template <class S>
void print_what_runs(const Solver<S>& solver, const Units& units) {
  const Model<S>& model = solver.model();
  const Scene& scene = model.scene;
  fmt::print("what will run\n");
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (model.parts[p].rigid) continue;
    const ElementFeatures& f = model.parts[p].features;
    const Material& material = scene.materials[model.parts[p].material];
    const ElementSettings& settings = model.parts[p].settings;
    fmt::print("  elements of {}{}: {}", material.name, own_settings_text(scene, settings, material.name),
               material.fluid     ? "flow of a fluid"
               : material.plastic ? "plasticity"
                                  : "elasticity");
    if (material.plastic && material.erosion_strain > 0) {
      fmt::print(", erosion at plastic strain {:.4g}", material.erosion_strain);
    }
    if (erodes_by_damage(material)) fmt::print(", erosion at damage 1");
    if (material.erosion) fmt::print(", erosion beyond limits");
    if (model.constants[p].failure.negative_volume) fmt::print(", erosion of inverted elements");
    if (f.hourglass != HourglassKind::none)
      fmt::print(", {}", hourglass_text(settings.hourglass_coefficient, f.hourglass));
    if (f.bulk_viscosity) {
      fmt::print(", bulk viscosity (linear {:.4g}, quadratic {:.4g})", settings.linear_viscosity,
                 settings.quadratic_viscosity);
    }
    fmt::print("\n");
  }
  print_rigid_bodies(scene, solver.rigid().results(), units);
  if (solver.subcycling() != nullptr) print_steps(*solver.subcycling());
  if (solver.contact() != nullptr) {
    print_contact(*solver.contact(), scene, model.element_count());
    print_search(scene);
    for (const ContactPair& pair : scene.contact_pairs) {
      fmt::print("  contact pair {}: friction {:.4g} at rest, {:.4g} sliding{}{}\n", pair.name, pair.static_friction,
                 pair.friction, pair.second.empty() ? ", of its first side alone" : "",
                 span_text({pair.start, pair.end}, units));
    }
  }
  if (!model.look.contact_because.empty()) fmt::print("  {}\n", model.look.contact_because);
  for (const TiedResult& tied : model.tie_counts) fmt::print("  tied contact {}\n", tied_text(tied));
  print_boundary_conditions(model, units);
  fmt::print("  output: {}\n", output_text(scene, units));
}

/// What a run warns of before its first step, too, but for its meshes, which have been printed.
template <class S>
void print_start_warnings(const Solver<S>& solver) {
  RunSummary summary;
  fill_summary(solver, summary);
  summary.mesh_warnings.clear();
  for (const std::string& sentence : start_warnings(summary)) fmt::print("warning: {}\n", sentence);
}

/// Returns the scene with all that its bodies decide.
template <class S>
Scene print_info(const Scene& scene, int threads, SpentSoFar spent) {
  const Units units = parse_units(scene.units);
  if (threads > 0) DefaultExecutionSpace::set_concurrency(threads);  // others would wait, and be counted, from now on
  Solver<S> solver(scene);
  spent.built = processor_seconds();
  history_column_names(names_of(scene.bodies), more_columns(solver));  // refused here, too
  DefaultExecutionSpace::set_concurrency(threads > 0 ? threads : earned_threads(solver.element_count()));
  fmt::print("{}: {}\n", scene.name, scene.title.empty() ? "(no title)" : scene.title);
  fmt::print("  {}; {} precision", units_line(scene.units), name_of(scene.precision));
  if (scene.refine > 1) fmt::print("; meshes refined {} times", scene.refine);
  fmt::print("\n  {}{}, {}, {}, end at {}\n", counted(solver.element_count(), "element"),
             other_shapes(solver.mesh().hexahedra), counted(solver.mesh().nodes.size(), "node"),
             counted(scene.bodies.size(), "body", "bodies"), with_unit(scene.time.end, units.time));
  print_bodies(solver.model(), units);
  print_mesh_files(solver.mesh());
  print_materials(scene, units);
  print_what_runs(solver, units);
  print_what_is_skipped(solver, units);
  print_start_warnings(solver);
  print_cost(solver, units, spent);
  return solver.scene();
}

/// Lists a mesh file, or a deck that is no more than a mesh, and so cannot be run. False: it is neither.
bool print_mesh_alone(const std::string& path) {
  const auto format = format_by_ending(path);
  if (!format || (is_any_deck(path) && !is_mesh_alone(path))) return false;
  print_mesh_file(path, *format);
  return true;
}

/// None: what it has is a mesh, which is listed.
std::optional<Scene> read_or_list(const InfoOptions& options) {
  if (format_by_ending(options.scene) && !is_any_deck(options.scene)) {
    print_mesh_alone(options.scene);
    return std::nullopt;
  }
  try {
    return scene_input(options).read();
  } catch (const InputError& error) {
    if (!is_any_deck(options.scene) || !print_mesh_alone(path_of_scene(options.scene))) throw;
    fmt::print("  by itself it cannot be run: {}\n", error.what());
    return std::nullopt;
  }
}

}  // namespace

int info_command(const InfoOptions& options) {
  const SpentSoFar spent{processor_seconds()};
  if (options.devices) print_devices();
  if (options.scene.empty()) {
    if (options.devices) return 0;
    throw InputError("info: expected a SCENE, or --device");
  }
  const std::optional<Scene> read = read_or_list(options);
  if (!read) return 0;
  const Scene& scene = *read;
  const bool single = scene.precision == Precision::float32;
  const Scene decided =
      single ? print_info<float>(scene, options.threads, spent) : print_info<double>(scene, options.threads, spent);
  if (options.devices) print_missing_on_devices(decided);
  if (options.ranks.empty()) return 0;
  fmt::print("\n");
  if (single) {
    print_ranks<float>(scene, options.ranks);
  } else {
    print_ranks<double>(scene, options.ranks);
  }
  return 0;
}

}  // namespace pinball
