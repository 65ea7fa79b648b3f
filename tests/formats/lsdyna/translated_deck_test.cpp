#include <gmock/gmock.h>

#include <cmath>

#include <solver/model/model.hpp>
#include <solver/model/selection/pressed_faces.hpp>

#include "deck_case.hpp"

namespace pinball::test::translated_deck_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

class Deck : public DeckTest {};

TEST_F(Deck, OfACubeIsAScene) {
  const Scene s = scene(cube + elastic + ends + "*TITLE\nA cube\n");
  EXPECT_EQ(s.name, "deck");
  expect_cube(s, "cube");
}

TEST_F(Deck, NumbersBeyondAllAreToldWithTheirCard) {
  const std::string stiff = cube + "*MAT_ELASTIC\n1,7.85E-9,1.7E308,0.49999\n" + ends;
  EXPECT_THAT(error_in_cards(stiff), HasSubstr("material.mat_1: bulk_modulus = inf is beyond double precision"));
}

TEST_F(Deck, HasTheDefaultsOfDecks) {
  const Scene s = scene(cube + elastic + ends);
  EXPECT_EQ(s.element.hourglass, HourglassControl::viscous);
  EXPECT_EQ(s.element.hourglass_coefficient, 0.025);
  EXPECT_EQ(s.element.quadratic_viscosity, std::sqrt(1.5));
  EXPECT_EQ(s.element.linear_viscosity, 0.06);
}

TEST_F(Deck, ChoosesHourglassControl) {
  const auto form = [&](const std::string& cards) { return scene(cube + elastic + ends + cards).element; };
  EXPECT_EQ(form("*CONTROL_HOURGLASS\n4,0.05\n").hourglass, HourglassControl::stiffness);
  EXPECT_EQ(form("*CONTROL_HOURGLASS\n4,0.05\n").hourglass_coefficient, 0.05);
  EXPECT_EQ(form("*CONTROL_HOURGLASS\n6\n").hourglass, HourglassControl::assumed_strain);
  EXPECT_EQ(form("*CONTROL_HOURGLASS\n2,0.2\n").hourglass_coefficient, 0.05);
  EXPECT_THAT(error(cube + elastic + ends + "*CONTROL_HOURGLASS\n9\n"), HasSubstr("hourglass control of form 9"));
}

TEST_F(Deck, TakesControlsOfTheStep) {
  const Scene s = scene(cube + elastic +
                        "*CONTROL_TERMINATION\n2.0,100\n*CONTROL_TIMESTEP\n0.0,0.67\n*CONTROL_BULK_VISCOSITY\n"
                        "1.0,0.1\n*DAMPING_GLOBAL\n0,50.\n*DATABASE_GLSTAT\n0.1\n*DATABASE_RCFORC\n0.05\n"
                        "*DATABASE_BINARY_D3PLOT\n0.5\n");
  EXPECT_EQ(s.time.cfl, 0.67);
  EXPECT_EQ(s.time.steps, 100);
  EXPECT_EQ(s.element.quadratic_viscosity, 1.0);
  EXPECT_EQ(s.element.linear_viscosity, 0.1);
  EXPECT_EQ(s.damping.mass, 50.0);
  EXPECT_EQ(s.output.interval, 0.05);
  EXPECT_EQ(s.output.field_interval, 0.5);
}

TEST_F(Deck, HoldsNodesByCodesSetsAndNumbers) {
  std::string held = cube;
  held.replace(held.find("1,0,0,0\n"), 8, "1,0,0,0,7\n");
  const Scene s = scene(held + elastic + ends + set_of_top +
                        "*BOUNDARY_SPC_SET\n3,0,0,0,1\n*BOUNDARY_SPC_NODE\n2,0,1,1,0,1,1,1\n3,0,1,1,0\n"
                        "*DEFINE_COORDINATE_VECTOR\n9,0,1,0,-1,0,0\n*BOUNDARY_SPC_NODE\n4,9,1,0,0\n");
  ASSERT_EQ(s.fixed_constraints.size(), 4u);
  EXPECT_EQ(s.fixed_constraints[0].directions.size(), 3u);
  EXPECT_THAT(s.fixed_constraints[0].nodes.nodes, ElementsAre(1));
  EXPECT_EQ(s.fixed_constraints[1].nodes.set, "3");
  const Model<double> model = build_model<double>(s);
  EXPECT_EQ(model.constraints.size(), 3u + 4u + 4u + 1u);
}

