#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include <solver/model/model.hpp>

#include "abaqus_case.hpp"

namespace pinball::test::translated_abaqus_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;

class Abaqus : public AbaqusTest {};

TEST_F(Abaqus, CubeIsAScene) {
  expect_cube(scene("*HEADING\nA cube\n" + abaqus_cube + abaqus_steel + abaqus_step()), "Cube");
}

TEST_F(Abaqus, HasTheDefaultsOfAbaqus) {
  const Scene s = scene(abaqus_cube + abaqus_steel + abaqus_step());
  EXPECT_EQ(s.element.hourglass, HourglassControl::assumed_strain);
  EXPECT_EQ(s.element.linear_viscosity, 0.06);
  EXPECT_EQ(s.element.quadratic_viscosity, 1.2);
  EXPECT_EQ(s.time.cfl, 0.9);
}

TEST_F(Abaqus, ChoosesHourglassControl) {
  std::string cube = abaqus_cube;
  cube.insert(cube.find(", MATERIAL=Steel"), ", CONTROLS=c");
  const auto form = [&](const std::string& controls) {
    return scene(cube + abaqus_steel + "*SECTION CONTROLS, NAME=C, " + controls + abaqus_step()).element;
  };
  EXPECT_EQ(form("HOURGLASS=VISCOUS\n 2., 1., 1., 0.5, 0.5\n").hourglass_coefficient, 0.05);
  EXPECT_EQ(form("HOURGLASS=VISCOUS\n").hourglass, HourglassControl::viscous);
  EXPECT_EQ(form("HOURGLASS=VISCOUS\n 2., 1., 1., 0.5, 0.5\n").quadratic_viscosity, 0.6);
  EXPECT_EQ(form("HOURGLASS=STIFFNESS\n").hourglass, HourglassControl::stiffness);
  EXPECT_EQ(form("HOURGLASS=ENHANCED\n").hourglass, HourglassControl::assumed_strain);
  EXPECT_THAT(error(cube + abaqus_steel + abaqus_step()), HasSubstr("deck.inp:16: there is no *SECTION CONTROLS c"));
  EXPECT_THAT(error(cube + abaqus_steel + "*SECTION CONTROLS, NAME=C, HOURGLASS=COMBINED\n" + abaqus_step()),
              HasSubstr("*SECTION CONTROLS, HOURGLASS=COMBINED (deck.inp:23)"));
}

TEST_F(Abaqus, SectionsMayHaveControlsOfTheirOwn) {
  const std::string two = "*PART, NAME=p\n" + abaqus_cube + "*END PART\n*PART, NAME=q\n" +
                          std::string(abaqus_cube).replace(abaqus_cube.find(", MATERIAL"), 0, ", CONTROLS=soft") +
                          "*END PART\n*ASSEMBLY\n*INSTANCE, NAME=p1, PART=p\n*END INSTANCE\n"
                          "*INSTANCE, NAME=q1, PART=q\n5., 0., 0.\n*END INSTANCE\n*END ASSEMBLY\n" +
                          abaqus_steel + "*SECTION CONTROLS, NAME=soft, HOURGLASS=VISCOUS\n";
  const Scene s = scene(two + abaqus_step());
  EXPECT_EQ(s.element.hourglass, HourglassControl::assumed_strain);
  EXPECT_FALSE(s.bodies.at(0).element);
  ASSERT_TRUE(s.bodies.at(1).element);
  EXPECT_EQ(s.bodies[1].element->hourglass, HourglassControl::viscous);
}

