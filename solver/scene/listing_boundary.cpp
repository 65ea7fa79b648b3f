#include <cmath>

#include "entries.hpp"

namespace pinball {

namespace {

std::string numbered(const char* kind, std::size_t number) { return fmt::format("{}.{}", kind, number); }

void list_nodes(Entries& table, const NodeSelection& nodes) {
  table.add_name("body", nodes.body, "all");
  if (nodes.plane) {
    table.add("plane.point", nodes.plane->point, "L");
    table.add("plane.normal", nodes.plane->normal, "-");
  }
  if (nodes.line) {
    table.add("line.point", nodes.line->point, "L");
    table.add("line.direction", nodes.line->direction, "-");
  }
  if (nodes.box) {
    table.add("box.low", nodes.box->low, "L");
    table.add("box.high", nodes.box->high, "L");
  }
  if (nodes.nearest) table.add("nearest", *nodes.nearest, "L");
  if (!nodes.set.empty()) table.add("set", nodes.set);
  if (!nodes.nodes.empty()) table.add_words("nodes", fmt::format("{} numbers", nodes.nodes.size()), false);
  if (!nodes.file.empty()) table.add("file", nodes.file);
  if (!nodes.without.empty()) table.add("without", nodes.without);
  if (nodes.tolerance > 0) table.add("tolerance", nodes.tolerance, "L");
}

/// Of a force in history.csv.
void list_name(Entries& table, const std::string& name) { table.add_name("name", name, "none"); }

void list_time_span(Entries& table, const TimeSpan& when) {
  table.add("start", when.start, 0.0, "T");
  const bool endless = std::isinf(when.end);
  table.add_words("end", endless ? "never" : toml_text(when.end), endless, "T");
}

void list_factors(Entries& table, const TimeTable& factors) {
  if (factors.times.empty()) {
    table.add_words("factors", "1 at all times", true, "-");
  } else {
    table.add("times", factors.times, "T");
    table.add("factors", factors.factors, "-");
  }
}

void list_constraints(const Scene& scene, std::vector<SceneEntry>& all) {
  std::size_t number = 0;
  for (const PlaneConstraint& plane : scene.constraints) {
    Entries table(all, numbered("constraint", number++));
    table.add("type", "symmetry");
    list_name(table, plane.name);
    table.add_numbers(plane, {});
    table.add("normal", plane.normal, "-");
    table.add_name("body", plane.body, "all");
    if (!plane.set.empty()) table.add("set", plane.set);
  }
  for (const FixedConstraint& fixed : scene.fixed_constraints) {
    Entries table(all, numbered("constraint", number++));
    table.add("type", "fixed");
    list_name(table, fixed.name);
    const bool global = fixed.frame == Frame::global;
    table.add_words("frame", toml_text(global ? "global" : "cylindrical"), global);
    table.add("directions", fixed.directions, "-");
    if (!global) {
      table.add("axis.point", fixed.axis.point, "L");
      table.add("axis.direction", fixed.axis.direction, "-");
    }
    list_time_span(table, fixed.when);
    list_nodes(table, fixed.nodes);
  }
}

void list_walls(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const RigidWall& wall : scene.rigid_walls) {
    Entries table(all, "rigid_wall." + wall.name);
    table.add_numbers(wall, {});
    table.add("normal", wall.plane.normal, "-");
    table.add("sliding", wall.sliding, true, "");
    table.add_words("edge", wall.edge ? toml_text(*wall.edge) : "none", !wall.edge, "-");
    table.add_words("size", wall.edge ? toml_text(wall.size) : "without end", !wall.edge, "L");
    table.add("mass", wall.mass, 0.0, "M");
    table.add("speed", wall.speed, 0.0, "L/T");
    list_factors(table, wall.table);
    list_time_span(table, wall.when);
    NodeSelection nodes = wall.nodes;
    nodes.body = wall.body;
    list_nodes(table, nodes);
  }
}

void list_motion(const Scene& scene, std::vector<SceneEntry>& all) {
  for (std::size_t n = 0; n < scene.prescribed_velocities.size(); ++n) {
    const PrescribedVelocity& given = scene.prescribed_velocities[n];
    Entries table(all, numbered("prescribed_velocity", n));
    list_name(table, given.name);
    table.add("velocity", given.velocity, "L/T");
    table.add_words("direction", given.direction ? toml_text(*given.direction) : "all three", !given.direction, "-");
    static const char* const quantities[] = {"velocity", "displacement", "acceleration"};
    table.add_words("quantity", toml_text(quantities[static_cast<int>(given.quantity)]),
                    given.quantity == MotionQuantity::velocity);
    list_factors(table, given.table);
    list_time_span(table, given.when);
    list_nodes(table, given.nodes);
  }
  for (std::size_t n = 0; n < scene.loads.size(); ++n) {
    Entries table(all, numbered("load", n));
    table.add_numbers(scene.loads[n], {});
    table.add("each", scene.loads[n].each, false, "");
    list_factors(table, scene.loads[n].table);
    list_nodes(table, scene.loads[n].nodes);
  }
  for (const Pressure& pressure : scene.pressures) {
    Entries table(all, "pressure." + pressure.name);
    table.add_numbers(pressure, {});
    list_factors(table, pressure.table);
    if (!pressure.corners.empty()) table.add_words("faces", fmt::format("{} faces", pressure.corners.size()), false);
    list_nodes(table, pressure.faces);
  }
  for (std::size_t n = 0; n < scene.gravities.size(); ++n) {
    Entries table(all, numbered("gravity", n));
    list_name(table, scene.gravities[n].name);
    table.add_numbers(scene.gravities[n], {});
    if (!scene.gravities[n].bodies.empty()) table.add("bodies", scene.gravities[n].bodies);
    list_factors(table, scene.gravities[n].table);
  }
  for (std::size_t n = 0; n < scene.initial_velocities.size(); ++n) {
    Entries table(all, numbered("initial_velocity", n));
    const InitialVelocity& given = scene.initial_velocities[n];
    table.add_numbers(given, {});
    std::string components;
    for (std::size_t k = 0; k < 3; ++k) components += given.components[k] ? std::string(1, "xyz"[k]) : "";
    table.add_words("components", components, components == "xyz", "");
    list_nodes(table, scene.initial_velocities[n].nodes);
  }
}

}  // namespace

void list_boundary(const Scene& scene, std::vector<SceneEntry>& all) {
  list_constraints(scene, all);
  list_walls(scene, all);
  list_motion(scene, all);
  for (const Probe& probe : scene.probes) {
    Entries table(all, "probe." + probe.name);
    const bool node = probe.kind == ProbeKind::node;
    table.add_words("kind", toml_text(node ? "node" : "element"), node);
    table.add_numbers(probe, {});
    if (probe.number) table.add(node ? "node" : "element", *probe.number);
    table.add_name("body", probe.body, "all");
    const bool all_quantities = probe.quantities.empty() || probe.quantities == probe_quantities(probe.kind);
    table.add_words("quantities", toml_text(all_quantities ? probe_quantities(probe.kind) : probe.quantities),
                    all_quantities);
  }
}

}  // namespace pinball
