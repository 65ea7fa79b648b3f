#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <solver/formats/abaqus/mesh/abaqus_mesh.hpp>
#include <solver/formats/deck/deck_definitions.hpp>
#include <solver/formats/deck/deck_element.hpp>
#include <solver/formats/deck/deck_point_masses.hpp>
#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/deck_scene.hpp>
#include <solver/formats/deck/deck_side.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/mesh/number_index.hpp>

namespace pinball {

/// A body of the scene: a section of an instance that has elements.
struct AbaqusBody {
  std::string name;      ///< in the scene
  std::string part;      ///< name of its elements in the mesh
  std::string material;  ///< key of the label; empty: of rigid elements
  std::size_t section;   ///< place in the sections of the mesh
  bool is_rigid_elements() const { return material.empty(); }
};

/// An amplitude as a factor over time.
struct AbaqusCurve {
  std::vector<double> times, factors;
  bool absolute = false;    ///< VALUE=ABSOLUTE: the factors are the values themselves
  bool total_time = false;  ///< TIME=TOTAL TIME: of the run and not of the step
};

/// A *STEP: when it begins, and how long it takes [time].
struct AbaqusStep {
  double start = 0, period = 0;
  bool ramps = false;  ///< AMPLITUDE=RAMP
};

/// Nodes that a label of the deck means.
struct AbaqusNodes {
  std::string set;                    ///< name in the mesh; empty: a single node
  std::int64_t number = 0;            ///< of the single node, in the mesh
  std::vector<std::int32_t> members;  ///< places in the mesh
};

/// Of a rigid body with what is at its reference node.
struct AbaqusWeight {
  double mass = 0;  ///< without what nodes have of elements that deform [mass]
  Point centre{};
  std::array<Point, 3> inertia{};  ///< about the centre, with those of all its nodes [mass length^2]
};

/// A *RIGID BODY: bodies that move as one, with their reference node; or a *COUPLING: nodes that do.
struct AbaqusRigidBody {
  DeckCard card;
  std::vector<std::string> bodies;
  std::vector<std::int32_t> tied{};      ///< nodes of parts that deform which move with it, ascending
  std::vector<bool> own{};               ///< per node of the mesh: whether its elements have it; empty: of nodes alone
  double mass = 0;                       ///< of MASS elements at its reference node [mass]
  std::array<Point, 3> inertia{};        ///< of ROTARYI elements there [mass length^2]
  std::optional<AbaqusWeight> weight{};  ///< where it is not that of its solids alone
  std::array<std::vector<std::array<double, 2>>, 6> led{};  ///< from when to when directions, and rotations, are given
  std::string name{}, nodes{};  ///< of a *COUPLING: its own in the scene, and that of its set in the mesh
  std::int32_t node = -1;       ///< place of the reference node in the mesh
  Point offset{};               ///< of it from the centre of mass [length]
  unsigned held = 0;            ///< at all times: bits of x, y, z, and behind these of rotations about them
  unsigned translations = 0;    ///< the same of directions that are held or moved at any time
  unsigned angles = 0;          ///< the same of rotations that are given as angles
  bool is_wall = false;         ///< of an analytical surface, without bodies
  bool is_coupling() const { return !name.empty(); }
  /// Whether a direction, or behind three of them a rotation, is held or moved from the start to the end.
  bool is_led(std::size_t direction, double end) const;
  std::optional<Point> velocity{}, angular_velocity{};  ///< of the reference node, at the start
};

/// A *RIGID BODY that is a straight analytical surface.
struct AbaqusWall {
  DeckCard card;
  std::set<std::string> keys;  ///< of the labels of its surface
  Point point{};               ///< where its line begins [length]
  Point normal{}, edge{};      ///< to its free side, along its line
  double length = 0;           ///< of its line [length]
  bool is_used = false;        ///< by a contact
};

/// What keywords of Abaqus input refer to by label.
class AbaqusData {
 public:
  /// deck, mesh and report have to stay.
  AbaqusData(const AbaqusDeck& deck, const AbaqusMesh& mesh, DeckReport& report);

  const AbaqusDeck& deck;
  const AbaqusMesh& mesh;
  DeckReport& report;
  const EdgeMiddles middles;  ///< of elements of ten and twenty nodes