TEST_F(Abaqus, ReadsPlasticityAsTableRatesAndLaws) {
  const auto material = [&](const std::string& options) {
    return scene(abaqus_cube + abaqus_steel + options + abaqus_step()).materials.at(0);
  };
  EXPECT_EQ(material("*PLASTIC\n300.,\n").yield_stress, 300);
  const Material line = material("*PLASTIC\n300., 0.\n400., 0.2\n");
  EXPECT_DOUBLE_EQ(line.plastic_modulus, 500);
  EXPECT_EQ(line.ultimate_stress, 400);
  const Material falls = material("*PLASTIC\n300., 0.\n200., 0.1\n");
  EXPECT_THAT(falls.yield_curves.at(0).stress, ElementsAre(300, 200, 200));
  const Material table = material("*PLASTIC\n300., 0.\n400., 0.1\n450., 0.3\n");
  EXPECT_THAT(table.yield_curves.at(0).plastic_strain, ElementsAre(0, 0.1, 0.3, 1.3));
  EXPECT_THAT(table.yield_curves.at(0).stress, ElementsAre(300, 400, 450, 450)) << "no hardening behind the table";
  const Material rates = material("*PLASTIC, RATE=100.\n400., 0.\n*PLASTIC\n300., 0.\n");
  ASSERT_EQ(rates.yield_curves.size(), 2u);
  EXPECT_EQ(rates.yield_curves[1].rate, 100);
  EXPECT_EQ(rates.strain_rate, StrainRate::plastic);
  const Material law = material("*PLASTIC\n300., 0.\n*RATE DEPENDENT, TYPE=POWER LAW\n40., 5.\n");
  EXPECT_EQ(law.rate_constant, 40);
  EXPECT_EQ(law.rate_exponent, 5);
  const Material ratio =
      material("*PLASTIC\n300., 0.\n400., 0.1\n*RATE DEPENDENT, TYPE=YIELD RATIO\n1., 0.\n1.5, 10.\n");
  EXPECT_THAT(ratio.yield_curves.at(1).stress, ElementsAre(450, 600, 600));
  const Material moves = material("*PLASTIC, HARDENING=KINEMATIC\n300., 0.\n400., 0.2\n");
  EXPECT_EQ(moves.isotropic_share, 0);
  EXPECT_DOUBLE_EQ(moves.plastic_modulus, 500);
  EXPECT_EQ(material("*PLASTIC\n300., 0.\n*SHEAR FAILURE\n0.4\n").erosion_strain, 0.4);
}

TEST_F(Abaqus, RefusesWhatDependsOnTemperature) {
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + "*PLASTIC\n300., 0., 20.\n200., 0., 400.\n" + abaqus_step()),
              HasSubstr("*PLASTIC that depends on temperature or fields (deck.inp:23)"));
  EXPECT_THAT(error(abaqus_cube + "*MATERIAL, NAME=steel\n*DENSITY\n1.\n*ELASTIC\n2., 0.3, 20.\n1., 0.3, 90.\n" +
                    abaqus_step()),
              HasSubstr("*ELASTIC that depends on temperature or fields"));
  EXPECT_EQ(error(abaqus_cube +
                  "*MATERIAL, NAME=steel\n*DENSITY\n1.\n*ELASTIC, TYPE=ANISOTROPIC\n1., 2., 3., 4., 5., 6., 7., "
                  "8.\n9., 10.\n" +
                  abaqus_step()),
            "deck.inp: cannot be run, for this version has not:\n  *ELASTIC, TYPE=ANISOTROPIC (deck.inp:21)")
      << "and for this reason alone";
}

TEST_F(Abaqus, HardensAsJohnsonAndCookSay) {
  const std::string head = abaqus_cube + abaqus_steel + "*PLASTIC, HARDENING=JOHNSON COOK\n240., 1220., .66, 0.77",
                    rate = "*RATE DEPENDENT, TYPE=JOHNSON COOK\n0.0298, 1.\n";
  const Material m = scene(head + "\n" + rate + abaqus_step()).materials.at(0);
  ASSERT_TRUE(m.johnson_cook);
  EXPECT_EQ(m.yield_stress, 240);
  EXPECT_EQ(m.johnson_cook->hardening_coefficient, 1220);
  EXPECT_EQ(m.johnson_cook->hardening_exponent, 0.66);
  EXPECT_EQ(m.johnson_cook->rate_coefficient, 0.0298);
  EXPECT_EQ(m.johnson_cook->reference_rate, 1);
  EXPECT_EQ(m.johnson_cook->melting_temperature, 0);
  EXPECT_EQ(m.strain_rate, StrainRate::plastic);
  EXPECT_EQ(scene(head + "\n" + abaqus_step()).materials.at(0).johnson_cook->rate_coefficient, 0);
  for (const char* alone : {"0.77", "0., 1500.", "0., 0., 300."})
    EXPECT_THAT(translate(abaqus_cube + abaqus_steel + "*PLASTIC, HARDENING=JOHNSON COOK\n240., 1220., .66, " + alone +
                          "\n" + abaqus_step())
                    .understood,
                Contains(AllOf(HasSubstr("m and its temperatures ("), HasSubstr("nothing becomes warm"))))
        << alone;
  EXPECT_THAT(error(head + "\n*RATE DEPENDENT, TYPE=POWER LAW\n40., 5.\n" + abaqus_step()),
              HasSubstr("*RATE DEPENDENT beside HARDENING=JOHNSON COOK"));
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + "*PLASTIC\n300., 0.\n" + rate + abaqus_step()),
              HasSubstr("*RATE DEPENDENT, TYPE=JOHNSON COOK beside another HARDENING"));
}

