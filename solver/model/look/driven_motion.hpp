#pragma once

#include <vector>

#include <solver/model/model.hpp>

#include "extent.hpp"

namespace pinball {

/// What acts on a mover from outside in the course of the run.
struct DrivenMotion {
  std::vector<Extent> moved;      ///< displacements that prescribed motion gives, at each time; empty boxes: none
  std::vector<Extent> pushed;     ///< and that gravity, loads and pressures add [length]
  std::array<bool, 3> stopped{};  ///< directions in which some node cannot move
  bool in_part = false;           ///< some of its nodes move as prescribed, others do not
  bool wholly = false;            ///< all its nodes move as prescribed, in all directions
  bool held = false;              ///< all its nodes are held in all directions
  double speed = 0;               ///< largest prescribed one [length/time]
  double turned = 0;              ///< largest angle by which a rigid body is turned as given [rad]
};

/// Of each of the groups that the bodies are in. times: ascending.
std::vector<DrivenMotion> driven_motions(const Scene& scene, const ModelMesh& mesh,
                                         const std::vector<std::int32_t>& group, std::size_t groups,
                                         const std::vector<double>& times);

/// How far along its normal a wall has moved [length].
double wall_displacement(const RigidWall& wall, double time);

}  // namespace pinball
