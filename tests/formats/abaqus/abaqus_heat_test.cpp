#include <gmock/gmock.h>

#include <cmath>

#include "abaqus_case.hpp"

/// What heat does to materials of Abaqus input. How these then behave: abaqus_decks_test.cpp.
namespace pinball::test::abaqus_heat_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string adiabatic = "*STEP\n*DYNAMIC, EXPLICIT, ADIABATIC\n, 1.0E-6\n*END STEP\n";

class AbaqusHeat : public AbaqusTest {
 protected:
  /// Of Johnson and Cook: it softens from 20 to 1520 degrees.
  static std::string softening(const std::string& more) {
    return abaqus_cube + abaqus_steel + "*PLASTIC, HARDENING=JOHNSON COOK\n240., 1220., .66, 2., 1520., 20.\n" + more;
  }
  static std::string start(const std::string& lines) {
    return "*NSET, NSET=all\n1, 2, 3, 4, 5, 6, 7, 8\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\n" + lines;
  }
};

TEST_F(AbaqusHeat, SoftensWherePlasticWorkStays) {
  const std::string heat = "*SPECIFIC HEAT\n4.6E8,\n";
  const Scene s = scene(softening(heat + "*INELASTIC HEAT FRACTION\n0.8,\n") + start("all, 20.\n") + adiabatic);
  const JohnsonCookSettings& law = s.materials.at(0).johnson_cook.value();
  EXPECT_EQ(law.softening_exponent, 2);
  EXPECT_EQ(law.melting_temperature, 1520);
  EXPECT_EQ(law.room_temperature, 20);
  EXPECT_EQ(law.specific_heat, 4.6e8);
  EXPECT_EQ(law.heat_share, 0.8);
  EXPECT_EQ(scene(softening(heat) + start("all, 20.\n") + adiabatic).materials.at(0).johnson_cook->heat_share, 0.9);
  EXPECT_THAT(error(softening("") + start("all, 20.\n") + adiabatic), HasSubstr("*MATERIAL: expected *SPECIFIC HEAT"));
  EXPECT_THAT(error(softening("*SPECIFIC HEAT\n0.,\n") + start("all, 20.\n") + adiabatic),
              HasSubstr("*SPECIFIC HEAT: expected more than 0, got 0"));
  EXPECT_THAT(error(softening(heat + "*INELASTIC HEAT FRACTION\n1.1,\n") + start("all, 20.\n") + adiabatic),
              HasSubstr("*INELASTIC HEAT FRACTION: expected 0 to 1, got 1.1"));
}

TEST_F(AbaqusHeat, IsOfAllStepsOrOfNone) {
  const std::string heat = "*SPECIFIC HEAT\n4.6E8,\n", model = softening(heat) + start("all, 20.\n");
  EXPECT_EQ(error(model + adiabatic + adiabatic), no_error);
  const std::string differ = "*DYNAMIC: ADIABATIC in some of the steps alone (deck.inp:";
  EXPECT_THAT(error(model + adiabatic + abaqus_step()), HasSubstr(differ));
  EXPECT_THAT(error(model + abaqus_step() + adiabatic), HasSubstr(differ));
  EXPECT_EQ(error(abaqus_cube + abaqus_steel + abaqus_step() + adiabatic), no_error) << "nothing becomes warm";
}

TEST_F(AbaqusHeat, BeginsWhereSofteningDoes) {
  const std::string heat = "*SPECIFIC HEAT\n4.6E8,\n";
  EXPECT_THAT(error(softening(heat) + start("all, 30.\n") + adiabatic),
              HasSubstr("with a transition temperature of 20 in an ADIABATIC step that begins at 30"));
  EXPECT_THAT(error(softening(heat) + adiabatic), HasSubstr("in an ADIABATIC step that begins at 0"))
      << "what nothing is said of";
  EXPECT_THAT(error(softening(heat) + start("base, 20.\n") + adiabatic),
              HasSubstr("*INITIAL CONDITIONS, TYPE=TEMPERATURE that differ within a material"));
  EXPECT_EQ(error(softening(heat) + start("all, 99.\nbase, 20.\ntop, 20.\n") + adiabatic), no_error)
      << "the last line counts";
  EXPECT_THAT(error(softening(heat) + start("none, 20.\n") + adiabatic), HasSubstr("none"));
}