TEST_F(Abaqus, DampsWithAlphaOfAllMaterials) {
  EXPECT_EQ(scene(abaqus_cube + abaqus_steel + "*DAMPING, ALPHA=50.\n" + abaqus_step()).damping.mass, 50);
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + "*DAMPING, BETA=1e-6\n" + abaqus_step()), HasSubstr("*DAMPING, BETA"));
}

TEST_F(Abaqus, HoldsNodesByDegreesAndNames) {
  const auto directions = [&](const std::string& line) {
    const Scene s = scene(abaqus_cube + abaqus_steel + "*BOUNDARY\n" + line + "\n" + abaqus_step());
    std::size_t held = 0;
    for (const FixedConstraint& one : s.fixed_constraints) held += one.directions.size();
    return held;
  };
  EXPECT_EQ(directions("base, ENCASTRE"), 3u);
  EXPECT_EQ(directions("base, Pinned"), 3u);
  EXPECT_EQ(directions("base, 1, 2"), 2u);
  EXPECT_EQ(directions("base, 2"), 1u);
  EXPECT_EQ(directions("base, 4, 6"), 0u);
  EXPECT_EQ(directions("base, XSYMM"), 1u);
  EXPECT_EQ(directions("base, ZASYMM"), 2u);
  const Scene numbers = scene(abaqus_cube + abaqus_steel + "*BOUNDARY\n1, 1, 3\n2, 3\n3, 3, 3\n" + abaqus_step());
  ASSERT_EQ(numbers.fixed_constraints.size(), 2u) << "those that are held alike together";
  EXPECT_THAT(numbers.fixed_constraints[0].nodes.nodes, ElementsAre(2, 3));
  EXPECT_EQ(build_model<double>(numbers).constraints.size(), 5u);
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + "*BOUNDARY\nnone, 1\n" + abaqus_step()),
              HasSubstr("deck.inp:24: there is no set of nodes none"));
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + "*BOUNDARY\n99, 1\n" + abaqus_step()),
              HasSubstr("deck.inp:24: node 99 is not there"));
}

TEST_F(Abaqus, DegreesThatNodesOfSolidsDoNotHaveAreToldOrRefused) {
  const std::string head = abaqus_cube + abaqus_steel;
  const std::string boundary = "*BOUNDARY\nbase, ", initial = "*INITIAL CONDITIONS, TYPE=VELOCITY\nbase, ";
  const auto of_force = [](const std::string& degree) { return abaqus_step("*CLOAD\nbase, " + degree + ", 1.\n"); };
  for (const char* degree : {"7", "0", "-1", "11"}) {
    const std::string problem = fmt::format("with degree of freedom {} (deck.inp:24)", degree);
    EXPECT_THAT(error(head + boundary + degree + "\n" + abaqus_step()), HasSubstr("*BOUNDARY " + problem));
    EXPECT_THAT(error(head + initial + degree + ", 1.\n" + abaqus_step()), HasSubstr("*INITIAL CONDITIONS " + problem));
    EXPECT_THAT(error(head + of_force(degree)), HasSubstr(fmt::format("*CLOAD with degree of freedom {}", degree)));
  }
  EXPECT_THAT(error(head + boundary + "-1, 3\n" + abaqus_step()), HasSubstr("*BOUNDARY with degree of freedom -1"));
  EXPECT_THAT(error(head + boundary + "-5, -3\n" + abaqus_step()), HasSubstr("*BOUNDARY with degree of freedom -5"));
  EXPECT_THAT(error(head + boundary + "1, 9\n" + abaqus_step()), HasSubstr("*BOUNDARY with degree of freedom 9"));
  EXPECT_THAT(error(head + boundary + "3, 1\n" + abaqus_step()),
              HasSubstr("deck.inp:24: *BOUNDARY: expected the first degree of freedom before the last, got 3 and 1"));
  for (const char* degree : {"4", "5", "6"}) {
    const auto told = [](const char* keyword) {
      return ElementsAre(HasSubstr(fmt::format("*{} of rotations of nodes of solids (", keyword)));
    };
    EXPECT_THAT(translate(head + boundary + degree + "\n" + abaqus_step()).ignored, told("BOUNDARY"));
    EXPECT_THAT(translate(head + initial + degree + ", 1.\n" + abaqus_step()).ignored, told("INITIAL CONDITIONS"));
    EXPECT_THAT(translate(head + of_force(degree)).ignored, told("CLOAD"));
  }
}

