#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <pinball/solver/error.hpp>
#include <pinball/solver/scene.hpp>
#include <pinball/solver/scene_boundary_parts.hpp>
#include <pinball/solver/scene_override.hpp>
#include <pinball/solver/scene_parts.hpp>
#include <pinball/solver/scene_table.hpp>
#include <pinball/solver/text_distance.hpp>
#include <sstream>

namespace pinball {

namespace {

TimeSettings read_time(const SceneTable& table) {
  TimeSettings time;
  time.end = table.number("end", positive);
  time.cfl = table.number("cfl", {.low = 0.0, .low_open = true, .high = 1.2}, time.cfl);
  time.steps = table.integer("steps", -1, time.steps);
  if (time.steps == 0) table.fail("steps", "expected an integer >= 1, or -1 for no limit, got 0");
  time.subcycling = table.boolean("subcycling", time.subcycling);
  return time;
}

ElementSettings read_element(const SceneTable& table) {
  ElementSettings element;
  element.hourglass = table.choice<HourglassControl>("hourglass",
                                                     {{"none", HourglassControl::none},
                                                      {"viscous", HourglassControl::viscous},
                                                      {"stiffness", HourglassControl::stiffness},
                                                      {"assumed_strain", HourglassControl::assumed_strain}},
                                                     element.hourglass);
  // A coefficient that was meant for one form would mean something else to another.
  if (table.has("hourglass_coefficient") && !table.has("hourglass")) {
    table.fail("hourglass_coefficient", "needs hourglass beside it, the form that it is a coefficient of");
  }
  element.hourglass_coefficient =
      table.number("hourglass_coefficient", not_negative, default_hourglass_coefficient(element.hourglass));
  element.bulk_viscosity = table.boolean("bulk_viscosity", element.bulk_viscosity);
  element.linear_viscosity = table.number("linear_viscosity", not_negative, element.linear_viscosity);
  element.quadratic_viscosity = table.number("quadratic_viscosity", not_negative, element.quadratic_viscosity);
  if (table.has("negative_volume")) {
    element.negative_volume = table.choice<NegativeVolume>(
        "negative_volume", {{"stop", NegativeVolume::stop}, {"erode", NegativeVolume::erode}});
  }
  return element;
}

ContactSettings read_contact(const SceneTable& table) {
  ContactSettings contact;
  contact.method = table.choice<ContactMethod>(
      "method",
      {{"none", ContactMethod::none}, {"pinball", ContactMethod::pinball}, {"slideline", ContactMethod::slideline}},
      contact.method);
  contact.enforcement = table.choice<Enforcement>(
      "enforcement",
      {{"penalty", Enforcement::penalty}, {"projection", Enforcement::projection}, {"lagrange", Enforcement::lagrange}},
      contact.enforcement);
  const bool penalty = contact.enforcement == Enforcement::penalty;
  contact.gap = table.choice<ContactGap>("gap", {{"pinball", ContactGap::pinball}, {"face", ContactGap::face}},
                                         penalty ? ContactGap::pinball : ContactGap::face);
  if (contact.method != ContactMethod::slideline && penalty && contact.gap == ContactGap::face) {
    table.fail("gap", "\"face\" needs enforcement = \"projection\" or \"lagrange\" in this version");
  }
  contact.beta = table.number("beta", not_negative, contact.beta);
  contact.damping = table.number("damping", not_negative, contact.damping);
  contact.friction = table.number("friction", not_negative, contact.friction);
  contact.static_friction = table.number("static_friction", not_negative, contact.friction);
  if (contact.static_friction < contact.friction) {
    table.fail("static_friction", fmt::format("expected a number >= friction = {:.6g}, got {:.6g}", contact.friction,
                                              contact.static_friction));
  }
  if (contact.enforcement == Enforcement::projection && contact.static_friction > contact.friction) {
    table.fail("static_friction", "another value than friction needs enforcement = \"lagrange\"");
  }
  if (penalty && contact.static_friction > 0) {
    table.fail(table.has("friction") ? "friction" : "static_friction",
               "expected 0: friction needs enforcement = \"projection\" or \"lagrange\"");
  }
  contact.radius = table.choice<ContactRadius>(
      "radius", {{"initial", ContactRadius::initial}, {"current", ContactRadius::current}}, contact.radius);
  contact.radius_factor = table.number("radius_factor", positive, contact.radius_factor);
  contact.self = table.boolean("self", contact.self);
  contact.skin = table.number("skin", not_negative, contact.skin);
  return contact;
}

OutputSettings read_output(const SceneTable& table) {
  OutputSettings output;
  if (table.is_text("interval")) {
    output.every_step = table.choice<bool>("interval", {{"step", true}});
  } else {
    output.interval = table.number("interval", not_negative, output.interval);
  }
  output.field_interval = table.number("field_interval", not_negative, output.field_interval);
  output.field_times = table.numbers("field_times", not_negative);
  std::sort(output.field_times.begin(), output.field_times.end());
  const std::vector<std::string> all{"velocity",       "contact_force",  "stress",
                                     "plastic_strain", "pinball_radius", "alive"};
  output.fields = table.has("fields") ? table.texts("fields", all) : all;
  return output;
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

/// Throws InputError if the text under a key is none of the names of materials or bodies.
void check_reference(const SceneTable& table, std::string_view key, const std::string& kind,
                     const std::vector<std::string>& names) {
  const std::string name = table.text(key);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  const std::string hint = names.empty() ? fmt::format("the scene has no [[{}]]", kind)
                                         : fmt::format("nearest is \"{}\"", nearest(name, names));
  table.fail(key, fmt::format("no {} is named \"{}\", {}", kind, name, hint));
}

template <class Named>
void check_unique(const SceneTable& table, const std::string& name, const std::vector<Named>& earlier) {
  const auto names = names_of(earlier);
  if (std::find(names.begin(), names.end(), name) != names.end()) {
    table.fail("name", fmt::format("expected a name of its own, got \"{}\" a second time", name));
  }
}

/// A mesh file is named relative to the folder of the scene. Throws InputError if there is none.
void find_mesh_file(const SceneTable& body, GmshMesh& mesh, const std::string& scene_path) {
  const auto path = std::filesystem::path(scene_path).parent_path() / mesh.file;
  if (!std::filesystem::is_regular_file(path)) {
    body.table("mesh", "gmsh").fail("file", fmt::format("expected a Gmsh file, there is no {}", path.string()));
  }
  mesh.file = path.string();
}

/// What acts from outside, and probes; bodies are known by now.
void read_boundary(const SceneTable& top, Scene& scene) {
  const auto tables = [&](std::string_view key) {
    auto all = top.tables(key, key);
    for (const SceneTable& table : all) {
      if (table.has("body")) check_reference(table, "body", "body", names_of(scene.bodies));
    }
    return all;
  };
  for (const auto& any : tables("constraint")) {
    const auto type = any.choice<std::string>("type", {{"symmetry", "symmetry"}, {"fixed", "fixed"}});
    const SceneTable table = any.as(type);
    if (type == "symmetry") {
      scene.constraints.push_back(read_constraint(table));
    } else {
      scene.fixed_constraints.push_back(read_fixed_constraint(table));
    }
  }
  for (const auto& table : tables("rigid_wall")) {
    const RigidWall wall = read_rigid_wall(table, scene.rigid_walls.size());
    check_unique(table, wall.name, scene.rigid_walls);
    scene.rigid_walls.push_back(wall);
  }
  for (const auto& table : tables("prescribed_velocity")) {
    scene.prescribed_velocities.push_back(read_prescribed_velocity(table));
  }
  for (const auto& table : tables("load")) scene.loads.push_back(read_load(table));
  for (const auto& table : tables("initial_velocity")) {
    scene.initial_velocities.push_back(read_initial_velocity(table));
  }
  for (const auto& table : tables("probe")) {
    const Probe probe = read_probe(table);
    check_unique(table, probe.name, scene.probes);
    check_unique(table, probe.name, scene.bodies);  // their columns in history.csv
    scene.probes.push_back(probe);
  }
}

Scene read_tables(const toml::table& root, const std::string& path, const SceneOverrides& overrides) {
  const SceneTable top(root, "", path + ":1:1", "scene");
  Scene scene;
  scene.path = path;
  scene.name = std::filesystem::path(path).stem().string();
  scene.refine = overrides.refine;
  scene.title = top.text("title", "");
  scene.units = top.text("units", "");
  scene.precision = top.choice<Precision>("precision", {{"double", Precision::float64}, {"float", Precision::float32}},
                                          scene.precision);
  if (overrides.precision) scene.precision = *overrides.precision;
  scene.time = read_time(top.table("time", "time"));
  scene.element = read_element(top.table("element", "element"));
  scene.contact = read_contact(top.table("contact", "contact"));
  const SceneTable skip = top.table("skip", "skip");
  scene.skip.contact_search = skip.boolean("contact_search", scene.skip.contact_search);
  scene.skip.resting = skip.boolean("resting", scene.skip.resting);
  const SceneTable guard = top.table("guard", "guard");
  scene.guard.energy_error = guard.number("energy_error", positive, scene.guard.energy_error);
  scene.guard.time_step_collapse =
      guard.number("time_step_collapse", {.low = 0.0, .high = 1.0}, scene.guard.time_step_collapse);
  scene.output = read_output(top.table("output", "output"));

  for (const auto& table : top.tables("material", "material")) {
    const Material material = read_material(table);
    check_unique(table, material.name, scene.materials);
    scene.materials.push_back(material);
  }
  const auto bodies = top.tables("body", "body");
  if (bodies.empty()) top.fail("body", "missing, expected at least one [[body]]");
  for (const auto& table : bodies) {
    Body body = read_body(table, overrides.refine);
    if (auto* gmsh = std::get_if<GmshMesh>(&body.mesh)) find_mesh_file(table, *gmsh, path);
    check_unique(table, body.name, scene.bodies);
    check_reference(table, "material", "material", names_of(scene.materials));
    scene.bodies.push_back(body);
  }
  scene.damping.mass = top.table("damping", "damping").number("mass", not_negative, scene.damping.mass);
  read_boundary(top, scene);
  return scene;
}

std::string read_text(const std::string& path) {
  std::error_code problem;
  if (std::filesystem::is_directory(path, problem)) throw InputError(path + ": expected a scene file, got a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": no such file, or it cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

toml::table parse(const std::string& text, const std::string& path) {
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: not valid TOML: {}", location(error.source(), path), error.description()));
  }
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
    } else if (const auto name = change.value["value"].value_exact<std::string>()) {
      const auto same = [&name](const Change& earlier) { return earlier.text == *name; };
      if (std::none_of(changes.variants.begin(), changes.variants.end(), same)) {
        changes.variants.push_back({option, *name});
      }
    } else {
      fail(change.where(), "variant", "expected the name of a variant");
    }
  }
}

/// The text with variants and keys applied, read and checked.
Scene read_changed(const std::string& text, const std::string& path, const Changes& changes,
                   const SceneOverrides& overrides) {
  // Parsed anew each time: tables cannot be copied without losing where their values were written.
  toml::table root = parse(text, path);
  for (const auto& [option, name] : changes.variants) {
    apply_variant(root, name, fmt::format("{} variant={}", option, name));
  }
  for (const auto& [option, key_value] : changes.keys) apply_override(root, parse_override(option, key_value));
  return read_tables(root, path, overrides);
}

/// A variant must fit the scene even if nobody asks for it now. A file that is complete only with some keys of the
/// command line is checked with these.
void check_variants(const std::string& text, const std::string& path, const std::vector<std::string>& names,
                    const std::vector<Change>& keys) {
  std::vector<Change> needed;
  try {
    read_changed(text, path, {}, {});
  } catch (const InputError&) {
    needed = keys;
  }
  for (const auto& name : names) {
    try {
      read_changed(text, path, {{{"--set", name}}, needed}, {});
    } catch (const InputError& error) {
      throw InputError(fmt::format("{} (in variant {})", error.what(), name));
    }
  }
}

}  // namespace

SceneSource read_scene_source(const std::string& path, const SceneOverrides& overrides) {
  return {path, read_text(path), overrides};
}

Scene read_scene(const std::string& path, const SceneOverrides& overrides) {
  return read_scene(read_scene_source(path, overrides));
}

Scene read_scene(const SceneSource& source) {
  const auto& [path, text, overrides] = source;
  if (overrides.refine < 1) {
    throw InputError(fmt::format("--refine {}: expected an integer >= 1, got {}", overrides.refine, overrides.refine));
  }
  Changes changes;
  sort_changes("--set", overrides.set, changes);
  sort_changes("--vary", overrides.vary, changes);
  Scene scene = read_changed(text, path, changes, overrides);
  check_variants(text, path, variant_names(parse(text, path), path), changes.keys);
  return scene;
}

}  // namespace pinball
