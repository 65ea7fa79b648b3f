#pragma once

#include <algorithm>

#include <solver/model/model.hpp>

namespace pinball {

/// What velocities that nodes are given at once have within elements, beyond those that a smooth motion has.
struct UnequalVelocities {
  double speed = 0;   ///< at which the ends of an edge come nearer, or part, at most [length/time]
  double energy = 0;  ///< of the nodes of such elements, beside the mean motion of each [energy]

  void join(const UnequalVelocities& other) {
    speed = std::max(speed, other.speed);
    energy += other.energy;
  }
};

/// A hundredth of the speed of waves is taken off: what spins or stretches in common has less. velocity: by how much
/// that of each node has changed, in records of four of the store.
template <class S>
UnequalVelocities unequal_velocities(const Model<S>& model, const S* velocity);

}  // namespace pinball
