#include <gmock/gmock.h>

#include "radioss_card_decks.hpp"

/// /MAT/LAW21 and /MAT/LAW10: as the sources of OpenRadioss (m21law.F, m10law.F, compaction.F90) have them, or refused.
namespace pinball::test::radioss_soil_test {
namespace {

using ::testing::Contains;
using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

using Numbers = std::initializer_list<double>;

class RadiossSoil : public RadiossTest {
 protected:
  static std::string deck(const std::string& name, Numbers strength, const std::string& rest) {
    return radioss_begin + "/MAT/" + name + "/1\nsoil\n" + twenty({1.8e-9}) + twenty({260, 0.3}) + twenty(strength) +
           rest + radioss_property + radioss_cube;
  }
  /// unloading: B and Mu_max.
  static std::string law21(Numbers strength, Numbers modulus_and_scale, double least, Numbers unloading,
                           const std::string& points) {
    return deck("LAW21", strength,
                "         6          " + twenty(modulus_and_scale) + twenty({least}) + twenty(unloading) +
                    "/FUNCT/6\np\n" + points);
  }
  static std::string points() { return twenty({0, 0}) + twenty({0.1, 5}) + twenty({0.3, 45}); }
  Material material(const std::string& text) { return scene(text).materials.at(0); }
  std::vector<std::string> told(const std::string& text) { return translate(text).understood; }
};

TEST_F(RadiossSoil, UnloadsWithAModulusThatGrowsUpToTheLargestCompaction) {
  const Material m = material(law21({100, 30, 0.3, 9000}, {400, 2}, -1.5, {900, 0.2}, points()));
  EXPECT_EQ(*m.drucker_prager, (DruckerPragerSettings{100, 30, 0.3, 9000}));
  EXPECT_DOUBLE_EQ(m.shear_modulus, 100);
  const EquationOfStateSettings& eos = *m.equation_of_state;
  EXPECT_EQ(eos.form, EquationOfStateForm::tabulated);
  EXPECT_EQ(eos.volume_measure, VolumeMeasure::density);
  EXPECT_THAT(eos.volume_strain, ElementsAre(0, -0.1, -0.2, -0.3));
  EXPECT_THAT(eos.pressure, ElementsAre(0, 10, DoubleEq(50), 90));
  EXPECT_THAT(eos.unloading_modulus, ElementsAre(400, 650, 900, 900));
  EXPECT_EQ(eos.full_compaction, 0.2);
  EXPECT_EQ(eos.tension_limit, 1.5);
  EXPECT_EQ(m.bulk_modulus, 400);
}

/// Its share of B is mu/Mu_max, and Mu_max 1E20.
TEST_F(RadiossSoil, UnloadsWithKtWithoutALargestCompaction) {
  const std::string text = law21({100, 30, 0.3}, {400, 0}, 0, {900, 0}, points());
  const EquationOfStateSettings eos = *material(text).equation_of_state;
  EXPECT_THAT(eos.unloading_modulus, ElementsAre(400));
  EXPECT_THAT(eos.pressure, ElementsAre(0, 5, 45));
  EXPECT_EQ(eos.full_compaction, INFINITY);
  EXPECT_EQ(eos.tension_limit, 0);
  EXPECT_TRUE(eos.bears_tension);
  EXPECT_THAT(told(text), Contains(HasSubstr("without Mu_max it unloads with Kt")));
  EXPECT_THAT(told(law21({100, 30, 0.3}, {400, 0}, 0, {0, 0}, points())), Not(Contains(HasSubstr("Mu_max"))));
}

TEST_F(RadiossSoil, HasItsFunctionInCompressionAndKtInTension) {
  const auto with = [](const std::string& more) { return law21({100, 30, 0.3}, {400, 1}, 0, {0, 0}, more); };
  const std::string rest = twenty({0.1, 5}) + twenty({0.3, 45});
  EXPECT_THAT(material(with(twenty({-0.2, -10}) + rest)).equation_of_state->volume_strain, ElementsAre(0, -0.1, -0.3));
  EXPECT_THAT(error(with(twenty({-0.2, -90}) + rest)), HasSubstr("/FUNCT 6: expected no pressure below Kt mu = -80"));
  EXPECT_THAT(error(with(twenty({-0.1, -10}) + rest)), HasSubstr("expected 0 at a volume_strain of 0"));
  EXPECT_THAT(error(with(twenty({0, 0}))), HasSubstr("/FUNCT 6: expected two points or more"));
}

TEST_F(RadiossSoil, RefusesAStrengthThatGrowsWithTension) {
  EXPECT_THAT(error(law21({100, 3, 0.3}, {400, 1}, 0, {0, 0}, points())), HasSubstr("give P_min >= -5, or A0 <="));
  EXPECT_EQ(error(law21({100, 3, 0.3}, {400, 1}, -5, {0, 0}, points())), no_error);
  EXPECT_THAT(error(law21({100, 3, 0.3}, {400, 1}, -5.1, {0, 0}, points())), HasSubstr("give P_min >= -5"));
  EXPECT_THAT(error(law21({100, 30, -0.3}, {400, 1}, 0, {0, 0}, points())), HasSubstr("A2"));
}

TEST_F(RadiossSoil, MayHaveAPolynomialThatCrushes) {
  const auto law10 = [](Numbers c, double least, Numbers unloading, Numbers strength = {100, 30, 0.3}) {
    return deck("LAW10", strength, twenty(c) + twenty({least}) + twenty(unloading));
  };
  const Material m = material(law10({0, 500, 300, 100}, -2, {900, 0.4}));
  const EquationOfStateSettings& eos = *m.equation_of_state;
  EXPECT_THAT(eos.coefficients, ElementsAre(0, 500, 300, 100, 0, 0, 0));
  EXPECT_THAT(eos.unloading_modulus, ElementsAre(900));
  EXPECT_EQ(eos.full_compaction, 0.4);
  EXPECT_EQ(eos.tension_limit, 2);
  EXPECT_EQ(*m.drucker_prager, (DruckerPragerSettings{100, 30, 0.3, INFINITY, 2})) << "none at the cutoff";
  EXPECT_EQ(eos.elastic_compaction, 0) << "tension that it begins with has the modulus C1";
  // One of B and Mu_max is that of the slope at the other.
  EXPECT_NEAR(material(law10({0, 500, 400}, 0, {900, 0})).equation_of_state->full_compaction, 0.5, 1e-15);
  EXPECT_THAT(material(law10({0, 500, 400}, 0, {0, 0.5})).equation_of_state->unloading_modulus, ElementsAre(900));
  const double most = material(law10({0, 500, 300, 100}, 0, {900, 0})).equation_of_state->full_compaction;
  EXPECT_NEAR(500 + 600 * most + 300 * most * most, 900, 1e-9);
  EXPECT_TRUE(material(law10({0, 500, 400}, 0, {0, 0})).equation_of_state->unloading_modulus.empty());
  EXPECT_THAT(material(law10({0, 0, 400}, 0, {0, 0})).equation_of_state->coefficients.at(1), DoubleEq(260 / 1.2));
  EXPECT_THAT(error(law10({0, 500, 300, 100}, 0, {0, 0.4})), HasSubstr("B: expected more than 0 beside Mu_max and C3"));
  EXPECT_THAT(error(law10({0, 500, -300}, 0, {900, 0})), HasSubstr("Mu_max: expected more than 0"));
  // Without a root the strength ends where it is least.
  const auto limit = [&](double least) {
    return material(law10({0, 500}, least, {0, 0}, {100, 3, 0.3})).drucker_prager->tension_limit;
  };
  EXPECT_EQ(limit(0), 5);
  EXPECT_EQ(limit(-2), 2);
  EXPECT_EQ(limit(-7), 5);
}

TEST_F(RadiossSoil, MayHaveAPressureOfItsOwn) {
  const auto law10 = [](const std::string& more) { return deck("DPRAG1", {100, 30, 0.3}, twenty({-2}) + more); };
  const EquationOfStateSettings linear = *material(law10("")).equation_of_state;
  EXPECT_THAT(linear.coefficients, ElementsAre(0, DoubleEq(260 / 1.2), 0, 0, 0, 0, 0));
  EXPECT_EQ(linear.tension_limit, 2);
  const Material given = material(law10("/EOS/POLYNOMIAL/1\ne\n" + twenty({0, 700, 3})));
  EXPECT_THAT(given.equation_of_state->coefficients, ElementsAre(0, 700, 3, 0, 0, 0, 0));
  EXPECT_EQ(given.equation_of_state->tension_limit, 2);
  EXPECT_EQ(given.drucker_prager->tension_limit, 2);
  EXPECT_THAT(
      error(deck("LAW10", {100},
                 twenty({0, 500}) + twenty({0}) + twenty({900, 0.4}) + "/EOS/POLYNOMIAL/1\ne\n" + twenty({0, 700, 3}))),
      HasSubstr("/EOS/POLYNOMIAL/1 of a /MAT/DPRAG1 that has C1 and B"));
}

}  // namespace
}  // namespace pinball::test::radioss_soil_test
