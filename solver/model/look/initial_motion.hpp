#pragma once

#include <vector>

#include <solver/model/model.hpp>

#include "extent.hpp"

namespace pinball {

/// How places of a mover begin to move: with it, as it turns, and on their own.
struct InitialMotion {
  Extent velocity;     ///< of its places, without its turning [length/time]
  Point mean{};        ///< of the velocities of its nodes [length/time]
  double spread = 0;   ///< how far others are from that, without its turning [length/time]
  Point centre{};      ///< mean of its nodes [length]
  double radius = 0;   ///< of the sphere about it that holds all of them [length]
  double turning = 0;  ///< angular velocity [1/time]
  double speed = 0;    ///< largest of a place [length/time]
};

/// Nodes of each rigid body: those of its bodies, and those that are attached to it.
std::vector<std::vector<std::int32_t>> nodes_of_rigid_bodies(const Scene& scene, const ModelMesh& mesh);
/// Of each node, without noise [length/time].
std::vector<Point> initial_velocities(const Scene& scene, const ModelMesh& mesh);

/// Of each of the groups that the bodies are in. group: per body. Bodies turn about the means of their nodes.
std::vector<InitialMotion> initial_motions(const Scene& scene, const ModelMesh& mesh,
                                           const std::vector<std::int32_t>& group, std::size_t groups);

}  // namespace pinball