/// Mass that is scaled takes up no more heat.
TEST_F(AbaqusHeat, ScaledMassIsAsWarm) {
  const std::string scaled =
      "*STEP\n*DYNAMIC, EXPLICIT, ADIABATIC\n, 1.0E-6\n*FIXED MASS SCALING, FACTOR=4.\n*END STEP\n";
  const Material m = scene(softening("*SPECIFIC HEAT\n4.6E8,\n") + start("all, 20.\n") + scaled).materials.at(0);
  EXPECT_THAT(m.density * m.johnson_cook->specific_heat, DoubleEq(7.85e-9 * 4.6e8));
}

TEST_F(AbaqusHeat, StaysAsWarmAsItIsWithoutAdiabatic) {
  const auto material = [&](const std::string& lines) {
    return scene(softening("") + start(lines) + abaqus_step()).materials.at(0);
  };
  EXPECT_EQ(material("all, 20.\n").yield_stress, 240);
  EXPECT_EQ(material("all, -100.\n").yield_stress, 240);
  const Material half = material("all, 770.\n");
  EXPECT_THAT(half.yield_stress, DoubleEq(240 * 0.75));
  EXPECT_THAT(half.johnson_cook->hardening_coefficient, DoubleEq(1220 * 0.75));
  EXPECT_EQ(half.johnson_cook->melting_temperature, 0);
  EXPECT_THAT(translate(softening("") + start("all, 770.\n") + abaqus_step()).understood,
              Contains(HasSubstr("A and B times 0.75, for it is at 770 from the start on")));
  EXPECT_THAT(error(softening("") + start("all, 1600.\n") + abaqus_step()), HasSubstr("it has melted at 1600"));
}

TEST_F(AbaqusHeat, ExpandsByAnEquationOfState) {
  const std::string expands = abaqus_cube + abaqus_steel + "*EXPANSION\n1.2E-5\n*SPECIFIC HEAT\n4.6E8\n",
                    plastic = "*PLASTIC\n300., 0.\n";
  const Material m = scene(expands + plastic + adiabatic).materials.at(0);
  ASSERT_TRUE(m.equation_of_state);
  const double bulk = 210000 / 1.2, gamma = 3 * bulk * 1.2e-5 * 0.9 / (7.85e-9 * 4.6e8);
  EXPECT_THAT(m.equation_of_state->coefficients,
              ElementsAre(0, DoubleEq(bulk), DoubleEq(-bulk / 2), DoubleEq(bulk / 3), DoubleEq(gamma), 0, 0));
  EXPECT_THAT(m.shear_modulus, DoubleEq(210000 / 2.6));
  EXPECT_THAT(translate(expands + plastic + adiabatic).understood,
              Contains(HasSubstr("/deck.inp:23): a pressure that grows with the plastic work")));
  EXPECT_FALSE(scene(expands + plastic + abaqus_step()).materials.at(0).equation_of_state) << "nothing becomes warm";
  EXPECT_FALSE(scene(expands + adiabatic).materials.at(0).equation_of_state) << "no plastic work";
  EXPECT_THAT(error(abaqus_cube +
                    "*MATERIAL, NAME=Steel\n*DENSITY\n1.\n*ELASTIC\n1., 0.5\n*EXPANSION\n1.\n"
                    "*SPECIFIC HEAT\n1.\n" +
                    plastic + adiabatic),
              HasSubstr("*ELASTIC: Poisson's ratio: expected more than -1 and less than 0.5, got 0.5"));
  EXPECT_THAT(error(abaqus_cube + abaqus_steel + "*EXPANSION, TYPE=ORTHO\n1., 2., 3.\n" + abaqus_step()),
              HasSubstr("*EXPANSION, TYPE=ORTHO"));
}

