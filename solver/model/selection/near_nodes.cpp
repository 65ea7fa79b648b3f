#include "near_nodes.hpp"

#include <fmt/core.h>

#include "node_selection.hpp"

namespace pinball {

std::vector<std::string> find_near_nodes(const Scene& scene, const ModelMesh& mesh) {
  std::vector<std::string> found;
  const auto look = [&](const NodeSelection& selection) {
    if (!selection.plane && !selection.line && !selection.box) return;
    const SelectedNodes selected = selected_nodes(mesh, selection);
    if (selected.near == 0) return;
    found.push_back(
        fmt::format("{}: {} node{} within a tenth of an element of those {} {} not taken, {} are: give a tolerance if "
                    "they are meant",
                    selection.where, selected.near, selected.near == 1 ? "" : "s", describe(selection),
                    selected.near == 1 ? "is" : "are", selected.nodes.size()));
  };
  for (const PlaneConstraint& plane : scene.constraints) look(nodes_of(plane));
  for (const FixedConstraint& fixed : scene.fixed_constraints) look(fixed.nodes);
  for (const RigidWall& wall : scene.rigid_walls) look(nodes_of(wall));
  for (const PrescribedVelocity& given : scene.prescribed_velocities) look(given.nodes);
  for (const NodalLoad& load : scene.loads) look(load.nodes);
  for (const Pressure& pressure : scene.pressures) look(pressure.faces);
  for (const InitialVelocity& given : scene.initial_velocities) look(given.nodes);
  return found;
}

}  // namespace pinball
