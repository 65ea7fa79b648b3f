#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include <solver/base/error.hpp>
#include <solver/mesh/file/input_file.hpp>
#include <solver/scene.hpp>
#include <solver/scene/given/given_scene.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <solver/scene/material/known_materials.hpp>
#include <solver/scene/names.hpp>
#include <solver/scene/schema/kinds.hpp>
#include <solver/scene/units/units.hpp>

#include "boundary_parts.hpp"
#include "contact_parts.hpp"
#include "overrides.hpp"
#include "parts.hpp"
#include "read_keys.hpp"
#include "rigid_parts.hpp"
#include "table.hpp"

namespace pinball {

namespace {

TimeSettings read_time(const SceneTable& table) {
  TimeSettings time;
  read_keys(table, time);
  table.require_none(problem_of(time));
  return time;
}

ContactSettings read_contact(const SceneTable& table) {
  ContactSettings contact;
  read_keys(table, contact);
  complete(contact);
  table.require_none(problem_of(contact));
  return contact;
}

OutputSettings read_output(const SceneTable& table) {
  OutputSettings output;
  output.every_step = table.is_text("interval") && table.choice<bool>("interval", {{"step", true}});
  if (!output.every_step && table.has("interval")) {
    output.interval = table.number("interval", schema::about<OutputSettings>("interval").bound);
  }
  read_keys(table, output);
  std::sort(output.field_times.begin(), output.field_times.end());
  return output;
}

/// A mesh file is named relative to the folder of the scene. Throws InputError if there is none.
void find_mesh_file(const SceneTable& body, FileMesh& mesh, const std::string& scene_path) {
  const auto path = std::filesystem::path(scene_path).parent_path() / mesh.file;
  if (!std::filesystem::is_regular_file(path)) {
    body.table("mesh", "mesh").fail("file", fmt::format("expected a mesh file, there is no {}", path.string()));
  }
  mesh.file = path.string();
}

/// What touches what; bodies are known by now.
void read_contact_parts(const SceneTable& contact, Scene& scene) {
  const Names bodies(scene.bodies);
  Names pairs, ties;
  for (const SceneTable& table : contact.tables("pair", "contact_pair")) {
    const ContactPair pair = read_contact_pair(table, scene, bodies);
    table.require_none(pairs.add(pair.name, table.where("name")));
    scene.contact_pairs.push_back(pair);
  }
  for (const SceneTable& table : contact.tables("tied", "contact_tied")) {
    const TiedContact tied = read_tied_contact(table, scene, bodies);
    table.require_none(ties.add(tied.name, table.where("name")));
    scene.tied_contacts.push_back(tied);
  }
}

/// What acts from outside, and probes; bodies are known by now.
void read_boundary(const SceneTable& top, Scene& scene) {
  const Names bodies(scene.bodies);
  const auto tables = [&](std::string_view key) {
    auto all = top.tables(key, key);
    for (const SceneTable& table : all) {
      if (table.has("body")) table.require_none(bodies.reference_problem("body", "body", table.text("body")));
    }
    return all;
  };
  std::vector<std::pair<SceneTable, std::string>> forces;
  constexpr schema::Kind symmetry = kind(schema::Of<PlaneConstraint>{}), fixed = kind(schema::Of<FixedConstraint>{});
  for (const auto& any : tables("constraint")) {
    const bool is_fixed = any.choice<bool>("type", {{symmetry.name, false}, {fixed.name, true}});
    const SceneTable table = any.as(is_fixed ? fixed.name : symmetry.name);
    if (!is_fixed) {
      scene.constraints.push_back(read_symmetry(table));
      forces.emplace_back(table, scene.constraints.back().name);
    } else {
      scene.fixed_constraints.push_back(read_fixed_constraint(table));
      forces.emplace_back(table, scene.fixed_constraints.back().name);
    }
  }
  for (const auto& table : tables("equation")) scene.equation_terms.push_back(read_equation_term(table));
  Names walls;
  for (const auto& table : tables("rigid_wall")) {
    const RigidWall wall = read_rigid_wall(table, scene.rigid_walls.size());
    table.require_none(walls.add(wall.name, table.where("name")));
    scene.rigid_walls.push_back(wall);
  }
  for (const auto& table : tables("prescribed_velocity")) {
    scene.prescribed_velocities.push_back(read_prescribed_velocity(table));
    forces.emplace_back(table, scene.prescribed_velocities.back().name);
  }
  for (const auto& table : tables("load")) scene.loads.push_back(read_load(table));
  Names pressures;
  for (const auto& table : tables("pressure")) {
    const Pressure pressure = read_pressure(table, scene.pressures.size());
    table.require_none(pressures.add(pressure.name, table.where("name")));
    scene.pressures.push_back(pressure);
  }
  std::vector<std::string> names;
  for (const Body& body : scene.bodies) names.push_back(body.name);
  for (const auto& table : tables("gravity")) {
    scene.gravities.push_back(read_gravity(table, names));
    forces.emplace_back(table, scene.gravities.back().name);
  }
  for (const auto& [table, name] : forces) table.require_none(force_name_problem(name, scene));
  for (const auto& table : tables("point_mass")) scene.point_masses.push_back(read_point_mass(table));
  for (const auto& table : tables("initial_velocity")) {
    scene.initial_velocities.push_back(read_initial_velocity(table));
  }
  for (const auto& table : tables("initial_stress")) scene.initial_stresses.push_back(read_initial_stress(table));
  Names columns(scene.bodies);  // of history.csv
  for (const auto& table : tables("probe")) {
    const Probe probe = read_probe(table);
    table.require_none(columns.add(probe.name, table.where("name")));
    scene.probes.push_back(probe);
  }
}

/// What a scene is read from.
struct Given {
  const GivenTable& table;
  std::string path;
  std::string where;  ///< of what is missing
};

Scene read_tables(const GivenTable& root, const Given& given, const SceneOverrides& overrides) {
  const SceneTable top(root, "", given.where, "scene");
  const std::string& path = given.path;
  Scene scene;
  scene.path = path;
  scene.name = std::filesystem::path(path).stem().string();
  scene.refine = overrides.refine;
  read_keys(top, scene);
  top.require_none(units_problem(scene.units));
  if (overrides.precision) scene.precision = *overrides.precision;
  scene.time = read_time(top.table("time", "time"));
  scene.element = read_element(top.table("element", "element"), {});
  scene.contact = read_contact(top.table("contact", "contact"));
  read_keys(top.table("skip", "skip"), scene.skip);
  read_keys(top.table("guard", "guard"), scene.guard);
  scene.output = read_output(top.table("output", "output"));

  Names materials, body_names;
  for (const auto& table : top.tables("material", "material")) {
    if (table.has("use") && !parse_units(scene.units).known()) {
      table.fail("use", "expected `units` of the scene, in which the values are to be, got none");
    }
    const Material material = read_material(table);
    table.require_none(materials.add(material.name, table.where("name")));
    scene.materials.push_back(material);
  }
  const auto bodies = top.tables("body", "body");
  if (bodies.empty()) top.fail("body", "missing, expected at least one [[body]]");
  for (const auto& table : bodies) {
    Body body = read_body(table, scene);
    if (auto* file = std::get_if<FileMesh>(&body.mesh)) find_mesh_file(table, *file, path);
    table.require_none(body_names.add(body.name, table.where("name")));
    table.require_none(materials.reference_problem("material", "material", body.material));
    table.require_none(problem_of(body, scene));
    scene.bodies.push_back(body);
  }
  read_contact_parts(top.table("contact", "contact"), scene);
  read_rigid_bodies(top, scene);
  read_keys(top.table("damping", "damping"), scene.damping);
  read_boundary(top, scene);
  return scene;
}

/// A change that the command line asks for.
struct Change {
  std::string option;
  std::string text;  ///< KEY=VALUE, or the name of a variant
};

struct Changes {
  std::vector<Change> variants;  ///< applied before keys
  std::vector<Change> keys;
};

void sort_changes(const std::string& option, const std::vector<std::string>& texts, Changes& changes) {
  for (const auto& text : texts) {
    const Override change = parse_override(option, text);
    if (change.key != "variant") {
      changes.keys.push_back({option, text});
    } else if (const auto* name = change.value.as<std::string>()) {
      const auto same = [&name](const Change& earlier) { return earlier.text == *name; };
      if (std::none_of(changes.variants.begin(), changes.variants.end(), same)) {
        changes.variants.push_back({option, *name});
      }
    } else {
      fail(change.where, "variant", "expected the name of a variant");
    }
  }
}

/// With variants and keys applied, read and checked.
Scene read_changed(const Given& given, const Changes& changes, const SceneOverrides& overrides) {
  GivenTable root = given.table;
  for (const auto& [option, name] : changes.variants) {
    apply_variant(root, name, fmt::format("{} variant={}", option, name));
  }
  for (const auto& [option, key_value] : changes.keys) apply_override(root, parse_override(option, key_value));
  take_known_materials(root);
  return read_tables(root, given, overrides);
}

/// A variant must fit the scene even if nobody asks for it now. A file that is complete only with some keys of the
/// command line is checked with these.
void check_variants(const Given& given, const std::vector<Change>& keys) {
  const std::vector<std::string> names = variant_names(given.table, given.path);
  if (names.empty()) return;
  std::vector<Change> needed;
  try {
    read_changed(given, {}, {});
  } catch (const InputError&) {
    needed = keys;
  }
  for (const auto& name : names) {
    try {
      read_changed(given, {{{"--set", name}}, needed}, {});
    } catch (const InputError& error) {
      throw InputError(fmt::format("{} (in variant {})", error.what(), name));
    }
  }
}

}  // namespace

SceneSource read_scene_source(const std::string& path, const SceneOverrides& overrides) {
  return {path, bytes_of_file(path), overrides, {}};
}

Scene read_scene(const std::string& path, const SceneOverrides& overrides) {
  return read_scene(read_scene_source(path, overrides));
}

namespace {

/// What a deck has beside its keys.
void take_from_deck(const GivenScene& deck, Scene& scene) {
  scene.of_deck = !deck.contact_said;
  for (Body& body : scene.bodies) {
    if (auto* file = std::get_if<FileMesh>(&body.mesh)) file->held = deck.mesh;
  }
}

}  // namespace

Scene read_scene(const SceneSource& source) {
  const SceneOverrides& overrides = source.overrides;
  if (overrides.refine < 1) {
    throw InputError(fmt::format("--refine {}: expected an integer >= 1, got {}", overrides.refine, overrides.refine));
  }
  Changes changes;
  sort_changes("--set", overrides.set, changes);
  sort_changes("--vary", overrides.vary, changes);
  const GivenTable table = source.given ? GivenTable() : parse_toml(source.text, source.path);
  const Given given{source.given ? source.given->table : table, source.path,
                    source.given ? source.path : source.path + ":1:1"};
  Scene scene = read_changed(given, changes, overrides);
  check_variants(given, changes.keys);
  if (source.given) take_from_deck(*source.given, scene);
  return scene;
}

}  // namespace pinball
