#pragma once

#include <array>
#include <cstdint>
#include <limits>
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
/// that is nearest to the point (the first of several). A set of elements, of faces or a part stands for its nodes.
struct NodeSelection {
  std::string where{};           ///< "FILE:LINE:COLUMN: KEY" of the table, for messages; "load.0" in a host's scene
  std::string body{};            ///< body; empty: of all bodies
  std::optional<Plane> plane{};  ///< plane = { point, normal }: on the plane
  std::optional<Line> line{};    ///< line = { point, direction }: on the line
  std::optional<Box> box{};      ///< box = { low, high }: in the box or on its faces
  std::optional<Point> nearest{};
  std::string set{};                  ///< set: name or number in a mesh file, of nodes, faces, elements or a part
  std::vector<std::int64_t> nodes{};  ///< nodes: numbers that the mesh file gives them
  std::string file{};                 ///< file: the mesh file that the set or the numbers are of; empty: the only one
  std::string without{};              ///< without: a set whose nodes are left out
  double tolerance = 0;  ///< tolerance: how far from plane, line and box nodes may be; 0: by the mesh [length]

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

/// When something acts: from start on, and before end.
struct TimeSpan {
  double start = 0;                                      ///< start; <= 0: from the beginning [time]
  double end = std::numeric_limits<double>::infinity();  ///< end [time]

  bool contains(double time) const { return (start <= 0 || time >= start) && time < end; }
  bool always() const { return start <= 0 && end == std::numeric_limits<double>::infinity(); }
};

enum class Frame { global, cylindrical };

/// [[constraint]] type = "fixed": the nodes may not move along some directions.
struct FixedConstraint {
  NodeSelection nodes{};
  /// directions: unit vectors, in components along x, y, z, or along "radial", "circumferential", "axial" of each node
  std::vector<Point> directions{};
  Frame frame = Frame::global;  ///< frame = "global" | "cylindrical"
  Line axis{};                  ///< axis = { point, direction } of the cylindrical frame
  TimeSpan when{};              ///< start, end
  std::string name{};           ///< name: of its force on the nodes; those of one name together; empty: not asked for
};

/// [[equation]]: one term of a linear equation among displacements. The terms of one name add up to zero: the sum of
/// factor (u . direction) over them, once for all of their nodes or, where terms have several nodes, for the first of
/// each, the second of each and so on; a term of one node is then in all of these.
struct EquationTerm {
  std::string name{};  ///< name: of the equation that it is a term of
  Point direction{};   ///< direction: of the displacement, of unit length
  double factor = 1;   ///< factor [-]
  NodeSelection nodes{};
};

/// [[rigid_wall]]: a plane that no node crosses, free to be left. With a mass it moves along its normal as the nodes
/// push it; else with a speed as given.
struct RigidWall {
  std::string name{};  ///< name: unique; default: wall_NUMBER
  Plane plane{};       ///< point, normal: the normal points to the free side
  std::string body{};  ///< body: only nodes of this body; default: all
  std::string where{};
  double friction = 0;           ///< friction: Coulomb coefficient [-]
  bool sliding = true;           ///< sliding = false: nodes do not move along the wall while they touch it
  NodeSelection nodes{};         ///< set, nodes, box, without: only these nodes; default: all
  TimeSpan when{};               ///< start, end
  std::optional<Point> edge{};   ///< edge: direction of the first side of a rectangle with a corner in `point`
  std::array<double, 2> size{};  ///< size: of its sides, along edge and normal x edge; 0: without end [length]
  double mass = 0;               ///< mass: of a wall that is pushed; 0: nothing moves it [mass]
  double speed = 0;              ///< speed: along the normal, with a mass that at the start [length/time]
  TimeTable table{};             ///< times, factors of the speed; without a mass
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
  TimeSpan when{};     ///< start, end: the nodes are free before and after; factors are of the time of the run
  std::string name{};  ///< name: as of a constraint
};

/// [[load]]: a force on the nodes together, shared in proportion to their masses.
struct NodalLoad {
  NodeSelection nodes{};
  Point force{};      ///< force: total [force]
  TimeTable table{};  ///< times, factors
  bool each = false;  ///< each: the force is that on each of the nodes
};

/// [[pressure]]: on faces of elements, against their outward normals, wherever these go. The faces that are listed,
/// those of a set, or the exposed ones all of whose corners are selected. Faces of eroded elements are free of it.
struct Pressure {
  std::string name{};     ///< name: unique; default: pressure_NUMBER
  NodeSelection faces{};  ///< set, body, plane, ...
  /// faces: four nodes each (of a triangle the last one twice), by the numbers that the mesh file gives them
  std::vector<std::array<std::int64_t, 4>> corners{};
  double pressure = 0;  ///< pressure: where the factor is 1; positive: it presses [stress]
  TimeTable table{};    ///< times, factors
  double start = 0;     ///< start: none before; times count from it [time]
};

/// [[gravity]]: an acceleration of all bodies, or of some.
struct Gravity {
  Point acceleration{};               ///< acceleration [length/time^2]
  TimeTable table{};                  ///< times, factors
  std::vector<std::string> bodies{};  ///< bodies; empty: all
  std::string name{};                 ///< name: as of a constraint
};

/// [[point_mass]]: mass at nodes beside that of their elements.
struct PointMass {
  NodeSelection nodes{};
  double mass = 0;    ///< mass: of the nodes together, shared in proportion to the masses of their elements [mass]
  bool each = false;  ///< each: the mass is that of each of the nodes
};

/// [[initial_velocity]]: of some nodes, in place of that of their body.
struct InitialVelocity {
  NodeSelection nodes{};
  Point velocity{};                                    ///< velocity [length/time]
  Point angular_velocity{};                            ///< angular_velocity: adds w x (x - centre) [1/time]
  Point centre{};                                      ///< centre: a point of the axis [length]
  std::array<bool, 3> components{{true, true, true}};  ///< components: those that are set; the others stay
};

/// [[initial_stress]]: of some elements at the start. A set of elements or a part stands for its elements; else those
/// all of whose corners are selected.
struct InitialStress {
  NodeSelection nodes{};
  std::vector<std::int64_t> elements{};  ///< elements: by the numbers that the mesh file gives them
  Point stress{};                        ///< stress: xx, yy, zz of Cauchy's, along x, y, z [stress]
  Point shear_stress{};                  ///< shear_stress: xy, yz, zx [stress]
  double plastic_strain = 0;             ///< plastic_strain: effective; of what yields [-]
};

enum class ProbeKind { node, element };

/// [[probe]]: history of a node or an element: the one nearest to a point at the start, or the one that a mesh file
/// gives a number.
struct Probe {
  std::string name{};                   ///< name: unique, also among the bodies
  ProbeKind kind = ProbeKind::node;     ///< kind = "node" | "element"
  Point point{};                        ///< point, at the start [length]
  std::string body{};                   ///< body: only of this body; default: all
  std::vector<std::string> quantities;  ///< quantities: see probe_quantities(); default: all of the kind
  std::string where{};
  /// node, element: its number in the mesh file that `body` is from, in the place of a point
  std::optional<std::int64_t> number{};
};

/// What a probe of a kind can watch: "position", "displacement", "velocity"; "stress", "effective_stress",
/// "plastic_strain".
const std::vector<std::string>& probe_quantities(ProbeKind kind);

}  // namespace pinball