TEST_F(AbaqusHeat, TellsWhatDoesNothing) {
  const auto told = [&](const std::string& text) { return translate(text).understood; };
  const std::string warm = softening("*SPECIFIC HEAT\n4.6E8\n*EXPANSION\n1.2E-5\n*INELASTIC HEAT FRACTION\n0.8\n");
  EXPECT_THAT(told(warm + abaqus_step()),
              AllOf(Contains(HasSubstr("m and its temperatures (")),
                    Contains(AllOf(HasSubstr("not used: *SPECIFIC HEAT ("),
                                   HasSubstr("/deck.inp:25): without ADIABATIC nothing becomes warm"))),
                    Contains(HasSubstr("not used: *EXPANSION (")),
                    Contains(HasSubstr("not used: *INELASTIC HEAT FRACTION ("))));
  const std::string plain = abaqus_cube + abaqus_steel + "*PLASTIC\n300., 0.\n";
  EXPECT_THAT(told(plain + "*SPECIFIC HEAT\n4.6E8\n" + adiabatic),
              Contains(AllOf(HasSubstr("not used: *SPECIFIC HEAT ("),
                             HasSubstr("/deck.inp:25): nothing depends on its temperature"))));
  EXPECT_THAT(told(plain + start("all, 20.\n") + abaqus_step()),
              Contains(AllOf(HasSubstr("not used: *INITIAL CONDITIONS, TYPE=TEMPERATURE ("),
                             HasSubstr("/deck.inp:27): nothing depends on it"))));
  EXPECT_THAT(told(softening("") + start("all, 20.\n") + abaqus_step()), Not(Contains(HasSubstr("TYPE=TEMPERATURE ("))))
      << "it has been looked at";
  const std::string cold = abaqus_cube + abaqus_steel + "*PLASTIC, HARDENING=JOHNSON COOK\n240., 1220., .66, 0.77\n";
  EXPECT_THAT(told(cold + adiabatic),
              Contains(AllOf(HasSubstr("m and its temperatures ("), HasSubstr("its melting temperature is 0"))))
      << "it does not soften";
}

/// Conduction of a step of both is left out where an element gives a neighbour less than a hundredth: k t/(rho c h^2).
TEST_F(AbaqusHeat, FlowsNowhere) {
  const auto deck = [&](const std::string& options, const std::string& type = "C3D8RT") {
    std::string text =
        softening("*SPECIFIC HEAT\n4.E8\n" + options) + start("all, 20.\n") +
        "*STEP\n*DYNAMIC TEMPERATURE-DISPLACEMENT, EXPLICIT\n, 1.0E-3\n*BULK VISCOSITY\n0.06, 1.2\n*END STEP\n";
    text.replace(text.find("C3D8R"), 5, type);
    return text;
  };
  const std::string share = "*INELASTIC HEAT FRACTION\n0.8\n";
  const Scene s = scene(deck(share + "*CONDUCTIVITY\n30.,\n"));
  EXPECT_EQ(s.time.end, 1e-3);
  EXPECT_EQ(s.materials.at(0).johnson_cook->heat_share, 0.8);
  EXPECT_THAT(translate(deck(share + "*CONDUCTIVITY\n30.,\n")).understood,
              Contains(HasSubstr("elements give a neighbour up to 0.955 % of the difference of their temperatures")))
      << "30*1e-3/(7.85e-9*4e8)";
  EXPECT_THAT(error(deck(share + "*CONDUCTIVITY\n32.,\n")),
              HasSubstr("*DYNAMIC TEMPERATURE-DISPLACEMENT with a CONDUCTIVITY that counts"));
  EXPECT_EQ(error(deck(share)), no_error) << "none conducts";
  EXPECT_THAT(error(deck("")), HasSubstr("*DYNAMIC TEMPERATURE-DISPLACEMENT without INELASTIC HEAT FRACTION"));
  for (const char* type : {"C3D8T", "C3D8RT"}) EXPECT_EQ(error(deck(share, type)), no_error) << type;
}

/// What stands once, whatever its temperature, holds at all temperatures; so does a table of one temperature.
TEST_F(AbaqusHeat, OneTemperatureIsAllTemperatures) {
  const std::string one = abaqus_cube +
                          "*MATERIAL, NAME=Steel\n*DENSITY\n7.85E-9, 0.0\n*ELASTIC\n210000., 0.3, 20.\n"
                          "*PLASTIC\n300., 0., 20.\n400., 0.1, 20.\n450., 0.3, 20.";
  const Material m = scene(one + "\n" + abaqus_step()).materials.at(0);
  EXPECT_EQ(m.density, 7.85e-9);
  EXPECT_THAT(m.yield_curves.at(0).stress, ElementsAre(300, 400, 450, 450));
  EXPECT_THAT(error(one + "0\n" + abaqus_step()), no_error) << "20. and 20.0 are the same";
  EXPECT_THAT(error(one + "5\n" + abaqus_step()), HasSubstr("*PLASTIC that depends on temperature or fields"));
  EXPECT_THAT(error(softening("*SPECIFIC HEAT\n4.E8, 20.\n5.E8, 90.\n") + abaqus_step()),
              HasSubstr("*SPECIFIC HEAT that depends on temperature or fields"));
}

}  // namespace
}  // namespace pinball::test::abaqus_heat_test