TEST_F(Abaqus, NodesOfNoSolidAreTold) {
  const std::string lone = abaqus_cube + abaqus_steel + "*NODE\n99, 5., 0., 0.\n";
  EXPECT_THAT(translate(lone + "*BOUNDARY\n99, 1, 3\n" + abaqus_step()).ignored,
              ElementsAre(HasSubstr("*BOUNDARY of a node of no solid (")));
  EXPECT_THAT(translate(lone + "*INITIAL CONDITIONS, TYPE=VELOCITY\n99, 1, 2.\n" + abaqus_step()).ignored,
              ElementsAre(HasSubstr("*INITIAL CONDITIONS of a node of no solid (")));
}

TEST_F(Abaqus, MovesNodesAsItsAmplitudesSay) {
  const std::string head = abaqus_cube + abaqus_steel + "*AMPLITUDE, NAME=Up\n0., 0., 1., 3.\n";
  const Scene s =
      scene(head + abaqus_step("*BOUNDARY, AMPLITUDE=UP\ntop, 3, 3, 0.5\n*BOUNDARY, TYPE=VELOCITY\nbase, 1, , 2.\n"));
  ASSERT_EQ(s.prescribed_velocities.size(), 2u);
  EXPECT_EQ(s.prescribed_velocities[0].quantity, MotionQuantity::displacement);
  EXPECT_THAT(s.prescribed_velocities[0].table.factors, ElementsAre(0.0, 1.5));
  EXPECT_EQ(s.prescribed_velocities[0].velocity[2], 1.0);
  EXPECT_EQ(s.prescribed_velocities[1].quantity, MotionQuantity::velocity);
  EXPECT_EQ(s.prescribed_velocities[1].velocity[0], 2.0);
  EXPECT_TRUE(s.prescribed_velocities[1].table.times.empty());
  EXPECT_THAT(error(head + abaqus_step("*BOUNDARY\ntop, 3, 3, 0.5\n")), HasSubstr("a displacement at once"));
  EXPECT_THAT(error(head + abaqus_step("*BOUNDARY, AMPLITUDE=q\ntop, 3, 3, 0.5\n")),
              HasSubstr("there is no *AMPLITUDE q"));
}

TEST_F(Abaqus, AmplitudesMayBeAbsoluteSmoothOrEquallySpaced) {
  const auto table = [&](const std::string& amplitude) {
    return scene(abaqus_cube + abaqus_steel + "*AMPLITUDE, NAME=a" + amplitude +
                 abaqus_step("*CLOAD, AMPLITUDE=a\ntop, 1, 2.\n"))
        .loads.at(0)
        .table;
  };
  EXPECT_THAT(table(", VALUE=ABSOLUTE\n0., 5., 1., 6.\n").factors, ElementsAre(5, 6));
  EXPECT_THAT(table(", DEFINITION=EQUALLY SPACED, FIXED INTERVAL=0.5\n1., 2., 4.\n").times, ElementsAre(0, 0.5, 1));
  const TimeTable smooth = table(", DEFINITION=SMOOTH STEP\n0., 0., 2., 1., 3., 1.\n");
  EXPECT_EQ(smooth.times.size(), 66u);
  for (const double time : {0.1, 0.5, 1.0, 1.7}) {
    const double x = time / 2;
    EXPECT_NEAR(smooth.value(time), 2 * (10 * x * x * x - 15 * std::pow(x, 4) + 6 * std::pow(x, 5)), 4e-4) << time;
  }
  EXPECT_EQ(smooth.value(2.5), 2);
}

