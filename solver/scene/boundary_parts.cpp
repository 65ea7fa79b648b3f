#include "boundary_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parts.hpp"

namespace pinball {

namespace {

std::string where_of(const SceneTable& table) { return fmt::format("{}: {}", table.where(), table.path()); }

Line read_line(const SceneTable& table) {
  return {table.point("point", any_number, Point{}), read_direction(table, "direction")};
}

NodeSelection read_selection(const SceneTable& table) {
  NodeSelection nodes;
  nodes.where = where_of(table);
  nodes.body = table.text("body", "");
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
  if (nodes.all()) table.fail_missing("body", "at least one of body, plane, line, box, nearest, set and nodes");
  return nodes;
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
  constraint.nodes = read_selection(table);
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
  wall.body = table.text("body", "");
  return wall;
}

PrescribedVelocity read_prescribed_velocity(const SceneTable& table) {
  PrescribedVelocity result;
  result.nodes = read_selection(table);
  result.quantity = table.choice<MotionQuantity>("quantity",
                                                 {{"velocity", MotionQuantity::velocity},
                                                  {"displacement", MotionQuantity::displacement},
                                                  {"acceleration", MotionQuantity::acceleration}},
                                                 result.quantity);
  result.table = read_time_table(table);
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

Gravity read_gravity(const SceneTable& table) {
  Gravity gravity;
  table.numbers_into(gravity);
  gravity.table = read_time_table(table);
  return gravity;
}

InitialVelocity read_initial_velocity(const SceneTable& table) {
  InitialVelocity given{read_selection(table), {}};
  table.numbers_into(given);
  return given;
}

Probe read_probe(const SceneTable& table) {
  Probe probe;
  probe.where = where_of(table);
  probe.name = table.name("name");
  probe.kind =
      table.choice<ProbeKind>("kind", {{"node", ProbeKind::node}, {"element", ProbeKind::element}}, probe.kind);
  table.numbers_into(probe);
  probe.body = table.text("body", "");
  const auto& all = probe_quantities(probe.kind);
  probe.quantities = table.has("quantities") ? table.texts("quantities", all) : all;
  return probe;
}

}  // namespace pinball
