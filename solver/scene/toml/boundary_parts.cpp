#include "boundary_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/scene/schema/boundary.hpp>

#include "read_keys.hpp"

namespace pinball {

void require_selection(const SceneTable& table, const NodeSelection& nodes) {
  if (nodes.all()) table.fail_missing("body", "at least one of body, plane, line, box, nearest, set and nodes");
}

namespace {

/// What the keys of a table say, with a selection of nodes that has to be given.
template <class Part>
void read_with_nodes(const SceneTable& table, Part& part) {
  read_keys(table, part);
  part.nodes.where = table.place();
  require_selection(table, part.nodes);
  if constexpr (requires { part.when; }) table.require_none(problem_of(part.when));
  if constexpr (requires { part.table; }) table.require_none(problem_of(part.table));
}

}  // namespace

const std::vector<std::string>& probe_quantities(ProbeKind kind) {
  const auto& all = schema::all_probe_quantities;
  static const std::vector<std::string> node(all.begin(), all.begin() + 3), element(all.begin() + 3, all.end());
  return kind == ProbeKind::node ? node : element;
}

PlaneConstraint read_symmetry(const SceneTable& table) {
  PlaneConstraint constraint;
  read_keys(table, constraint);
  constraint.where = table.place();
  return constraint;
}

FixedConstraint read_fixed_constraint(const SceneTable& table) {
  FixedConstraint constraint;
  read_with_nodes(table, constraint);
  const bool cylindrical = constraint.frame == Frame::cylindrical;
  if (cylindrical) {
    if (!table.has("axis")) table.fail_missing("axis", "a table { point = ..., direction = ... }");
    read_keys(table.table("axis", "line"), constraint.axis);
  }
  constraint.directions = table.directions(
      "directions", cylindrical ? std::array{"radial", "circumferential", "axial"} : std::array{"x", "y", "z"});
  return constraint;
}

EquationTerm read_equation_term(const SceneTable& table) {
  EquationTerm term;
  read_with_nodes(table, term);
  table.require_none(problem_of(term));
  return term;
}

RigidWall read_rigid_wall(const SceneTable& table, std::size_t number) {
  RigidWall wall;
  wall.where = wall.nodes.where = table.place();
  wall.name = fmt::format("wall_{}", number);
  read_keys(table, wall);
  table.require_none(problem_of(wall.when));
  if (table.has("size")) {
    const std::vector<double> size = table.numbers("size", schema::about<RigidWall>("size").bound);
    if (size.size() != 2) table.fail("size", fmt::format("expected 2 numbers, got {}", size.size()));
    wall.size = {size[0], size[1]};
  }
  table.require_none(problem_of(wall.table));
  table.require_none(problem_of(wall));
  return wall;
}

PrescribedVelocity read_prescribed_velocity(const SceneTable& table) {
  PrescribedVelocity result;
  read_with_nodes(table, result);
  if (table.has("direction") || table.has("speed")) {
    if (table.has("velocity")) table.fail("velocity", "expected either velocity or direction and speed, got both");
    if (!table.has("direction")) table.fail_missing("direction", "an array of 3 numbers");
    const double speed = table.number("speed", any_number);
    for (std::size_t k = 0; k < 3; ++k) result.velocity[k] = speed * (*result.direction)[k];
  } else {
    result.velocity = table.point("velocity", any_number);
  }
  return result;
}

NodalLoad read_load(const SceneTable& table) {
  NodalLoad load;
  read_with_nodes(table, load);
  return load;
}

Pressure read_pressure(const SceneTable& table, std::size_t number) {
  Pressure pressure;
  pressure.name = fmt::format("pressure_{}", number);
  pressure.faces.where = table.place();
  read_keys(table, pressure);
  if (pressure.corners.empty()) require_selection(table, pressure.faces);
  table.require_none(problem_of(pressure.table));
  return pressure;
}

Gravity read_gravity(const SceneTable& table, const std::vector<std::string>& bodies) {
  Gravity gravity;
  read_keys(table, gravity);
  gravity.bodies = table.texts("bodies", bodies);
  table.require_none(problem_of(gravity.table));
  return gravity;
}

PointMass read_point_mass(const SceneTable& table) {
  PointMass point;
  read_with_nodes(table, point);
  return point;
}

InitialVelocity read_initial_velocity(const SceneTable& table) {
  InitialVelocity given;
  read_with_nodes(table, given);
  if (!table.has("velocity") && !table.has("angular_velocity")) table.point("velocity", any_number);
  if (!table.has("components")) return given;
  const auto& names = schema::component_names;
  const std::vector<std::string> listed = table.texts("components", {names.begin(), names.end()});
  for (std::size_t k = 0; k < 3; ++k) given.components[k] = std::ranges::count(listed, names[k]) > 0;
  return given;
}

InitialStress read_initial_stress(const SceneTable& table) {
  InitialStress given;
  given.nodes.where = table.place();
  read_keys(table, given);
  if (given.elements.empty()) require_selection(table, given.nodes);
  return given;
}

namespace {

/// At most one of point, node and element says what is watched; a number also says of which kind it is.
void read_number(const SceneTable& table, Probe& probe) {
  const bool node = table.has("node"), element = table.has("element");
  if (!node && !element) return;
  const char* key = node ? "node" : "element";
  if ((node && element) || table.has("point")) table.fail(key, "expected only one of point, node and element");
  probe.number = table.integer(key, schema::lowest(schema::about<Probe>(key)));
  probe.kind = node ? ProbeKind::node : ProbeKind::element;
}

}  // namespace

Probe read_probe(const SceneTable& table) {
  Probe probe;
  probe.where = table.place();
  read_number(table, probe);
  read_keys(table, probe);
  if (probe.number && table.has(probe.kind == ProbeKind::node ? "element" : "node"))
    table.fail("kind", "expected the kind of what the number is of");
  if (!probe.number) probe.point = table.point("point", any_number);
  const auto& all = probe_quantities(probe.kind);
  probe.quantities = table.has("quantities") ? table.texts("quantities", all) : all;
  return probe;
}

}  // namespace pinball
