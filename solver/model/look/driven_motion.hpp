#pragma once

#include <optional>
#include <vector>

#include <solver/model/model.hpp>

#include "extent.hpp"
#include "time_course.hpp"

namespace pinball {

/// A motion that is prescribed to all nodes of a mover, along some of the axes.
struct WholeMotion {
  std::array<bool, 3> along{};
  Point vector{};     ///< of which the course gives multiples
  bool adds = false;  ///< an acceleration: to the motion that is there when it begins
  MotionCourse course;
};

/// A motion that is prescribed to some nodes of a mover.
struct PartMotion {
  std::vector<Point> way;          ///< at each time [length]
  std::optional<Point> direction;  ///< along which alone it acts, a unit vector
};

/// What acts on a mover from outside in the course of the run.
struct DrivenMotion {
  std::vector<WholeMotion> whole;  ///< of several at one time the last one counts
  std::vector<Extent> moved;       ///< displacements that other motions give, at each time; empty boxes: none
  std::vector<PartMotion> parts;   ///< the same motions
  std::vector<double> carried;     ///< how far those may bring it that do not act all the time [length]
  std::vector<Point> pushed;       ///< what gravity, loads and pressures add [length]
  std::vector<Point> push_rate;    ///< its rate [length/time]
  std::vector<double> strained;    ///< how far forces against each other may move its places [length]
  std::array<bool, 3> stopped{};   ///< directions in which some node cannot move
  bool in_part = false;            ///< some of its nodes move as prescribed, others do not
  bool guided = false;             ///< along a direction askew to the axes, which turns other motion aside
  bool turns_not = false;          ///< a rigid body of it is held against turning
  bool wholly = false;             ///< all its nodes move as prescribed, in all directions, all the time
  bool held = false;               ///< all its nodes are held in all directions
  double speed = 0;                ///< largest prescribed one [length/time]
  double turned = 0;               ///< largest angle by which a rigid body is turned as given [rad]
  double swung = 0;                ///< largest angle by which loads and pressures turn it where nothing stops it [rad]
};

/// Of each of the groups that the bodies are in. times: ascending.
std::vector<DrivenMotion> driven_motions(const Scene& scene, const ModelMesh& mesh,
                                         const std::vector<std::int32_t>& group, std::size_t groups,
                                         const std::vector<double>& times);

/// How far along its normal a wall has moved [length].
double wall_displacement(const RigidWall& wall, double time);

}  // namespace pinball
