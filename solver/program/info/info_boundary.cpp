#include "info_boundary.hpp"

#include <fmt/core.h>

#include <solver/model/node_selection.hpp>

namespace pinball {

namespace {

std::string vector_text(const Point& p, const std::string& unit) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}){}{}", p[0], p[1], p[2], unit.empty() ? "" : " ", unit);
}

std::string table_text(const TimeTable& table) {
  return table.times.empty() ? "constant" : fmt::format("{} points in time", table.times.size());
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
    fmt::print("  constraints: {} direction{} of nodes, from {} plane{} of symmetry and {} set{} of fixed nodes\n",
               model.constraints.size(), model.constraints.size() == 1 ? "" : "s", scene.constraints.size(),
               scene.constraints.size() == 1 ? "" : "s", scene.fixed_constraints.size(),
               scene.fixed_constraints.size() == 1 ? "" : "s");
  }
  for (const RigidWall& wall : scene.rigid_walls) {
    fmt::print("  rigid wall {}: through {}, free side along {}{}{}\n", wall.name,
               vector_text(wall.plane.point, units.length), vector_text(wall.plane.normal, ""),
               wall.friction > 0 ? fmt::format(", friction {:.4g}", wall.friction) : "",
               wall.body.empty() ? "" : ", for body " + wall.body);
  }
  for (const PrescribedVelocity& p : scene.prescribed_velocities) {
    fmt::print("  prescribed velocity: {}{} of {} nodes {} ({})\n", vector_text(p.velocity, units.velocity),
               p.direction ? " along its direction" : "", select_nodes(model.mesh, p.nodes).size(), describe(p.nodes),
               table_text(p.table));
  }
  for (const NodalLoad& load : scene.loads) {
    fmt::print("  load: {} on {} nodes {} ({})\n", vector_text(load.force, force_unit(units)),
               select_nodes(model.mesh, load.nodes).size(), describe(load.nodes), table_text(load.table));
  }
  for (const Gravity& gravity : scene.gravities) {
    fmt::print("  gravity: {} ({})\n", vector_text(gravity.acceleration, acceleration_unit(units)),
               table_text(gravity.table));
  }
  for (const InitialVelocity& v : scene.initial_velocities) {
    fmt::print("  initial velocity: {} of {} nodes {}\n", vector_text(v.velocity, units.velocity),
               select_nodes(model.mesh, v.nodes).size(), describe(v.nodes));
  }
  if (scene.damping.mass > 0) fmt::print("  damping: {:.6g} times mass and velocity\n", scene.damping.mass);
}

template void print_boundary_conditions(const Model<double>&, const Units&);
template void print_boundary_conditions(const Model<float>&, const Units&);

}  // namespace pinball
