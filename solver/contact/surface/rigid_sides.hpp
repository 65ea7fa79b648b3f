#pragma once

#include <cstdint>
#include <vector>

#include <kernels/tensor.hpp>

namespace pinball {

/// How a rigid body answers an impulse at the present place. Impulse P and moment D about its centre change the
/// velocity of the centre by `translation` P, and the angular velocity by `rotation` D; directions that are held or
/// moved as prescribed have no mobility.
struct RigidSide {
  Vec3<double> centre{};            ///< [length]
  Symmetric<double> translation{};  ///< 1/M where it is free [1/mass]
  Symmetric<double> rotation{};     ///< I^-1 where it is free [1/(mass length^2)]
  double most_translation = 0;      ///< largest principal value [1/mass]
  double most_rotation = 0;         ///< the same [1/(mass length^2)]

  bool is_mobile() const { return most_translation > 0 || most_rotation > 0; }
};

/// The rigid bodies of whoever owns nodes, as contact sees them.
struct RigidSides {
  std::vector<std::int32_t> body_of_node;  ///< per node of the store; -1: it moves by itself
  std::vector<RigidSide> bodies;           ///< brought up to date before each step
};

}  // namespace pinball
