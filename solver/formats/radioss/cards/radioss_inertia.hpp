#pragma once

#include "radioss_data.hpp"

/// Masses and inertias of rigid bodies of Radioss input.
namespace pinball {

/// Of nodes, from an eighth of the mass of each of their solids, about `centre` or, without one, that of these masses.
/// nodes: per node of the mesh whether it counts. Inertia is in the global system [mass length^2].
RadiossInertia radioss_inertia(const RadiossData& data, const std::vector<bool>& nodes,
                               const std::optional<Point>& centre = {});

/// What stands on the cards of an /RBODY: Mass and J of its main node, ICoG and Ispher.
struct RadiossMainMass {
  double mass = 0;
  std::array<Point, 3> inertia{};  ///< about the main node, rows
  int centre = 1;                  ///< ICoG
  bool is_sphere = false;          ///< Ispher 1

  bool changes_nothing() const;
};

/// Of a rigid body: what its main node adds to its nodes, about the centre that ICoG says: 1 that of all, 2 that of the
/// nodes, 3 the main node, 4 the main node by itself; a sphere has the mean of the principal inertias.
RadiossInertia with_main_node(const RadiossData& data, const std::vector<bool>& nodes, const Point& main,
                              const RadiossMainMass& given);

/// What /ADMAS of types 0 and 1 give a node [mass].
double mass_added_to(const RadiossData& data, std::int32_t main);

/// Per node of the mesh whether it is of a rigid body, which is one of data.rigid.
std::vector<bool> nodes_of(const RadiossData& data, const RadiossRigidBody& rigid);

/// Nodes of a rigid body, and weights whose sum is 1, with which their mean is at a point wherever the body is: forces
/// in these shares are one at the point. Empty where no four of them are out of one plane.
std::vector<std::pair<std::int32_t, double>> shares_at(const RadiossData& data, const RadiossRigidBody& rigid,
                                                       const Point& point);

}  // namespace pinball
