#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "deck_case.hpp"

/// Materials of decks that never yield.
namespace pinball::test::deck_elastic_laws_test {
namespace {

using testing::HasSubstr;

class DeckElasticLaws : public DeckTest {};

TEST_F(DeckElasticLaws, OrthotropicElasticityHasItsConstantsAndAxes) {
  const auto wood = [](const std::string& ratios, const std::string& option, const std::string& axis) {
    return cube + ends + "*MAT_002\n1,1.E-9,9000.,5000.,2000.," + ratios + "\n700.,300.,500.," + option +
           "\n,,,1.,1.,0.\n,,," + axis + "\n";
  };
  const Material m = scene(wood("0.1,0.05,0.12", "2.", "0.,1.,0.")).materials.at(0);
  EXPECT_FALSE(m.plastic);
  ASSERT_TRUE(m.orthotropic.has_value());
  EXPECT_EQ(m.orthotropic->young_moduli, (Point{9000, 5000, 2000}));
  EXPECT_DOUBLE_EQ(m.orthotropic->poisson_ratios[0], 0.1 * 9000 / 5000);
  EXPECT_DOUBLE_EQ(m.orthotropic->poisson_ratios[1], 0.05 * 9000 / 2000);
  EXPECT_DOUBLE_EQ(m.orthotropic->poisson_ratios[2], 0.12 * 5000 / 2000);
  EXPECT_EQ(m.orthotropic->shear_moduli, (Point{700, 500, 300})) << "ab, ac, bc";
  EXPECT_EQ(m.orthotropic->first_axis, (Point{1, 1, 0}));
  EXPECT_EQ(m.orthotropic->second_axis, (Point{0, 1, 0}));
  EXPECT_THAT(error(wood("0.1,0.05,0.12", "", "0.,1.,0.")), HasSubstr("AOPT: expected 2"));
  EXPECT_THAT(error(wood("0.1,0.05,0.12", "2.", "2.,2.,0.")), HasSubstr("second_axis"));
  EXPECT_THAT(error(wood("0.9,0.05,0.12", "2.", "0.,1.,0.")), HasSubstr("poisson_ratios"));
}

TEST_F(DeckElasticLaws, MooneyAndRivlinHaveTheirConstants) {
  const auto rubber = [](const std::string& rest, const std::string& test = "") {
    return cube + ends + "*MAT_027\n1,1.1E-9," + rest + "\n" + test + "\n";
  };
  const Material m = scene(rubber("0.495,0.3,0.1")).materials.at(0);
  EXPECT_FALSE(m.plastic);
  EXPECT_EQ(*m.mooney_rivlin, (MooneyRivlinSettings{0.3, 0.1, 0.495}));
  EXPECT_DOUBLE_EQ(m.shear_modulus, 0.8);
  EXPECT_THAT(error(rubber("0.495,0.3,0.1,1.")), HasSubstr("leave it 0: the mesh has no stress"));
  EXPECT_THAT(error(rubber("0.495,0.,0.", "1.,1.,1.,5")), HasSubstr("they are not fitted to a test"));
  EXPECT_THAT(error(rubber("0.5,0.3,0.1")), HasSubstr("poisson_ratio"));
}

TEST_F(DeckElasticLaws, OgdensRubberHasPowers) {
  const auto rubber = [](const std::string& moduli, const std::string& exponents, const std::string& more = "") {
    return cube + ends + "*MAT_077_O\n1,1.1E-9,0.495\n" + moduli + "\n" + exponents + "\n" + more;
  };
  const Material m = scene(rubber("0.63,0.0012,-0.01", "1.3,5.,-2.")).materials.at(0);
  EXPECT_FALSE(m.plastic);
  EXPECT_EQ(*m.ogden, (OgdenSettings{{0.63, 0.0012, -0.01}, {1.3, 5, -2}, 0.495, false}));
  EXPECT_DOUBLE_EQ(m.shear_modulus, 0.4225);
  EXPECT_THAT(error(rubber("0.63,0.1", "1.3")), HasSubstr("expected a modulus with an exponent"));
  EXPECT_THAT(error(rubber("0.63", "1.3", "0.2,100.\n")), HasSubstr("with viscosity"));
  EXPECT_THAT(error(rubber("0.63", "-1.3")), HasSubstr("ogden.moduli"));
}

/// Its stress, G (b/J - J^(-1/(1 - 2 nu)) I) with nu = 0.463, is that of its moduli: G at rest.
TEST_F(DeckElasticLaws, BlatzAndKoHaveOnePower) {
  const auto rubber = [](const std::string& rest) { return cube + ends + "*MAT_007\n1,1.1E-9," + rest + "\n"; };
  const Material m = scene(rubber("0.5")).materials.at(0);
  EXPECT_FALSE(m.plastic);
  EXPECT_EQ(*m.ogden, (OgdenSettings{{0.5}, {2}, 0.463, true}));
  EXPECT_DOUBLE_EQ(m.shear_modulus, 0.5);
  EXPECT_EQ(*scene(cube + ends + "*MAT_BLATZ-KO_RUBBER\n1,1.1E-9,0.5\n").materials.at(0).ogden, *m.ogden);
  EXPECT_THAT(error(rubber("0.")), HasSubstr("ogden.moduli"));
  EXPECT_THAT(error(rubber("-1.")), HasSubstr("G"));
  EXPECT_THAT(error(rubber("0.5,1.")), HasSubstr("leave it 0: the mesh has no stress"));
}

/// The energy of its powers is that of its polynomial, at stretches of any shape.
TEST_F(DeckElasticLaws, PolynomialsOfInvariantsArePowersWhereTheyCanBe) {
  const auto rubber = [](const std::string& constants, const std::string& more = "", const std::string& first = "") {
    return cube + ends + "*MAT_077_H\n1,1.1E-9,0.495" + first + "\n" + constants + "\n" + more;
  };
  const double c10 = 0.4, c01 = 0.1, c20 = 0.02, c02 = 0.03;
  const Material m = scene(rubber("0.4,0.1,,0.02,0.03")).materials.at(0);
  ASSERT_TRUE(m.ogden);
  EXPECT_EQ(m.ogden->poisson_ratio, 0.495);
  EXPECT_FALSE(m.ogden->whole);
  EXPECT_NEAR(m.shear_modulus, 2 * (c10 + c01), 1e-15);
  for (const double l : {0.5, 0.9, 1.0, 1.3, 2.5}) {
    for (const double k : {0.7, 1.0, 1.9}) {
      const std::array<double, 3> x{l * l, k * k, 1 / (l * l * k * k)};
      const double one = x[0] + x[1] + x[2] - 3, two = 1 / x[0] + 1 / x[1] + 1 / x[2] - 3;
      double powers = 0;
      for (std::size_t p = 0; p < m.ogden->moduli.size(); ++p) {
        const double a = m.ogden->exponents[p];
        for (const double square : x) powers += m.ogden->moduli[p] / a * (std::pow(square, a / 2) - 1);
      }
      const double exact = c10 * one + c01 * two + c20 * one * one + c02 * two * two;
      EXPECT_NEAR(powers, exact, 1e-12 * (1 + exact)) << l << ' ' << k;
    }
  }
  EXPECT_EQ(*scene(rubber("0.4,0.1")).materials.at(0).ogden, (OgdenSettings{{0.8, -0.2}, {2, -2}, 0.495, false}));
  EXPECT_THAT(error(rubber("0.4,0.1,0.02")), HasSubstr("it is no sum of powers of stretches"));
  EXPECT_THAT(error(rubber("0.4,0.1,,,,0.02")), HasSubstr("it is no sum of powers of stretches"));
  EXPECT_THAT(error(rubber("0.1,-0.2")), HasSubstr("C10: expected C10 + C01 > 0"));
  EXPECT_THAT(error(rubber("0.4", "0.2,100.\n")), HasSubstr("with viscosity"));
  EXPECT_THAT(error(rubber("1.,1.,1.,5", "", ",2")), HasSubstr("they are not fitted"));
}

/// N = nu/(1 - 2 nu).
TEST_F(DeckElasticLaws, HillsFoamHasPowersOfWholeStretches) {
  const auto foam = [](const std::string& first, const std::string& moduli, const std::string& exponents,
                       const std::string& more = "") {
    return cube + ends + "*MAT_177\n1,1.1E-10," + first + "\n" + moduli + "\n" + exponents + "\n" + more;
  };
  const Material m = scene(foam(",0.5", "0.3,-0.1", "4.,-2.")).materials.at(0);
  EXPECT_FALSE(m.plastic);
  EXPECT_EQ(*m.ogden, (OgdenSettings{{0.3, -0.1}, {4, -2}, 0.25, true}));
  EXPECT_DOUBLE_EQ(m.shear_modulus, 0.7);
  EXPECT_EQ(scene(foam("1.", "0.3", "4.")).materials.at(0).ogden->poisson_ratio, 0);
  EXPECT_THAT(error(foam(",0.5,0.1", "0.3", "4.")), HasSubstr("there is no damping"));
  EXPECT_THAT(error(foam(",0.5,,7", "0.3", "4.")), HasSubstr("they are not fitted"));
  EXPECT_THAT(error(foam(",-0.5", "0.3", "4.")), HasSubstr("N"));
  EXPECT_THAT(error(foam(",0.5", "0.3,0.1", "4.")), HasSubstr("C2: expected a modulus with an exponent"));
  EXPECT_THAT(error(foam(",0.5", "0.3", "-4.")), HasSubstr("ogden.moduli"));
  EXPECT_THAT(error(foam(",0.5", "0.3", "4.", "0.5\n")), HasSubstr("it unloads as it is loaded"));
}

}  // namespace
}  // namespace pinball::test::deck_elastic_laws_test
