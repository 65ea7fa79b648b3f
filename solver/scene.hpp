#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/export.h"
#include "contact/contact_settings.hpp"
#include "mesh_settings.hpp"
#include "scene_boundary.hpp"
#include "scene_contact.hpp"
#include "scene_material.hpp"
#include "scene_rigid.hpp"

/// A scene: plain data with defaults, read from a file or filled in by a host; no arrays of the size of the mesh.
/// Every field carries the TOML key that sets it. Units are the scene's own consistent set. What is called "not set"
/// below complete_scene() fills in (scene_rules.hpp).
namespace pinball {

enum class Precision {
  float32,
  float64,
  mixed,  ///< nodes and contact in double, the work of elements in single precision
};

/// As scenes name it.
constexpr const char* name_of(Precision precision) {
  return precision == Precision::float32 ? "float" : precision == Precision::float64 ? "double" : "mixed";
}
/// Whether elements have numbers of single precision.
constexpr bool has_single_elements(Precision precision) { return precision != Precision::float64; }
enum class HourglassControl { none, viscous, stiffness, assumed_strain };
enum class NegativeVolume { stop, erode };
enum class InsideOut { warn, erode, stop };

/// Of the viscous and stiffness forms; of the assumed strains the factor on what the material gives [-].
inline double default_hourglass_coefficient(HourglassControl control) {
  return control == HourglassControl::assumed_strain ? 1.0
         : control == HourglassControl::stiffness    ? 0.05
         : control == HourglassControl::viscous      ? 0.025
                                                     : 0.0;
}

enum class MassScaling { small, all };

struct TimeSettings {
  double end = 0.0;         ///< time.end: when the run stops [time], required
  double cfl = 0.9;         ///< time.cfl: fraction of the stable step, 0 < cfl <= 1.2
  std::int64_t steps = -1;  ///< time.steps: stop after so many steps; -1: no limit
  /// time.subcycling: elements that are stable with a larger step make one, a power of two times the smallest
  bool subcycling = false;
  /// time.smallest_step: elements that would need a smaller one get as much mass as makes it stable; 0: none [time]
  double smallest_step = 0.0;
  /// time.mass_scaling = "small" | "all": only those, or mass is added to and taken from all, so that all have that
  /// step
  MassScaling mass_scaling = MassScaling::small;
};

struct ElementSettings {
  /// element.hourglass = "none" | "viscous" | "stiffness" | "assumed_strain"
  HourglassControl hourglass = HourglassControl::assumed_strain;
  /// element.hourglass_coefficient; negative: not set, becomes default_hourglass_coefficient [-]
  double hourglass_coefficient = -1.0;
  bool bulk_viscosity = true;        ///< element.bulk_viscosity = true | false
  double linear_viscosity = 0.06;    ///< element.linear_viscosity: b1 [-]
  double quadratic_viscosity = 1.2;  ///< element.quadratic_viscosity: b2 [-]
  /// element.negative_volume = "stop" | "erode"; default: erode where a material erodes, stop elsewhere
  std::optional<NegativeVolume> negative_volume;
  /// element.inside_out = "warn" | "erode" | "stop": what becomes of an element with a corner that has turned over
  InsideOut inside_out = InsideOut::warn;
  /// element.folding_resistance: modulus with which corners resist turning over, over the bulk modulus [-]
  double folding_resistance = 0.02;

