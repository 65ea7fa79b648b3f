#include "info_boundary.hpp"

#include <fmt/core.h>

#include <cmath>

#include <solver/base/counted.hpp>
#include <solver/model/selection/node_selection.hpp>
#include <solver/model/selection/pressed_faces.hpp>

namespace pinball {

std::string vector_text(const Point& p, const std::string& unit) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}){}{}", p[0], p[1], p[2], unit.empty() ? "" : " ", unit);
}

namespace {

std::string table_text(const TimeTable& table) {
  return table.times.empty() ? "constant" : counted(table.times.size(), "point") + " in time";
}

/// "25 nodes on the plane ..., 3 more lie near"
std::string nodes_text(const ModelMesh& mesh, const NodeSelection& selection) {
  const SelectedNodes found = selected_nodes(mesh, selection);
  return fmt::format(
      "{} {}{}", counted(found.nodes.size(), "node"), describe(selection),
      found.near > 0 ? fmt::format(", {} more {} near", found.near, found.near == 1 ? "lies" : "lie") : "");
}

std::string span_text(const TimeSpan& when) {
  std::string text;
  if (when.start > 0) text += fmt::format(", from time {:.6g}", when.start);
  if (!std::isinf(when.end)) text += fmt::format(", up to time {:.6g}", when.end);
  return text;
}

std::string force_unit(const Units& units) {
  if (units.stress.empty() || units.length.empty()) return "";
  return fmt::format("{} {}^2", units.stress, units.length);
}

std::string acceleration_unit(const Units& units) {
  return units.length.empty() ? "" : fmt::format("{}/{}^2", units.length, units.time);
}

}  // namespace

template <class S>
void print_boundary_conditions(const Model<S>& model, const Units& units) {
  const Scene& scene = model.scene;
  if (!model.constraints.empty()) {
    fmt::print("  constraints: {} of nodes, from {} of symmetry and {} of fixed nodes\n",
               counted(model.constraints.size(), "direction"), counted(scene.constraints.size(), "plane"),
               counted(scene.fixed_constraints.size(), "set"));
  }
  for (const PlaneConstraint& plane : scene.constraints)
    fmt::print("    symmetry: {}\n", nodes_text(model.mesh, nodes_of(plane)));
  for (const FixedConstraint& fixed : scene.fixed_constraints)
    fmt::print("    fixed: {}{}\n", nodes_text(model.mesh, fixed.nodes), span_text(fixed.when));
  for (const RigidWall& wall : scene.rigid_walls) {
    const NodeSelection nodes = nodes_of(wall);
    fmt::print("  rigid wall {}: through {}, free side along {}{}{}{}{}\n", wall.name,
               vector_text(wall.plane.point, units.length), vector_text(wall.plane.normal, ""),
               wall.friction > 0 ? fmt::format(", friction {:.4g}", wall.friction) : "",
               wall.sliding ? "" : ", without sliding", span_text(wall.when),
               nodes.all() && nodes.without.empty() ? "" : ", for " + nodes_text(model.mesh, nodes));
  }
  for (const PrescribedVelocity& p : scene.prescribed_velocities) {
    fmt::print("  prescribed velocity: {}{} of {} ({}{})\n", vector_text(p.velocity, units.velocity),
               p.direction ? " along its direction" : "", nodes_text(model.mesh, p.nodes), table_text(p.table),
               span_text(p.when));
  }
  for (const NodalLoad& load : scene.loads) {
    fmt::print("  load: {} on {} ({})\n", vector_text(load.force, force_unit(units)),
               nodes_text(model.mesh, load.nodes), table_text(load.table));
  }
  for (const Pressure& pressure : scene.pressures) {
    fmt::print("  pressure {}: {:.6g}{}{} on {} {} ({})\n", pressure.name, pressure.pressure,
               units.stress.empty() ? "" : " ", units.stress,
               counted(pressed_faces(model.mesh, scene.constraints, pressure).size(), "face"),
               pressure.corners.empty() ? describe(pressure.faces) : "that are listed", table_text(pressure.table));
  }
  for (const Gravity& gravity : scene.gravities) {
    fmt::print("  gravity: {} ({})\n", vector_text(gravity.acceleration, acceleration_unit(units)),
               table_text(gravity.table));
  }
  for (const InitialVelocity& v : scene.initial_velocities) {
    fmt::print("  initial velocity: {} of {}\n", vector_text(v.velocity, units.velocity),
               nodes_text(model.mesh, v.nodes));
  }
  if (scene.damping.mass > 0) fmt::print("  damping: {:.6g} times mass and velocity\n", scene.damping.mass);
}

template void print_boundary_conditions(const Model<double>&, const Units&);
template void print_boundary_conditions(const Model<float>&, const Units&);

}  // namespace pinball
