#pragma once

#include <cstdint>
#include <vector>

#include <solver/base/point.hpp>

#include "model.hpp"

namespace pinball {

/// A direction in which the velocity of a node is given, before those of one node are made orthogonal.
struct GivenDirection {
  std::int32_t node = 0;   ///< of the scene
  Point direction{};       ///< of unit length
  double speed = 0;        ///< along it [length/time]; of a prescribed velocity as its quantity has it
  std::int32_t table = 0;  ///< number of the prescribed velocity, or of the constraint, those of planes first
  bool held = false;       ///< a constraint
  TimeSpan when{};         ///< when it counts
};

/// Below this a direction is one of those before it.
inline constexpr double least_length_left = 1e-6;

/// Those of all nodes, of all times: constraints first, then prescribed velocities, each in the order of the scene.
/// Throws InputError for a selection without nodes.
std::vector<GivenDirection> given_directions(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