TEST_F(Deck, MovesNodesAsItsCurvesSay) {
  const Scene s = scene(cube + elastic + ends + set_of_top +
                        "*DEFINE_CURVE\n5,0,1.0,2.0\n0.,0.\n1.,3.\n*BOUNDARY_PRESCRIBED_MOTION_SET\n3,3,2,5,0.5\n"
                        "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,5\n");
  ASSERT_EQ(s.prescribed_velocities.size(), 2u);
  EXPECT_EQ(s.prescribed_velocities[0].quantity, MotionQuantity::displacement);
  EXPECT_THAT(s.prescribed_velocities[0].table.factors, ElementsAre(0.0, 3.0));
  EXPECT_EQ(s.prescribed_velocities[1].quantity, MotionQuantity::velocity);
  EXPECT_THAT(error(cube + elastic + ends + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,5\n"),
              HasSubstr("deck.k:23: no *DEFINE_CURVE has the number 5"));
}

TEST_F(Deck, BeginsWithVelocities) {
  const Scene s = scene(cube + elastic + ends + set_of_top +
                        "*INITIAL_VELOCITY\n0\n1.,2.,3.\n*INITIAL_VELOCITY_GENERATION\n1,2,0.,4.,5.,6.\n\n"
                        "*INITIAL_VELOCITY\n3\n0.,0.,-7.\n*INITIAL_VELOCITY_NODE\n1,9.,0.,0.\n");
  const Model<double> model = build_model<double>(s);
  const auto vz = [&](int n) { return model.nodes.velocity_of(model.node_of_scene_node[n])[2]; };
  EXPECT_EQ(vz(1), 6);
  EXPECT_EQ(vz(5), -7);
  EXPECT_EQ(model.nodes.velocity_of(model.node_of_scene_node[0])[0], 9);
}

TEST_F(Deck, HasWallsAndLoads) {
  const Scene s =
      scene(cube + elastic + ends + set_of_top +
            "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n*RIGIDWALL_PLANAR\n0\n0.,0.,-1.,0.,0.,5.,0.2\n*LOAD_NODE_SET\n3,3,5,-2.\n"
            "*LOAD_BODY_Z\n5,9.81\n");
  EXPECT_EQ(s.rigid_walls.at(0).plane.normal[2], 1);
  EXPECT_EQ(s.rigid_walls.at(0).friction, 0.2);
  EXPECT_TRUE(s.loads.at(0).each);
  EXPECT_THAT(s.loads[0].table.factors, ElementsAre(-2.0, -2.0));
  EXPECT_EQ(s.gravities.at(0).acceleration[2], -1) << "the frame goes up, bodies feel their weight";
}

TEST_F(Deck, HoldsAndMovesFromBirthToDeath) {
  const std::string curve = "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n*DEFINE_VECTOR\n6,0,0,0,0,3,4\n";
  const Scene s = scene(cube + elastic + ends + set_of_top + curve +
                        "*BOUNDARY_SPC_SET_BIRTH_DEATH\n3,0,1\n1.E-7,5.E-7\n*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1\n"
                        "0.,2.E-7\n2,0,1\n0.,1.E20\n*BOUNDARY_PRESCRIBED_MOTION_SET\n3,-4,0,5,2.,6,7.E-7,1.E-7\n"
                        "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,4,0,5,,6\n");
  ASSERT_EQ(s.fixed_constraints.size(), 3u);
  EXPECT_EQ(s.fixed_constraints[0].when.start, 1e-7);
  EXPECT_EQ(s.fixed_constraints[0].when.end, 5e-7);
  EXPECT_TRUE(s.fixed_constraints[1].when.always());
  EXPECT_EQ(s.fixed_constraints[2].when.end, 2e-7);
  ASSERT_EQ(s.prescribed_velocities.size(), 2u);
  EXPECT_FALSE(s.prescribed_velocities[0].direction) << "-4: the nodes are held across the vector";
  EXPECT_EQ(s.prescribed_velocities[0].velocity, (Point{0, 0.6, 0.8}));
  EXPECT_EQ(s.prescribed_velocities[0].when.start, 1e-7);
  EXPECT_EQ(s.prescribed_velocities[0].when.end, 7e-7);
  EXPECT_THAT(s.prescribed_velocities[0].table.times, ElementsAre(1e-7, 1 + 1e-7)) << "the curve begins at the birth";
  EXPECT_THAT(s.prescribed_velocities[1].table.times, ElementsAre(0.0, 1.0));
  EXPECT_EQ(s.prescribed_velocities[1].nodes.body, "cube");
  EXPECT_EQ(s.prescribed_velocities[1].direction.value(), (Point{0, 0.6, 0.8}));
  EXPECT_THAT(
      error(cube + elastic + ends + curve + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,8,0,5,,6\n1,1,4,5\n"),
      HasSubstr("*BOUNDARY_PRESCRIBED_MOTION_NODE with DOF 8 (deck.k:29): DOF 1 to 4 and -4 are read, and VAD 0 "
                "to 2\n  *BOUNDARY_PRESCRIBED_MOTION_NODE with VAD 4 (deck.k:30): DOF 1 to 4 and -4 "));
  EXPECT_THAT(translate(cube + elastic + ends + curve + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,6,0,5\n").understood,
              testing::Contains(HasSubstr("a rotation of nodes of solids (DOF 6) means nothing")));
}

/// As the manual of *INITIAL_VELOCITY_GENERATION has it, and OpenRadioss' reader: XC, YC, ZC are those of node NY then.
TEST_F(Deck, SpinsAboutAnAxisOfTwoNodesThroughTheFirst) {
  const auto spin = [&](const std::string& axis) {
    return cube + elastic + ends + "*INITIAL_VELOCITY_GENERATION\n1,2,10.\n" + axis + "\n";
  };
  const Scene of_nodes = scene(spin(",,,-999,2,6")), of_places = scene(spin("1.,0.,0.,0.,0.,1."));
  ASSERT_EQ(of_nodes.initial_velocities.size(), 1u);
  EXPECT_EQ(of_nodes.initial_velocities[0].centre, (Point{1, 0, 0}));
  EXPECT_EQ(of_nodes.initial_velocities[0].angular_velocity, of_places.initial_velocities[0].angular_velocity);
  const Model<double> model = build_model<double>(of_nodes), other = build_model<double>(of_places);
  for (std::size_t n = 0; n < 8; ++n) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(model.nodes.velocity_of(n)[k], other.nodes.velocity_of(n)[k]);
  }
  const std::string said = "NX is -999: the axis goes through node NY";
  EXPECT_THAT(translate(spin("3.,0.,0.,-999,2,6")).understood,
              Contains(AllOf(HasSubstr("INITIAL_VELOCITY_GENERATION: XC, YC, ZC"), HasSubstr(said))));
  EXPECT_THAT(translate(spin(",,,-999,2,6")).understood, Not(Contains(HasSubstr(said))));
}

TEST_F(Deck, BeginsWithSpinsBoxesAndLocalSystems) {
  const Scene s =
      scene(cube + elastic + ends + set_of_top +
            "*DEFINE_BOX\n4,-1,2,-1,2,-1.,0.5\n*DEFINE_COORDINATE_VECTOR\n9,0,1,0,-1,0,0\n"
            "*INITIAL_VELOCITY_GENERATION\n1,2,-3.,1.,0.,0.,0,9\n1.,2.,3.,0.,0.,2.\n"
            "*INITIAL_VELOCITY_GENERATION\n3,3,7.\n0.,0.,0.,-999,1,5\n"
            "*INITIAL_VELOCITY\n0,3,4\n5.,0.,0.\n0.,6.,0.\n*INITIAL_VELOCITY_NODE\n1,1.,0.,0.,0.,0.,0.,9\n");
  ASSERT_EQ(s.initial_velocities.size(), 5u);
  EXPECT_EQ(s.initial_velocities[0].velocity, (Point{0, 1, 0})) << "x of the system is the global y";
  EXPECT_EQ(s.initial_velocities[0].angular_velocity, (Point{0, 0, -3}));
  EXPECT_EQ(s.initial_velocities[0].centre, (Point{1, 2, 3}));
  EXPECT_EQ(s.initial_velocities[1].angular_velocity, (Point{0, 0, 7})) << "from node 1 to node 5";
  EXPECT_EQ(s.initial_velocities[1].nodes.set, "3");
  EXPECT_EQ(s.initial_velocities[2].nodes.box.value().high, (Point{2, 2, 0.5}));
  EXPECT_EQ(s.initial_velocities[2].nodes.without, "3");
  EXPECT_EQ(s.initial_velocities[3].velocity, (Point{0, 6, 0})) << "of those that NSIDEX leaves out";
  EXPECT_EQ(s.initial_velocities[4].velocity, (Point{0, 1, 0}));
  const Model<double> model = build_model<double>(s);
  EXPECT_EQ(model.nodes.velocity_of(model.node_of_scene_node[1])[0], 5);
  EXPECT_EQ(model.nodes.velocity_of(model.node_of_scene_node[5])[1], 6);
  EXPECT_THAT(error(cube + elastic + ends + "*INITIAL_VELOCITY\n0,0,8\n1.\n"),
              HasSubstr("deck.k:23: *INITIAL_VELOCITY: no *DEFINE_BOX has the number 8"));
}

TEST_F(Deck, HasWallsOfSetsThatEndAndMove) {
  const Scene s = scene(cube + elastic + ends + set_of_top + "*DEFINE_BOX\n4,-1,2,-1,2,-1.,0.5\n" +
                        "*RIGIDWALL_PLANAR_ID\n1,floor\n3,0,4,0.,1.E-7,2.E-7\n0.,0.,-1.,0.,0.,5.,1.\n"
                        "*RIGIDWALL_PLANAR_FINITE\n0,3\n1.,2.,-1.,1.,2.,0.,0.3\n1.,5.,-1.,4.,0.\n"
                        "*RIGIDWALL_PLANAR_MOVING\n0\n0.,0.,-2.,0.,0.,5.\n12.,-7.\n");
  ASSERT_EQ(s.rigid_walls.size(), 3u);
  EXPECT_EQ(s.rigid_walls[0].nodes.set, "3");
  EXPECT_TRUE(s.rigid_walls[0].nodes.box);
  EXPECT_FALSE(s.rigid_walls[0].sliding);
  EXPECT_EQ(s.rigid_walls[0].when.start, 1e-7);
  EXPECT_EQ(s.rigid_walls[0].when.end, 2e-7);
  EXPECT_EQ(s.rigid_walls[1].nodes.without, "3");
  EXPECT_EQ(s.rigid_walls[1].edge.value(), (Point{0, 1, 0}));
  EXPECT_EQ(s.rigid_walls[1].size, (std::array<double, 2>{4, 0}));
  EXPECT_EQ(s.rigid_walls[2].mass, 12);
  EXPECT_EQ(s.rigid_walls[2].speed, -7);
  EXPECT_THAT(error(cube + elastic + ends + "*RIGIDWALL_PLANAR\n0\n0.,0.,-1.,0.,0.,5.,2.\n"),
              HasSubstr("nodes that stick (FRIC > 1)"));
}

TEST_F(Deck, PressesOnSegments) {
  const std::string loads =
      "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n*SET_SEGMENT\n3\n5,6,7,8\n*LOAD_SEGMENT_SET\n3,5,2.E3,1.E-7\n"
      "*LOAD_SEGMENT\n5,-4.,0.,1,2,6,5\n5,-4.,0.,4,3,7,8\n";
  const Scene s = scene(cube + elastic + ends + set_of_top + loads);
  ASSERT_EQ(s.pressures.size(), 2u);
  EXPECT_EQ(s.pressures[0].faces.set, "3") << "sets of segments have numbers of their own";
  EXPECT_EQ(s.pressures[0].start, 1e-7);
  EXPECT_THAT(s.pressures[0].table.factors, ElementsAre(2e3, 2e3));
  EXPECT_EQ(s.pressures[1].corners.size(), 2u);
  const Model<double> model = build_model<double>(s);
  EXPECT_EQ(pressed_faces(model.mesh, {}, s.pressures[0]).size(), 1u);
  EXPECT_EQ(pressed_faces(model.mesh, {}, s.pressures[1]).size(), 2u);
}

TEST_F(Deck, AcceleratesPartsAlongVectors) {
  const std::string loads =
      "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n*SET_PART\n2\n1\n*LOAD_BODY_PARTS\n2\n*LOAD_BODY_VECTOR\n5,3.\n0.,0.,-2.\n"
      "*DEFINE_COORDINATE_VECTOR\n9,0,1,0,-1,0,0\n*LOAD_BODY_X\n5,1.,,,,,9\n";
  const Scene s = scene(cube + elastic + ends + loads);
  ASSERT_EQ(s.gravities.size(), 2u);
  EXPECT_EQ(s.gravities[0].acceleration[2], 1);
  EXPECT_THAT(s.gravities[0].bodies, ElementsAre("cube"));
  EXPECT_EQ(s.gravities[1].acceleration[1], -1);
}

TEST_F(Deck, ParametersAndCasesReachTheScene) {
  const std::string deck =
      cube + elastic + "*PARAMETER\nR end,2.5\n*CONTROL_TERMINATION\n&end\n*INITIAL_VELOCITY CID=2\n0\n1.,0.,0.\n";
  EXPECT_EQ(scene(deck).time.end, 2.5);
  EXPECT_TRUE(scene(deck).initial_velocities.empty());
  EXPECT_EQ(scene(deck, {.chosen_case = 2, .lenient = false, .name_in_scene = ""}).initial_velocities.size(), 1u);
}

TEST_F(Deck, ACaseBringsItsPartOfTheMesh) {
  const std::string deck = cube + elastic + ends +
                           "*CASE_BEGIN_2\n*NODE\n9,0,0,2\n11,1,0,2\n12,1,1,2\n13,0,1,2\n*ELEMENT_SOLID\n"
                           "11,1,5,6,7,8,9,11,12,13\n*SET_NODE_LIST\n4\n9\n*BOUNDARY_SPC_SET\n4,0,1,1,1\n*CASE_END_2\n";
  EXPECT_EQ(build_model<double>(scene(deck)).element_count(), 1);
  const Model<double> model =
      build_model<double>(scene(deck, {.chosen_case = 2, .lenient = false, .name_in_scene = ""}));
  EXPECT_EQ(model.element_count(), 2);
  EXPECT_EQ(model.constraints.size(), 3u);
}

TEST_F(Deck, SetsOfPartsHaveTheirForms) {
  const std::string velocity = "*INITIAL_VELOCITY_GENERATION\n5,1,0.,4.,5.,6.\n\n";
  for (const std::string set : {"*SET_PART_LIST_GENERATE\n5\n1,9000000000000000\n", "*SET_PART_LIST_COLLECT\n5\n1\n",
                                "*SET_PART_LIST_TITLE\nname\n5\n1\n", "*SET_PART_LIST\n4\n1\n*SET_PART_ADD\n5\n4\n"})
    EXPECT_EQ(scene(cube + elastic + ends + set + velocity).initial_velocities.size(), 1u) << set;
  EXPECT_THAT(error(cube + elastic + ends + "*SET_PART_COLUMN\n5\n1,2\n"), HasSubstr("*SET_PART_COLUMN (deck.k:22)"));
}

TEST_F(Deck, PartsMayHaveACardOfContact) {
  std::string parts = cube;
  parts.replace(parts.find("*PART\n"), 6, "*PART_CONTACT\n");
  parts.replace(parts.find("*SECTION"), 0, "0.1,0.2\n");
  EXPECT_EQ(scene(parts + elastic + ends).bodies.at(0).name, "cube");
}

/// Sets that a set adds are those of its own file, with the numbers that they have in the deck.
TEST_F(Deck, AddsSetsOfAnIncludedFileWithItsOffset) {
  std::ofstream(folder_ / "other.k")
      << "*KEYWORD\n*SET_PART_LIST\n4\n1\n*SET_PART_ADD\n5\n4\n*LOAD_BODY_PARTS\n5\n*END\n";
  const Scene s = scene(cube + elastic + ends + "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n*LOAD_BODY_Z\n5,3.\n" +
                        "*INCLUDE_TRANSFORM\nother.k\n0,0,0,0,100\n\n1,1,1,1\n\n");
  EXPECT_THAT(s.gravities.at(0).bodies, ElementsAre("cube"));
}

TEST_F(Deck, ThatCannotBeDoneIsRefusedInOneMessage) {
  const std::string message =
      error(cube + ends + "*ELEMENT_SHELL\n1,2,1,2,3,4\n2,2,1,2,3,4\n*ELEMENT_SHELL\n3,2,1,2,3,4\n*MAT_JOINT\n1,1\n" +
            "*MAT_VISCOELASTIC\n7,1\n*SECTION_SHELL\n7\n*CONTROL_UNHEARD_OF\n*CONTROL_UNHEARD_OF\n*CONTROL_TIMESTEP\n0,"
            "0.9,0,0,"
            "0,3\n");
  EXPECT_EQ(message,
            "deck.k: cannot be run, for this version has not:\n"
            "  *CONTROL_UNHEARD_OF (2 times, first in deck.k:31)\n"
            "  *MAT_JOINT (deck.k:25): other materials; where no part with solids has it, it is reported and refuses "
            "nothing\n"
            "  *ELEMENT_SHELL of parts that deform (3 elements, first in deck.k:20): solids, one or more through the "
            "thickness, in their place\n"
            "  *CONTROL_TIMESTEP with LCTM (deck.k:34): leave it out: the step is TSSFAC times the stable one");
  EXPECT_THAT(
      translate(cube + elastic + ends + "*MAT_VISCOELASTIC\n7,1\n*SECTION_SHELL\n7\n*EOS_JWL\n7\n*EOS_GRUNEISEN\n8\n")
          .understood,
      testing::IsSupersetOf({HasSubstr("not used: *MAT_VISCOELASTIC ("), HasSubstr("not used: *SECTION_SHELL ("),
                             HasSubstr("not used: *EOS_JWL ("),
                             HasSubstr("*EOS_GRUNEISEN, equation of state 8, which no part with solids has (")}));
}

/// What has a dimension that is not converted, or curves of which nobody says what they are.
TEST_F(Deck, RefusesWhatIsNotConvertedInAnIncludedFile) {
  const auto problem = [&](const std::string& text, const std::string& factors, const std::string& own = "") {
    std::ofstream(folder_ / "other.k") << text;
    return error(cube + elastic + ends + own + "*INCLUDE_TRANSFORM\nother.k\n\n\n" + factors + "\n\n");
  };
  const std::string velocity = "*INITIAL_VELOCITY\n0\n1.,0,0\n", curve = "*DEFINE_CURVE\n5\n0,1\n1,1\n",
                    load = "*LOAD_NODE_POINT\n1,1,5\n";
  EXPECT_EQ(problem(velocity + curve + load, "1,1,1,1"), no_error);
  EXPECT_THAT(problem(velocity + "*CONTROL_TERMINATION\n1.\n*DATABASE_ABSTAT\n1.\n", "1,1,1000"),
              AllOf(HasSubstr("*INITIAL_VELOCITY (other.k:1): in an included file of other units"),
                    HasSubstr("*CONTROL_TERMINATION (other.k:4): in an included file of other units"),
                    Not(HasSubstr("ABSTAT"))));
  EXPECT_THAT(problem(curve, "1,1000,1", load), HasSubstr("*DEFINE_CURVE 5 stands in an included file of other units"));
  EXPECT_THAT(problem("*DEFINE_TRANSFORMATION\n4\nTRANSL,1,0,0\n", "2,1,1"), HasSubstr("*DEFINE_TRANSFORMATION ("));
  EXPECT_THAT(problem("", "1,1,1,FtoC"), HasSubstr("FCTTEM: expected 1 or a blank"));
  EXPECT_THAT(problem("", "1,-1,1"), HasSubstr("FCTTIM: expected a number from 1e-30 to 1e30, got -1"));
}

TEST_F(Deck, LenientLeavesOutOutputAndControlsAlone) {
  const DeckOptions lenient{.chosen_case = {}, .lenient = true, .name_in_scene = ""};
  EXPECT_THAT(error(cube + elastic + ends + "*CONSTRAINED_NODE_SET\n*CONTROL_UNHEARD_OF\n", lenient),
              AllOf(HasSubstr("*CONSTRAINED_NODE_SET ("), Not(HasSubstr("CONTROL"))));
  EXPECT_EQ(error(cube + elastic + ends + "*CONTROL_UNHEARD_OF\n", lenient), "no error");
  for (const char* control : {"ADAPTIVE", "ALE", "THERMAL_SOLVER", "SPH", "CONTACT"}) {
    const TranslatedDeck deck = translate(cube + elastic + ends + "*CONTROL_" + control + "\n1.5\n", lenient);
    EXPECT_TRUE(deck.ignored.empty()) << control;
    EXPECT_THAT(deck.understood, Contains(HasSubstr(std::string("*CONTROL_") + control)));
  }
}

TEST_F(Deck, IgnoresAreListed) {
  EXPECT_THAT(translate(cube + elastic + ends + "*CONTROL_ENERGY\n2\n*DATABASE_ABSTAT\n").ignored,
              ElementsAre(HasSubstr("*CONTROL_ENERGY ("), HasSubstr("*DATABASE_ABSTAT (")));
}

/// A node that no solid has: it has no mass, and nothing could happen to it.
TEST_F(Deck, NodesOfNoSolidAreTold) {
  const std::string lone = "*NODE\n97,3,0,0,7\n98,3,0,0,7\n99,3,0,0\n";
  const TranslatedDeck deck = translate(cube + elastic + ends + lone +
                                        "*BOUNDARY_SPC_NODE\n1,0,1\n98,0,1\n99,0,1\n*INITIAL_VELOCITY_NODE\n99,1.\n"
                                        "*DATABASE_HISTORY_NODE\n1,99\n");
  EXPECT_THAT(deck.understood, Contains("*NODE: TC of 2 nodes of no solid is not used, the first is node 97"));
  EXPECT_THAT(deck.ignored,
              UnorderedElementsAre(HasSubstr("*BOUNDARY_SPC_NODE of a node of no solid (2 times, first in "),
                                   HasSubstr("*INITIAL_VELOCITY_NODE of a node of no solid ("),
                                   HasSubstr("*DATABASE_HISTORY_NODE of a node of no solid (")));
}

TEST_F(Deck, WhatIsMissingIsNamedWithItsPlace) {
  EXPECT_THAT(error(cube + elastic), HasSubstr("expected *CONTROL_TERMINATION"));
  EXPECT_EQ(error(cube + ends), "deck.k:15: no *MAT_... has the number 1");
  const std::string two = "*MAT_ELASTIC\n7,7.85E-9,210000.,0.3\n1,2.7E-9,70000.,0.3\n";
  EXPECT_EQ(error(cube + two + ends),
            "deck.k:15: no *MAT_... has the number 1; deck.k:20 begins with it, a line of *MAT_ELASTIC, and such a "
            "keyword has one: give each its own");
  EXPECT_THAT(error(cube + "*MAT_ELASTIC_TITLE\nfirst\n7,7.85E-9,210000.,0.3\nsecond\n1,2.7E-9,70000.,0.3\n" + ends),
              HasSubstr("deck.k:22 begins with it, a line of *MAT_ELASTIC_TITLE"));
  EXPECT_THAT(error(cube + "*MAT_ELASTIC\n7,7.85E-9,210000.,0.3\n3,2.7E-9,70000.,0.3\n" + ends),
              Not(HasSubstr("begins with it")));
  std::string no_section = cube;
  no_section.resize(no_section.find("*SECTION"));
  EXPECT_THAT(error(no_section + elastic + ends), HasSubstr("no *SECTION_SOLID has the number 1"));
  EXPECT_THAT(error(cube + elastic + ends + "*BOUNDARY_SPC_NODE\n99,0,1\n"),
              HasSubstr("deck.k:23: *BOUNDARY_SPC_NODE: node 99 is not there"));
}

TEST_F(Deck, ErrorsOfItsSceneNameItsCards) {
  EXPECT_THAT(error_in_cards(cube + "*MAT_ELASTIC\n1,-7.85E-9,210000.,0.3\n" + ends),
              HasSubstr("deck.k:19: *MAT_ELASTIC (ro): material.mat_1.density: expected a number > 0, got -7.85e-09"));
  EXPECT_THAT(error_in_cards(cube + elastic + "*CONTROL_TERMINATION\n-1.\n"),
              HasSubstr("deck.k:21: *CONTROL_TERMINATION (endtim): time.end: expected"));
  EXPECT_THAT(error_in_cards(cube + elastic + ends + "*BOUNDARY_SPC_SET\n77,0,1\n"),
              HasSubstr("deck.k:23: *BOUNDARY_SPC_SET: "));
  EXPECT_THAT(error_in_cards(cube + elastic + ends + "*INITIAL_VELOCITY\n77\n1.\n"), HasSubstr(" *INITIAL_VELOCITY: "));
}

/// Cards in another order, commas for columns and other numbers make the same scene.
TEST_F(Deck, IsTheSameInAnotherOrder) {
  const Model<double> a = build_model<double>(scene(cube + elastic + ends));
  const Model<double> b = build_model<double>(scene(ends + elastic + cube));
  EXPECT_EQ(a.mesh.nodes, b.mesh.nodes);
  EXPECT_EQ(a.mesh.hexahedra, b.mesh.hexahedra);
  EXPECT_EQ(a.element_mass, b.element_mass);
}

}  // namespace
}  // namespace pinball::test::translated_deck_test
