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

/// mu = 0.3 and 0.2, G = 0.5 and K = 10; eight numbers to a line.
TEST_F(AbaqusHyperelastic, OgdenHasPowers) {
  const Material m = material(", OGDEN, N=2\n0.3, 1.5, 0.2, -2., 0.2\n");
  ASSERT_TRUE(m.ogden);
  EXPECT_EQ(m.ogden->moduli, (std::vector<double>{2 * 0.3 / 1.5, -0.2}));
  EXPECT_EQ(m.ogden->exponents, (std::vector<double>{1.5, -2}));
  EXPECT_FALSE(m.ogden->whole);
  EXPECT_NEAR(m.shear_modulus, 0.5, 1e-15);
  EXPECT_NEAR(m.bulk_modulus, 10, 1e-12);
  const Material three = material(", OGDEN, N=3\n0.1, 1., 0.2, 2., 0.3, 3., 0.1, 0.\n0.\n");
  EXPECT_EQ(three.ogden->exponents, (std::vector<double>{1, 2, 3}));
  EXPECT_NEAR(three.bulk_modulus, 20, 1e-11);
  EXPECT_NEAR(material(", OGDEN\n0.5, 1.7\n").bulk_modulus / 0.5, 20, 1e-11) << "as without D1";
}

TEST_F(AbaqusHyperelastic, WithoutD1ItIsThatOfTheManual) {
  for (const char* d1 : {"", ", 0."}) {
    const Material m = material(std::string(", NEO HOOKE\n0.5") + d1 + "\n");
    EXPECT_NEAR(m.bulk_modulus / m.shear_modulus, 20, 1e-12);
  }
}

TEST_F(AbaqusHyperelastic, WhatIsNotDoneIsRefused) {
  EXPECT_THAT(error(deck(", OGDEN, N=2\n0.5, 2., 0.1, 3., 0.2, 0.1\n")), HasSubstr("expected D1 alone"));
  EXPECT_THAT(error(deck(", OGDEN, N=7\n0.5, 2.\n")), HasSubstr("N: expected 1 to 6, got 7"));
  EXPECT_THAT(error(deck(", OGDEN\n0.5, 0.\n")), HasSubstr("mu and alpha: expected numbers that are not 0"));
  EXPECT_THAT(error(deck(", OGDEN\n-0.5, 2.\n")), HasSubstr("mu: expected constants with a sum above 0"));
  EXPECT_THAT(error(deck(", OGDEN\n0.5, 2., 0.1, 20.\n0.6, 2., 0.1, 30.\n")), HasSubstr("depend on temperature"));
  EXPECT_THAT(error(deck("\n0.5, 0.1, 0.2\n")), HasSubstr("*HYPERELASTIC without NEO HOOKE, MOONEY-RIVLIN and OGDEN"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n-0.5\n")), HasSubstr("C10: expected constants with a sum above 0"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5, -1.\n")), HasSubstr("D1: expected 0 or more, got -1"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5, 0.2, 20.\n0.6, 0.2, 50.\n")), HasSubstr("depends on temperature"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5\n", "*PLASTIC\n5.\n")), HasSubstr("*PLASTIC beside *HYPERELASTIC"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5\n", "*ELASTIC\n5., 0.3\n")), HasSubstr("*ELASTIC beside *HYPERELASTIC"));
}

}  // namespace
}  // namespace pinball::test::abaqus_hyperelastic_test
