#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include <solver/base/point.hpp>
#include <solver/formats/deck/deck_definitions.hpp>
#include <solver/formats/deck/deck_element.hpp>
#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/deck_scene.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/lsdyna/mesh/keyword_boxes.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <solver/formats/lsdyna/scan/keyword_deck.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/number_index.hpp>
#include <solver/scene_boundary.hpp>

#include "reversed_faces.hpp"

namespace pinball {

struct DeckPart {
  std::int64_t id, section, material, hourglass;
  std::int64_t state_equation;  ///< EOSID; 0: none
  std::string body;             ///< name of the body that it becomes
  DeckPlace place;
  std::int64_t solids = 0, tetrahedra = 0;  ///< how many; the latter are some of the former
  std::int64_t wedges = 0;                  ///< as these
  bool ten_nodes = false;                   ///< they are tetrahedra of ten nodes, eight of four in the place of each
  std::int64_t lead = 0;  ///< of a rigid one: the part that it is merged into, or itself; 0: it deforms

  bool is_rigid() const { return lead != 0; }
};

/// *PART_INERTIA
struct DeckInertia {
  double mass = 0;
  Point centre{};
  std::array<Point, 3> inertia{};  ///< about it, along the axes of the deck
  Point velocity{}, angular_velocity{};
  DeckCard card;
};

/// *HOURGLASS, or the defaults that *CONTROL_HOURGLASS and *CONTROL_BULK_VISCOSITY give it.
struct DeckHourglass {
  std::int64_t form = 0;             ///< IHQ; 0: the default
  double coefficient = 0;            ///< QH, QM; 0: the default
  double quadratic = 0, linear = 0;  ///< Q1, Q2; 0: the default
};

struct DeckCurve {
  std::vector<double> abscissa, ordinate;
  DeckUnits units{};     ///< of the file that it stands in: what they mean for it, only who uses it knows
  bool relaxes = false;  ///< SIDR 1: it is for dynamic relaxation, and not for the run itself
  DeckPlace place{};
  double moved = 0;  ///< by OFFA > 0, of DATTYP 0: a curve of time is zero up to there [time]
};

/// Curves over the strain rate.
struct DeckTable {
  bool logarithmic = false;                             ///< between the curves
  std::vector<std::pair<double, std::int64_t>> curves;  ///< rate [1/time] and number of the curve for it
};

/// *EOS_...
struct DeckStateEquation {
  EquationOfStateSettings settings;
  DeckCard card;
};

/// Unit vectors of a system by its x axis and a vector in its plane of x and y. Throws InputError where these are none.
std::array<Point, 3> axes_by(const Point& x, const Point& in_plane, const DeckPlace& place);

/// ELFORM of an element that users have written.
constexpr bool is_of_users(std::int64_t form) { return form >= 101 && form <= 105; }

/// ELFORM of hexahedra with more points of integration than one: 2 and its kin, 3 with rotations of nodes, 18 with
/// enhanced strains.
constexpr bool is_of_full_integration(std::int64_t form) {
  return form == 2 || form == -1 || form == -2 || form == 3 || form == 18;
}

/// What keywords of a deck refer to by number, read before anything that refers to it. What returns something of a
/// number throws InputError "FILE:LINE: ..." at `place` where the deck does not have it.
class DeckData {
 public:
  /// deck, mesh and report have to stay.
  DeckData(const KeywordDeck& deck, const MeshFile& mesh, DeckReport& report);

  const KeywordDeck& deck;
  const MeshFile& mesh;
  DeckReport& report;
  const NumberIndex nodes;    ///< places of nodes in the mesh
  const EdgeMiddles middles;  ///< of tetrahedra of ten nodes
  const KeywordBoxes boxes;

  std::vector<DeckPart> parts;  ///< those with solids, by their numbers
  std::map<std::int64_t, std::int64_t> section_form;
  std::map<std::int64_t, DeckHourglass> hourglass;
  std::vector<DeckElement> part_elements;  ///< of each part, once the controls are translated
  int motions = 0;                         ///< prescribed ones that are translated
  std::size_t walls = 0;                   ///< the same of rigid walls
  double step_share = 0;                   ///< DTMIN, where ERODE erodes elements of smaller steps [-]
  DeckCard step_card;                      ///< of ERODE
  std::vector<DeckFaces> pressed;          ///< of each card of pressure
  std::vector<bool> used;                  ///< per node of the mesh: whether a solid of a part has it
  std::vector<std::int64_t> lead_of_node;  ///< the same: the leading rigid part that has it, or 0; empty: none is rigid
  std::map<std::int64_t, const KeywordBlock*> rigid_materials;  ///< *MAT_RIGID, by their numbers
  std::map<std::int64_t, DeckInertia> inertia;                  ///< of rigid parts, by their numbers

