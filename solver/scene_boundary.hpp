#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh.hpp"

/// What acts on a scene from outside, and what is watched in it, as the user wrote it.
/// Every field carries the TOML key that sets it.
namespace pinball {

struct Plane {
  Point point{};   ///< point [length]
  Point normal{};  ///< normal, of unit length
};

struct Line {
  Point point{};      ///< point [length]
  Point direction{};  ///< direction, of unit length
};

struct Box {
  Point low{}, high{};  ///< low, high: opposite corners, both inside [length]
};

/// Which nodes: those of `body` that fulfil everything given, at their initial places; with `nearest`, the one of them
/// that is nearest to the point (the first of several).
struct NodeSelection {
  std::string where{};           ///< "FILE:LINE:COLUMN: KEY" of the table, for messages; "load.0" in a host's scene
  std::string body{};            ///< body; empty: of all bodies
  std::optional<Plane> plane{};  ///< plane = { point, normal }: on the plane
  std::optional<Line> line{};    ///< line = { point, direction }: on the line
  std::optional<Box> box{};      ///< box = { low, high }: in the box or on its faces
  std::optional<Point> nearest{};
  std::string set{};                  ///< set: name or number of a set of nodes in a mesh file
  std::vector<std::int64_t> nodes{};  ///< nodes: numbers that the mesh file gives them
  std::string file{};                 ///< file: the mesh file that the set or the numbers are of; empty: the only one

  /// Whether nothing is given that says which nodes.
  bool all() const { return body.empty() && !plane && !line && !box && !nearest && set.empty() && nodes.empty(); }
};

/// Factor over time: piecewise linear through the points, constant before the first and after the last.
struct TimeTable {
  std::vector<double> times{};    ///< times: increasing [time]; empty: the factor is 1
  std::vector<double> factors{};  ///< factors: one per time [-]

  double value(double time) const;
  double integral(double time) const;         ///< from time 0 [time]
  double second_integral(double time) const;  ///< of the integral, from time 0 [time^2]
};

enum class Frame { global, cylindrical };

/// [[constraint]] type = "fixed": the nodes may not move along some directions.
struct FixedConstraint {
  NodeSelection nodes{};
  /// directions: unit vectors, in components along x, y, z, or along "radial", "circumferential", "axial" of each node
  std::vector<Point> directions{};
  Frame frame = Frame::global;  ///< frame = "global" | "cylindrical"
  Line axis{};                  ///< axis = { point, direction } of the cylindrical frame
};

/// [[rigid_wall]]: a plane that no node crosses, free to be left.
struct RigidWall {
  std::string name{};  ///< name: unique; default: wall_NUMBER
  Plane plane{};       ///< point, normal: the normal points to the free side
  std::string body{};  ///< body: only nodes of this body; default: all
  std::string where{};
  double friction = 0;  ///< friction: Coulomb coefficient [-]
};

/// What a table of prescribed motion gives, whose factors multiply the velocity that stands beside it.
enum class MotionQuantity { velocity, displacement, acceleration };

/// [[prescribed_velocity]]: the nodes move as given, whatever acts on them.
struct PrescribedVelocity {
  NodeSelection nodes{};
  std::optional<Point> direction{};  ///< direction: only along this unit vector; default: all three components
  Point velocity{};                  ///< velocity; with a direction, speed times direction [length/time]
  TimeTable table{};                 ///< times, factors
  /// quantity = "velocity" | "displacement" | "acceleration": velocity is then a length or an acceleration
  MotionQuantity quantity = MotionQuantity::velocity;
};

/// [[load]]: a force on the nodes together, shared in proportion to their masses.
struct NodalLoad {
  NodeSelection nodes{};
  Point force{};      ///< force: total [force]
  TimeTable table{};  ///< times, factors
  bool each = false;  ///< each: the force is that on each of the nodes
};

/// [[gravity]]: an acceleration of all bodies.
struct Gravity {
  Point acceleration{};  ///< acceleration [length/time^2]
  TimeTable table{};     ///< times, factors
};

/// [[initial_velocity]]: of some nodes, in place of that of their body.
struct InitialVelocity {
  NodeSelection nodes{};
  Point velocity{};  ///< velocity [length/time]
};

enum class ProbeKind { node, element };

/// [[probe]]: history of the node or the element nearest to a point, chosen at the start.
struct Probe {
  std::string name{};                   ///< name: unique, also among the bodies
  ProbeKind kind = ProbeKind::node;     ///< kind = "node" | "element"
  Point point{};                        ///< point, at the start [length]
  std::string body{};                   ///< body: only of this body; default: all
  std::vector<std::string> quantities;  ///< quantities: see probe_quantities(); default: all of the kind
  std::string where{};
};

/// What a probe of a kind can watch: "position", "displacement", "velocity"; "stress", "effective_stress",
/// "plastic_strain".
const std::vector<std::string>& probe_quantities(ProbeKind kind);

}  // namespace pinball
