#include <gmock/gmock.h>

#include <cmath>

#include "abaqus_case.hpp"

/// *DRUCKER PRAGER: a cone of ideal plasticity.
namespace pinball::test::abaqus_drucker_prager_test {
namespace {

using testing::HasSubstr;

class AbaqusDruckerPrager : public AbaqusTest {
 protected:
  static std::string deck(const std::string& constants, const std::string& hardening,
                          const std::string& elastic = "300., 0.2\n") {
    return "*PART, NAME=Cube\n" + std::string(abaqus_cube) +
           "*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=One, PART=Cube\n*END INSTANCE\n*END ASSEMBLY\n"
           "*MATERIAL, NAME=Steel\n*DENSITY\n1.8E-9\n*ELASTIC\n" +
           elastic + "*DRUCKER PRAGER" + constants + hardening + abaqus_step();
  }
  Material material(const std::string& text) { return scene(text).materials.at(0); }
};

const std::string compression = "*DRUCKER PRAGER HARDENING\n3.\n";

TEST_F(AbaqusDruckerPrager, IsAConeUpToItsApex) {
  const double slope = std::tan(M_PI / 6), d = 3 * (1 - slope / 3);
  const Material m = material(deck("\n30., 1., 0.\n", compression));
  ASSERT_TRUE(m.plastic && m.drucker_prager && m.equation_of_state);
  for (const double p : {0.0, 2.0, -d / slope}) {
    const DruckerPragerSettings& law = *m.drucker_prager;
    EXPECT_NEAR(3 * (law.constant + law.linear * p + law.quadratic * p * p), std::pow(d + p * slope, 2), 1e-12) << p;
  }
  EXPECT_NEAR(m.equation_of_state->tension_limit, d / slope, 1e-12);
  EXPECT_NEAR(m.bulk_modulus, 300 / 1.8, 1e-12);
  EXPECT_NEAR(m.shear_modulus, 125, 1e-12);
}

/// A test along one axis yields at the stress that is given.
TEST_F(AbaqusDruckerPrager, HasItsCohesionFromATest) {
  const double slope = std::tan(M_PI / 6);
  const auto cohesion = [&](const std::string& type) {
    const Material m = material(
        deck(", SHEAR CRITERION=LINEAR\n30.\n", "*DRUCKER PRAGER HARDENING, TYPE=" + type + "\n3., 0.\n3., 0.1\n"));
    return std::sqrt(3 * m.drucker_prager->constant);
  };
  EXPECT_NEAR(cohesion("COMPRESSION") + slope * 1, 3, 1e-12);  // p = 3/3
  EXPECT_NEAR(cohesion("TENSION") - slope * 1, 3, 1e-12);      // p = -3/3
  EXPECT_NEAR(cohesion("SHEAR"), std::sqrt(3.0) * 3, 1e-12);   // p = 0
}

TEST_F(AbaqusDruckerPrager, IsVonMisesWithoutFriction) {
  const Material m = material(deck("\n0.\n", compression));
  EXPECT_EQ(*m.drucker_prager, (DruckerPragerSettings{3, 0, 0}));
  EXPECT_EQ(m.equation_of_state->tension_limit, 0);
  EXPECT_TRUE(m.equation_of_state->bears_tension);
}

TEST_F(AbaqusDruckerPrager, RefusesWhatIsNotDone) {
  EXPECT_THAT(error(deck("\n30., 0.8\n", compression)), HasSubstr("K other than 1"));
  EXPECT_THAT(error(deck("\n30., 1., 30.\n", compression)), HasSubstr("flow does not dilate"));
  EXPECT_THAT(error(deck("\n30., 1., 0., 20.\n25., 1., 0., 400.\n", compression)), HasSubstr("depends on temperature"));
  EXPECT_THAT(error(deck("\n30.\n", "*DRUCKER PRAGER HARDENING\n3., 0., 20.\n3., 0., 400.\n")),
              HasSubstr("depends on temperature"));
  EXPECT_THAT(error(deck("\n75.\n", compression)), HasSubstr("angle of friction: expected 0 to 71.5, got 75"));
  EXPECT_THAT(error(deck("\n30.\n", "")), HasSubstr("expected *DRUCKER PRAGER HARDENING"));
  EXPECT_THAT(error(deck("\n30.\n", "*DRUCKER PRAGER HARDENING\n3., 0.\n4., 0.1\n")), HasSubstr("it does not harden"));
  EXPECT_THAT(error(deck("\n30.\n", compression + "*PLASTIC\n5.\n")), HasSubstr("*PLASTIC beside *DRUCKER PRAGER"));
  EXPECT_THAT(error(deck(", SHEAR CRITERION=HYPERBOLIC\n30.\n", compression)), HasSubstr("SHEAR"));
  EXPECT_THAT(error(deck("\n30.\n", compression, "300., 0.5\n")), HasSubstr("less than 0.5, got 0.5"));
}

}  // namespace
}  // namespace pinball::test::abaqus_drucker_prager_test