  std::vector<AbaqusBody> bodies;
  std::vector<DeckElement> body_elements;               ///< per body, when they are known
  std::vector<AbaqusStep> steps;                        ///< one after the other, at least one
  std::vector<bool> used;                               ///< per node of the mesh: whether an element has it
  DeckPointMasses point_masses;                         ///< of nodes of solids that deform
  std::vector<const AbaqusPointElement*> heavy_points;  ///< MASS elements with a mass
  std::vector<AbaqusRigidBody> rigid;
  std::vector<AbaqusWall> walls;
  std::vector<std::int32_t> rigid_of_node;  ///< per node: the rigid body whose elements have it, or -1; empty: none

  /// The nodes of a set, or one by its number, as the assembly calls them. Throws InputError where they are not there.
  AbaqusNodes nodes(const std::string& label, const DeckPlace& place) const;
  /// The rigid body whose reference node stands there; null: none.
  AbaqusRigidBody* rigid_at(std::int32_t node);
  bool has_reference(const AbaqusNodes& nodes);
  /// The wall of a *RIGID BODY with an ANALYTICAL SURFACE; what is no wall is refused.
  void add_wall(const AbaqusComponent& component, const AbaqusBlock& block);
  /// The wall of a surface; null: it is none.
  AbaqusWall* wall(const std::string& label);
  /// Places of the elements of a set, of the one with a number, or of all for an empty label. Throws InputError where
  /// they are not there.
  std::vector<std::int32_t> elements(const std::string& label, const DeckPlace& place) const;
  /// Bodies of a set of elements, or of all for an empty label. Throws InputError for one that is not there; returns
  /// none for a set that is not made of whole bodies.
  std::vector<std::string> whole_bodies(const std::string& label, const DeckPlace& place) const;
  /// Name of a surface of faces. Throws InputError where it is not there.
  std::string faces(const std::string& label, const DeckPlace& place) const;
  /// A surface of faces; null: there is none of this label.
  const FaceSet* find_faces(const std::string& label) const;
  /// A surface as a side of a contact: faces or nodes. Throws InputError where it is not there.
  DeckSide surface(const std::string& label, const DeckPlace& place) const;
  /// The step that a keyword stands in; of those before all steps the first one.
  const AbaqusStep& step_of(const AbaqusBlock& block) const;
  /// When the last step ends [time].
  double end() const { return steps.back().start + steps.back().period; }
  /// The amplitude that a block in a step names, or that of the step, over the time of the run: when its step ends, it
  /// stays what it is. No times: a factor of 1. Throws InputError for one that is not there.
  AbaqusCurve curve(const AbaqusBlock& block) const;
  /// The last keyword of a name, without case and blanks, which is the one that counts; null: none.
  const AbaqusBlock* last(const std::string& name) const;
  /// Throws InputError where the deck gives this ("material STEEL") already.
  void give_once(const std::string& what, const DeckPlace& place) { given_.add(what, place); }
  /// Reports what is defined and nothing has named: when all else is translated.
  void tell_unused_definitions() { definitions_.tell_unused(report); }
  /// Name of a material, or the like, in the scene.
  std::string material_name(const std::string& key) const {
    return key.empty() ? "rigid_elements" : "mat_" + plain_name(key);
  }
  static std::string plain_name(const std::string& label);

 private:
  void name_bodies();
  void require_sections() const;
  [[noreturn]] void throw_at_element(std::size_t e, const std::string& part) const;
  void read_steps();
  void read_amplitude(const AbaqusBlock& block);
  const AbaqusRange* range_of(const std::string& instance) const;

  void require_once(const AbaqusBlock& block);

  NumberIndex numbers_;  ///< of nodes
  GivenOnce given_;
  std::map<std::string, std::size_t> node_sets_, element_sets_, face_sets_, components_;
  std::map<std::string, AbaqusCurve> amplitudes_;
  DeckDefinitions<std::string> definitions_;
};

/// A factor that is that of the curve between these times alone, for loads: it comes and goes within 1e-9 of them.
/// start <= 0: from the beginning; no end: to that of the run.
AbaqusCurve within(AbaqusCurve curve, double start, std::optional<double> end);

/// All numbers of a data line, which may be more than it has fields by names. Throws InputError for what is none.
std::vector<double> numbers_of(const AbaqusBlock& block, const DataLine& card);

/// times and factors of a curve, times a magnitude; nothing for a factor of 1.
void set_curve(const AbaqusCurve& curve, double magnitude, const DeckKeys<TimeTable>& keys);

}  // namespace pinball
