#include "boundary_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "parts.hpp"

namespace pinball {

namespace {

/// Of its force in history.csv; empty: not asked for.
std::string optional_name(const SceneTable& table) { return table.has("name") ? table.name("name") : std::string(); }

std::string where_of(const SceneTable& table) { return fmt::format("{}: {}", table.where(), table.path()); }

Line read_line(const SceneTable& table) {
  return {table.point("point", any_number, Point{}), read_direction(table, "direction")};
}

/// What is given; it may be nothing.
NodeSelection read_any_selection(const SceneTable& table) {
  NodeSelection nodes;
  nodes.where = where_of(table);
  nodes.body = table.text("body", "");
  nodes.tolerance = table.number("tolerance", not_negative, nodes.tolerance);
  nodes.file = table.text("file", "");
  nodes.without = table.text("without", "");
  if (table.has("plane")) {
    const SceneTable plane = table.table("plane", "plane");
    nodes.plane = Plane{plane.point("point", any_number, Point{}), read_direction(plane, "normal")};
  }
  if (table.has("line")) nodes.line = read_line(table.table("line", "line"));
  if (table.has("box")) {
    const SceneTable box = table.table("box", "box");
    nodes.box = Box{box.point("low", any_number), box.point("high", any_number)};
    box.require_none(problem_of(*nodes.box));
  }
  if (table.has("nearest")) nodes.nearest = table.point("nearest", any_number);
  nodes.set = table.text("set", "");
  if (table.has("nodes")) nodes.nodes = table.integers("nodes", 0);
  return nodes;
}

NodeSelection read_selection(const SceneTable& table) {
  const NodeSelection nodes = read_any_selection(table);
  if (nodes.all()) table.fail_missing("body", "at least one of body, plane, line, box, nearest, set and nodes");
  return nodes;
}

TimeSpan read_time_span(const SceneTable& table) {
  TimeSpan when;
  when.start = table.number("start", any_number, when.start);
  if (table.has("end")) when.end = table.number("end", any_number);
  table.require_none(problem_of(when));
  return when;
}

TimeTable read_time_table(const SceneTable& table) {
  TimeTable result{table.numbers("times", any_number), table.numbers("factors", any_number)};
  table.require_none(problem_of(result));
  return result;
}

}  // namespace

const std::vector<std::string>& probe_quantities(ProbeKind kind) {
  static const std::vector<std::string> node{"position", "displacement", "velocity"};
  static const std::vector<std::string> element{"stress", "effective_stress", "plastic_strain"};
  return kind == ProbeKind::node ? node : element;
}

FixedConstraint read_fixed_constraint(const SceneTable& table) {
  FixedConstraint constraint;
  constraint.name = optional_name(table);
  constraint.nodes = read_selection(table);
  constraint.when = read_time_span(table);
  constraint.frame =
      table.choice<Frame>("frame", {{"global", Frame::global}, {"cylindrical", Frame::cylindrical}}, constraint.frame);
  const bool cylindrical = constraint.frame == Frame::cylindrical;
  if (cylindrical) {
    if (!table.has("axis")) table.fail_missing("axis", "a table { point = ..., direction = ... }");
    constraint.axis = read_line(table.table("axis", "line"));
  } else if (table.has("axis")) {
    table.fail("axis", "only a frame = \"cylindrical\" has an axis");
  }
  constraint.directions = table.directions(
      "directions", cylindrical ? std::array{"radial", "circumferential", "axial"} : std::array{"x", "y", "z"});
  return constraint;
}

RigidWall read_rigid_wall(const SceneTable& table, std::size_t number) {
  RigidWall wall;
  wall.where = where_of(table);
  wall.name = table.has("name") ? table.name("name") : fmt::format("wall_{}", number);
  table.numbers_into(wall);
  wall.plane.normal = read_direction(table, "normal");
  wall.nodes = read_any_selection(table);
  wall.body = std::exchange(wall.nodes.body, "");
  wall.when = read_time_span(table);
  wall.sliding = table.boolean("sliding", wall.sliding);
  if (table.has("edge")) wall.edge = read_direction(table, "edge");
  if (table.has("size")) {
    const std::vector<double> size = table.numbers("size", not_negative);
    if (size.size() != 2) table.fail("size", fmt::format("expected 2 numbers, got {}", size.size()));
    wall.size = {size[0], size[1]};
  }
  wall.mass = table.number("mass", not_negative, wall.mass);
  wall.speed = table.number("speed", any_number, wall.speed);
  wall.table = read_time_table(table);
  table.require_none(problem_of(wall));
  return wall;
}

PrescribedVelocity read_prescribed_velocity(const SceneTable& table) {
  PrescribedVelocity result;
  result.name = optional_name(table);
  result.nodes = read_selection(table);
  result.quantity = table.choice<MotionQuantity>("quantity",
                                                 {{"velocity", MotionQuantity::velocity},
                                                  {"displacement", MotionQuantity::displacement},
                                                  {"acceleration", MotionQuantity::acceleration}},
                                                 result.quantity);
  result.table = read_time_table(table);
  result.when = read_time_span(table);
  if (table.has("direction") || table.has("speed")) {
    if (table.has("velocity")) table.fail("velocity", "expected either velocity or direction and speed, got both");
    if (!table.has("direction")) table.fail_missing("direction", "an array of 3 numbers");
    result.direction = read_direction(table, "direction");
    const double speed = table.number("speed", any_number);
    for (std::size_t k = 0; k < 3; ++k) result.velocity[k] = speed * (*result.direction)[k];
  } else {
    result.velocity = table.point("velocity", any_number);
  }
  return result;
}

NodalLoad read_load(const SceneTable& table) {
  NodalLoad load;
  load.nodes = read_selection(table);
  table.numbers_into(load);
  load.table = read_time_table(table);
  load.each = table.boolean("each", load.each);
  return load;
}

Pressure read_pressure(const SceneTable& table, std::size_t number) {
  Pressure pressure;
  pressure.name = table.has("name") ? table.name("name") : fmt::format("pressure_{}", number);
  pressure.corners = table.faces("faces");
  pressure.faces = pressure.corners.empty() ? read_selection(table) : read_any_selection(table);
  table.numbers_into(pressure);
  pressure.table = read_time_table(table);
  return pressure;
}

Gravity read_gravity(const SceneTable& table, const std::vector<std::string>& bodies) {
  Gravity gravity;
  gravity.name = optional_name(table);
  table.numbers_into(gravity);
  gravity.bodies = table.texts("bodies", bodies);
  gravity.table = read_time_table(table);
  return gravity;
}

InitialVelocity read_initial_velocity(const SceneTable& table) {
  InitialVelocity given;
  given.nodes = read_selection(table);
  table.numbers_into(given);
  if (!table.has("velocity") && !table.has("angular_velocity")) table.point("velocity", any_number);
  if (!table.has("components")) return given;
  static const std::vector<std::string> names{"x", "y", "z"};
  const std::vector<std::string> listed = table.texts("components", names);
  for (std::size_t k = 0; k < 3; ++k) given.components[k] = std::ranges::count(listed, names[k]) > 0;
  return given;
}

namespace {

/// At most one of point, node and element says what is watched; a number also says of which kind it is.
void read_number(const SceneTable& table, Probe& probe) {
  const bool node = table.has("node"), element = table.has("element");
  if (!node && !element) return;
  const char* key = node ? "node" : "element";
  if ((node && element) || table.has("point")) table.fail(key, "expected only one of point, node and element");
  probe.number = table.integer(key, 0);
  probe.kind = node ? ProbeKind::node : ProbeKind::element;
}

}  // namespace

Probe read_probe(const SceneTable& table) {
  Probe probe;
  probe.where = where_of(table);
  probe.name = table.name("name");
  read_number(table, probe);
  probe.kind =
      table.choice<ProbeKind>("kind", {{"node", ProbeKind::node}, {"element", ProbeKind::element}}, probe.kind);
  if (probe.number && table.has(probe.kind == ProbeKind::node ? "element" : "node"))
    table.fail("kind", "expected the kind of what the number is of");
  table.numbers_into(probe);
  probe.body = table.text("body", "");
  const auto& all = probe_quantities(probe.kind);
  probe.quantities = table.has("quantities") ? table.texts("quantities", all) : all;
  return probe;
}

}  // namespace pinball
