#include <gmock/gmock.h>

#include "abaqus_case.hpp"

/// Mass scaling, section controls and times of output of Abaqus input.
namespace pinball::test::abaqus_controls_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

class AbaqusControls : public AbaqusTest {};

TEST_F(AbaqusControls, ScalesMassForAStep) {
  const auto scaled = [](const std::string& type) {
    return abaqus_cube + abaqus_steel + abaqus_step("*FIXED MASS SCALING, DT=1E-7" + type + "\n");
  };
  EXPECT_EQ(scene(scaled(", TYPE=BELOW MIN")).time.smallest_step, 1e-7);
  EXPECT_EQ(scene(scaled(", TYPE=BELOW MIN")).time.mass_scaling, MassScaling::small);
  EXPECT_EQ(scene(scaled(", TYPE=SET EQUAL DT, ELSET=Cube")).time.mass_scaling, MassScaling::all);
  EXPECT_EQ(scene(scaled("")).time.mass_scaling, MassScaling::small) << "the default of Abaqus";
  EXPECT_THAT(error(scaled(", TYPE=UNIFORM")), HasSubstr("*FIXED MASS SCALING, TYPE=UNIFORM (deck.inp:26)"));
}

TEST_F(AbaqusControls, ScalesAllMassesByAFactor) {
  const std::string head = abaqus_cube + abaqus_steel, scaling = "*FIXED MASS SCALING, FACTOR=";
  const TranslatedDeck deck = translate(head + abaqus_step(scaling + "100.\n"));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("densities are 100 times those of the materials")));
  const Scene s = read_scene(deck.source(path_));
  EXPECT_DOUBLE_EQ(s.materials.at(0).density, 7.85e-7);
  EXPECT_EQ(s.time.smallest_step, 0);
  EXPECT_EQ(scene(head + abaqus_step(scaling + "4., DT=1E-7\n")).time.smallest_step, 1e-7) << "and then by a step";
  EXPECT_EQ(scene(head + abaqus_step("*FIXED MASS SCALING\n")).materials.at(0).density, 7.85e-9) << "no factor is 1";
  EXPECT_THAT(error(head + abaqus_step(scaling + "0.\n")), HasSubstr("FACTOR: expected more than 0"));
}

TEST_F(AbaqusControls, ScalesMassAtTheStartAlone) {
  const std::string head = abaqus_cube + abaqus_steel;
  const std::string scaling = "*VARIABLE MASS SCALING, DT=1E-7, TYPE=BELOW MIN, FREQUENCY=5\n";
  const TranslatedDeck deck = translate(head + abaqus_step(scaling));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("elements get mass at the start alone")));
  EXPECT_EQ(read_scene(deck.source(path_)).time.smallest_step, 1e-7);
  EXPECT_THAT(
      error(head + abaqus_step("*VARIABLE MASS SCALING, TYPE=ROLLING, FEED RATE=1.\n")),
      AllOf(HasSubstr("*VARIABLE MASS SCALING, TYPE=ROLLING"), HasSubstr("*VARIABLE MASS SCALING, FEEDRATE=1.")));
  EXPECT_THAT(error(head + abaqus_step("*FIXED MASS SCALING, DT=2E-7\n" + scaling)),
              HasSubstr("*VARIABLE MASS SCALING with DT beside *FIXED MASS SCALING with DT"));
}

TEST_F(AbaqusControls, FactorsAndViscositiesBelowZeroAreToldWithTheirLine) {
  std::string section = abaqus_cube;
  section.replace(section.find("MATERIAL=Steel"), 14, "MATERIAL=Steel, CONTROLS=c");
  const auto controls = [&](const std::string& line) {
    return error(section + abaqus_steel + "*SECTION CONTROLS, NAME=c, HOURGLASS=STIFFNESS\n" + line + "\n" +
                 abaqus_step());
  };
  const std::string place = "deck.inp:24: *SECTION CONTROLS: ", wrong = ": expected a number >= 0, got -2";
  EXPECT_EQ(controls("-2."), place + "hourglass factor" + wrong);
  EXPECT_EQ(controls(",,,-2."), place + "factor of the linear bulk viscosity" + wrong);
  EXPECT_EQ(controls(",,,,-2."), place + "factor of the quadratic bulk viscosity" + wrong);
  const auto viscosity = [&](const std::string& line) {
    return error(abaqus_cube + abaqus_steel + abaqus_step("*BULK VISCOSITY\n" + line + "\n"));
  };
  EXPECT_EQ(viscosity("-2."), "deck.inp:27: *BULK VISCOSITY: b1" + wrong);
  EXPECT_EQ(viscosity("0.06,-2."), "deck.inp:27: *BULK VISCOSITY: b2" + wrong);
}

TEST_F(AbaqusControls, WritesAsOftenAsItIsAskedTo) {
  const Scene s = scene(
      abaqus_cube + abaqus_steel +
      abaqus_step("*OUTPUT, FIELD, NUMBER INTERVAL=10\n*NODE OUTPUT\nU, V\n*OUTPUT, HISTORY, TIME INTERVAL=1e-8\n"));
  EXPECT_DOUBLE_EQ(s.output.field_interval, 1e-7);
  EXPECT_EQ(s.output.interval, 1e-8);
  EXPECT_FALSE(s.output.body_energies);
}