  /// Of whatever; it has to stand in a file of the deck's own units.
  const DeckCurve& curve(std::int64_t id, const DeckPlace& place) const;
  /// Stress over plastic strain, in the units of the deck.
  DeckCurve yield_curve(std::int64_t id, const DeckPlace& place) const;
  /// A factor over the strain rate, in the units of the deck.
  DeckCurve rate_curve(std::int64_t id, const DeckPlace& place) const;
  bool is_curve(std::int64_t id) const { return curves_.contains(id); }
  /// Null: no *DEFINE_TABLE has this number.
  const DeckTable* table(std::int64_t id) const;
  /// Unit vector of *DEFINE_VECTOR.
  Point vector(std::int64_t id, const DeckPlace& place) const;
  /// Unit vectors of a local system; those of the global one for 0.
  std::array<Point, 3> axes(std::int64_t system, const DeckPlace& place) const;
  /// Numbers of parts; those of set 0 and of numbers without parts are an error.
  std::vector<std::int64_t> part_set(std::int64_t id, const DeckPlace& place) const;
  /// Body of a part. Throws InputError for a number without a part; none: a part without solids.
  std::optional<std::string> body_of(std::int64_t part, const DeckPlace& place) const;

  /// A part with solids; null: there is none of this number.
  const DeckPart* find_part(std::int64_t id) const;
  /// Bodies of a leading rigid part, and of what is merged into it.
  std::vector<std::string> bodies_with(std::int64_t lead) const;
  /// Rejects what would act on single nodes of rigid parts, and returns whether it does. members: in the mesh.
  bool reject_rigid_nodes(const std::vector<std::int32_t>& members, const DeckPlace& place,
                          const std::string& star_name, const char* instead);
  /// Whether a part with solids is of it.
  bool is_used(std::int64_t material) const { return materials_.contains(material); }
  /// That of the parts of a material that needs one; none: it is refused.
  std::optional<DeckStateEquation> state_equation_of(std::int64_t material, const std::string& keyword);
  /// Refuses parts whose material has a bulk modulus and needs none.
  void reject_state_equations(std::int64_t material, const std::string& keyword);
  /// Throws InputError where the deck gives this ("section 1") already.
  void give_once(const KeywordBlock& block, const std::string& what, const DeckPlace& place) {
    given_.add(what, place, block.of_case);
  }

  /// Reports what is defined and nothing has named, and parts without solids: when all else is translated.
  void tell_unused_definitions();

  /// The keywords of this name, in their order.
  const std::vector<const KeywordBlock*>& blocks_of(const std::string& name) const;

  Fields fields(const Card& card, const CardLayout& layout) const { return Fields(card, deck.parameters, layout); }

 private:
  void read(const KeywordBlock& block);
  void require_one_of_a_kind(const KeywordBlock& block);
  void read_parts(const KeywordBlock& block);
  void number_state_equation(const KeywordBlock& block);
  void tell_unused_state_equations();
  void define(const KeywordBlock& block, const std::string& kind, std::int64_t id, const DeckPlace& place);
  DeckStateEquation read_state_equation(const KeywordBlock& block) const;
  void read_section(const KeywordBlock& block);
  void read_hourglass(const KeywordBlock& block);
  void read_curve(const KeywordBlock& block);
  void read_table(const KeywordBlock& block);
  void read_vector(const KeywordBlock& block);
  void read_system(const KeywordBlock& block);
  void read_part_set(const KeywordBlock& block);
  void add_parts(const KeywordBlock& block, const Card& card, std::vector<std::int64_t>& members) const;
  void name_bodies();
  void read_inertias(const KeywordBlock& block);
  DeckInertia read_inertia(const KeywordBlock& block, Cards& cards);
  void find_rigid_parts();
  void merge_rigid_parts();
  void find_rigid_nodes();
  const DeckCurve& find_curve(std::int64_t id, const DeckPlace& place) const;

  std::map<std::int64_t, DeckCurve> curves_;
  std::map<std::int64_t, DeckTable> tables_;
  std::map<std::int64_t, Point> vectors_;
  std::map<std::int64_t, std::array<Point, 3>> systems_;
  std::map<std::int64_t, std::vector<std::int64_t>> part_sets_;
  std::map<std::int64_t, std::string> titles_;
  std::map<std::int64_t, DeckPart> all_parts_;
  std::unordered_map<std::string, std::vector<const KeywordBlock*>> blocks_;
  std::map<std::int64_t, const KeywordBlock*> state_equation_blocks_;
  std::set<std::int64_t> materials_;  ///< of the parts with solids
  GivenOnce given_;
  DeckDefinitions<std::int64_t> definitions_;
};

}  // namespace pinball
