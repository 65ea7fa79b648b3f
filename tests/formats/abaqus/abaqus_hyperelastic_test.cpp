#include <gmock/gmock.h>

#include <cmath>

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

/// Without a name it is POLYNOMIAL, of N = 1 that of Mooney and Rivlin: C10, C01, D1.
TEST_F(AbaqusHyperelastic, PolynomialsAreThoseOfOneTerm) {
  EXPECT_EQ(*material("\n0.4, 0.1, 0.2\n").mooney_rivlin, *material(", MOONEY-RIVLIN\n0.4, 0.1, 0.2\n").mooney_rivlin);
  EXPECT_EQ(*material(", POLYNOMIAL, N=1\n0.4, 0.1, 0.2\n").mooney_rivlin,
            *material(", MOONEY-RIVLIN\n0.4, 0.1, 0.2\n").mooney_rivlin);
  const Material neo = material(", REDUCED POLYNOMIAL\n0.5, 0.2\n");
  EXPECT_NEAR(neo.shear_modulus, 1, 1e-14);
  EXPECT_NEAR(neo.bulk_modulus, 10, 1e-12);
  EXPECT_FALSE(neo.mooney_rivlin || neo.ogden);
  EXPECT_FALSE(material(", YEOH\n0.5, 0., 0., 0.2\n").ogden) << "which is neo-Hookean";
}

/// Their energy of shape is that of powers of its stretches.
TEST_F(AbaqusHyperelastic, SquaresOfInvariantsArePowers) {
  const auto energy = [](const Material& m, double l, double k) {
    double sum = 0;
    for (std::size_t p = 0; p < m.ogden->moduli.size(); ++p) {
      const double a = m.ogden->exponents[p];
      sum += m.ogden->moduli[p] / a * (std::pow(l, a) + std::pow(k, a) + std::pow(l * k, -a) - 3);
    }
    return sum;
  };
  const Material full = material(", POLYNOMIAL, N=2\n0.4, 0.1, 0.02, 0., 0.03, 0.2\n"),
                 yeoh = material(", YEOH\n0.5, -0.02, 0., 0.2\n"),
                 reduced = material(", REDUCED POLYNOMIAL, N=2\n0.5, -0.02, 0.2\n");
  for (const double l : {0.6, 1.0, 2.2}) {
    for (const double k : {0.8, 1.0, 1.4}) {
      const double one = l * l + k * k + 1 / (l * l * k * k) - 3, two = 1 / (l * l) + 1 / (k * k) + l * l * k * k - 3;
      EXPECT_NEAR(energy(full, l, k), 0.4 * one + 0.1 * two + 0.02 * one * one + 0.03 * two * two, 1e-13);
      EXPECT_NEAR(energy(yeoh, l, k), 0.5 * one - 0.02 * one * one, 1e-13);
    }
  }
  EXPECT_NEAR(yeoh.shear_modulus, 1, 1e-15);
  EXPECT_NEAR(yeoh.bulk_modulus, 10, 1e-12);
  EXPECT_EQ(*reduced.ogden, *yeoh.ogden);
  EXPECT_THAT(error(deck(", YEOH\n0.5, -0.02, 0.001, 0.2\n")), HasSubstr("no sums of powers of stretches"));
  EXPECT_THAT(error(deck(", POLYNOMIAL, N=2\n0.4, 0.1, 0.02, 0.01, 0.03, 0.2\n")), HasSubstr("no sums of powers"));
  EXPECT_THAT(error(deck(", YEOH\n0.5, -0.02, 0., 0.2, 0.1\n")), HasSubstr("expected D1 alone"));
  EXPECT_THAT(error(deck(", YEOH\n-0.5, 0.02\n")), HasSubstr("C10: expected constants with a sum above 0"));
}

/// G is the sum of mu, and K that of 2 mu (1/3 + nu/(1 - 2 nu)).
TEST_F(AbaqusHyperelastic, FoamHasPowersOfWholeStretches) {
  const auto foam = [](const std::string& text, const std::string& more = "") {
    return abaqus_cube + "*MATERIAL, NAME=Steel\n*DENSITY\n1.E-9\n*HYPERFOAM" + text + more + abaqus_step();
  };
  const Material two = scene(foam(", N=2\n0.18, 8.9, 0.0065, -0.0013, 0.1, 0.1\n")).materials.at(0);
  EXPECT_EQ(two.ogden->moduli, (std::vector<double>{2 * 0.18 / 8.9, 2 * 0.0065 / -0.0013}));
  EXPECT_EQ(two.ogden->exponents, (std::vector<double>{8.9, -0.0013}));
  EXPECT_TRUE(two.ogden->whole);
  EXPECT_EQ(two.ogden->poisson_ratio, 0.1);
  EXPECT_NEAR(two.shear_modulus, 0.1865, 1e-15);
  EXPECT_NEAR(two.bulk_modulus, 2 * 0.1865 * (1. / 3 + 0.1 / 0.8), 1e-15);
  EXPECT_EQ(*scene(foam(", N=2, POISSON=0.1\n0.18, 8.9, 0.0065, -0.0013\n")).materials.at(0).ogden, *two.ogden);
  EXPECT_EQ(scene(foam("\n0.2, 4.\n")).materials.at(0).ogden->poisson_ratio, 0);
  EXPECT_THAT(error(foam(", N=2\n0.18, 8.9, 0.0065, -0.0013, 0.1, 0.2\n")),
              HasSubstr("nu: expected one Poisson's ratio of all terms, got 0.1 and 0.2"));
  EXPECT_THAT(error(foam("\n0.2, 4., 0.5\n")), HasSubstr("nu: expected a number >= 0 and < 0.5"));
  EXPECT_THAT(error(foam("\n-0.2, 4.\n")), HasSubstr("mu: expected constants with a sum above 0"));
  EXPECT_THAT(error(foam("\n0.2, 0.\n")), HasSubstr("*HYPERFOAM: mu and alpha"));
  EXPECT_THAT(error(foam(", TEST DATA INPUT\n")), HasSubstr("*HYPERFOAM of test data"));
  EXPECT_THAT(error(foam("\n0.2, 4.\n", "*ELASTIC\n5., 0.3\n")), HasSubstr("*ELASTIC beside *HYPERFOAM"));
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
  EXPECT_THAT(error(deck(", ARRUDA-BOYCE\n0.5, 3., 0.2\n")), HasSubstr("*HYPERELASTIC, ARRUDA-BOYCE"));
  EXPECT_THAT(error(deck(", YEOH, TEST DATA INPUT\n", "*UNIAXIAL TEST DATA\n0.1, 0.1\n")),
              AllOf(HasSubstr("*HYPERELASTIC of test data"), HasSubstr("*UNIAXIAL TEST DATA")));
  EXPECT_THAT(error(deck(", NEO HOOKE\n-0.5\n")), HasSubstr("C10: expected constants with a sum above 0"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5, -1.\n")), HasSubstr("D1: expected 0 or more, got -1"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5, 0.2, 20.\n0.6, 0.2, 50.\n")), HasSubstr("depends on temperature"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5\n", "*PLASTIC\n5.\n")), HasSubstr("*PLASTIC beside *HYPERELASTIC"));
  EXPECT_THAT(error(deck(", NEO HOOKE\n0.5\n", "*ELASTIC\n5., 0.3\n")), HasSubstr("*ELASTIC beside *HYPERELASTIC"));
}

}  // namespace
}  // namespace pinball::test::abaqus_hyperelastic_test
