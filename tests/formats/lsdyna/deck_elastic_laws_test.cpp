#include <gmock/gmock.h>

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

}  // namespace
}  // namespace pinball::test::deck_elastic_laws_test
