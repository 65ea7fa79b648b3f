#include "abaqus_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace pinball {

const std::vector<AbaqusRule>& abaqus_rules() {
  using enum Treatment;
  static const std::vector<AbaqusRule> rules{
      {"HEADING", done, "title of the scene"},
      {"PARAMETER", done, "names between < and >, numbers or texts, by expressions of Python; DEPENDENT is refused"},
      {"PREPRINT", ignored, ""},
      {"NODE", mesh, "in Cartesian coordinates", "NSET INPUT SYSTEM=R"},
      {"ELEMENT", mesh,
       "C3D8R; C3D8 and its variants as elements of assumed strain; C3D6, C3D5 and C3D4 as collapsed hexahedra; C3D10 "
       "as eight of C3D4, C3D20 and C3D20R as eight of C3D8; R3D4 and R3D3 of a RIGID BODY as a layer of "
       "solids; MASS of nodes of solids, MASS and ROTARYI of reference nodes",
       "TYPE ELSET INPUT"},
      {"NSET", mesh, "lists, GENERATE, of an ELSET, of an INSTANCE",
       "NSET ELSET GENERATE INSTANCE INTERNAL UNSORTED INPUT"},
      {"ELSET", mesh, "the same", "ELSET GENERATE INSTANCE INTERNAL UNSORTED INPUT"},
      {"SURFACE", mesh,
       "faces S1 to S6, SPOS and SNEG of rigid elements, the outside of a set or of all, nodes; CYLINDER of a RIGID "
       "BODY",
       "NAME TYPE=ELEMENT|NODE|CYLINDER INTERNAL"},
      {"PART", done, "", "NAME"},
      {"END PART", done, ""},
      {"ASSEMBLY", done, "", "NAME"},
      {"END ASSEMBLY", done, ""},
      {"INSTANCE", done, "moved and then turned", "NAME PART"},
      {"END INSTANCE", done, ""},
      {"SOLID SECTION", done, "a body each in every instance", "ELSET MATERIAL CONTROLS ORIENTATION"},
      {"RIGID BODY", done,
       "an ELSET of whole sections, of rigid elements, or both; BOUNDARY and INITIAL CONDITIONS of its REF NODE hold, "
       "move and throw it; nodes of a TIE NSET or a PIN NSET move with it; a straight ANALYTICAL SURFACE that is held "
       "as a wall",
       "REFNODE ANALYTICALSURFACE ELSET POSITION=INPUT|CENTEROFMASS ISOTHERMAL TIENSET PINNSET"},
      {"MASS", done, "of MASS elements at nodes of solids, a point mass, or at reference nodes of a RIGID BODY",
       "ELSET TYPE=ISOTROPIC"},
      {"ROTARY INERTIA", done, "of ROTARYI elements at reference nodes, without products of inertia", "ELSET"},
      {"COUPLING", done, "nodes of a surface that move as one with a REF NODE, as a RIGID BODY does; with KINEMATIC",
       "CONSTRAINTNAME REFNODE SURFACE"},
      {"KINEMATIC", done, "of all directions"},
      {"SECTION CONTROLS", done,
       "of each section: HOURGLASS and its factors; ENHANCED, RELAX STIFFNESS and none at all as elements of assumed "
       "strain",
       "NAME HOURGLASS=ENHANCED|RELAXSTIFFNESS|STIFFNESS|VISCOUS KINEMATICSPLIT SECONDORDERACCURACY "
       "DISTORTIONCONTROL=NO|YES LENGTHRATIO ELEMENTDELETION MAXDEGRADATION"},
      {"ORIENTATION", done, "RECTANGULAR, of sections whose material is orthotropic", "NAME SYSTEM DEFINITION"},
      {"MATERIAL", done, "", "NAME"},
      {"DENSITY", done, "a constant"},
      {"ELASTIC", done, "isotropic constants; orthotropic ones where nothing yields",
       "TYPE=ISOTROPIC|ISO|ORTHOTROPIC|ORTHO|ENGINEERINGCONSTANTS"},
      {"HYPERELASTIC", done,
       "NEO HOOKE, MOONEY-RIVLIN, OGDEN, and POLYNOMIAL, REDUCED POLYNOMIAL and YEOH of C10, C01, C20 and C02, with "
       "D1; "
       "without it Poisson's ratio is 0.475; not fitted to a test",
       "NEOHOOKE MOONEY-RIVLIN OGDEN POLYNOMIAL REDUCEDPOLYNOMIAL YEOH N TESTDATAINPUT MODULI=INSTANTANEOUS|LONGTERM"},
      {"HYPERFOAM", done, "one Poisson's ratio of all terms; not fitted to a test",
       "N POISSON TESTDATAINPUT MODULI=INSTANTANEOUS|LONGTERM"},
      {"UNIAXIAL TEST DATA", rejected, "HYPERELASTIC and HYPERFOAM are not fitted: their constants in its place"},
      {"BIAXIAL TEST DATA", rejected, "the same"},
      {"PLANAR TEST DATA", rejected, "the same"},
      {"SIMPLE SHEAR TEST DATA", rejected, "the same"},
      {"VOLUMETRIC TEST DATA", rejected, "the same"},
      {"PLASTIC", done,
       "table, also for several RATEs; KINEMATIC of two points; JOHNSON COOK, softening where the step is ADIABATIC",
       "HARDENING=ISOTROPIC|KINEMATIC|JOHNSONCOOK RATE"},
      {"DRUCKER PRAGER", done, "LINEAR, with K 1 and a dilation angle of 0", "SHEARCRITERION=LINEAR"},
      {"DRUCKER PRAGER HARDENING", done, "of one stress, which stays", "TYPE=COMPRESSION|TENSION|SHEAR"},
      {"RATE DEPENDENT", done, "POWER LAW (Cowper-Symonds), YIELD RATIO, JOHNSON COOK",
       "TYPE=POWERLAW|YIELDRATIO|JOHNSONCOOK"},
      {"SHEAR FAILURE", done, "a constant strain at which elements are eroded", "ELEMENTDELETION=YES"},
      {"DAMPING", done, "ALPHA, the same for all materials", "ALPHA BETA"},
      {"CONDUCTIVITY", ignored, "heat of plastic work stays where it is"},
      {"SPECIFIC HEAT", done, "a constant, in an ADIABATIC step"},
      {"INELASTIC HEAT FRACTION", done, "the same; without it 0.9"},
      {"EXPANSION", done, "the same: as an equation of state", "ZERO TYPE=ISO"},
      {"AMPLITUDE", done, "TABULAR, EQUALLY SPACED; SMOOTH STEP as 64 straight pieces",
       "NAME DEFINITION=TABULAR|SMOOTHSTEP|EQUALLYSPACED TIME=STEPTIME|TOTALTIME VALUE=RELATIVE|ABSOLUTE FIXEDINTERVAL "
       "BEGIN INPUT"},
      {"INITIAL CONDITIONS", done,
       "TYPE=VELOCITY; TYPE=ROTATING VELOCITY; TYPE=TEMPERATURE, the same for all nodes of a material; TYPE=STRESS, "
       "one "
       "for each element; TYPE=HARDENING without back stress",
       "TYPE=VELOCITY|ROTATINGVELOCITY|TEMPERATURE|STRESS|HARDENING DEFINITION=COORDINATES"},
      {"STEP", done, "one after the other; in those behind the first BOUNDARY, CLOAD, DLOAD, DSLOAD and output alone",
       "NAME NLGEOM=YES| AMPLITUDE=STEP|RAMP INC"},
      {"END STEP", done, ""},
      {"DYNAMIC", done, "EXPLICIT, with its period and SCALE FACTOR",
       "EXPLICIT ELEMENTBYELEMENT ADIABATIC SCALEFACTOR FIXEDTIMEINCREMENTATION IMPROVEDDTMETHOD"},
      {"DYNAMIC TEMPERATURE-DISPLACEMENT", done, "as ADIABATIC, where next to no heat flows"},
      {"BULK VISCOSITY", done, "without it 0.06 and 1.2"},
      {"FIXED MASS SCALING", done, "DT with BELOW MIN, which is the default, or SET EQUAL DT; FACTOR; of all elements",
       "DT TYPE=BELOWMIN|SETEQUALDT ELSET FACTOR"},
      {"VARIABLE MASS SCALING", done, "the same without FACTOR, of the start of the run alone",
       "DT TYPE=BELOWMIN|SETEQUALDT ELSET FREQUENCY NUMBERINTERVAL"},
      {"BOUNDARY", done,
       "degrees of freedom 1 to 3, of reference nodes 1 to 6, ENCASTRE, PINNED, symmetries; displacement, velocity, "
       "acceleration",
       "TYPE=DISPLACEMENT|VELOCITY|ACCELERATION AMPLITUDE OP=MOD|NEW"},
      {"CLOAD", done, "on each node", "AMPLITUDE OP=MOD|NEW"},
      {"DLOAD", done, "P1 to P6, GRAV", "AMPLITUDE OP=MOD|NEW"},
      {"DSLOAD", done, "P", "AMPLITUDE OP=MOD|NEW"},
      {"CONTACT", done, "exact impulses between faces", "OP=MOD|NEW"},
      {"CONTACT INCLUSIONS", done, "ALL EXTERIOR, or pairs of surfaces", "ALLEXTERIOR"},
      {"CONTACT EXCLUSIONS", done, "of whole bodies, and of whole surfaces of inclusions; others are refused"},
      {"CONTACT PROPERTY ASSIGNMENT", done,
       "of all, or of surfaces that general contact includes; the last one counts"},
      {"CONTACT PAIR", done, "of two surfaces, or of one with itself; they may slide as far as they do",
       "INTERACTION MECHANICALCONSTRAINT=KINEMATIC|PENALTY TYPE=SURFACETOSURFACE|NODETOSURFACE|MASSLESS CPSET WEIGHT "
       "OP=ADD SMALLSLIDING"},
      {"TIE", done, "nodes of the first surface move with the faces of the second",
       "NAME ADJUST POSITIONTOLERANCE TYPE=SURFACETOSURFACE|NODETOSURFACE NOROTATION"},
      {"SURFACE INTERACTION", done, "", "NAME"},
      {"FRICTION", done, "a constant, or EXPONENTIAL DECAY", "EXPONENTIALDECAY SLIPTOLERANCE"},
      {"SURFACE BEHAVIOR", done, "hard contact; LINEAR, where it is not softer than an element, as hard contact",
       "PRESSURE-OVERCLOSURE=HARD|LINEAR PENALTY AUGMENTEDLAGRANGE"},
      {"CONTACT CONTROLS*", ignored, "scale factors of penalties: contact here has none"},
      {"CONTACT FORMULATION", ignored, "exact between all faces"},
      {"OUTPUT", done, "FIELD: fields of this program; HISTORY: rows of history.csv",
       "FIELD HISTORY VARIABLE NUMBERINTERVAL TIMEINTERVAL TIMEPOINTS FREQUENCY TIMEMARKS NAME OP FILTER MODELEDGE"},
      {"TIME POINTS", done, "of fields: where an OUTPUT names them", "NAME GENERATE"},
      {"NODE OUTPUT", done,
       "HISTORY of an NSET: a probe of each node, node_NUMBER or node_INSTANCE_NUMBER; else ignored",
       "NSET VARIABLE EXTERIOR TRACERSET"},
      {"ELEMENT OUTPUT", done, "the same of an ELSET, element_NUMBER or element_INSTANCE_NUMBER",
       "ELSET VARIABLE EXTERIOR DIRECTIONS POSITION REBAR SECTIONPOINTS ALLSECTIONPTS MICROMECHANICS"},
      {"ENERGY OUTPUT", done, "all energies are always written; ELSET: those of each body, too (`body_energies`)",
       "ELSET VARIABLE PERELEMENTSET"},
      {"CONTACT OUTPUT", ignored, "output of another program"},
      {"SURFACE OUTPUT", ignored, "output of another program"},
      {"INCREMENTATION OUTPUT", ignored, "output of another program"},
      {"INTEGRATED OUTPUT*", ignored, "output of another program"},
      {"NODE PRINT", ignored, "output of another program"},
      {"EL PRINT", ignored, "output of another program"},
      {"ENERGY PRINT", ignored, "output of another program"},
      {"NODE FILE", ignored, "output of another program"},
      {"EL FILE", ignored, "output of another program"},
      {"ENERGY FILE", ignored, "output of another program"},
      {"CONTACT PRINT", ignored, "output of another program"},
      {"CONTACT FILE", ignored, "output of another program"},
      {"SECTION PRINT", ignored, "output of another program"},
      {"SECTION FILE", ignored, "output of another program"},
      {"FILE OUTPUT", ignored, "output of another program"},
      {"FILE FORMAT", ignored, "output of another program"},
      {"FILTER", ignored, "output of another program"},
      {"MONITOR", ignored, "output of another program"},
      {"DIAGNOSTICS", ignored, "output of another program"},
      {"RESTART", ignored, "WRITE; READ is refused"},
      {"USER MATERIAL", rejected, "a subroutine: ELASTIC and PLASTIC in its place"},
      {"DEPVAR", rejected, "the same"},
      {"DAMAGE INITIATION", rejected, "SHEAR FAILURE in its place"},
      {"DAMAGE EVOLUTION", rejected, "the same"},
      {"MPC", done, "PIN, TIE and LINEAR of nodes of solids, or of sets of them, as EQUATION; other kinds are refused",
       ""},
      {"EQUATION", done, "of displacements of nodes of solids, or of sets of them, in the order of their numbers", ""},
      {"TRANSFORM", done, "R, and C of what holds nodes or acts along the axis: of BOUNDARY, CLOAD and EQUATION",
       "NSET TYPE=R|C|S"},
      {"SYSTEM", rejected, "local systems of nodes"},
      {"NGEN", rejected, "meshes that the deck generates"},
      {"NFILL", rejected, "meshes that the deck generates"},
      {"NCOPY", rejected, "meshes that the deck generates"},
      {"ELGEN", rejected, "meshes that the deck generates"},
      {"ELCOPY", rejected, "meshes that the deck generates"},
  };
  return rules;
}

