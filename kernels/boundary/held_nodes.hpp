#pragma once

#include "../node_update.hpp"
#include "node_arrays.hpp"

/// Nodes that are held or moved along some directions, orthonormal per node: first what holds, then what moves it.
namespace pinball {

/// One constrained direction of one node.
template <class S>
struct NodeConstraint {
  std::int32_t node;
  S normal[3];
  std::int32_t table;  ///< number of the [[constraint]] that takes it first: those of planes, then the fixed ones
};

/// One direction of one node, along which its velocity is given, or how much that changes.
template <class S>
struct NodePrescription {
  std::int32_t node;
  S normal[3];
  S speed;             ///< along the normal, where the factor is 1 [length/time]
  std::int32_t table;  ///< number of the [[prescribed_velocity]], whose times and factors it follows
  bool accelerates;    ///< from the velocity that the node has: speed is that of an acceleration
};

/// The nodes that take part in a step.
struct DueNodes {
  const std::int8_t* level_of_span = nullptr;  ///< of consecutive nodes each; null: all are due
  std::int32_t nodes_per_span = 1;
  std::int32_t level = 0;  ///< the highest that is due

  PINBALL_FUNCTION bool contain(std::int32_t node) const {
    return level_of_span == nullptr || level_of_span[node / nodes_per_span] <= level;
  }
};

/// Force and velocity of a constraint's node along its normal.
struct MotionAlong {
  double force, velocity;
};
template <class S>
PINBALL_FUNCTION MotionAlong motion_along(const NodeArrays<S>& nodes, const NodeConstraint<S>& c) {
  const auto place = 4 * std::int64_t(c.node);
  MotionAlong along{0, 0};
  for (int k = 0; k < 3; ++k) {
    along.force += static_cast<double>(nodes.force[place + k]) * static_cast<double>(c.normal[k]);
    along.velocity += static_cast<double>(nodes.velocity[place + k]) * static_cast<double>(c.normal[k]);
  }
  return along;
}

/// Force of a constraint that takes the force f and the velocity v along its normal: -f - m v / dt. velocity_step: dt;
/// where it is 0, nothing can be taken from the velocity [time].
template <class S>
PINBALL_FUNCTION double held_force(const NodeArrays<S>& nodes, const NodeConstraint<S>& c, double velocity_step) {
  const MotionAlong along = motion_along(nodes, c);
  const double rate = velocity_step > 0 ? along.velocity / velocity_step : 0.0;
  return -along.force - nodes.mass[c.node] * rate;
}

/// Takes the constrained directions of a node from its force and velocity.
template <class S>
struct ConstrainNodes {
  NodeArrays<S> nodes;
  const NodeConstraint<S>* constraints;
  const std::int32_t* first;  ///< per constrained node and one more: its constraints
  DueNodes due;
  double velocity_step;  ///< [time]
  double* held;          ///< per constraint, to which its force is added; null: nobody asks for it [force]

  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    const auto node = std::int64_t(constraints[first[i]].node);
    if (!due.contain(constraints[first[i]].node)) return;
    for (std::int32_t c = first[i]; c < first[i + 1]; ++c) {
      if (held != nullptr) held[c] += held_force(nodes, constraints[c], velocity_step);
      constrain_node(nodes.force + 4 * node, nodes.velocity + 4 * node, constraints[c].normal);
    }
  }
};

/// Kinetic energy that a constraint takes from a node which moves along it, as it is counted at the time of the forces
/// (external_work.hpp): v (m v + dt_(n-1/2) f) / 2. One that holds already takes nothing.
template <class S>
struct EnergyAlong {
  NodeArrays<S> nodes;
  const NodeConstraint<S>* constraints;
  double before;  ///< dt_(n-1/2) [time]

  PINBALL_FUNCTION void operator()(std::int64_t i, double& taken) const {
    const NodeConstraint<S>& c = constraints[i];
    const MotionAlong along = motion_along(nodes, c);
    taken += 0.5 * along.velocity * (nodes.mass[c.node] * along.velocity + before * along.force);
  }
};

/// Force along the direction of a prescription that gives its node the velocity wanted of it over the coming step,
/// added to that of the node:
///
///     R = (wanted - v.n) / ((dt_(n-1/2) + dt_(n+1/2))/2 / m) - f.n ,    f <- f + R n .
///
/// wanted: of one that accelerates its node the change wanted - v.n. velocity_step: (dt_(n-1/2) + dt_(n+1/2))/2 [time].
/// Returns R, zero where nothing can move the node [force].
template <class S>
PINBALL_FUNCTION S move_node(const NodeArrays<S>& nodes, const NodePrescription<S>& p, S wanted, S velocity_step) {
  const S* v = nodes.velocity + 4 * std::int64_t(p.node);
  S* f = nodes.force + 4 * std::int64_t(p.node);
  S velocity = 0, force = 0;
  for (int k = 0; k < 3; ++k) {
    velocity += v[k] * p.normal[k];
    force += f[k] * p.normal[k];
  }
  const S mobility = velocity_step * nodes.inverse_mass[p.node];
  if (!(mobility > S(0))) return S(0);
  const S reaction = (p.accelerates ? wanted : wanted - velocity) / mobility - force;
  for (int k = 0; k < 3; ++k) f[k] += reaction * p.normal[k];
  return reaction;
}

/// Moves nodes as prescribed, and adds to the reactions what that takes: contact by impulses comes between two parts of
/// them.
template <class S>
struct MoveNodes {
  NodeArrays<S> nodes;
  const NodePrescription<S>* prescribed;
  const std::int32_t* first;  ///< per moved node and one more: its prescriptions
  const double* factor;       ///< per table: means over the coming step, or how much these change [-]
  S velocity_step;            ///< [time]
  S* reaction;                ///< per prescription [force]

  PINBALL_FUNCTION void operator()(std::int64_t n) const {
    for (std::int32_t i = first[n]; i < first[n + 1]; ++i) {
      const NodePrescription<S>& p = prescribed[i];
      reaction[i] += move_node(nodes, p, static_cast<S>(factor[p.table]) * p.speed, velocity_step);
    }
  }
};

/// Sums up the forces of one table's constraints, or prescriptions.
template <class S, class Held>
struct ForceOfTable {
  const Held* held;    ///< NodeConstraint or NodePrescription
  std::int32_t table;  ///< its number
  const S* force;      ///< of each along its normal [force]

  PINBALL_FUNCTION void operator()(std::int64_t i, VectorSum& sum) const {
    if (held[i].table != table) return;
    const double size = force[i];
    const auto* const normal = held[i].normal;
    sum.join({size * static_cast<double>(normal[0]), size * static_cast<double>(normal[1]), size * normal[2]});
  }
};

/// The reactions of prescriptions: a list of forces (node_arrays.hpp).
template <class S>
struct MovingForce {
  const NodePrescription<S>* prescribed;
  const S* reaction;  ///< per prescription [force]

  PINBALL_FUNCTION std::int64_t node(std::int64_t i) const { return prescribed[i].node; }
  PINBALL_FUNCTION void find(const NodeArrays<S>& /*of*/, std::int64_t i, S* force) const {
    for (int k = 0; k < 3; ++k) force[k] = reaction[i] * prescribed[i].normal[k];
  }
};

}  // namespace pinball
