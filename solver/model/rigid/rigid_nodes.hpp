#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// Number of the rigid body of this name, which a checked scene has.
std::int32_t rigid_body_of_name(const Scene& scene, const std::string& name);

/// Number of the rigid body that each body of a scene is of; -1: it deforms.
std::vector<std::int32_t> rigid_body_of_bodies(const Scene& scene);

/// A body that goes with a rigid one: the first of it or, where it has none, that of the first node attached to it.
std::size_t body_with(const Scene& scene, const ModelMesh& mesh, const RigidBody& rigid);

/// The rigid bodies of a scene, with nodes in the numbers of the scene, ascending. Nodes that other bodies share with a
/// rigid one move with it, and those attached to it. A symmetry plane with nodes of a rigid body holds it. Throws
/// InputError where two of them share a node, and for constraints, prescribed velocities, rigid walls and ties that act
/// on their nodes.
std::vector<RigidNodes> find_rigid_nodes(const Scene& scene, const ModelMesh& mesh,
                                         const std::vector<TiedNode>& tied_nodes);

/// From the numbers of the scene to those of the store.
void number_rigid_nodes(std::vector<RigidNodes>& all, const std::vector<std::int32_t>& node_of_scene_node);

/// Gives bodies of rigid ones that have a mass a material of their own, of the density that this needs.
void set_given_masses(Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