const AbaqusRule* abaqus_rule_of(const std::string& name) {
  const AbaqusRule* best = nullptr;
  for (const AbaqusRule& rule : abaqus_rules()) {
    std::string pattern = squeezed(rule.name);
    const bool open = pattern.ends_with('*');
    if (open) pattern.pop_back();
    if (name == pattern) return &rule;
    if (open && name.starts_with(pattern)) best = &rule;
  }
  return best;
}

namespace {

bool is_output_or_control(const std::string& name) {
  return name.find("OUTPUT") != std::string::npos || name.find("CONTROLS") != std::string::npos ||
         name.ends_with("PRINT") || name.ends_with("FILE");
}

std::vector<std::string> cut(const std::string& text, char at) {
  std::vector<std::string> pieces{""};
  for (const char c : text) {
    if (c == at) {
      pieces.emplace_back();
    } else {
      pieces.back() += c;
    }
  }
  return pieces;
}

bool is_known(const AbaqusRule& rule, const std::string& name, const std::string& value) {
  for (const std::string& known : cut(rule.parameters, ' ')) {
    const std::size_t equals = known.find('=');
    if (known.substr(0, equals) != name) continue;
    if (equals == std::string::npos) return true;
    return std::ranges::count(cut(known.substr(equals + 1), '|'), squeezed(value)) > 0;
  }
  return false;
}

/// What may stand in a step behind the first: what else a step changes would need a beginning in the scene.
bool may_come_later(const std::string& name) {
  static const std::set<std::string> names{"STEP",          "ENDSTEP",      "DYNAMIC",  "BULKVISCOSITY", "BOUNDARY",
                                           "CLOAD",         "DLOAD",        "DSLOAD",   "OUTPUT",        "NODEOUTPUT",
                                           "ELEMENTOUTPUT", "ENERGYOUTPUT", "AMPLITUDE"};
  return names.contains(name);
}

/// What acts in a step, and cannot stand before the first one or behind *END STEP.
bool is_of_step(const std::string& name) {
  static const std::set<std::string> names{
      "CLOAD", "DLOAD", "DSLOAD", "FIXEDMASSSCALING", "DYNAMIC", "BULKVISCOSITY", "VARIABLEMASSSCALING"};
  return names.contains(name);
}

/// What a keyword is refused for besides its parameters.
std::string rejected_option(const AbaqusBlock& block) {
  if (block.step == 0 && is_of_step(block.name)) return block.star_name() + " outside of a step";
  if (block.name == "DYNAMIC" && !block.has("EXPLICIT")) return "*DYNAMIC without EXPLICIT";
  if (block.name == "RESTART" && block.has("READ")) return "*RESTART, READ";
  return "";
}

}  // namespace

void sort_abaqus_keyword(const AbaqusBlock& block, bool lenient, DeckReport& report) {
  const AbaqusRule* rule = abaqus_rule_of(block.name);
  if (const std::string option = rejected_option(block); !option.empty()) {
    report.reject(block.place, option);
  } else if (rule == nullptr) {
    if (lenient && is_output_or_control(block.name)) {
      report.leave_out(block.place, block.star_name());
    } else {
      report.reject(block.place, block.star_name());
    }
  } else if (rule->treatment == Treatment::ignored) {
    report.ignore(block.place, block.star_name());
  } else if (rule->treatment == Treatment::rejected) {
    report.reject(block.place, block.star_name(), rule->remark);
  } else if (rule->treatment == Treatment::done && block.step > 1 && !may_come_later(block.name)) {
    report.reject(block.place, block.star_name() + " in a step behind the first");
  } else {
    for (const auto& [name, value] : block.parameters) {
      if (!is_known(*rule, name, value))
        report.reject(block.place, fmt::format("{}, {}{}", block.star_name(), name, value.empty() ? "" : '=' + value));
    }
  }
}

}  // namespace pinball
