#pragma once

#include <solver/formats/deck/direction_names.hpp>

#include "radioss_data.hpp"

/// Keywords of Radioss input as tables of a scene, one function per kind. What cannot be done goes to data.report; what
/// is wrong is an InputError "FILE:LINE: ...".
namespace pinball {

/// A /SPRING that is a joint, and what the /PROP/KJOINT2 of its part says.
struct RadiossJoint {
  DeckCard card{}, property{};
  std::int64_t number = 0;
  std::array<std::int32_t, 2> nodes{};  ///< places in the mesh
  bool is_fixed = false;                ///< else spherical
  std::vector<double> stiffness{};      ///< Kri [moment]
};

/// /PROP/SOLID and /DEF_SOLID: what each body has.
std::vector<DeckElement> radioss_elements(RadiossData& data);

/// /TITLE, /RUN, /DT, /TFILE, /ANIM/DT, /DAMP: title, [time], [element], [damping], [output].
void translate_radioss_controls(RadiossData& data, DeckScene& scene);

/// /MAT/..., /EOS/..., /FAIL/...: a [[material]] each, named mat_NUMBER; those that no part has are left out.
void translate_radioss_materials(RadiossData& data, DeckScene& scene);

/// A [[body]] for each part that has solids; mesh_file: as the scene names it.
void translate_radioss_bodies(const RadiossData& data, const std::string& mesh_file, DeckScene& scene);

/// /RBODY, before what holds and moves main nodes, and what has become of them: [[rigid_body]], [[rigid_nodes]].
void find_radioss_rigid_bodies(RadiossData& data);
void translate_radioss_rigid_bodies(RadiossData& data, DeckScene& scene);

/// /SPRING whose parts have a /PROP/KJOINT2, read before all else, and what they join: [[joint]]. Other /SPRING are
/// refused.
std::vector<RadiossJoint> find_radioss_joints(RadiossData& data);
bool is_property_of_springs(const RadiossData& data, std::int64_t id);
void translate_radioss_joints(RadiossData& data, const std::vector<RadiossJoint>& joints, DeckScene& scene);

/// /BCS, /IMPVEL, /IMPDISP, /IMPACC: [[constraint]], [[prescribed_velocity]], of main nodes [[rigid_motion]].
void translate_radioss_boundary(RadiossData& data, DeckScene& scene);
/// /INIVEL/...: [[initial_velocity]].
void translate_radioss_velocities(RadiossData& data, DeckScene& scene);
/// /INIBRI/STRESS, /EPSP and /STRS_FGLO: [[initial_stress]].
void translate_radioss_stresses(RadiossData& data, DeckScene& scene);
/// /ADMAS of nodes that are no main nodes of an /RBODY: [[point_mass]].
void translate_radioss_added_masses(RadiossData& data, DeckScene& scene);
/// /CLOAD, /PLOAD, /GRAV: [[load]], [[pressure]], [[gravity]].
void translate_radioss_loads(RadiossData& data, DeckScene& scene);
/// /RWALL/PLANE: a [[rigid_wall]] each.
void translate_radioss_walls(RadiossData& data, DeckScene& scene);
/// /INTER/TYPE...: [contact]. Returns whether anything says what touches.
bool translate_radioss_contact(RadiossData& data, DeckScene& scene);
/// /TH/NODE and /TH/BRIC: a [[probe]] each.
void translate_radioss_probes(RadiossData& data, DeckScene& scene);

}  // namespace pinball
