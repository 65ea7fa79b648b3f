#include "info_boundary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include <solver/base/counted.hpp>
#include <solver/model/selection/node_selection.hpp>
#include <solver/model/selection/pressed_faces.hpp>
#include <solver/model/selection/selected_elements.hpp>
#include <solver/scene/schema/choices.hpp>

#include "info_material.hpp"

namespace pinball {

std::string vector_text(const Point& p, const std::string& unit) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}){}{}", p[0], p[1], p[2], unit.empty() ? "" : " ", unit);
}

std::string per_time(const Units& units) { return units.time.empty() ? "" : "1/" + units.time; }

std::string directions_text(const std::vector<Point>& directions) {
  std::string text;
  for (const Point& d : directions) text += (text.empty() ? "" : ", ") + vector_text(d, "");
  return text;
}

std::string table_text(const TimeTable& table) {
  return table.times.empty() ? "constant" : counted(table.times.size(), "point") + " in time";
}

std::string span_text(const TimeSpan& when, const Units& units) {
  std::string text;
  if (when.start > 0) text += ", from time " + with_unit(when.start, units.time);
  if (!std::isinf(when.end)) text += ", up to time " + with_unit(when.end, units.time);
  return text;
}

std::string motion_text(MotionQuantity quantity, const std::string& amount, const std::string& way,
                        const Units& units) {
  std::string unit = units.time.empty() ? "" : way;
  if (!unit.empty() && quantity == MotionQuantity::velocity) unit += "/" + units.time;
  if (!unit.empty() && quantity == MotionQuantity::acceleration) unit += "/" + units.time + "^2";
  return fmt::format("{} {}{}{}", schema::name_of(quantity), amount, unit.empty() ? "" : " ", unit);
}

namespace {

/// "25 nodes on the plane ..., 3 more lie near"
std::string nodes_text(const ModelMesh& mesh, const NodeSelection& selection) {
  const SelectedNodes found = selected_nodes(mesh, selection);
  return fmt::format(
      "{} {}{}", counted(found.nodes.size(), "node"), describe(selection),
      found.near > 0 ? fmt::format(", {} more {} near", found.near, found.near == 1 ? "lies" : "lie") : "");
}

std::string directions_of(const FixedConstraint& fixed) {
  const bool turned = fixed.frame == Frame::cylindrical;
  return directions_text(fixed.directions) + (turned ? " of radial, circumferential, axial" : "");
}

/// What pushes or moves a wall, and where it ends.
std::string wall_text(const RigidWall& wall, const Units& units) {
  std::string text;
  if (wall.mass > 0) {
    text += fmt::format(", pushed with its mass {}, at first {}", with_unit(wall.mass, units.mass),
                        motion_text(MotionQuantity::velocity, fmt::format("{:.6g}", wall.speed), units.length, units));
  } else if (wall.speed != 0) {
    text += fmt::format(", moves with {} ({})",
                        motion_text(MotionQuantity::velocity, fmt::format("{:.6g}", wall.speed), units.length, units),
                        table_text(wall.table));
  }
  if (wall.edge) {
    text += fmt::format(", {:.6g} x {:.6g}{} from there, the first along {} (0: without end)", wall.size[0],
                        wall.size[1], units.length.empty() ? "" : " " + units.length, vector_text(*wall.edge, ""));
  }
  return text;
}

std::string spin_text(const InitialVelocity& v, const Units& units) {
  if (v.angular_velocity == Point{}) return "";
  return fmt::format(", turning with {} about {}", vector_text(v.angular_velocity, per_time(units)),
                     vector_text(v.centre, units.length));
}

std::string components_text(const InitialVelocity& v) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    if (v.components[k]) text += (text.empty() ? "" : ", ") + std::string(1, "xyz"[k]);
  }
  return text.size() == std::string("x, y, z").size() ? "" : " along " + text;
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
    fmt::print("    fixed: {} along {}{}\n", nodes_text(model.mesh, fixed.nodes), directions_of(fixed),
               span_text(fixed.when, units));
  for (const EquationTerm& term : scene.equation_terms) {
    fmt::print("  equation {}: {:.6g} times the way along {} of {}\n", term.name, term.factor,
               vector_text(term.direction, ""), nodes_text(model.mesh, term.nodes));
  }
  for (const AttachedNodes& attached : scene.attached_nodes)
    fmt::print("  with rigid body {}: {}\n", attached.rigid_body, nodes_text(model.mesh, attached.nodes));
  for (const RigidWall& wall : scene.rigid_walls) {
    const NodeSelection nodes = nodes_of(wall);
    fmt::print("  rigid wall {}: through {}, free side along {}{}{}{}{}{}\n", wall.name,
               vector_text(wall.plane.point, units.length), vector_text(wall.plane.normal, ""),
               wall.friction > 0 ? fmt::format(", friction {:.4g}", wall.friction) : "",
               wall.sliding ? "" : ", without sliding", wall_text(wall, units), span_text(wall.when, units),
               nodes.all() && nodes.without.empty() ? "" : ", for " + nodes_text(model.mesh, nodes));
  }
  for (const PrescribedVelocity& p : scene.prescribed_velocities) {
    fmt::print("  prescribed {}{} of {} ({}{})\n",
               motion_text(p.quantity, vector_text(p.velocity, ""), units.length, units),
               p.direction ? " along its direction" : "", nodes_text(model.mesh, p.nodes), table_text(p.table),
               span_text(p.when, units));
  }
  for (const NodalLoad& load : scene.loads) {
    fmt::print("  load: {} on {}{} ({})\n", vector_text(load.force, units.force), load.each ? "each of " : "",
               nodes_text(model.mesh, load.nodes), table_text(load.table));
  }
  for (const Pressure& pressure : scene.pressures) {
    fmt::print("  pressure {}: {} on {} {} ({}{})\n", pressure.name, with_unit(pressure.pressure, units.stress),
               counted(pressed_faces(model.mesh, scene.constraints, pressure).size(), "face"),
               pressure.corners.empty() ? describe(pressure.faces) : "that are listed", table_text(pressure.table),
               span_text({pressure.start, INFINITY}, units));
  }
  for (const Gravity& gravity : scene.gravities) {
    fmt::print("  gravity: {}{} ({})\n", vector_text(gravity.acceleration, acceleration_unit(units)),
               gravity.bodies.empty() ? "" : fmt::format(" of {}", fmt::join(gravity.bodies, ", ")),
               table_text(gravity.table));
  }
  for (const PointMass& point : scene.point_masses) {
    fmt::print("  point mass: {} {} {}\n", with_unit(point.mass, units.mass), point.each ? "at each of" : "at",
               nodes_text(model.mesh, point.nodes));
  }
  for (const InitialVelocity& v : scene.initial_velocities) {
    fmt::print("  initial velocity: {}{} of {}{}\n", vector_text(v.velocity, units.velocity), components_text(v),
               nodes_text(model.mesh, v.nodes), spin_text(v, units));
  }
  for (const InitialStress& given : scene.initial_stresses) {
    fmt::print("  initial stress: {}, shear {} in {}\n", vector_text(given.stress, units.stress),
               vector_text(given.shear_stress, units.stress),
               counted(select_elements(model.mesh, given).size(), "element"));
  }
  if (scene.damping.mass > 0)
    fmt::print("  damping: {} times mass and velocity\n", with_unit(scene.damping.mass, per_time(units)));
}

template void print_boundary_conditions(const Model<double>&, const Units&);
template void print_boundary_conditions(const Model<float>&, const Units&);

}  // namespace pinball
