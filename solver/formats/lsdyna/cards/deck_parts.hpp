#pragma once

#include <solver/formats/deck/deck_scene.hpp>

#include "deck_data.hpp"

/// Keywords of a deck as tables of a scene, one function per kind. What cannot be done goes to data.report; what is
/// wrong is an InputError "FILE:LINE: ...".
namespace pinball {

/// Of each of data.parts; those of the first are [element] of the scene.
std::vector<DeckElement> deck_elements(DeckData& data);

/// A card of the last keyword of a name, which is the one that counts: the first, or one `number` after it; none: the
/// deck has none.
std::optional<Card> last_card(const DeckData& data, const std::string& name, int number = 0);

/// Number of a *MAT_... .
std::int64_t material_number(const DeckData& data, const KeywordBlock& block);
/// The limits beyond which elements of a material are eroded.
struct DeckLimits {
  InnerKeys<ErosionSettings> keys;
  DeckCard card;  ///< that they are of
  bool any = false, has_share = false;

  void add(KeyOf<ErosionSettings> key, double limit) {
    if (!(limit > 0)) return;
    keys.set(key, limit);
    any = true;
  }
};
/// *MAT_ADD_EROSION, and ERODE of *CONTROL_TIMESTEP for all materials; by their numbers.
std::map<std::int64_t, DeckLimits> limits_of_materials(DeckData& data);

/// *MAT_...: a [[material]] each, named mat_NUMBER; those that no part has are left out.
void translate_material(DeckData& data, const KeywordBlock& block, const DeckLimits& limits, DeckScene& scene);

/// A [[body]] for each part that has solids; mesh_file: as the scene names it.
void translate_parts(DeckData& data, const std::string& mesh_file, std::optional<std::int64_t> chosen_case,
                     DeckScene& scene);

/// *MAT_RIGID: a [[rigid_body]] for each rigid part that leads, with what is merged into it.
void translate_rigid_bodies(DeckData& data, DeckScene& scene);
void translate_nodal_rigid_bodies(DeckData& data, const KeywordBlock& block, DeckScene& scene);
/// The name that a *CONSTRAINED_NODAL_RIGID_BODY of this number has; none: there is none.
std::optional<std::string> nodal_rigid_body(const DeckData& data, std::int64_t number);
void translate_extra_nodes(DeckData& data, const KeywordBlock& block, DeckScene& scene);
/// *ELEMENT_MASS, _NODE_SET: a [[point_mass]] of all nodes with the same mass.
void translate_node_masses(DeckData& data, const KeywordBlock& block, DeckScene& scene);
void translate_joints(DeckData& data, const KeywordBlock& block, DeckScene& scene);

/// *NODE: constraints of TC, all nodes of one code together.
void translate_node_codes(DeckData& data, DeckScene& scene);
/// *BOUNDARY_SPC_NODE, _SET: those with the same directions together.
void translate_single_point_constraints(DeckData& data, DeckScene& scene);
void translate_prescribed_motion(DeckData& data, const KeywordBlock& block, DeckScene& scene);
void translate_initial_velocity(DeckData& data, const KeywordBlock& block, DeckScene& scene);
void translate_initial_stress(DeckData& data, const KeywordBlock& block, DeckScene& scene);
void translate_initial_velocity_of_nodes(DeckData& data, const KeywordBlock& block, DeckScene& scene);
void translate_velocity_generation(DeckData& data, const KeywordBlock& block, DeckScene& scene);
/// Where there are several kinds of initial velocities.
void tell_order_of_velocities(DeckData& data);
/// Of *INITIAL_VELOCITY_NODE, which counts before all but *INITIAL_VELOCITY_RIGID_BODY.
bool gives_velocity_of_nodes(const KeywordBlock& block);
void translate_rigid_walls(DeckData& data, const KeywordBlock& block, DeckScene& scene);
void translate_node_load(DeckData& data, const KeywordBlock& block, DeckScene& scene);
/// *LOAD_SEGMENT: faces of the same load together; and of a set.
void translate_segment_load(DeckData& data, const KeywordBlock& block, DeckScene& scene);
void translate_segment_set_load(DeckData& data, const KeywordBlock& block, DeckScene& scene);
void translate_body_load(DeckData& data, const KeywordBlock& block, DeckScene& scene);

/// All contact keywords together: [contact]. Returns whether any says what touches.
bool translate_contact(DeckData& data, DeckScene& scene);
/// CONTROL, DAMPING, DATABASE: title, [time], [element], [damping], [output].
void translate_controls(DeckData& data, DeckScene& scene);
/// *DATABASE_HISTORY_NODE, _SOLID and sets of these: a [[probe]] each.
void translate_probes(DeckData& data, DeckScene& scene);

}  // namespace pinball
