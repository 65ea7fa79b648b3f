#include "keyword_rules.hpp"

#include <map>
#include <string_view>

#include "deck_parts.hpp"

namespace pinball {

namespace {

constexpr bool in_other_units = true;

}  // namespace

const std::vector<KeywordRule>& keyword_rules() {
  using enum Treatment;
  static const std::vector<KeywordRule> rules{
      {"TITLE", done, "title of the scene", in_other_units},
      {"NODE", done, "with TC as constraints; rotations of nodes of solids mean nothing", in_other_units},
      {"ELEMENT_SOLID", mesh,
       "one line or two; wedges, pyramids and tetrahedra as collapsed hexahedra, those of ten nodes as eight of four",
       in_other_units},
      {"PART", done, "a body each; parts share the nodes that they have in common", in_other_units},
      {"PART_CONTACT", done, "as PART; its friction is for contacts with FS -1, which are refused", in_other_units},
      {"PART_INERTIA", done, "as PART; mass, centre, inertia and velocities of a rigid part, also in a local system"},
      {"SECTION_SOLID", done,
       "ELFORM 0 and 1; 2, -1, -2, 3, 18 as elements of assumed strain; 10 and 13 of tetrahedra, 15 and 115 of wedges, "
       "16 and "
       "17 of ten nodes",
       in_other_units},
      {"HOURGLASS", done,
       "of each part: IHQ 1 to 3 viscous with QM/4, 4 and 5 stiffness and 6 and 7 assumed strains with QM; Q1, Q2",
       in_other_units},
      {"CONTROL_HOURGLASS", done, "the same where a part has none, or blanks; without it IHQ 1, QH 0.1",
       in_other_units},
      {"CONTROL_TERMINATION", done, "ENDTIM, ENDCYC, DTMIN with ERODE; the other limits are not used, and reported"},
      {"TERMINATION_SENSOR", ignored, "a run goes on to ENDTIM"},
      {"SENSOR_DEFINE*", ignored, "of TERMINATION_SENSOR; SENSOR_CONTROL is refused"},
      {"SENSOR_SWITCH", ignored, "the same"},
      {"CONTROL_TIMESTEP", done,
       "TSSFAC, DT2MS (mass scaling at the start), ERODE with DTMIN; LCTM, DT2MSF, DT2MSLC and IMSCL are refused"},
      {"CONTROL_BULK_VISCOSITY", done, "Q1 and Q2: coefficients sqrt(Q1) and Q2; without it 1.5 and 0.06",
       in_other_units},
      {"MAT_ELASTIC", done, "MAT_001", in_other_units},
      {"MAT_PLASTIC_KINEMATIC", done, "MAT_003: isotropic, kinematic, mixed; Cowper-Symonds; failure strain",
       in_other_units},
      {"MAT_NULL", done, "MAT_009: a fluid of the viscosity MU and a limit PC of tension; with an equation of state"},
      {"MAT_MOONEY-RIVLIN_RUBBER", done, "MAT_027: A, B and PR; not fitted to a test", in_other_units},
      {"MAT_POWER_LAW_PLASTICITY", done, "MAT_018: K, N, SIGY or where E crosses the power; Cowper-Symonds; EPSF"},
      {"MAT_PIECEWISE_LINEAR_PLASTICITY", done, "MAT_024: curve, table over the rate, EPS and ES; Cowper-Symonds; FAIL",
       in_other_units},
      {"MAT_JOHNSON_COOK", done, "MAT_015: strength, heat, failure by D1 to D5; with an equation of state",
       in_other_units},
      {"MAT_RIGID", done, "MAT_020: a rigid body of each part; CMO 1, 0, -1 with CON1 and CON2", in_other_units},
      {"MAT_ADD_EROSION", done, "MXPRES, MNPRES, SIGP1, SIGVM, MXEPS, EPSSH, FAILTM, DTMIN: of the material of its MID",
       in_other_units},
      {"EOS_GRUNEISEN", done, "EOS_004, of MAT_015 and MAT_009", in_other_units},
      {"EOS_LINEAR_POLYNOMIAL", done, "EOS_001, the same", in_other_units},
      {"BOUNDARY_SPC_NODE", done, "also in a local system; rotations mean nothing", in_other_units},
      {"BOUNDARY_SPC_NODE_BIRTH_DEATH", done, "the same from birth to death"},
      {"BOUNDARY_SPC_SET", done, "the same of a set of nodes", in_other_units},
      {"BOUNDARY_SPC_SET_BIRTH_DEATH", done, "the same from birth to death"},
      {"BOUNDARY_PRESCRIBED_MOTION_NODE", done,
       "velocity, acceleration or displacement along an axis or a vector; birth, death", !in_other_units,
       translate_prescribed_motion},
      {"BOUNDARY_PRESCRIBED_MOTION_SET", done, "the same of a set of nodes", !in_other_units,
       translate_prescribed_motion},
      {"BOUNDARY_PRESCRIBED_MOTION_RIGID", done,
       "of a rigid part, along and about axes or a vector; of all nodes of one that deforms", !in_other_units,
       translate_prescribed_motion},
      {"INITIAL_VELOCITY", done, "of a set, of all nodes, in a box; NSIDEX; in a local system; rotations mean nothing",
       !in_other_units, translate_initial_velocity},
      {"INITIAL_VELOCITY_NODE", done, "", !in_other_units, translate_initial_velocity_of_nodes},
      {"INITIAL_VELOCITY_SET", done, "as INITIAL_VELOCITY", !in_other_units, translate_initial_velocity},
      {"INITIAL_VELOCITY_GENERATION", done, "of parts, sets of parts and of nodes; a spin; IVATN; PHASE is refused",
       !in_other_units, translate_velocity_generation},
      {"INITIAL_VELOCITY_RIGID_BODY", done, "of the centre of a rigid part, whatever velocities its nodes have"},
      {"RIGIDWALL_PLANAR", done,
       "NSID, NSIDEX, BOXID; birth, death; friction, 1: no sliding; nodes that stick are refused", !in_other_units,
       translate_rigid_walls},
      {"RIGIDWALL_PLANAR_FINITE", done, "a rectangle; what has gone past it is left alone", !in_other_units,
       translate_rigid_walls},
      {"RIGIDWALL_PLANAR_MOVING", done, "MASS and V0: the nodes push it along its normal", !in_other_units,
       translate_rigid_walls},
      {"RIGIDWALL_PLANAR_FINITE_MOVING", done, "both", !in_other_units, translate_rigid_walls},
      {"CONTACT_AUTOMATIC_SINGLE_SURFACE", done,
       "parts, sets of parts or of segments; exact impulses between faces; FS, FD, DC, BT, DT"},
      {"CONTACT_AUTOMATIC_GENERAL", done, "the same"},
      {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", done, "a contact pair; its force and impulse are in history.csv"},
      {"CONTACT_AUTOMATIC_NODES_TO_SURFACE", done, "the same; parts touch both ways, a set of nodes one way"},
      {"CONTACT_SINGLE_SURFACE", done, "as AUTOMATIC"},
      {"CONTACT_SURFACE_TO_SURFACE", done, "as AUTOMATIC"},
      {"CONTACT_NODES_TO_SURFACE", done, "as AUTOMATIC"},
      {"CONTACT_ERODING_SINGLE_SURFACE", done, "as AUTOMATIC: erosion is always seen to"},
      {"CONTACT_ERODING_SURFACE_TO_SURFACE", done, "as AUTOMATIC"},
      {"CONTACT_ERODING_NODES_TO_SURFACE", done, "as AUTOMATIC"},
      {"CONTACT_TIED_NODES_TO_SURFACE", done,
       "nodes within 0.05 of a face's shorter diagonal, or within 0.6 of negative SST + MST, are put on the face"},
      {"CONTACT_TIED_NODES_TO_SURFACE_OFFSET", done, "the same: offsets are not kept"},
      {"CONTACT_TIED_SURFACE_TO_SURFACE", done, "the same"},
      {"CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET", done, "the same"},
      {"CONTACT_FORCE_TRANSDUCER*", ignored, "output: history.csv has the contact force on each body"},
      {"LOAD_NODE_SET", done, "along an axis, on each node", !in_other_units, translate_node_load},
      {"LOAD_NODE_POINT", done, "the same", !in_other_units, translate_node_load},
      {"LOAD_SEGMENT", done, "pressure on faces of solids: LCID, SF, AT from which the curve's time counts",
       !in_other_units, translate_segment_load},
      {"LOAD_SEGMENT_SET", done, "the same of a set of segments", !in_other_units, translate_segment_set_load},
      {"LOAD_BODY_X", done, "acceleration of the frame along the axis: bodies feel its opposite", !in_other_units,
       translate_body_load},
      {"LOAD_BODY_Y", done, "the same", !in_other_units, translate_body_load},
      {"LOAD_BODY_Z", done, "the same", !in_other_units, translate_body_load},
      {"LOAD_BODY_VECTOR", done, "the same along a vector", !in_other_units, translate_body_load},
      {"LOAD_BODY_PARTS", done, "the parts that the others of these act on"},
      {"DAMPING_GLOBAL", done, "a constant; a curve is refused"},
      {"DEFINE_CURVE", done, "where something names it", in_other_units},
      {"DEFINE_TABLE", done, "curves over the strain rate of MAT_024", in_other_units},
      {"DEFINE_VECTOR", done, "where something names it", in_other_units},
      {"DEFINE_COORDINATE_SYSTEM", done, "where something names it", in_other_units},
      {"DEFINE_COORDINATE_VECTOR", done, "where something names it", in_other_units},
      {"DEFINE_COORDINATE_NODES", ignored, "refused where something names it"},
      {"DEFINE_BOX", mesh, "for sets, walls and initial velocities", in_other_units},
      {"DEFINE_TRANSFORMATION", mesh, "for INCLUDE_TRANSFORM; in the order of its cards"},
      {"SET_NODE*", mesh, "_LIST, _GENERATE (_INCREMENT), _GENERAL, _ADD, _COLUMN, each with _COLLECT", in_other_units},
      {"SET_SOLID*", mesh, "the same", in_other_units},
      {"SET_SEGMENT*", mesh, "_GENERAL: SEG, PART, BOX, ALL, also with D", in_other_units},
      {"SET_PART*", done, "_LIST, _GENERATE, _ADD, each with _COLLECT", in_other_units},
      {"SET_SHELL*", ignored, "there are no shells"},
      {"SET_BEAM*", ignored, "there are no beams"},
      {"DATABASE_HISTORY_NODE", done, "a probe each, node_NUMBER", in_other_units},
      {"DATABASE_HISTORY_NODE_SET", done, "the same of the nodes of sets", in_other_units},
      {"DATABASE_HISTORY_SOLID", done, "a probe each, element_NUMBER", in_other_units},
      {"DATABASE_HISTORY_SOLID_SET", done, "the same of the solids of sets", in_other_units},
      {"DATABASE_BINARY_D3PLOT", done, "DT: fields of this program for ParaView"},
      {"DATABASE_GLSTAT", done, "DT: rows of history.csv; the smallest of all that have one"},
      {"DATABASE_MATSUM", done, "the same; energies, momentum and mass of each body (`body_energies`)"},
      {"DATABASE_RCFORC", done, "the same"},
      {"DATABASE_RWFORC", done, "the same"},
      {"DATABASE_SPCFORC", done, "the same; the force of all constraints together, `spc_force_x`"},
      {"DATABASE_BNDOUT", done, "the same; the force of each motion of nodes, `motion_1_force_x`, in their order"},
      {"DATABASE_RBDOUT", done, "the same; centre, velocities and reactions of each rigid body"},
      {"DATABASE_NODOUT", done, "the same"},
      {"DATABASE_ELOUT", done, "the same"},
      {"DATABASE_SLEOUT", done, "the same"},
      {"DATABASE*", ignored, "output of another program"},
      {"ELEMENT_SHELL", mesh,
       "of parts of MAT_RIGID: a layer of solids, half of the thickness on each side; refused of others",
       in_other_units},
      {"SECTION_SHELL", mesh, "T1, of these", in_other_units},
      {"ELEMENT_SHELL_*", rejected, "shells: solids, one or more through the thickness, in their place"},
      {"ELEMENT_TSHELL*", rejected, "thick shells: ELEMENT_SOLID in their place"},
      {"ELEMENT_BEAM*", rejected, "beams: solids in their place"},
      {"ELEMENT_DISCRETE*", rejected, "springs and dampers"},
      {"ELEMENT_MASS*", rejected, "masses of nodes: the density of a part in their place"},
      {"MAT_*", rejected, "other materials; where no part with solids has it, it is reported and refuses nothing"},
      {"SECTION_*", rejected, "the same"},
      {"EOS_*", rejected, "the same"},
      {"CONSTRAINED_RIGID_BODIES", done, "rigid parts that move as one, as the leading one (PIDM) is held",
       in_other_units},
      {"CONSTRAINED_EXTRA_NODES_NODE", done, "a node of other parts that moves with a rigid part", in_other_units,
       translate_extra_nodes},
      {"CONSTRAINED_EXTRA_NODES_SET", done, "the same of a set", in_other_units, translate_extra_nodes},
      {"CONSTRAINED_JOINT_SPHERICAL", done, "between rigid parts, at a node of each or of their extra nodes",
       in_other_units, translate_joints},
      {"CONSTRAINED_JOINT_REVOLUTE", done, "the same, about N1 and N3", in_other_units, translate_joints},
      {"CONSTRAINED_JOINT_CYLINDRICAL", done, "the same", in_other_units, translate_joints},
      {"CONSTRAINED_JOINT_TRANSLATIONAL", done, "the same, along N1 and N3", in_other_units, translate_joints},
      {"CONSTRAINED_JOINT_UNIVERSAL", done, "the same, about N1 and N3 of one part and N2 and N4 of the other",
       in_other_units, translate_joints},
      {"CONSTRAINED_JOINT_LOCKING", done, "the same", in_other_units, translate_joints},
      {"CONSTRAINED_JOINT_*", rejected, "other joints, their stiffness, failure, motors and local systems"},
      {"CONSTRAINED_*", rejected, "nodes that parts have in common, or CONTACT_TIED_..., in its place"},
      {"CONTACT_*", rejected, "other contacts: AUTOMATIC or TIED ones in their place"},
      {"CONTROL_ACCURACY", ignored, ""},
      {"CONTROL_CONTACT", done, "nothing of it is used, and what it sets is reported: contact has no penalties"},
      {"CONTROL_CPU", ignored, ""},
      {"CONTROL_DYNAMIC_RELAXATION", rejected, ""},
      {"CONTROL_ENERGY", ignored, "all energies are always computed"},
      {"CONTROL_IMPLICIT*", rejected, "implicit analysis"},
      {"CONTROL_MPP*", ignored, ""},
      {"CONTROL_OUTPUT", ignored, ""},
      {"CONTROL_PARALLEL", ignored, ""},
      {"CONTROL_RIGID", ignored, "of joints, and of bodies that become rigid"},
      {"CONTROL_SHELL", ignored, "there are no shells"},
      {"CONTROL_SOLID", ignored, ""},
      {"CONTROL_SOLUTION", done, "SOLN is refused if not 0, the others are reported"},
      {"PARAMETER_DUPLICATION", ignored, ""},
      {"PARAMETER_TYPE", ignored, ""},
      {"CONTROL_UNITS", ignored, "names of units"},
      {"COMMENT", ignored, ""},
      {"KEYWORD_ID", ignored, ""},
      {"MODULE*", ignored, ""},
  };
  return rules;
}

std::string keyword_alias(const std::string& name) {
  static const std::map<std::string, std::string> aliases{
      {"MAT_001", "MAT_ELASTIC"},
      {"MAT_1", "MAT_ELASTIC"},
      {"MAT_003", "MAT_PLASTIC_KINEMATIC"},
      {"MAT_3", "MAT_PLASTIC_KINEMATIC"},
      {"MAT_009", "MAT_NULL"},
      {"MAT_9", "MAT_NULL"},
      {"MAT_027", "MAT_MOONEY-RIVLIN_RUBBER"},
      {"MAT_27", "MAT_MOONEY-RIVLIN_RUBBER"},
      {"MAT_018", "MAT_POWER_LAW_PLASTICITY"},
      {"MAT_18", "MAT_POWER_LAW_PLASTICITY"},
      {"MAT_020", "MAT_RIGID"},
      {"MAT_20", "MAT_RIGID"},
      {"MAT_024", "MAT_PIECEWISE_LINEAR_PLASTICITY"},
      {"MAT_24", "MAT_PIECEWISE_LINEAR_PLASTICITY"},
      {"MAT_015", "MAT_JOHNSON_COOK"},
      {"MAT_15", "MAT_JOHNSON_COOK"},
      {"EOS_004", "EOS_GRUNEISEN"},
      {"EOS_4", "EOS_GRUNEISEN"},
      {"EOS_001", "EOS_LINEAR_POLYNOMIAL"},
      {"EOS_1", "EOS_LINEAR_POLYNOMIAL"},
  };
  const auto found = aliases.find(name);
  return found == aliases.end() ? name : found->second;
}

const KeywordRule* rule_of(const std::string& name) {
  const KeywordRule* best = nullptr;
  for (const KeywordRule& rule : keyword_rules()) {
    const std::string_view pattern(rule.name);
    const bool open = pattern.ends_with('*');
    const bool fits =
        open ? std::string_view(name).starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
    if (fits && (best == nullptr || !open || pattern.size() > std::string_view(best->name).size())) {
      best = &rule;
      if (!open) break;
    }
  }
  return best;
}

}  // namespace pinball
