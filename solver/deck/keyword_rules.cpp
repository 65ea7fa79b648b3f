#include "keyword_rules.hpp"

#include <map>
#include <string_view>

namespace pinball {

const std::vector<KeywordRule>& keyword_rules() {
  using enum Treatment;
  static const std::vector<KeywordRule> rules{
      {"TITLE", done, "title of the scene"},
      {"NODE", done, "with TC as constraints; rotations of nodes of solids mean nothing"},
      {"ELEMENT_SOLID", mesh, "one line or two; wedges and pyramids as collapsed hexahedra; tetrahedra are refused"},
      {"PART", done, "a body each; parts share the nodes that they have in common"},
      {"SECTION_SOLID", done, "ELFORM 0 and 1; 2, -1, -2 as elements of assumed strain"},
      {"HOURGLASS", done, "IHQ 1 to 3 viscous with QM/4, 4 and 5 stiffness with QM, 6 and 7 assumed strains"},
      {"CONTROL_HOURGLASS", done, "the same for all parts without their own; without it IHQ 1, QH 0.1"},
      {"CONTROL_TERMINATION", done, "ENDTIM, ENDCYC; the other limits are ignored"},
      {"CONTROL_TIMESTEP", done, "TSSFAC; DT2MS (mass scaling) and LCTM are refused"},
      {"CONTROL_BULK_VISCOSITY", done, "Q1 and Q2: coefficients sqrt(Q1) and Q2; without it 1.5 and 0.06"},
      {"MAT_ELASTIC", done, "MAT_001"},
      {"MAT_PLASTIC_KINEMATIC", done, "MAT_003: isotropic, kinematic, mixed; Cowper-Symonds; failure strain"},
      {"MAT_PIECEWISE_LINEAR_PLASTICITY", done,
       "MAT_024: curve, table over the rate, EPS and ES; Cowper-Symonds; FAIL"},
      {"BOUNDARY_SPC_NODE", done, "also in a local system; rotations mean nothing; births and deaths are refused"},
      {"BOUNDARY_SPC_SET", done, "the same of a set of nodes"},
      {"BOUNDARY_PRESCRIBED_MOTION_NODE", done, "velocity, acceleration or displacement along an axis or a vector"},
      {"BOUNDARY_PRESCRIBED_MOTION_SET", done, "the same of a set of nodes"},
      {"INITIAL_VELOCITY", done, "of a set or of all nodes; rotations mean nothing"},
      {"INITIAL_VELOCITY_NODE", done, ""},
      {"INITIAL_VELOCITY_SET", done, "as INITIAL_VELOCITY"},
      {"INITIAL_VELOCITY_GENERATION", done, "of parts, sets of parts and of nodes; a spin (OMEGA) is refused"},
      {"RIGIDWALL_PLANAR", done, "for all nodes; friction; other forms are refused"},
      {"CONTACT_AUTOMATIC_SINGLE_SURFACE", done, "contact of all bodies, exact impulses between faces"},
      {"CONTACT_AUTOMATIC_GENERAL", done, "the same"},
      {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", done, "of parts or sets of them that are all of the deck; FS, FD, DC"},
      {"CONTACT_AUTOMATIC_NODES_TO_SURFACE", done, "the same"},
      {"CONTACT_ERODING_SINGLE_SURFACE", done, "as AUTOMATIC: erosion is always seen to"},
      {"CONTACT_ERODING_SURFACE_TO_SURFACE", done, "as AUTOMATIC"},
      {"CONTACT_ERODING_NODES_TO_SURFACE", done, "as AUTOMATIC"},
      {"CONTACT_FORCE_TRANSDUCER*", ignored, "output"},
      {"LOAD_NODE_SET", done, "along an axis, on each node"},
      {"LOAD_NODE_POINT", done, "the same"},
      {"LOAD_BODY_X", done, "acceleration of the frame along the axis: bodies feel its opposite"},
      {"LOAD_BODY_Y", done, "the same"},
      {"LOAD_BODY_Z", done, "the same"},
      {"DAMPING_GLOBAL", done, "a constant; a curve is refused"},
      {"DEFINE_CURVE", done, "where something names it"},
      {"DEFINE_TABLE", done, "curves over the strain rate of MAT_024"},
      {"DEFINE_VECTOR", done, "where something names it"},
      {"DEFINE_COORDINATE_SYSTEM", done, "where something names it"},
      {"DEFINE_COORDINATE_VECTOR", done, "where something names it"},
      {"DEFINE_COORDINATE_NODES", ignored, "refused where something names it"},
      {"DEFINE_BOX", mesh, "for sets"},
      {"DEFINE_TRANSFORMATION", mesh, "for INCLUDE_TRANSFORM; in the order of its cards"},
      {"SET_NODE*", mesh, "_LIST, _GENERATE, _GENERAL, _ADD"},
      {"SET_SOLID*", mesh, "the same"},
      {"SET_SEGMENT*", mesh, ""},
      {"SET_PART*", done, "_LIST, _GENERATE, _ADD"},
      {"SET_SHELL*", ignored, "there are no shells"},
      {"SET_BEAM*", ignored, "there are no beams"},
      {"DATABASE_HISTORY_NODE", done, "a probe each"},
      {"DATABASE_BINARY_D3PLOT", done, "DT: fields of this program for ParaView"},
      {"DATABASE_GLSTAT", done, "DT: rows of history.csv; the smallest of all that have one"},
      {"DATABASE_MATSUM", done, "the same"},
      {"DATABASE_RCFORC", done, "the same"},
      {"DATABASE_RWFORC", done, "the same"},
      {"DATABASE_SPCFORC", done, "the same"},
      {"DATABASE_NODOUT", done, "the same"},
      {"DATABASE_ELOUT", done, "the same"},
      {"DATABASE_SLEOUT", done, "the same"},
      {"DATABASE*", ignored, "output of another program"},
      {"CONTROL_ACCURACY", ignored, ""},
      {"CONTROL_CONTACT", ignored, "scale factors of penalties: contact here has none"},
      {"CONTROL_CPU", ignored, ""},
      {"CONTROL_DYNAMIC_RELAXATION", refused, ""},
      {"CONTROL_ENERGY", ignored, "all energies are always computed"},
      {"CONTROL_IMPLICIT*", refused, "implicit analysis"},
      {"CONTROL_MPP*", ignored, ""},
      {"CONTROL_OUTPUT", ignored, ""},
      {"CONTROL_PARALLEL", ignored, ""},
      {"CONTROL_SHELL", ignored, "there are no shells"},
      {"CONTROL_SOLID", ignored, ""},
      {"CONTROL_SOLUTION", ignored, "but for SOLN, which is refused if not 0"},
      {"PARAMETER_DUPLICATION", ignored, ""},
      {"PARAMETER_TYPE", ignored, ""},
      {"COMMENT", ignored, ""},
      {"KEYWORD_ID", ignored, ""},
      {"MODULE*", ignored, ""},
  };
  return rules;
}

std::string keyword_alias(const std::string& name) {
  static const std::map<std::string, std::string> aliases{
      {"MAT_001", "MAT_ELASTIC"},
      {"MAT_003", "MAT_PLASTIC_KINEMATIC"},
      {"MAT_024", "MAT_PIECEWISE_LINEAR_PLASTICITY"},
      {"INITIAL_VELOCITY_GENERATION_START_TIME", "INITIAL_VELOCITY_GENERATION_START_TIME"},
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
