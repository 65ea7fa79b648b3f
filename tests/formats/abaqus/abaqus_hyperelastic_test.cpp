#include <gmock/gmock.h>

#include "abaqus_case.hpp"

/// *HYPERELASTIC: its constants, and the ratio of Poisson that D1 stands for.
namespace pinball::test::abaqus_hyperelastic_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

class AbaqusHyperelastic : public AbaqusTest {
 protected:
  static std::string deck(const std::string& rubber, const std::string& more = "") {
    return abaqus_cube + "*MATERIAL, NAME=Steel\n*DENSITY\n1.E-9\n*HYPERELASTIC" + rubber + more + abaqus_step();
  }
  Material material(const std::string& rubber) { return scene(deck(rubber)).materials.at(0); }
};

/// G = 1 and K = 10, that is E = 90/31 and nu = 14/31.
TEST_F(AbaqusHyperelastic, NeoHookeIsElastic) {
  const Material m = material(", NEO HOOKE\n0.5, 0.2\n");
  EXPECT_NEAR(m.shear_modulus, 1, 1e-14);
  EXPECT_NEAR(m.bulk_modulus, 10, 1e-12);
  EXPECT_FALSE(m.mooney_rivlin);
  EXPECT_THAT(translate(deck(", NEO HOOKE\n0.5, 0.2\n")).understood,
              Contains(AllOf(HasSubstr("*HYPERELASTIC ("), HasSubstr("neo-Hookean, Poisson's ratio 0.451613"))));
}

TEST_F(AbaqusHyperelastic, MooneyAndRivlinHasTwoConstants) {
  const Material m = material(", MOONEY-RIVLIN\n0.4, 0.1, 0.2\n");
  EXPECT_EQ(m.mooney_rivlin->a, 0.4);
  EXPECT_EQ(m.mooney_rivlin->b, 0.1);
  EXPECT_NEAR(m.mooney_rivlin->poisson_ratio, 14. / 31, 1e-14);
  EXPECT_FALSE(material(", MOONEY-RIVLIN\n0.5, 0., 0.2\n").mooney_rivlin) << "which is neo-Hookean";
}

TEST_F(AbaqusHyperelastic, WithoutD1ItIsThatOfTheManual) {
  for (const char* d1 : {"", ", 0."}) {
    const Material m = material(std::string(", NEO HOOKE\n0.5") + d1 + "\n");
    EXPECT_NEAR(m.bulk_modulus / m.shear_modulus, 20, 1e-12);
  }
}

TEST_F(AbaqusHyperelastic, WhatIsNotDoneIsRefused) {
  EXPECT_THAT(error(deck(", OGDEN, N=1\n0.5, 2., 0.2\n")), HasSubstr("*HYPERELASTIC, OGDEN"));
  EXPECT_THAT(error(deck("\n0.5, 0.1, 0.2\n")), HasSubstr("*HYPERELASTIC without NEO HOOKE and MOONEY-RIVLIN"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n-0.5\n")), HasSubstr("C10: expected constants with a sum above 0"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5, -1.\n")), HasSubstr("D1: expected 0 or more, got -1"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5, 0.2, 20.\n0.6, 0.2, 50.\n")), HasSubstr("depends on temperature"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5\n", "*PLASTIC\n5.\n")), HasSubstr("*PLASTIC beside *HYPERELASTIC"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5\n", "*ELASTIC\n5., 0.3\n")), HasSubstr("*ELASTIC beside *HYPERELASTIC"));
}

}  // namespace
}  // namespace pinball::test::abaqus_hyperelastic_test
