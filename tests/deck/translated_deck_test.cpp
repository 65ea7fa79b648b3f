#include <gmock/gmock.h>

#include <cmath>

#include <solver/model/model.hpp>

#include "deck_case.hpp"

namespace pinball::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Deck : public DeckTest {};

TEST_F(Deck, OfACubeIsAScene) {
  const Scene s = scene(cube + elastic + ends + "*TITLE\nA cube\n");
  EXPECT_EQ(s.title, "A cube");
  EXPECT_EQ(s.name, "deck");
  EXPECT_EQ(s.time.end, 1e-6);
  EXPECT_EQ(s.bodies.at(0).name, "cube");
  EXPECT_EQ(s.materials.at(0).density, 7.85e-9);
  EXPECT_DOUBLE_EQ(s.materials.at(0).shear_modulus, 210000. / 2.6);
  EXPECT_EQ(s.contact.method, ContactMethod::none);
  const Model<double> model = build_model<double>(s);
  EXPECT_EQ(model.element_count(), 1);
  EXPECT_DOUBLE_EQ(model.element_mass[0], 7.85e-9);
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

TEST_F(Deck, ParametersAndCasesReachTheScene) {
  const std::string deck =
      cube + elastic + "*PARAMETER\nR end,2.5\n*CONTROL_TERMINATION\n&end\n*INITIAL_VELOCITY CID=2\n0\n1.,0.,0.\n";
  EXPECT_EQ(scene(deck).time.end, 2.5);
  EXPECT_TRUE(scene(deck).initial_velocities.empty());
  EXPECT_EQ(scene(deck, {.chosen_case = 2, .lenient = false, .name_in_scene = ""}).initial_velocities.size(), 1u);
}

TEST_F(Deck, OfTwoPartsIsJoinedAndMayBeInContact) {
  const std::string two =
      cube +
      "*NODE\n11,0,0,1.1\n12,1,0,1.1\n13,1,1,1.1\n14,0,1,1.1\n15,0,0,2\n16,1,0,2\n17,1,1,2\n18,0,1,2\n"
      "*ELEMENT_SOLID\n20,2,11,12,13,14,15,16,17,18\n*PART\ncube\n2,1,1\n";
  const std::string contact = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n7,name\n1,2,3,3\n0.3,0.1,5.\n";
  const Scene s = scene(two + elastic + ends + contact);
  EXPECT_EQ(s.bodies.at(1).name, "part_2") << "a second title of that name";
  EXPECT_EQ(s.contact.method, ContactMethod::pinball);
  EXPECT_FALSE(s.contact.self);
  EXPECT_EQ(s.contact.friction, 0.1);
  EXPECT_EQ(s.contact.static_friction, 0.3);
  EXPECT_TRUE(scene(two + elastic + ends + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.2\n").contact.self);
  EXPECT_THAT(error(two + elastic + ends + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,3\n\n"),
              HasSubstr("contact of some parts of a deck alone"));
}

TEST_F(Deck, ThatCannotBeDoneIsRefusedInOneMessage) {
  const std::string message =
      error(cube + elastic + ends + "*ELEMENT_SHELL\n*ELEMENT_SHELL\n*MAT_RIGID\n*CONTROL_UNHEARD_OF\n");
  EXPECT_EQ(message,
            "deck.k: cannot be run, for this version has not:\n"
            "  *ELEMENT_SHELL (2 times, first in deck.k:22)\n"
            "  *MAT_RIGID (deck.k:24)\n"
            "  *CONTROL_UNHEARD_OF (deck.k:25)");
}

TEST_F(Deck, LenientLeavesOutOutputAndControlsAlone) {
  const DeckOptions lenient{.chosen_case = {}, .lenient = true, .name_in_scene = ""};
  EXPECT_THAT(error(cube + elastic + ends + "*MAT_RIGID\n*CONTROL_UNHEARD_OF\n", lenient),
              testing::Not(HasSubstr("CONTROL")));
  EXPECT_EQ(error(cube + elastic + ends + "*CONTROL_UNHEARD_OF\n", lenient), "no error");
}

TEST_F(Deck, IgnoresAreListed) {
  EXPECT_THAT(translate(cube + elastic + ends + "*CONTROL_ENERGY\n2\n*DATABASE_ABSTAT\n").ignored,
              ElementsAre(HasSubstr("*CONTROL_ENERGY ("), HasSubstr("*DATABASE_ABSTAT (")));
}

TEST_F(Deck, WhatIsMissingIsNamedWithItsPlace) {
  EXPECT_THAT(error(cube + elastic), HasSubstr("expected *CONTROL_TERMINATION"));
  EXPECT_THAT(error(cube + ends), HasSubstr("material"));
  std::string no_section = cube;
  no_section.resize(no_section.find("*SECTION"));
  EXPECT_THAT(error(no_section + elastic + ends), HasSubstr("no *SECTION_SOLID has the number 1"));
  EXPECT_THAT(error(cube + elastic + ends + "*BOUNDARY_SPC_NODE\n99,0,1\n"),
              HasSubstr("deck.k:23: *BOUNDARY_SPC_NODE: node 99 is not there"));
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
}  // namespace pinball::test
