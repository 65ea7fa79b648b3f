#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene_boundary.hpp"

/// Rigid bodies of a scene, and what moves them, as the user wrote it. Every field carries the TOML key that sets it.
namespace pinball {

/// [[rigid_body]]: bodies that move as one and do not deform. Its mass, centre and inertia are those of the masses of
/// its nodes, an eighth of each of their elements, also of elements of other bodies that have the node, or as given.
struct RigidBody {
  std::string name{};  ///< name: unique among them; default: that of the first of its bodies
  std::vector<std::string>
      bodies{};  ///< bodies: which move together; each in one rigid body; none: attached nodes alone
  /// held: directions along which its centre does not move, unit vectors at right angles
  std::vector<Point> held{};
  /// held_rotations: directions about which it does not turn, unit vectors at right angles
  std::vector<Point> held_rotations{};
  /// mass: in place of that of the materials of its bodies, whose densities follow; 0: not set [mass]
  double mass = 0;
  /// inertia: about its centre, at the start, rows; zero: not set [mass length^2]
  std::array<Point, 3> inertia{};
  std::optional<Point> centre{};  ///< centre: of its mass, at the start, with a given inertia [length]
  /// velocity: of its centre at the start, in place of those of its nodes, and with the next one [length/time]
  std::optional<Point> velocity{};
  std::optional<Point> angular_velocity{};  ///< angular_velocity: at the start; of both a missing one is 0 [1/time]
  std::string where{};                      ///< for messages
};

/// [[rigid_nodes]]: nodes of bodies that deform which move with a rigid body, as those that share nodes with it do.
struct AttachedNodes {
  std::string rigid_body{};  ///< rigid_body: with which
  NodeSelection nodes{};
};

/// [[rigid_motion]]: a rigid body moves along a direction, or turns about one, as given, whatever acts on it. In all
/// other directions it is free.
struct RigidMotion {
  std::string rigid_body{};          ///< rigid_body: which
  std::optional<Point> direction{};  ///< direction: in which its centre moves with `speed`, a unit vector
  double speed = 0;                  ///< speed [length/time]
  std::optional<Point> axis{};       ///< axis: about which it turns with `angular_speed`, a unit vector
  double angular_speed = 0;          ///< angular_speed [1/time]
  TimeTable table{};                 ///< times, factors
  /// quantity = "velocity" | "displacement" | "acceleration": speeds are then lengths, angles or accelerations
  MotionQuantity quantity = MotionQuantity::velocity;
  TimeSpan when{};      ///< start, end: the body is free before and after; factors are of the time of the run
  std::string where{};  ///< for messages
};

enum class JointKind { spherical, revolute, cylindrical, translational, universal, locking };

/// What a joint names in the place of a rigid body: what does not move.
inline constexpr const char* ground = "ground";

/// [[joint]]: how two rigid bodies move with each other, or one with the ground. What the joint does not let them do it
/// keeps from the start, whatever acts on them.
struct Joint {
  std::string name{};  ///< name: unique among them; default: "joint_NUMBER"
  JointKind kind = JointKind::spherical;
  std::vector<std::string> bodies{};  ///< bodies: two of them; one may be the ground
  std::optional<Point> point{};       ///< point: of both, at the start [length]
  std::optional<Point> axis{};  ///< axis: of a revolute, cylindrical, translational or universal one, a unit vector
  std::optional<Point> second_axis{};  ///< second_axis: of a universal one, that of the second body, a unit vector
  std::string where{};                 ///< for messages
};

}  // namespace pinball
