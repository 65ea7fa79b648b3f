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
    table.add_numbers(plane, {});
    table.add("normal", plane.normal, "-");
    table.add_name("body", plane.body, "all");
  }
  for (const FixedConstraint& fixed : scene.fixed_constraints) {
    Entries table(all, numbered("constraint", number++));
    table.add("type", "fixed");
    const bool global = fixed.frame == Frame::global;
    table.add_words("frame", toml_text(global ? "global" : "cylindrical"), global);
    table.add("directions", fixed.directions, "-");
    if (!global) {
      table.add("axis.point", fixed.axis.point, "L");
      table.add("axis.direction", fixed.axis.direction, "-");
    }
    list_nodes(table, fixed.nodes);
  }
}

void list_walls(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const RigidWall& wall : scene.rigid_walls) {
    Entries table(all, "rigid_wall." + wall.name);
    table.add_numbers(wall, {});
    table.add("normal", wall.plane.normal, "-");
    table.add_name("body", wall.body, "all");
  }
}

void list_motion(const Scene& scene, std::vector<SceneEntry>& all) {
  for (std::size_t n = 0; n < scene.prescribed_velocities.size(); ++n) {
    const PrescribedVelocity& given = scene.prescribed_velocities[n];
    Entries table(all, numbered("prescribed_velocity", n));
    table.add("velocity", given.velocity, "L/T");
    table.add_words("direction", given.direction ? toml_text(*given.direction) : "all three", !given.direction, "-");
    static const char* const quantities[] = {"velocity", "displacement", "acceleration"};
    table.add_words("quantity", toml_text(quantities[static_cast<int>(given.quantity)]),
                    given.quantity == MotionQuantity::velocity);
    list_factors(table, given.table);
    list_nodes(table, given.nodes);
  }
  for (std::size_t n = 0; n < scene.loads.size(); ++n) {
    Entries table(all, numbered("load", n));
    table.add_numbers(scene.loads[n], {});
    table.add("each", scene.loads[n].each, false, "");
    list_factors(table, scene.loads[n].table);
    list_nodes(table, scene.loads[n].nodes);
  }
  for (std::size_t n = 0; n < scene.gravities.size(); ++n) {
    Entries table(all, numbered("gravity", n));
    table.add_numbers(scene.gravities[n], {});
    list_factors(table, scene.gravities[n].table);
  }
  for (std::size_t n = 0; n < scene.initial_velocities.size(); ++n) {
    Entries table(all, numbered("initial_velocity", n));
    table.add_numbers(scene.initial_velocities[n], {});
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
    table.add_name("body", probe.body, "all");
    const bool all_quantities = probe.quantities.empty() || probe.quantities == probe_quantities(probe.kind);
    table.add_words("quantities", toml_text(all_quantities ? probe_quantities(probe.kind) : probe.quantities),
                    all_quantities);
  }
}

}  // namespace pinball