TEST_F(Abaqus, AStepMayRampAndRenewWhatIsHeld) {
  const std::string head = abaqus_cube + abaqus_steel + "*BOUNDARY\nbase, 3\n";
  const std::string step = "*STEP, AMPLITUDE=RAMP\n*DYNAMIC, EXPLICIT, SCALE FACTOR=0.5\n, 2.0E-6\n";
  const Scene s = scene(head + step + "*BOUNDARY, OP=NEW\ntop, 1, 1, 0.25\n*END STEP\n");
  EXPECT_TRUE(s.fixed_constraints.empty());
  EXPECT_THAT(s.prescribed_velocities.at(0).table.times, ElementsAre(0, 2e-6));
  EXPECT_THAT(s.prescribed_velocities[0].table.factors, ElementsAre(0, 0.25));
  EXPECT_EQ(s.time.cfl, 0.45);
}

TEST_F(Abaqus, BeginsWithVelocities) {
  const std::string head = abaqus_cube + abaqus_steel + "*INITIAL CONDITIONS, TYPE=VELOCITY\n";
  const auto velocity = [&](const std::string& lines, int node) {
    const Model<double> model = build_model<double>(scene(head + lines + abaqus_step()));
    const auto v = model.nodes.velocity_of(model.node_of_scene_node[node]);
    return Point{v[0], v[1], v[2]};
  };
  EXPECT_THAT(velocity("top, 1, 2.\ntop, 3, -7.\n", 4), ElementsAre(2, 0, -7));
  EXPECT_THAT(velocity("top, 1, 2.\ntop, 3, -7.\n", 0), ElementsAre(0, 0, 0));
  EXPECT_THAT(velocity("Cube, 1, 2.\n*NSET, NSET=cube, ELSET=Cube\n*INITIAL CONDITIONS, TYPE=VELOCITY\n7, 2, 4.\n", 6),
              ElementsAre(2, 4, 0))
      << "what one line leaves out the other gives";
}

TEST_F(Abaqus, HasLoadsAndGravity) {
  const Scene s = scene(
      abaqus_cube + abaqus_steel +
      abaqus_step("*CLOAD\ntop, 3, -2.\n8, 1, 3.\n*DLOAD\nCube, GRAV, 9810., 0., 0., -2.\n, GRAV, 1., 1., 0., 0.\n"));
  EXPECT_THAT(s.loads.at(0).force, ElementsAre(0, 0, -2));
  EXPECT_TRUE(s.loads[0].each);
  EXPECT_THAT(s.loads.at(1).nodes.nodes, ElementsAre(8));
  EXPECT_THAT(s.gravities.at(0).acceleration, ElementsAre(0, 0, -9810));
  EXPECT_EQ(s.gravities.size(), 2u);
}

TEST_F(Abaqus, PressesOnSurfacesAndFaces) {
  const std::string head = abaqus_cube + abaqus_steel + "*SURFACE, NAME=lid\nCube, S2\n";
  const Scene s = scene(head + abaqus_step("*DSLOAD\nlid, P, 5.\n*DLOAD\n10, P1, -2.\n"));
  ASSERT_EQ(s.pressures.size(), 2u);
  EXPECT_EQ(s.pressures[0].pressure, 5);
  EXPECT_EQ(s.pressures[0].faces.set, "lid");
  EXPECT_EQ(s.pressures[1].pressure, -2);
  EXPECT_THAT(error(head + abaqus_step("*DLOAD\nCube, BX, 1.\n*DSLOAD\nlid, TRVEC, 1.\n")),
              testing::AllOf(HasSubstr("*DLOAD, BX (deck.inp:28)"), HasSubstr("*DSLOAD, TRVEC (deck.inp:30)")));
  EXPECT_THAT(error(head + abaqus_step("*DSLOAD\nnone, P, 5.\n")), HasSubstr("there is no surface none"));
}