TEST_F(AbaqusControls, WritesFieldsAtTimesOfAStep) {
  const std::string head = abaqus_cube + abaqus_steel, listed = "*TIME POINTS, NAME=tp\n0., 2e-7, 5e-7, 9.\n7e-7\n";
  const auto output = [&](const std::string& points) {
    return scene(head + points + abaqus_step("*OUTPUT, FIELD, TIME POINTS=TP\n*NODE OUTPUT\nU\n")).output;
  };
  EXPECT_THAT(output(listed).field_times, ElementsAre(0, 2e-7, 5e-7, 7e-7)) << "9 is behind the step";
  EXPECT_EQ(output(listed).field_interval, 0);
  EXPECT_THAT(output("*TIME POINTS, NAME=tp, GENERATE\n0., 1e-6, 5e-7\n").field_times,
              ElementsAre(0, DoubleEq(5e-7), DoubleEq(1e-6)));
  const std::string twice = head + listed + abaqus_step() + abaqus_step("*OUTPUT, FIELD, TIME POINTS=tp\n");
  EXPECT_THAT(scene(twice).output.field_times.at(1), DoubleEq(1.2e-6)) << "of the second step";
  EXPECT_THAT(error(head + abaqus_step("*OUTPUT, FIELD, TIME POINTS=tp\n")), HasSubstr("there is no *TIME POINTS tp"));
  EXPECT_THAT(
      error(head + "*TIME POINTS, NAME=tp, GENERATE\n0., 1., 1e-9\n" + abaqus_step("*OUTPUT, FIELD, TIME POINTS=tp\n")),
      HasSubstr("interval: expected more than 0, and at most 100000 times"));
  EXPECT_THAT(translate(head + listed + abaqus_step("*OUTPUT, HISTORY, TIME POINTS=tp\n")).understood,
              Contains(HasSubstr("not used: *OUTPUT, HISTORY, TIME POINTS")));
  EXPECT_THAT(translate(head + listed + abaqus_step("*NODE FILE, TIME POINTS=tp\nU\n")).understood,
              Contains(HasSubstr("not used: *TIME POINTS")))
      << "of CalculiX";
}

TEST_F(AbaqusControls, WritesEnergiesOfBodiesWhereThoseOfASetAreAskedFor) {
  const auto of_bodies = [this](const std::string& request) {
    return scene(abaqus_cube + abaqus_steel + abaqus_step("*OUTPUT, HISTORY\n*ENERGY OUTPUT" + request + "\nALLKE\n"))
        .output.body_energies;
  };
  EXPECT_TRUE(of_bodies(", ELSET=all"));
  EXPECT_FALSE(of_bodies(""));
}

TEST_F(AbaqusControls, ControlOfDistortionIsThatOfCorners) {
  std::string cube = abaqus_cube;
  cube.insert(cube.find(", MATERIAL=Steel"), ", CONTROLS=c");
  const std::string controls = "*SECTION CONTROLS, NAME=C, DISTORTION CONTROL=YES, LENGTH RATIO=0.2\n1., 1., 1.\n";
  EXPECT_THAT(translate(cube + abaqus_steel + controls + abaqus_step()).understood,
              AllOf(Contains(HasSubstr("not used: *SECTION CONTROLS, DISTORTION CONTROL=YES")),
                    Contains(HasSubstr("*SECTION CONTROLS, LENGTHRATIO=0.2"))));
}

TEST_F(AbaqusControls, AmplitudesThatNothingNamesAreReported) {
  const std::string head = abaqus_cube + abaqus_steel,
                    curves = "*AMPLITUDE, NAME=a\n0., 0., 1., 1.\n*AMPLITUDE, NAME=b\n0., 0., 1., 1.\n";
  const auto lines = [&](const std::string& loads) { return translate(head + curves + abaqus_step(loads)).understood; };
  EXPECT_THAT(lines(""), Contains(HasSubstr("not used: *AMPLITUDE that nothing of what is read names (2 times, ")));
  EXPECT_THAT(lines("*CLOAD, AMPLITUDE=A\ntop, 1, 2.\n"),
              Contains(HasSubstr("not used: *AMPLITUDE that nothing of what is read names (")));
  EXPECT_THAT(lines("*CLOAD, AMPLITUDE=A\ntop, 1, 2.\n*CLOAD, AMPLITUDE=b\ntop, 2, 2.\n"),
              Not(Contains(HasSubstr("*AMPLITUDE that nothing"))));
}

TEST_F(AbaqusControls, ALastNumberThatNoStepHitsIsReported) {
  const auto lines = [&](const std::string& set) {
    return translate(abaqus_cube + set + abaqus_steel + abaqus_step()).understood;
  };
  EXPECT_THAT(
      lines("*NSET, NSET=n, GENERATE\n1, 8, 3\n"),
      Contains(AllOf(HasSubstr("*NSET, GENERATE ("), HasSubstr("from 1 in steps of 3 it ends at 7, 8 is not hit"))));
  EXPECT_THAT(lines("*ELSET, ELSET=e, GENERATE\n10, 15, 2\n"),
              Contains(AllOf(HasSubstr("*ELSET, GENERATE ("), HasSubstr("15 is not hit"))));
  for (const char* range : {"1, 7, 3", "1, 8", "1, 8, 1", "5, 5, 3"})
    EXPECT_THAT(lines(fmt::format("*NSET, NSET=n, GENERATE\n{}\n", range)), Not(Contains(HasSubstr("is not hit"))))
        << range;
  const auto times = [&](const char* range) {
    return translate(abaqus_cube + abaqus_steel + fmt::format("*TIME POINTS, NAME=tp, GENERATE\n{}\n", range) +
                     abaqus_step("*OUTPUT, FIELD, TIME POINTS=tp\n"))
        .understood;
  };
  EXPECT_THAT(times("0., 1e-6, 3e-7"), Contains(HasSubstr("not used: *TIME POINTS, GENERATE: the last time")));
  EXPECT_THAT(times("0., 1e-6, 1e-7"), Not(Contains(HasSubstr("TIME POINTS"))));
}

}  // namespace
}  // namespace pinball::test::abaqus_controls_test
