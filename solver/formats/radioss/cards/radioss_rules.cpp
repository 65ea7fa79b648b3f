#include "radioss_rules.hpp"

#include <string_view>

namespace pinball {

const std::vector<RadiossRule>& radioss_rules() {
  using enum Treatment;
  static const std::vector<RadiossRule> rules{
      {"BEGIN", done, "version and units; other work units are refused"},
      {"TITLE", done, "title of the scene"},
      {"UNIT", done, "of other keywords, which are refused where it is not that of BEGIN"},
      {"NODE", mesh, ""},
      {"BRICK", mesh, "wedges, pyramids and tetrahedra as collapsed hexahedra"},
      {"PENTA6", mesh, "as collapsed hexahedra"},
      {"TETRA4", mesh, "with volumes averaged over nodes"},
      {"TETRA10", mesh, "as eight of four nodes, with volumes averaged over nodes"},
      {"BRIC20", mesh, "as eight of eight nodes"},
      {"PART", done, "a body each; parts share the nodes that they have in common"},
      {"SUBSET", mesh, "of parts and of subsets"},
      {"PROP/SOLID", done,
       "TYPE14: Isolid 1 and 2 viscous with h/4; 24 and, in the place of full integration, 12, 14, 16, 17, 18 as "
       "assumed "
       "strains; qa, qb"},
      {"PROP/SHELL", done, "TYPE1: Thick, of shells that do not deform"},
      {"PROP/KJOINT2", done,
       "TYPE45, spherical (Type 1) or fixed (8), of a SPRING between two RBODY, exact; resistance that counts is "
       "refused"},
      {"PROP/*", rejected, "other properties; where no part with solids has it, it is reported"},
      {"DEF_SOLID", done, "Isolid and Ismstr where a property leaves them 0"},
      {"MAT/ELAST", done, "LAW1"},
      {"MAT/RIGID", done, "LAW13: each part that has it, and is not all of an RBODY, is a rigid body"},
      {"MAT/PLAS_JOHNS", done,
       "LAW2: a, b, n or Iflag 1, rate, heat, Chard of a line; SIG_max0 without rate and heat; EPS_p_max is refused"},
      {"MAT/HYDPLA", done, "LAW3, with an EOS"},
      {"MAT/HYD_JCOOK", done, "LAW4, with an EOS; Pmin"},
      {"MAT/PLAS_TAB", done, "LAW36: functions over plastic strain, of several rates"},
      {"MAT/COWPER", done, "LAW44: A, B, n or Iflag 1, sigmax; rate"},
      {"MAT/OGDEN", done, "LAW42: up to 10 terms, without viscosity"},
      {"MAT/VISC_HYP", done, "LAW62: up to 10 terms, without viscosity, and one nu"},
      {"MAT/JOHN_HOLM", done, "LAW79; IDEL 1 is refused"},
      {"MAT/DPRAG", done, "LAW21: a function of the compression, with Kt, B and Mu_max"},
      {"MAT/DPRAG1", done, "LAW10: C1, C2 and C3 with B and Mu_max; or a line P_min, with or without an EOS"},
      {"MAT/FOAM_PLAS", done, "LAW33: func_IDf, or A, B and C; P0 and Phi; SIG_COFF with Ka 2; Ka 1 is refused"},
      {"MAT/*", rejected, "other materials; where no part with solids has it, it is reported"},
      {"EOS/GRUNEISEN", done, "of LAW3, LAW4 and LAW10, at rest at the start"},
      {"EOS/POLYNOMIAL", done, "the same"},
      {"EOS/COMPACTION", done, "the same: C1, C2 and C3 with B, Mue_min and Mue_max; IFORM 1 and 2"},
      {"EOS/COMPACTION2", done, "the same: a function P_fun_id with Bmin, Bmax, Mue_min and Mue_max"},
      {"EOS/LINEAR", done, "the same: B"},
      {"EOS/*", rejected, "other equations of state, the same"},
      {"FAIL/JOHNSON", done, "of LAW2, LAW3 and LAW4: D1 to D5, IFAIL_SO 1: what fails is eroded"},
      {"FAIL/*", rejected, "other criteria, the same"},
      {"FUNCT", done, "where something names it"},
      {"SKEW/FIX", done, "where something names it"},
      {"SKEW/*", ignored, "refused where something names it"},
      {"FRAME/FIX", done, "axis and place of INIVEL/AXIS"},
      {"FRAME/*", ignored, "refused where something names it"},
      {"GRNOD/NODE", mesh, ""},
      {"GRNOD/GENE", mesh, ""},
      {"GRNOD/GEN_INCR", mesh, ""},
      {"GRNOD/GRNOD", mesh, ""},
      {"GRNOD/GRBRIC", mesh, ""},
      {"GRNOD/PART", mesh, ""},
      {"GRNOD/SUBSET", mesh, ""},
      {"GRNOD/MAT", mesh, ""},
      {"GRNOD/PROP", mesh, ""},
      {"GRNOD/SURF", mesh, "of SURF/.../EXT all nodes around its solids"},
      {"GRNOD/BOX", mesh, "of BOX/RECTA"},
      {"GRBRIC/BRIC", mesh, ""},
      {"GRBRIC/GENE", mesh, ""},
      {"GRBRIC/GEN_INCR", mesh, ""},
      {"GRBRIC/GRBRIC", mesh, ""},
      {"GRBRIC/PART", mesh, ""},
      {"GRBRIC/SUBSET", mesh, ""},
      {"GRBRIC/MAT", mesh, ""},
      {"GRBRIC/PROP", mesh, ""},
      {"GRBRIC/BOX", mesh, "solids all of whose nodes are in it"},
      {"GRPART/*", ignored, "nothing that is read names one"},
      {"SURF/SEG", mesh, ""},
      {"SURF/SURF", mesh, ""},
      {"SURF/PART/EXT", mesh, "faces on the surface of the mesh"},
      {"SURF/PART/ALL", mesh, "the same: faces between solids come to it where these erode"},
      {"SURF/SUBSET/EXT", mesh, "the same"},
      {"SURF/MAT/EXT", mesh, "the same"},
      {"SURF/PROP/EXT", mesh, "the same"},
      {"SURF/GRBRIC/EXT", mesh, "the same"},
      {"LINE/SURF", mesh, "for INTER/TYPE11"},
      {"BOX/RECTA", mesh, "along the axes, by the coordinates of two corners"},
      {"BCS", done, "also in a SKEW/FIX; rotations of nodes of solids mean nothing, those of main nodes hold a body"},
      {"IMPVEL", done, "along an axis, also of a SKEW/FIX; Tstart, Tstop; of main nodes also about an axis"},
      {"IMPDISP", done, "the same"},
      {"IMPACC", done, "the same"},
      {"INIVEL/TRA", done, "of a group, or of all nodes; also in a SKEW/FIX"},
      {"INIVEL/ROT", done, "of main nodes of RBODY; means nothing of other nodes"},
      {"INIVEL/AXIS", done, "with a spin about an axis of a FRAME/FIX, or of the global system"},
      {"INIBRI/STRESS", done, "a stress for each solid, along x, y and z"},
      {"INIBRI/EPSP", done, "its plastic strain"},
      {"INIBRI/STRS_FGLO", done, "both, of one point (Nb_integr 1)"},
      {"CLOAD", done, "along an axis, on each node; on main nodes on the centre of the body"},
      {"PLOAD", done, "on a SURF/SEG of faces of solids, along its normal"},
      {"GRAV", done, "of whole parts"},
      {"RWALL/PLANE", done,
       "nodes of grnd_ID1 and those within d, without grnd_ID2; slides, sticks (Slide 1) or rubs; with a node, Mass "
       "and velocity it is pushed along its normal"},
      {"RBODY", done,
       "nodes of whole parts, and others that move with these; mass, centre (ICoG) and inertia are those of its nodes "
       "with "
       "what its main node adds; Mass where no body that deforms has its nodes"},
      {"INTER/TYPE2", done, "nodes within dsearch of a face are put on it; 0: within 0.05 of its shorter diagonal"},
      {"INTER/TYPE7", done, "exact impulses between faces; Fric; Tstart, Tstop"},
      {"INTER/TYPE11", done, "the same of the faces that the lines are of"},
      {"INTER/TYPE24", done, "the same; without surf_ID2 a surface touches itself"},
      {"INTER/TYPE25", done, "the same"},
      {"DAMP", done, "Alpha of all nodes"},
      {"ADMAS", done, "types 0 and 1: a point mass at nodes of solids; of a main node of an RBODY a part of its mass"},
      {"TH/NODE", done, "a probe each, node_NUMBER"},
      {"TH/BRIC", done, "a probe each, element_NUMBER"},
      {"TH/PART", done, "energies, momentum and mass of each body (`body_energies`)"},
      {"TH/*", ignored, "history.csv has energies, and forces of contact, walls and rigid bodies"},
      {"ACCEL", ignored, "output, or of a SENSOR, which is refused"},
      {"RUN", done, "when the run ends"},
      {"DT", done, "Tsca; Tmin is not used"},
      {"DT/NODA", done, "the same: the step is that of elements"},
      {"DT/NODA/CST", done, "Tsca and Tmin: mass scaling at the start"},
      {"DT/BRICK/STOP", done, "Tsca, which counts before that of DT; Tmin is not used"},
      {"DT/BRICK/CST", done, "the same: at no step strains become small ones"},
      {"DT/INTER/DEL", ignored, "contact limits no step"},
      {"DT/INTER/CST", ignored, "the same"},
      {"DT/SHELL*", ignored, "there are no shells"},
      {"DT/SH_3N*", ignored, "there are no shells"},
      {"DT/SPRING*", ignored, "there are no springs"},
      {"DTIX", done, "steps are as long as is stable: nothing of it is used, and what it sets is reported"},
      {"STOP", done, "limits at which the engine stops: nothing of it is used, and what it sets is reported"},
      {"KILL", done, "the same"},
      {"TFILE", done, "rows of history.csv"},
      {"ANIM/DT", done, "Tfreq: fields of this program for ParaView"},
      {"ANIM*", ignored, "output of another program"},
      {"H3D*", ignored, "the same"},
      {"OUTP*", ignored, "the same"},
      {"RFILE*", ignored, "the same"},
      {"STATE*", ignored, "the same"},
      {"PRINT", ignored, "the same"},
      {"MON/*", ignored, "the same"},
      {"VERS", ignored, "of the engine's file"},
      {"PARITH/*", ignored, "results are the same bits for any number of threads"},
      {"PROC", ignored, "processors"},
      {"SPMD", ignored, "the same"},
      {"MEMORY", ignored, ""},
      {"IOFLAG", ignored, "output of another program"},
      {"ANALY", done, "N2D3D other than 0 is refused"},
      {"RANDOM", done, "noise other than 0 is refused"},
      {"DEF_SHELL", ignored, "there are no shells"},
      {"SHFRA/V4", ignored, "the same"},
      {"PROP/VOID", rejected, "elements without stiffness"},
      {"SHELL", mesh,
       "of parts of a MAT/RIGID, of an RBODY as a whole, or held along all axes by a BCS: a layer of solids; others "
       "are "
       "refused"},
      {"SH3N", mesh, "the same"},
      {"SHEL16", rejected, "thick shells: BRICK in their place"},
      {"QUAD", rejected, "plane and axisymmetric elements"},
      {"TRIA", rejected, "the same"},
      {"BEAM", rejected, "beams: solids in their place"},
      {"TRUSS", rejected, "the same"},
      {"SPRING", done, "joints of PROP/KJOINT2; springs and dampers are refused"},
      {"SPHCEL*", rejected, "particles"},
      {"ALE/*", rejected, "meshes that do not go with the material"},
      {"EULER/*", rejected, "the same"},
      {"INIBRI/*", rejected, "what elements have at the start"},
      {"INTER/*", rejected, "other contacts: TYPE2, 7, 11, 24 or 25 in their place"},
      {"RWALL/*", rejected, "walls that are no planes, or parts of them"},
      {"INIVEL/*", rejected, "other velocities: TRA, ROT or AXIS in their place"},
      {"SURF/*", rejected, "of solids SURF/.../EXT or SEG"},
      {"SET/*", rejected, "sets: GRNOD, GRBRIC and SURF in their place"},
  };
  return rules;
}

const RadiossRule* radioss_rule_of(const std::string& name) {
  const RadiossRule* best = nullptr;
  std::size_t longest = 0;
  for (const RadiossRule& rule : radioss_rules()) {
    std::string_view pattern = rule.name;
    if (name == pattern) return &rule;
    if (!pattern.ends_with('*')) continue;
    pattern.remove_suffix(1);
    if (name.starts_with(pattern) && pattern.size() >= longest) {
      best = &rule;
      longest = pattern.size();
    }
  }
  return best;
}

bool is_of_radioss_parts(const RadiossBlock& block) {
  for (const std::string_view family : {"MAT/", "PROP/", "EOS/", "FAIL/"}) {
    if (block.name.starts_with(family)) return true;
  }
  return false;
}

namespace {

bool is_output(const std::string& name) {
  for (const std::string_view family : {"ANIM", "H3D", "OUTP", "TH", "STATE", "DYNAIN", "ABF"}) {
    if (name.starts_with(family)) return true;
  }
  return false;
}

}  // namespace

void sort_radioss_keyword(const RadiossBlock& block, bool lenient, DeckReport& report) {
  const RadiossRule* rule = radioss_rule_of(block.name);
  if (rule == nullptr) {
    if (lenient && is_output(block.name)) {
      report.leave_out(block.place, block.title);
    } else {
      report.reject(block.place, block.title);
    }
  } else if (rule->treatment == Treatment::ignored) {
    report.ignore(block.place, block.title);
  } else if (rule->treatment == Treatment::rejected && !is_of_radioss_parts(block)) {
    report.reject(block.place, '/' + block.name, rule->remark);
  }
}

}  // namespace pinball
