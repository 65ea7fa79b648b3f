#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <solver/formats/lsdyna/layouts/keyword_cards.hpp>
#include <tests/support/cube_text.hpp>

/// A small deck for each card that is read, in which each of its fields can be set to something else.
namespace pinball::test {

struct CardDeck {
  std::string keyword, form;       ///< as in keyword_cards()
  std::vector<std::string> lines;  ///< of the keyword, between commas
  std::string others{};            ///< what it needs beside the two cubes, or in the place of what they have
  std::string same{};              ///< a field of which other values mean the same here
};

/// What stands in each deck that has not the same keyword otherwise: two cubes of elastic steel, one above the other,
/// sets, curves, a box, local systems, a vector.
inline std::vector<std::pair<std::string, std::string>> common_keywords() {
  return {{"NODE", square_lines(1, 0) + square_lines(5, 1) + square_lines(9, 1.5) + square_lines(13, 2.5)},
          {"ELEMENT_SOLID", "1,1,1,2,3,4,5,6,7,8\n2,2,9,10,11,12,13,14,15,16\n"},
          {"PART", "lower\n1,1,1\nupper\n2,1,1\n"},
          {"SECTION_SOLID", "1,1\n"},
          {"MAT_ELASTIC", "1,7.85E-9,210000.,0.3\n"},
          {"CONTROL_TERMINATION", "1.0E-6\n"},
          {"SET_NODE_LIST", "5\n5,6,7,8\n"},
          {"SET_NODE", "6\n13,14,15,16\n"},
          {"SET_SOLID_LIST", "5\n1\n"},
          {"SET_SEGMENT", "5\n5,6,7,8\n"},
          {"SET_PART_LIST", "5\n1\n"},
          {"SET_PART", "6\n2\n"},
          {"DEFINE_CURVE", "1\n0.0,1.0\n1.0,2.0\n"},
          {"DEFINE_BOX", "1,-1.,2.,-1.,2.,-1.,1.2\n"},
          {"DEFINE_VECTOR", "1,0.,0.,0.,1.,2.,3.\n"},
          {"DEFINE_COORDINATE_VECTOR", "1,1.,2.,3.,3.,-1.,0.5\n"}};
}

namespace of_cards {

/// A force by the curve 1; a part with hourglass control 4; a table 9 as the yield curves of the material.
inline const std::string load = "*LOAD_NODE_SET\n5,3,1\n", controlled = "*PART\nlower\n1,1,1,0,4\nupper\n2,1,1\n",
                         held = "*BOUNDARY_SPC_NODE\n5,1,1,1\n", falling = "*LOAD_BODY_Z\n1,9.81\n",
                         moving = "*INITIAL_VELOCITY_GENERATION\n30,1,0.,1.,2.,3.\n",
                         rates =
                             "*DEFINE_CURVE\n11\n0.,400.\n1.,500.\n*DEFINE_CURVE\n12\n0.,500.\n1.,600.\n"
                             "*DEFINE_CURVE\n1\n0.,1.\n1.,2.\n";
/// Parts with the equation of state 3, and a material that needs one.
inline const std::string compressed = "*PART\nlower\n1,1,1,3\nupper\n2,1,1,3\n",
                         metal = "*MAT_JOHNSON_COOK\n1,7.85E-9,80000.\n400.\n\n\n";
/// The upper part is rigid; both are.
inline const std::string rigid_part = "*PART\nlower\n1,1,1\nupper\n2,1,2\n",
                         rigid_parts = "*PART\nlower\n1,1,2\nupper\n2,1,2\n*MAT_RIGID\n2,7.85E-9,210000.,0.3\n\n\n";
/// The upper part is rigid, and moves.
inline const std::string attached =
    rigid_part + "*MAT_RIGID\n2,7.85E-9,210000.,0.3\n\n\n*INITIAL_VELOCITY_RIGID_BODY\n2,1.,2.,3.\n";
/// Both parts are rigid, the upper one stands on the lower one and moves.
inline const std::string standing =
    "*NODE\n" + square_lines(1, 0) + square_lines(5, 1) + square_lines(9, 1) + square_lines(13, 2) + rigid_parts;
inline const std::string one_inertia = "*PART\nupper\n2,1,1\n*MAT_RIGID\n2,7.85E-9,210000.,0.3\n\n\n";
inline const std::string no_elastic = "*MAT_ELASTIC\n9,7.85E-9,210000.,0.3\n";
/// A rigid plate of one shell above both.
inline const std::string plated =
    "*NODE\n" + square_lines(1, 0) + square_lines(5, 1) + square_lines(9, 1.5) + square_lines(13, 2.5) +
    square_lines(17, 4) + "*PART\nlower\n1,1,1\nupper\n2,1,1\nplate\n3,3,2\n*MAT_RIGID\n2,7.85E-9,210000.,0.3\n\n\n";
inline const std::string plate = "*SECTION_SHELL\n3\n0.1\n";
inline std::vector<std::string> with_blanks(std::vector<std::string> lines, std::size_t count) {
  lines.resize(lines.size() + count);
  return lines;
}

}  // namespace of_cards

inline std::vector<CardDeck> decks_of_mesh() {
  using namespace of_cards;
  std::vector<std::string> nodes;
  for (const std::string& text :
       {square_lines(1, 0), square_lines(5, 1), square_lines(9, 1.5), square_lines(13, 2.5)}) {
    for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
      nodes.push_back(text.substr(at, text.find('\n', at) - at));
  }
  std::vector<CardDeck> decks{
      {"NODE", "", nodes},
      {"ELEMENT_SOLID", "in one line", {"1,1,1,2,3,4,5,6,7,8", "2,2,9,10,11,12,13,14,15,16"}},
      {"ELEMENT_SOLID", "in two lines", {"1,1", "1,2,3,4,5,6,7,8", "2,2", "9,10,11,12,13,14,15,16"}},
      {"ELEMENT_MASS", "", {"3,13,1.E-9"}, "", "EID"},
      {"ELEMENT_MASS_NODE_SET", "", {"3,6,1.E-9"}, "", "EID"},
      {"ELEMENT_SHELL", "", {"3,3,17,18,19,20"}, plated + plate, "EID"},
      {"SECTION_SHELL", "", {"3", "0.1"}, plated + "*ELEMENT_SHELL\n3,3,17,18,19,20\n"},
      {"PART", "", {"lower", "1,1,1", "upper", "2,1,1"}},
      {"PART_CONTACT", "", {"lower", "1,1,1", "", "upper", "2,1,1", ""}, "*PART\n"},
      {"PART_INERTIA",
       "IRCS 0",
       {"lower", "1,1,2", "0.5,0.4,0.6,2.E-8", "4.,0.1,0.2,5.,0.3,6.", "1.,2.,3.,4.,5.,6."},
       one_inertia},
      {"PART_INERTIA",
       "IRCS 1",
       {"lower", "1,1,2", "0.5,0.4,0.6,2.E-8,1", "4.,0.1,0.2,5.,0.3,6.", "1.,2.,3.,4.,5.,6.", "2.,1.,3.,3.,-1.,0.5"},
       one_inertia},
      {"SECTION_SOLID", "", {"1,1"}},
      {"INCLUDE_TRANSFORM",
       "",
       {"part.k", "100,100,100,100,100,100,100", "100", "", "7"},
       "*DEFINE_TRANSFORMATION\n7\nTRANSL,5.,5.,5.\n*BOUNDARY_PRESCRIBED_MOTION_SET\n5,4,0,101,1.,101\n"
       "*PART\nlower\n1,101,1\nupper\n2,1,1\n"},
      {"HOURGLASS", "", {"4,4,0.05,0,1.2,0.04"}, controlled},
      {"HOURGLASS", "", {"4,1"}, controlled},
      {"HOURGLASS", "", {"4,6"}, controlled},
      {"SET_SEGMENT", "", {"30", "9,10,11,12"}},
      {"SET_SEGMENT_GENERAL", "", {"30", "PART,1"}},
      {"SET_PART_LIST", "", {"30", "1"}, moving},
      {"SET_PART_LIST_GENERATE", "", {"30", "1,1"}, moving},
      {"SET_PART_ADD", "", {"30", "6"}, moving}};
  for (const char* kind : {"SET_NODE", "SET_SOLID"}) {
    const bool of_nodes = std::string(kind) == "SET_NODE";
    const auto set = [&](const char* form, const char* nodes_line, const char* solids_line) {
      decks.push_back(
          {std::string(kind) + form, "", {"30", of_nodes ? nodes_line : solids_line}, "", of_nodes ? "" : "BEND"});
    };
    set("_LIST", "9,10,11,12", "1");
    set("_LIST_GENERATE", "9,12", "1,1");
    set("_LIST_GENERATE_INCREMENT", "4,12,1", "1,2,1");
    set("_GENERAL", "NODE,9,10", "ELEM,1");
    set("_ADD", "5", "5");
    set("_COLUMN", "9", "1");
  }
  return decks;
}

inline std::vector<CardDeck> decks_of_definitions() {
  using namespace of_cards;
  const std::string included = "*INCLUDE_TRANSFORM\nmore.k\n100,100\n\n\n7\n";
  const std::string plastic = "1,7.85E-9,210000.,0.3,400.,1000.", curve = "9\n0.,400.\n1.,500.\n";
  return {
      {"DEFINE_BOX", "", {"1,-1.,2.,-1.,2.,-1.,1.2"}, "*INITIAL_VELOCITY\n0,0,1\n1.,2.,3.\n"},
      {"DEFINE_CURVE", "", {"1", "0.,1.", "1.,2."}, load},
      {"DEFINE_TABLE",
       "",
       {"9", "0.5,11", "10.,12"},
       rates + no_elastic + "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + plastic + "\n0.,0.,9\n\n\n"},
      {"DEFINE_VECTOR", "", {"1,0.,0.,0.,1.,2.,3."}, "*BOUNDARY_PRESCRIBED_MOTION_SET\n5,4,0,1,1.,1\n"},
      {"DEFINE_COORDINATE_SYSTEM",
       "",
       {"1,0.,0.,0.,1.,2.,3.", "3.,-1.,0.5"},
       held + "*DEFINE_COORDINATE_VECTOR\n8,1.,2.,3.,3.,-1.,0.5\n"},
      {"DEFINE_COORDINATE_VECTOR", "", {"1,1.,2.,3.,3.,-1.,0.5"}, held},
      {"DEFINE_TRANSFORMATION", "TRANSL", {"7", "TRANSL,5.,5.,5."}, included},
      {"DEFINE_TRANSFORMATION", "SCALE", {"7", "SCALE,3.,3.,3."}, included},
      {"DEFINE_TRANSFORMATION", "ROTATE", {"7", "ROTATE,1.,2.,3.,4.,5.,6.,30."}, included},
      {"DEFINE_TRANSFORMATION", "MIRROR", {"7", "MIRROR,5.,5.,5.,6.,7.,8."}, included},
      {"MAT_ELASTIC", "", {"1,7.85E-9,210000.,0.3"}},
      {"MAT_PLASTIC_KINEMATIC", "", {plastic + ",0.5", "40.,5.,0.1"}, no_elastic},
      {"MAT_NULL",
       "",
       {"1,1.E-9,-900.,1.E-9"},
       no_elastic + compressed + "*EOS_GRUNEISEN\n3,1.5E6,1.9,0.,0.,0.3,0.\n\n"},
      {"MAT_ORTHOTROPIC_ELASTIC",
       "",
       {"1,7.85E-9,9000.,5000.,2000.,0.1,0.05,0.12", "700.,300.,500.,2.", ",,,1.,0.5,0.", ",,,0.,1.,0.25"},
       no_elastic},
      {"MAT_MOONEY-RIVLIN_RUBBER", "", {"1,1.E-9,0.49,0.4,0.1", ""}, no_elastic},
      {"MAT_BLATZ-KO_RUBBER", "", {"1,1.E-9,0.5"}, no_elastic},
      {"MAT_HYPERELASTIC_RUBBER", "", {"1,1.E-9,0.49", "0.4,0.1,,0.02,0.01"}, no_elastic},
      {"MAT_HILL_FOAM",
       "",
       {"1,1.E-10,,0.3", "0.4,-0.1,0.2,0.1,0.1,0.1,0.1,0.1", "1.3,-2.,5.,1.,2.,3.,4.,6.", ""},
       no_elastic},
      {"MAT_OGDEN_RUBBER",
       "",
       {"1,1.E-9,0.49", "0.4,-0.1,0.2,0.1,0.1,0.1,0.1,0.1", "1.3,-2.,5.,1.,2.,3.,4.,6."},
       no_elastic},
      {"MAT_POWER_LAW_PLASTICITY", "", {"1,7.85E-9,210000.,0.3,600.,0.2,40.,5.", "400.,0,0.1"}, no_elastic},
      {"MAT_PIECEWISE_LINEAR_PLASTICITY", "SIGY and ETAN", {plastic, "40.,5."}, no_elastic},
      {"MAT_PIECEWISE_LINEAR_PLASTICITY",
       "LCSS",
       {plastic, "40.,5.,9", "", ""},
       no_elastic + "*DEFINE_CURVE\n" + curve + "*DEFINE_CURVE\n1\n0.,1.\n1.,2.\n"},
      {"MAT_PIECEWISE_LINEAR_PLASTICITY",
       "EPS and ES",
       {plastic, "40.,5.", "0.,0.1,0.2,0.3,0.4,0.5,0.6,0.7", "400.,410.,420.,430.,440.,450.,460.,470."},
       no_elastic},
      {"MAT_ISOTROPIC_ELASTIC_PLASTIC", "", {"1,7.85E-9,80000.,400.,1000.,170000."}, no_elastic},
      {"MAT_SIMPLIFIED_JOHNSON_COOK", "", {"1,7.85E-9,210000.,0.3", "400.,500.,0.3,0.01,0.4,,,1."}, no_elastic},
      {"MAT_JOHNSON_HOLMQUIST_CERAMICS",
       "",
       {"1,7.85E-9,80000.,0.9,0.3,0.01,0.6,0.7", "1.,200.,0.5,2800.,1400.,0.9", "0.01,0.9,170000.,1E4,2E4,0.5"},
       no_elastic},
      {"MAT_JOHNSON_HOLMQUIST_CERAMICS", "", {"1,7.85E-9,80000.,0.9", ",200.,,2800.,1400.", ",,170000."}, no_elastic},
      {"MAT_SOIL_AND_FOAM",
       "",
       {"1,1.8E-9,80.,900.,100.,3.,0.3,-2.", "", "0.,-0.01,-0.02,-0.03,-0.04,-0.05,-0.06,-0.07", "-0.08,-0.09",
        "0.,1.,2.,3.,4.,5.,6.,7.", "8.,9."},
       no_elastic},
      {"MAT_SOIL_AND_FOAM_FAILURE",
       "",
       {"1,1.8E-9,80.,900.,100.,3.,0.3,-2.", "", "0.,-0.01,-0.02,-0.03,-0.04,-0.05,-0.06,-0.07", "-0.08,-0.09",
        "0.,1.,2.,3.,4.,5.,6.,7.", "8.,9."},
       no_elastic},
      {"MAT_CRUSHABLE_FOAM", "", {"1,6.E-11,20.,0.1,71,0.1,0.2"}, no_elastic + "*DEFINE_CURVE\n71\n0,0.2\n0.5,3.\n"},
      {"MAT_JOHNSON_COOK",
       "",
       {"1,7.85E-9,80000.", "400.,500.,0.3,0.01,1.1,1800.,300.,1.", "4.5E8,-900.,1.,0.,0.1,0.2,-1.5,0.01", "0.5"},
       no_elastic + compressed + "*EOS_GRUNEISEN\n3,4.5E6,1.5,0.1,0.2,2.,0.4\n\n"},
      {"MAT_RIGID", "", {"2,7.85E-9,210000.,0.3", "1.,4,7", ""}, rigid_part},
      {"MAT_RIGID", "", {"2,7.85E-9,210000.,0.3", "-1.,1,100001", ""}, rigid_part},
      {"CONSTRAINED_RIGID_BODIES", "", {"1,2"}, rigid_parts},
      {"CONSTRAINED_EXTRA_NODES_NODE", "", {"2,7"}, attached},
      {"CONSTRAINED_EXTRA_NODES_SET", "", {"2,5"}, attached},
      {"CONSTRAINED_NODAL_RIGID_BODY", "", {"30,0,5"}},
      {"CONSTRAINED_JOINT_SPHERICAL", "", {"5,9"}, standing},
      {"CONSTRAINED_JOINT_REVOLUTE", "", {"5,9,6,10"}, standing},
      {"CONSTRAINED_JOINT_CYLINDRICAL", "", {"5,9,6,10"}, standing},
      {"CONSTRAINED_JOINT_TRANSLATIONAL", "", {"5,9,6,10"}, standing},
      {"CONSTRAINED_JOINT_UNIVERSAL", "", {"5,9,6,12"}, standing},
      {"CONSTRAINED_JOINT_LOCKING", "", {"5,9"}, standing},
      {"MAT_ADD_EROSION", "", {"1,0.,900.", "-300.,400.,500.,0.6,0.7,0.,0.,5.E-7", "", "", "0.,0.,0.,1.E-12"}},
      {"EOS_GRUNEISEN", "", {"3,4.5E6,1.5,0.1,0.2,2.,0.4", ""}, no_elastic + compressed + metal},
      {"EOS_LINEAR_POLYNOMIAL", "", {"3,0.,1.7E5,1.E5,1.E5,2.,0.4,0.1", ""}, no_elastic + compressed + metal},
      {"EOS_TABULATED",
       "",
       {"3,1.5", "0.1,0.,-0.1,-0.2,-0.3", "-0.4,-0.5,-0.6,-0.7,-0.8", "-1.7E4,0.,1.7E4,4.E4,8.E4",
        "1.E5,2.E5,3.E5,4.E5,5.E5", "1.,1.,1.,1.,1.", "1.,1.,1.,1.,1."},
       no_elastic + compressed + metal},
      {"EOS_TABULATED_COMPACTION",
       "",
       {"3,1.5", "0.,-0.05,-0.1,-0.2,-0.3", "-0.4,-0.5,-0.6,-0.7,-0.8", "0.,1.E4,1.7E4,4.E4,8.E4",
        "1.E5,2.E5,3.E5,4.E5,5.E5", "1.,1.,1.,1.,1.", "1.,1.,1.,1.,1.", "2.E5,2.E5,3.E5,3.E5,3.E5",
        "2.E6,3.E6,4.E6,5.E6,6.E6"},
       no_elastic + compressed + metal}};
}

inline std::vector<CardDeck> decks_of_boundaries() {
  std::vector<CardDeck> decks{{"BOUNDARY_SPC_NODE", "", {"5,0,1"}},
                              {"BOUNDARY_SPC_NODE_BIRTH_DEATH", "", {"5,0,1", "1E-7,5E-7"}},
                              {"BOUNDARY_SPC_SET", "", {"5,0,1"}},
                              {"BOUNDARY_SPC_SET_BIRTH_DEATH", "", {"5,0,1", "1E-7,5E-7"}},
                              {"BOUNDARY_PRESCRIBED_MOTION_NODE", "", {"5,1,0,1"}},
                              {"BOUNDARY_PRESCRIBED_MOTION_SET", "", {"5,1,0,1"}},
                              {"BOUNDARY_PRESCRIBED_MOTION_SET", "", {"5,4,0,1,1.,1"}},
                              {"BOUNDARY_PRESCRIBED_MOTION_RIGID", "", {"2,1,0,1"}},
                              {"BOUNDARY_PRESCRIBED_MOTION_RIGID", "", {"2,-8,0,1,1.,1"}, of_cards::rigid_parts},
                              {"INITIAL_VELOCITY", "", {"5,6", "1.,2.,3.", "4.,5.,6."}},
                              {"INITIAL_VELOCITY", "", {"", "1.,2.,3.", ""}},
                              {"INITIAL_VELOCITY_SET", "", {"5,6", "1.,2.,3.", "4.,5.,6."}},
                              {"INITIAL_VELOCITY_NODE", "", {"5,1.,2.,3."}},
                              {"INITIAL_VELOCITY_GENERATION", "", {"2,2,10.,1.,2.,3.", "0.,0.,0.,1.,2.,3."}},
                              {"INITIAL_VELOCITY_GENERATION", "", {"0,0,0.,1.,2.,3.", ""}},
                              {"INITIAL_STRESS_SOLID", "", {"1,1", "1.,2.,3.,4.,5.,6.,0.01"}},
                              {"INITIAL_STRESS_SOLID", "LARGE", {"1,1,0,1", "1.,2.,3.,4.,5.", "6.,0.01"}},
                              {"INITIAL_STRESS_SOLID_SET", "", {"5,1", "1.,2.,3.,4.,5.,6.,0.01"}},
                              {"INITIAL_STRESS_SOLID_SET", "LARGE", {"5,1,0,1", "1.,2.,3.,4.,5.", "6.,0.01"}},
                              {"INITIAL_VELOCITY_RIGID_BODY", "", {"2,1.,2.,3.,4.,5.,6."}, of_cards::rigid_parts},
                              {"INITIAL_VELOCITY_GENERATION", "", {"5,3,0.,1.,2.,3.", ""}},
                              {"LOAD_NODE_SET", "", {"5,3,1"}},
                              {"LOAD_NODE_POINT", "", {"5,3,1"}},
                              {"LOAD_SEGMENT", "", {"1,1.,0.,5,6,7,8"}},
                              {"LOAD_SEGMENT_SET", "", {"5,1"}},
                              {"LOAD_BODY_VECTOR", "", {"1,5.", "1.,2.,3."}},
                              {"LOAD_BODY_PARTS", "", {"5"}, of_cards::falling}};
  for (const char* axis : {"X", "Y", "Z"}) decks.push_back({std::string("LOAD_BODY_") + axis, "", {"1,5."}});
  const std::string nodes = "5", plane = "0.,0.,-1.,0.,0.5,1.", rectangle = "1.,0.,-1.,2.,3.", mass = "1E-6,1.";
  decks.push_back({"RIGIDWALL_PLANAR", "", {nodes, plane}});
  decks.push_back({"RIGIDWALL_PLANAR", "", {"", "0.,0.,-1.,0.,0.5,1.,1."}});
  decks.push_back({"RIGIDWALL_PLANAR_FINITE", "", {"", plane, ""}});
  decks.push_back({"RIGIDWALL_PLANAR_FINITE", "", {nodes, plane, rectangle}});
  decks.push_back({"RIGIDWALL_PLANAR_MOVING", "", {nodes, plane, mass}});
  decks.push_back({"RIGIDWALL_PLANAR_FINITE_MOVING", "", {nodes, plane, rectangle, mass}});
  return decks;
}

/// Every card of contact and of the controls: what is missing of the first lines is blank.
inline std::vector<CardDeck> decks_of_controls() {
  using namespace of_cards;
  std::vector<CardDeck> decks{
      {"CONTROL_BULK_VISCOSITY", "", {"1.2,0.04"}},
      {"CONTROL_CONTACT", "", with_blanks({}, 7)},
      {"CONTROL_BULK_VISCOSITY", "", {""}},
      {"CONTROL_DYNAMIC_RELAXATION", "", {""}},
      {"CONTROL_HOURGLASS", "", {"4,0.05"}},
      {"CONTROL_HOURGLASS", "", {""}},
      {"CONTROL_SOLUTION", "", {""}},
      {"CONTROL_TERMINATION", "", {"1E-6"}},
      {"CONTROL_TIMESTEP", "", {"0.,0.5,0,0.,-1E-9", "", ""}},
      {"CONTROL_TIMESTEP", "", {"", "", ""}},
      {"CONTROL_TIMESTEP", "", {"0.,0.5,0,0.,-1E-9", "", ""}, "*CONTROL_TERMINATION\n1.E-6,0,0.1\n"},
      {"CONTROL_TERMINATION", "", {"1E-6,0,0.1"}, "*CONTROL_TIMESTEP\n0.,0.5,0,0.,0.,0,1\n"},
      {"DAMPING_GLOBAL", "", {"0,10."}},
      {"DAMPING_GLOBAL", "", {""}},
      {"DATABASE_HISTORY_NODE", "", {"9,10"}},
      {"DATABASE_HISTORY_NODE_SET", "", {"5"}},
      {"DATABASE_HISTORY_SOLID", "", {"1"}},
      {"DATABASE_HISTORY_SOLID_SET", "", {"5"}},
      {"DATABASE_BINARY_D3PLOT", "", {"1E-7", ""}}};
  for (const char* name :
       {"GLSTAT", "MATSUM", "RCFORC", "RWFORC", "SPCFORC", "BNDOUT", "RBDOUT", "NODOUT", "ELOUT", "SLEOUT"})
    decks.push_back({std::string("DATABASE_") + name, "", {"1E-7"}});
  for (const KeywordCards& cards : keyword_cards()) {
    if (!cards.keyword.starts_with("CONTACT_")) continue;
    const bool tied = cards.keyword.starts_with("CONTACT_TIED");
    const bool single = cards.keyword.ends_with("SINGLE_SURFACE") || cards.keyword.find("GENERAL") != std::string::npos;
    const std::string sides = single ? "5,0,2,0" : "1,2,3,3",
                      friction = tied ? "0.,0.,0.,0.,0.,0,1E-7,5E-7" : "0.3,0.1,5.,0.,0.,0,1E-7,5E-7";
    const std::size_t more = cards.lines.size() - 3;
    decks.push_back({cards.keyword, "", with_blanks({sides, friction, tied ? "0.,0.,-0.1,-0.2" : ""}, more)});
    decks.push_back({cards.keyword, "", with_blanks({single ? "" : "5,5", "", ""}, more)});
    if (!tied) decks.push_back({cards.keyword, "", with_blanks({single ? "" : "5,5", "0.3", ""}, more)});
  }
  return decks;
}

}  // namespace pinball::test
