#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <solver/formats/deck/deck_definitions.hpp>
#include <solver/formats/deck/deck_element.hpp>
#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/deck_scene.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/radioss/mesh/radioss_parts.hpp>
#include <solver/formats/radioss/scan/radioss_fields.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/number_index.hpp>

namespace pinball {

/// A body of the scene: a part that has solids.
struct RadiossBody {
  std::string name;  ///< in the scene
  RadiossPart part;
  int solids = 0;
  bool is_of_shells = false;  ///< a layer in the place of shells that do not deform
};

/// Mass, centre and inertia about it, rows.
struct RadiossInertia {
  double mass = 0;  ///< 0 where it is given: that of the nodes
  Point centre{};
  std::array<Point, 3> about{};
};

/// An /RBODY: bodies all of whose nodes are in its group, and single nodes of others; or a part of /MAT/RIGID, or of
/// shells that a /BCS holds.
struct RadiossRigidBody {
  const RadiossBlock* block = nullptr;
  DeckCard card{};
  std::string name{};                 ///< in the scene
  std::int32_t main = -1;             ///< place of the main node in the mesh, which no solid has; -1: it has none
  std::int64_t group = 0;             ///< number of the group of its nodes
  std::vector<std::string> bodies{};  ///< those that are rigid as a whole
  bool attaches = false;              ///< whether the group has nodes of bodies that deform
  bool is_held = false;               ///< of shells that a /BCS holds
  unsigned held = 0;                  ///< bits of x, y, z, and behind these of rotations about them
  std::optional<Point> velocity{};    ///< of its centre, at the start
  std::optional<Point> angular_velocity{};
  std::optional<RadiossInertia> inertia{};  ///< where it is not that of its nodes
};

/// What keywords of Radioss input refer to by number.
class RadiossData {
 public:
  /// deck, mesh and report have to stay.
  RadiossData(const RadiossDeck& deck, const MeshFile& mesh, DeckReport& report);

  const RadiossDeck& deck;
  const MeshFile& mesh;
  DeckReport& report;
  RadiossParts parts;
  NumberIndex nodes;

  std::vector<RadiossBody> bodies;    ///< by the numbers of their parts
  std::vector<DeckElement> elements;  ///< per body, when they are known
  std::vector<bool> used;             ///< per node of the mesh: whether a solid has it
  std::vector<RadiossRigidBody> rigid;
  std::vector<std::int32_t> rigid_of_node;  ///< per node: the rigid body that it is of, or -1
  std::set<std::int32_t> wall_nodes;        ///< places of the nodes of rigid walls that move
  std::size_t walls = 0;
  std::size_t given_nodes = 0;  ///< behind these come those that hexahedra of twenty nodes get

  /// Blocks of a name, in the order of the deck.
  const std::vector<const RadiossBlock*>& blocks_of(const std::string& name) const;
  /// Number of its part among those of the mesh.
  std::ptrdiff_t part_of(const RadiossBody& body) const {
    return std::ranges::find(mesh.parts, body.part.id, &MeshPart::id) - mesh.parts.begin();
  }
  /// The last block of a name, which is the one that counts; null: there is none.
  const RadiossBlock* last(const std::string& name) const;

  /// A group of nodes. Throws InputError where it is not there, or wrong.
  const MeshSet& node_group(std::int64_t id, const DeckPlace& place) const;
  /// A surface. Throws InputError where it is not there, or wrong.
  const FaceSet& surface(std::int64_t id, const DeckPlace& place) const;
  /// The rigid body whose main node stands there; null: none.
  RadiossRigidBody* rigid_at(std::int32_t node);
  /// Rigid bodies whose main nodes a group has.
  std::vector<RadiossRigidBody*> rigid_in(const MeshSet& group);
  /// Whether a group has nodes of solids.
  bool has_used(const MeshSet& group) const;
  /// For each node whether a group has it.
  std::vector<bool> nodes_in(const MeshSet& group) const;
  /// For each part of the mesh whether a group has all of its nodes.
  std::vector<bool> whole_parts(const std::vector<bool>& in_group) const;
  /// Whether all nodes of solids of a group are of these parts.
  bool are_of_parts(const std::vector<bool>& in_group, const std::vector<bool>& parts_) const;
  /// The bodies of these parts.
  std::vector<std::string> bodies_of(const std::vector<bool>& parts_) const;
  /// Bodies all of whose nodes a group has, if these are all its nodes of solids; else none.
  std::vector<std::string> whole_bodies(const MeshSet& group) const;
  std::vector<std::string> all_bodies() const;

  /// /SKEW/FIX of this number: its axes; 0: the global ones. Throws InputError where there is none.
  std::array<Point, 3> axes(std::int64_t skew, const DeckPlace& place) const;
  /// /FRAME/FIX of this number: its origin and its axes; 0: the global ones. Throws InputError where there is none.
  std::pair<Point, std::array<Point, 3>> frame(std::int64_t id, const DeckPlace& place) const;
  /// times and factors of a function over the whole run: abscissas times ascale, ordinates times fscale. Throws
  /// InputError where there is none.
  void set_function(std::int64_t function, double ascale, double fscale, const DeckPlace& place,
                    const DeckKeys<TimeTable>& keys) const;
  /// Tstop of /RUN; 0 where there is none.
  double run_end() const;
  /// Points of a function.
  const std::pair<std::vector<double>, std::vector<double>>& function(std::int64_t id, const DeckPlace& place) const;

  /// Reports what is defined and nothing has named: when all else is translated.
  void tell_unused_definitions() { definitions_.tell_unused(report); }

  /// Whether a part with solids has this material, or property.
  bool has_material(std::int64_t id) const;
  bool has_property(std::int64_t id) const;

 private:
  void read_function(const RadiossBlock& block);
  void read_axes(const RadiossBlock& block);
  void name_bodies();
  void require_units() const;

  std::map<std::string, std::vector<const RadiossBlock*>> blocks_;
  std::map<std::int64_t, std::pair<std::vector<double>, std::vector<double>>> functions_;
  std::map<std::int64_t, std::array<Point, 3>> skews_;
  std::map<std::int64_t, std::pair<Point, std::array<Point, 3>>> frames_;
  DeckDefinitions<std::int64_t> definitions_;
  GivenOnce given_;
};

/// A keyword at the place of one of its lines.
inline DeckCard card_of(const RadiossBlock& block, const DeckPlace& place) { return {block.title, place}; }

/// "X", "YY": 0 to 2 along an axis, 3 to 5 about one. Throws InputError for anything else.
int degree_of(const RadiossFields& f, std::string_view name);

/// A unit vector. Throws InputError for one without a length.
Point radioss_unit(const Point& vector, const DeckPlace& place);

}  // namespace pinball