/// Two instances of a cube, of which one turns; bodies are their sections.
TEST_F(Abaqus, InstancesAreBodies) {
  const std::string deck = "*PART, NAME=Cube\n" + abaqus_cube +
                           "*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=Low, PART=Cube\n*END INSTANCE\n" +
                           "*INSTANCE, NAME=\"Up there\", PART=Cube\n0., 0., 1.5\n*END INSTANCE\n*NSET, "
                           "NSET=ends\nLow.base, \"Up there\".top\n"
                           "*END ASSEMBLY\n" +
                           abaqus_steel + "*BOUNDARY\nLow.base, 3\nends, 1\nLow.7, 2\n";
  const std::string contact = "*SURFACE INTERACTION, NAME=p\n*FRICTION\n0.2,\n";
  const Scene s = scene(deck + contact +
                        abaqus_step("*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n"
                                    "*CONTACT PROPERTY ASSIGNMENT\n , , p\n"));
  ASSERT_EQ(s.bodies.size(), 2u);
  EXPECT_EQ(s.bodies[0].name, "Low");
  EXPECT_EQ(s.bodies[1].name, "Up_there");
  EXPECT_EQ(s.contact.method, ContactMethod::pinball);
  EXPECT_EQ(s.contact.friction, 0.2);
  EXPECT_TRUE(s.contact.self);
  EXPECT_EQ(build_model<double>(s).constraints.size(), 4u + 8u + 1u);
}

TEST_F(Abaqus, LabelsInQuotesHaveACase) {
  const std::string soft = "*MATERIAL, NAME=\"Steel\"\n*DENSITY\n1E-9\n*ELASTIC\n1., 0.3\n";
  EXPECT_EQ(scene(abaqus_cube + soft + abaqus_steel + abaqus_step()).materials.at(0).density, 7.85e-9);
  EXPECT_EQ(scene(abaqus_cube + abaqus_steel + soft + abaqus_step()).materials.at(0).density, 7.85e-9);
  EXPECT_THAT(error(abaqus_cube + soft + abaqus_step()), HasSubstr("there is no *MATERIAL Steel"));
  std::string quoted = abaqus_cube;
  quoted.replace(quoted.find("=Steel"), 6, "=\"STEEL\"");
  EXPECT_EQ(scene(quoted + abaqus_steel + abaqus_step()).materials.at(0).density, 7.85e-9);
}

/// Two instances, and in each two sections, whose labels differ by quotes alone.
TEST_F(Abaqus, BodiesMayDifferByQuotesAlone) {
  const std::string deck =
      "*PART, NAME=p\n*NODE\n" + cube_lines(1) + "*NODE\n11, 0., 0., 2.\n12, 1., 0., 2.\n13, 1., 1., 2.\n" +
      "14, 0., 1., 2.\n*ELEMENT, TYPE=C3D8R, ELSET=Low\n1, 1, 2, 3, 4, 5, 6, 7, 8\n" +
      "*ELEMENT, TYPE=C3D8R, ELSET=\"Low\"\n2, 5, 6, 7, 8, 11, 12, 13, 14\n" +
      "*SOLID SECTION, ELSET=Low, MATERIAL=Steel\n*SOLID SECTION, ELSET=\"Low\", MATERIAL=light\n" +
      "*NSET, NSET=\"Low\", ELSET=\"Low\"\n*END PART\n" +
      "*ASSEMBLY\n*INSTANCE, NAME=It, PART=p\n*END INSTANCE\n*INSTANCE, NAME=\"It\", PART=P\n5., 0., 0.\n" +
      "*END INSTANCE\n*END ASSEMBLY\n" + abaqus_steel + "*MATERIAL, NAME=light\n*DENSITY\n1E-9\n*ELASTIC\n1., 0.3\n";
  const Scene s = scene(deck + abaqus_step("*BOUNDARY\nIt.\"Low\", 1\n\"It\".5, 2\n"));
  ASSERT_EQ(s.bodies.size(), 4u);
  const Model<double> model = build_model<double>(s);
  EXPECT_THAT(std::vector(model.element_mass.begin(), model.element_mass.end()),
              UnorderedElementsAre(DoubleEq(7.85e-9), DoubleEq(1e-9), DoubleEq(7.85e-9), DoubleEq(1e-9)));
  EXPECT_EQ(model.constraints.size(), 8u + 1u);
}

