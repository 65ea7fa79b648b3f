#include <solver/scene/schema/boundary.hpp>
#include <solver/scene/schema/rigid.hpp>

#include "entries.hpp"
#include "list_keys.hpp"

namespace pinball {

namespace {

std::string numbered(const char* kind, std::size_t number) { return fmt::format("{}.{}", kind, number); }

/// Tables of which nothing but their keys is to be said.
template <class T>
void list_numbered(const char* kind, const std::vector<T>& items, std::vector<SceneEntry>& all) {
  for (std::size_t n = 0; n < items.size(); ++n) {
    Entries table(all, numbered(kind, n));
    list_keys(table, items[n]);
  }
}

void list_constraints(const Scene& scene, std::vector<SceneEntry>& all) {
  std::size_t number = 0;
  for (const PlaneConstraint& plane : scene.constraints) {
    Entries table(all, numbered("constraint", number++));
    table.add("type", "symmetry");
    list_keys(table, plane);
  }
  for (const FixedConstraint& fixed : scene.fixed_constraints) {
    Entries table(all, numbered("constraint", number++));
    table.add("type", "fixed");
    list_keys(table, fixed);
  }
}

void list_walls(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const RigidWall& wall : scene.rigid_walls) {
    Entries table(all, "rigid_wall." + wall.name);
    list_keys(table, wall);
    table.add_words("size", wall.edge ? toml_text(wall.size) : "without end", !wall.edge, "L");
  }
}

void list_initial_velocities(const Scene& scene, std::vector<SceneEntry>& all) {
  for (std::size_t n = 0; n < scene.initial_velocities.size(); ++n) {
    Entries table(all, numbered("initial_velocity", n));
    const InitialVelocity& given = scene.initial_velocities[n];
    list_keys(table, given);
    std::string components;
    for (std::size_t k = 0; k < 3; ++k) components += given.components[k] ? std::string(1, "xyz"[k]) : "";
    table.add_words("components", components, components == "xyz", "");
  }
}

void list_probes(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const Probe& probe : scene.probes) {
    Entries table(all, "probe." + probe.name);
    list_keys(table, probe);
    if (probe.number) table.add(schema::name_of(probe.kind), *probe.number);
    const bool all_quantities = probe.quantities.empty() || probe.quantities == probe_quantities(probe.kind);
    table.add_words("quantities", toml_text(all_quantities ? probe_quantities(probe.kind) : probe.quantities),
                    all_quantities);
  }
}

}  // namespace

void list_boundary(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const RigidBody& rigid : scene.rigid_bodies) {
    Entries table(all, "rigid_body." + rigid.name);
    list_keys(table, rigid);
  }
  list_numbered("rigid_nodes", scene.attached_nodes, all);
  list_numbered("rigid_motion", scene.rigid_motions, all);
  for (const Joint& joint : scene.joints) {
    Entries table(all, "joint." + joint.name);
    list_keys(table, joint);
  }
  list_constraints(scene, all);
  list_numbered("equation", scene.equation_terms, all);
  list_walls(scene, all);
  list_numbered("prescribed_velocity", scene.prescribed_velocities, all);
  list_numbered("load", scene.loads, all);
  for (const Pressure& pressure : scene.pressures) {
    Entries table(all, "pressure." + pressure.name);
    list_keys(table, pressure);
  }
  list_numbered("gravity", scene.gravities, all);
  list_numbered("point_mass", scene.point_masses, all);
  list_initial_velocities(scene, all);
  list_numbered("initial_stress", scene.initial_stresses, all);
  list_probes(scene, all);
}

}  // namespace pinball