  bool operator==(const ElementSettings&) const = default;
};

struct SkipSettings {
  bool contact_search = true;  ///< skip.contact_search: lists of what may touch last while the skin allows it
  bool resting = true;         ///< skip.resting: tiles of elements at rest or in free uniform flight are not computed
};

struct GuardSettings {
  double energy_error = 0.5;  ///< guard.energy_error: stop when |energy balance error| exceeds this [-]
  /// guard.time_step_collapse: stop when the stable step is smaller than this times the largest of the run [-]
  double time_step_collapse = 1e-6;
};

enum class ElementShape {
  hexahedra,
  tetrahedra  ///< each hexahedron of the mesh is cut into six
};

/// One [[body]] table.
struct Body {
  std::string name;
  std::string material;                             ///< material: name of a [[material]]
  MeshSettings mesh;                                ///< mesh: inline table or [body.mesh]
  ElementShape elements = ElementShape::hexahedra;  ///< elements: of a mesh that is generated
  Point position{};                                 ///< position: translation of the mesh, after the rotation [length]
  /// axis: unit vector onto which the body's z axis is turned (shortest rotation); default: no rotation
  std::optional<Point> axis;
  Point velocity{};          ///< velocity: initial, uniform [length/time]
  Point angular_velocity{};  ///< angular_velocity: initial rigid spin about the body's centroid [1/time]
  /// velocity_gradient: 3 x 3, rows; adds G (x - centroid) to the initial velocity [1/time]
  std::array<Point, 3> velocity_gradient{};
  double velocity_noise =
      0.0;  ///< velocity_noise: adds a deterministic pseudo-random velocity of this amplitude [length/time]
  /// element: in place of [element] of the scene; in a file what it leaves out is as there
  std::optional<ElementSettings> element;
};

/// One [[constraint]] table. type = "symmetry": nodes on the plane may not move along its normal.
struct PlaneConstraint {
  Point point{};
  Point normal{};        ///< of unit length
  std::string body;      ///< body: only nodes of this body; default: all
  std::string set{};     ///< set: these nodes of a mesh file, in the place of those on the plane
  double tolerance = 0;  ///< tolerance: how far from the plane nodes may be; 0: by the mesh [length]
  std::string where{};   ///< for messages
  std::string name{};    ///< name: of its force on the nodes; those of one name together; empty: not asked for
};

struct DampingSettings {
  double mass = 0.0;  ///< damping.mass: a in the force -a m v on every node [1/time]
};

struct OutputSettings {
  double interval = 0.0;            ///< output.interval: between history rows [time]; 0: 200 rows over the run
  bool every_step = false;          ///< output.interval = "step": a history row per step
  double field_interval = 0.0;      ///< output.field_interval: between field outputs [time]; 0: none
  std::vector<double> field_times;  ///< output.field_times: field output at these times [time]
  /// output.body_energies: energies, momentum and mass of each body in history.csv. Tiles of elements are then of one
  /// body each: where bodies share a material, results are others in their last digits
  bool body_energies = false;
  /// output.fields: which of these
  std::vector<std::string> fields{"velocity",       "contact_force", "stress",      "plastic_strain",
                                  "pinball_radius", "alive",         "corner_share"};
};

/// Where the arrays of a run lie, and its steps are made.
enum class Device { none, mock, cuda, hip };

struct Scene {
  std::string name;                          ///< file name without folder and ending
  std::string path;                          ///< the file it was read from
  std::string title;                         ///< title
  std::string units;                         ///< units = "in-lbf-s": named, compared with known solids, never converted
  Precision precision = Precision::float64;  ///< precision = "double" | "float" | "mixed"
  Device device = Device::none;              ///< --device
  int refine = 1;                            ///< --refine: already multiplied into the element counts of the meshes
  /// Translated from a deck of another program, in which nothing touches without a card that says so.
  bool of_deck = false;
  TimeSettings time;
  ElementSettings element;
  ContactSettings contact;
  std::vector<ContactPair> contact_pairs;  ///< [[contact.pair]]; none: all touches all
  std::vector<TiedContact> tied_contacts;  ///< [[contact.tied]]
  SkipSettings skip;
  GuardSettings guard;
  std::vector<Material> materials;
  std::vector<Body> bodies;
  std::vector<RigidBody> rigid_bodies;
  std::vector<AttachedNodes> attached_nodes;  ///< [[rigid_nodes]]
  std::vector<RigidMotion> rigid_motions;
  std::vector<Joint> joints;
  DampingSettings damping;
  std::vector<PlaneConstraint> constraints;        ///< [[constraint]] type = "symmetry"
  std::vector<FixedConstraint> fixed_constraints;  ///< [[constraint]] type = "fixed"
  std::vector<EquationTerm> equation_terms;        ///< [[equation]]
  std::vector<RigidWall> rigid_walls;
  std::vector<PrescribedVelocity> prescribed_velocities;
  std::vector<NodalLoad> loads;
  std::vector<Pressure> pressures;
  std::vector<Gravity> gravities;
  std::vector<PointMass> point_masses;
  std::vector<InitialVelocity> initial_velocities;
  std::vector<InitialStress> initial_stresses;
  std::vector<Probe> probes;
  OutputSettings output;
};

/// What the command line adds to a scene file.
struct SceneOverrides {
  /// "KEY=VALUE", in order; KEY as in "contact.beta", "material.copper.density", "constraint.0.normal"; VALUE as in
  /// TOML, texts also without quotes. "variant=NAME" applies the keys of [variant.NAME], before all others.
  std::vector<std::string> set{};
  int refine = 1;  ///< multiplies the element counts of every generated mesh in each direction
  std::optional<Precision> precision{};
  std::vector<std::string> vary{};  ///< as `set`, and after it: one value of each --vary
};

/// Reads, overrides and checks a scene. Throws InputError naming file, line, key and what was expected.
PINBALL_API Scene read_scene(const std::string& path, const SceneOverrides& overrides = {});

struct GivenScene;  // solver/scene/given/given_scene.hpp: not for hosts

/// What a scene is read from, mesh files apart: enough to read the same scene again when its file has changed.
struct SceneSource {
  std::string path;  ///< for messages and the name; mesh files are named relative to its folder
  std::string text;  ///< of the file
  SceneOverrides overrides;
  std::shared_ptr<const GivenScene> given{};  ///< what a deck of another program gives, in place of a text; null: none
};
/// Throws InputError where there is no such file.
PINBALL_API SceneSource read_scene_source(const std::string& path, const SceneOverrides& overrides = {});
PINBALL_API Scene read_scene(const SceneSource& source);

/// A path as given if it is a file, else the scene NAME or NAME.toml in the first of these folders that has it:
/// $PINBALL_DATA/scenes, share/pinball/data/scenes below the prefix of the installed library or program, data/scenes of
/// the source tree.
/// Throws InputError that lists the known scenes and names the nearest.
PINBALL_API std::string find_scene(const std::string& name_or_path);

}  // namespace pinball