TEST_F(Abaqus, WhatCannotBeDoneIsRefusedInOneMessageBeforeTheMeshIsRead) {
  const std::string wrong =
      "*NODE\nno number\n*ELEMENT, TYPE=S4R\n*ELEMENT, TYPE=C3D27\n*ELEMENT, TYPE=C3D27\n"
      "*Shell Section, ELSET=a\n*CONNECTOR SECTION\n";
  EXPECT_EQ(error(wrong + abaqus_step("*FIXED MASS SCALING, DT=1e-7, TYPE=UNIFORM\n") + "*STEP\n*STATIC\n*END STEP\n"),
            "deck.inp: cannot be run, for this version has not:\n"
            "  *ELEMENT, TYPE=S4R (deck.inp:3)\n"
            "  *ELEMENT, TYPE=C3D27 (2 times, first in deck.inp:4)\n"
            "  *SHELL SECTION (deck.inp:6)\n"
            "  *CONNECTOR SECTION (deck.inp:7)\n"
            "  *FIXED MASS SCALING, TYPE=UNIFORM (deck.inp:11)\n"
            "  *STATIC (deck.inp:14)");
}

TEST_F(Abaqus, ErrorsOfItsSceneNameItsLines) {
  const TranslatedDeck deck =
      translate(abaqus_cube + abaqus_steel + "*INITIAL CONDITIONS, TYPE=VELOCITY\ntop, 3, 1.\n" + abaqus_step());
  SceneSource source = deck.source(path_);
  EXPECT_THAT(read_scene(source).initial_velocities.at(0).nodes.where,
              testing::AllOf(HasSubstr("deck.inp:24"), HasSubstr("*INITIAL CONDITIONS")));
  source.overrides.set = {"initial_velocity.0.set=5"};  // which is no text
  EXPECT_EQ(error_of([&] { read_scene(source); }), "--set initial_velocity.0.set=5: expected a text in quotes, got 5");
  const std::string light = "*MATERIAL, NAME=steel\n*DENSITY\n-1.\n*ELASTIC\n210000., 0.3\n";
  EXPECT_THAT(error(abaqus_cube + light + abaqus_step()),
              HasSubstr("deck.inp:20: *DENSITY: material.mat_STEEL.density: expected a number > 0, got -1"));
}

TEST_F(Abaqus, LenientLeavesOutOutputAndControlsAlone) {
  const DeckOptions lenient{.chosen_case = {}, .lenient = true, .name_in_scene = ""};
  const std::string deck = abaqus_cube + abaqus_steel + abaqus_step("*UNHEARD OUTPUT\n");
  EXPECT_THAT(error(deck), HasSubstr("*UNHEARD OUTPUT"));
  EXPECT_EQ(error(deck, lenient), no_error);
  EXPECT_THAT(error(abaqus_cube + "*CONNECTOR SECTION\n", lenient), HasSubstr("*CONNECTOR SECTION"));
}

TEST_F(Abaqus, WhatIsMissingIsNamedWithItsPlace) {
  EXPECT_THAT(error(abaqus_cube + abaqus_steel), HasSubstr("expected *STEP with *DYNAMIC, EXPLICIT"));
  EXPECT_THAT(error(abaqus_cube + abaqus_step()), HasSubstr("deck.inp:16: there is no *MATERIAL Steel"));
  EXPECT_THAT(error(abaqus_cube + "*MATERIAL, NAME=STEEL\n*ELASTIC\n1., 0.\n" + abaqus_step()),
              HasSubstr("deck.inp:18: *MATERIAL STEEL: expected *DENSITY"));
  std::string no_section = abaqus_cube;
  no_section.resize(no_section.find("*SOLID"));
  EXPECT_THAT(error(no_section + abaqus_steel + abaqus_step()),
              HasSubstr("deck.inp:11: element 10 is of no *SOLID SECTION"));
  EXPECT_THAT(error(abaqus_cube, {.chosen_case = 1, .lenient = false, .name_in_scene = ""}),
              HasSubstr("--case is for LS-DYNA"));
}

}  // namespace
}  // namespace pinball::test::translated_abaqus_test
