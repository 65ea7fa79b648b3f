#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// How far from a plane, a line or a box a node may lie and count as on it. Files of meshes round places, so that it
/// goes by the mesh: a thousandth of the shortest edge at the node, or what six or seven digits leave of places where
/// that is more, but no more than a hundredth of the edge. A gap between bodies is larger.
class PlaceTolerance {
 public:
  /// given: for all nodes; 0: by the mesh, which has to stay [length]
  PlaceTolerance(const ModelMesh& mesh, double given);

  double of(std::int32_t node) const;    ///< [length]
  double near(std::int32_t node) const;  ///< up to which somebody may have meant the node: a tenth of its edge [length]

 private:
  double edge_of(std::int32_t node) const { return mesh_.edge.empty() ? 0.0 : mesh_.edge[node]; }

  const ModelMesh& mesh_;
  double given_, rounding_ = 0, least_ = 0;
};

struct SelectedNodes {
  std::vector<std::int32_t> nodes;  ///< in the mesh, ascending
  std::int64_t near = 0;            ///< further ones that lie near to plane, line or box
};

/// The nodes of a selection, of which there may be none.
SelectedNodes selected_nodes(const ModelMesh& mesh, const NodeSelection& selection);

/// The same without those near.
std::vector<std::int32_t> matching_nodes(const ModelMesh& mesh, const NodeSelection& selection);

/// The same, but throws InputError that names the selection if there is none.
std::vector<std::int32_t> select_nodes(const ModelMesh& mesh, const NodeSelection& selection);

/// What a symmetry constraint holds, and what a wall acts on.
NodeSelection nodes_of(const PlaneConstraint& plane);
NodeSelection nodes_of(const RigidWall& wall);

/// Calls look(NodeSelection) for everything of the scene that acts on nodes, which pressures do not.
template <class Look>
void for_each_selection_of_nodes(const Scene& scene, const Look& look) {
  for (const PlaneConstraint& plane : scene.constraints) look(nodes_of(plane));
  for (const FixedConstraint& fixed : scene.fixed_constraints) look(fixed.nodes);
  for (const EquationTerm& term : scene.equation_terms) look(term.nodes);
  for (const AttachedNodes& attached : scene.attached_nodes) look(attached.nodes);
  for (const RigidWall& wall : scene.rigid_walls) look(nodes_of(wall));
  for (const PrescribedVelocity& given : scene.prescribed_velocities) look(given.nodes);
  for (const NodalLoad& load : scene.loads) look(load.nodes);
  for (const PointMass& point : scene.point_masses) look(point.nodes);
  for (const InitialVelocity& given : scene.initial_velocities) look(given.nodes);
  for (const InitialStress& given : scene.initial_stresses) look(given.nodes);
}

/// Whether anything of the scene asks where nodes lie.
bool selects_by_place(const Scene& scene);

/// Largest extent of the mesh along x, y or z [length].
double mesh_size(const ModelMesh& mesh);

/// The selection in words: "on the plane through (0, 0, 0) with normal (1, 0, 0), of body bar".
std::string describe(const NodeSelection& selection);

}  // namespace pinball
