#pragma once

#include <map>
#include <string>
#include <vector>

#include <solver/formats/deck/direction_names.hpp>

#include "abaqus_data.hpp"

/// Keywords of Abaqus input as tables of a scene, one function per kind. What cannot be done goes to data.report; what
/// is wrong is an InputError "FILE:LINE: ...".
namespace pinball {

class AbaqusTransforms;

/// SECTION CONTROLS, BULK VISCOSITY and types of elements: what each body has.
std::vector<DeckElement> abaqus_elements(AbaqusData& data);

/// HEADING, DYNAMIC, FIXED MASS SCALING, OUTPUT: title, [time], [element], [output].
void translate_abaqus_controls(AbaqusData& data, DeckScene& scene);

/// DENSITY of each material that has one, by its key.
std::map<std::string, double> abaqus_densities(const AbaqusDeck& deck);
/// The same per part of the mesh; 0: it has none.
std::vector<double> abaqus_densities_of_parts(const AbaqusData& data);
/// Young's modulus of each material that has one, by its key.
std::map<std::string, double> abaqus_moduli(const AbaqusDeck& deck);
/// A [[material]] for each that a body has, of MATERIAL and its options.
void translate_abaqus_materials(AbaqusData& data, DeckScene& scene);

/// A [[body]] for each section of an instance; mesh_file: as the scene names it.
void translate_abaqus_bodies(const AbaqusData& data, const std::string& mesh_file, DeckScene& scene);

/// Of the size of a body: a reference node this near to its centre is in it.
constexpr double near_abaqus_centre = 1e-3;
/// RIGID BODY, before what holds and moves reference nodes, and what has become of them: [[rigid_body]].
void find_abaqus_rigid_bodies(AbaqusData& data);
void translate_abaqus_rigid_bodies(AbaqusData& data, DeckScene& scene);

/// MASS and ROTARY INERTIA of elements at the reference nodes of rigid bodies, when these are found.
void find_abaqus_point_masses(AbaqusData& data);
/// Whether a set of elements that a step names, or one that it names, has an element of one node.
bool set_has_point(const AbaqusData& data, const std::string& label, const AbaqusPointElement& point);
/// The mass of a rigid body with rigid elements, or with masses at its reference node, when it is known what is held.
void set_abaqus_mass(AbaqusData& data, const AbaqusRigidBody& rigid, const DeckKeys<RigidBody>& keys);

/// The [[rigid_wall]] of an analytical surface, for what meets it.
DeckKeys<RigidWall> begin_wall(AbaqusData& data, AbaqusWall& wall, DeckScene& scene);
/// Reports those that no contact has.
void tell_unused_walls(AbaqusData& data);

/// BOUNDARY: [[constraint]] and [[prescribed_velocity]], of reference nodes [[rigid_motion]].
void translate_abaqus_boundary(AbaqusData& data, const AbaqusTransforms& transforms, DeckScene& scene);
/// EQUATION and MPC: [[equation]], a term each.
void translate_abaqus_equations(AbaqusData& data, const AbaqusTransforms& transforms, DeckScene& scene);
void translate_abaqus_initial_velocities(AbaqusData& data, DeckScene& scene);
/// *INITIAL CONDITIONS, TYPE=STRESS and TYPE=HARDENING: [[initial_stress]].
void translate_abaqus_initial_stresses(AbaqusData& data, DeckScene& scene);
/// CLOAD, DLOAD: [[load]], [[gravity]].
void translate_abaqus_loads(AbaqusData& data, const AbaqusTransforms& transforms, DeckScene& scene);
/// CONTACT and its options: [contact]. Returns whether anything says what touches.
bool translate_abaqus_contact(AbaqusData& data, DeckScene& scene);

/// NODE OUTPUT and ELEMENT OUTPUT of HISTORY: a [[probe]] each.
void translate_abaqus_probes(AbaqusData& data, DeckScene& scene);

/// Whether a degree of freedom is a translation, 1 to 3. Rotations, 4 to 6, which nodes of solids do not have, are
/// reported; others are refused.
bool is_translation(AbaqusData& data, const AbaqusBlock& block, const DeckPlace& place, std::int64_t degree);

/// A keyword at the place of one of its lines.
inline DeckCard card_of(const AbaqusBlock& block, const DeckPlace& place) { return {block.star_name(), place}; }
/// set or nodes.
void set_nodes(const AbaqusNodes& nodes, const DeckKeys<NodeSelection>& keys);

}  // namespace pinball
