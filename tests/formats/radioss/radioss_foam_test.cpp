#include <gmock/gmock.h>

#include "radioss_card_decks.hpp"

/// /MAT/LAW33 and /EOS/COMPACTION: as the sources of OpenRadioss (sigeps33.F, compaction.F90) have them, or refused.
namespace pinball::test::radioss_foam_test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Numbers = std::initializer_list<double>;

class RadiossFoam : public RadiossTest {
 protected:
  /// kind: Ka and func_IDf, ten columns each.
  static std::string foam(const std::string& kind, Numbers air, Numbers yield, const std::string& more = "") {
    return radioss_begin + "/MAT/LAW33/1\nfoam\n" + twenty({6e-11}) + "                  20" + kind +
           "                  2.\n" + twenty(air) + twenty(yield) + more + radioss_property + radioss_cube;
  }
  static constexpr const char *by_function = "         0         6", *by_formula = "         0         0",
                              *with_cutoff = "         2         6", *viscous = "         1         6";
  static std::string function() { return "/FUNCT/6\nf\n" + twenty({-0.7, 2}) + twenty({-0.1, 0.3}) + twenty({0, 0.2}); }
  static std::string state(const std::string& lines, const std::string& name = "COMPACTION") {
    return radioss_begin + "/MAT/DPRAG1/1\nsoil\n" + twenty({1.8e-9}) + twenty({260, 0.3}) + twenty({100, 30, 0.3}) +
           twenty({-2}) + "/EOS/" + name + "/1\ne\n" + lines + radioss_property + radioss_cube;
  }
  Material material(const std::string& text) { return scene(text).materials.at(0); }
  std::vector<std::string> told(const std::string& text) { return translate(text).understood; }
};

TEST_F(RadiossFoam, HasItsFunctionOfTheVolume) {
  const Material m = material(foam(by_function, {0}, {0}, function()));
  ASSERT_TRUE(m.crushable_foam);
  EXPECT_THAT(m.crushable_foam->compaction, ElementsAre(0, 0.1, 0.7));
  EXPECT_THAT(m.crushable_foam->yield_stress, ElementsAre(0.4, 0.6, 4));
  EXPECT_EQ(m.crushable_foam->tension_cutoff, INFINITY) << "tension yields as pressure does";
  EXPECT_EQ(m.crushable_foam->damping, 0);
  EXPECT_EQ(m.shear_modulus, 10);
  EXPECT_NEAR(m.bulk_modulus, 20.0 / 3, 1e-12);
  EXPECT_THAT(told(foam(by_function, {0}, {0}, function())), Contains(HasSubstr("less compressed than its function")));
}

TEST_F(RadiossFoam, HasItsFormulaWithoutAFunction) {
  const CrushableFoamSettings law = *material(foam(by_formula, {0}, {0.1, 0.2, -2})).crushable_foam;
  EXPECT_THAT(law.compaction, ElementsAre(-1, DoubleEq(-0.75), 0.999));  // |0.3 + 0.4 x|
  EXPECT_THAT(law.yield_stress, ElementsAre(DoubleEq(0.1), 0, DoubleEq(0.6996)));
  const CrushableFoamSettings ideal = *material(foam(by_formula, {0}, {0.1})).crushable_foam;
  EXPECT_THAT(ideal.yield_stress, ElementsAre(0.1, 0.1));
}

TEST_F(RadiossFoam, HasAirInItsCells) {
  const CrushableFoamSettings law = *material(foam(by_function, {0.1, 0.05}, {0}, function())).crushable_foam;
  EXPECT_EQ(law.air_pressure, 0.1);
  EXPECT_EQ(law.solid_share, 0.05);
  EXPECT_THAT(error(foam(by_function, {0.1, 0.05, -0.1}, {0}, function())), HasSubstr("Gamma_0"));
}

TEST_F(RadiossFoam, HasACutoffWithKaOfTwo) {
  EXPECT_EQ(material(foam(with_cutoff, {0}, {0, 0, 0, 0.3}, function())).crushable_foam->tension_cutoff, 0.3);
  EXPECT_EQ(material(foam(with_cutoff, {0}, {0}, function())).crushable_foam->tension_cutoff, INFINITY);
  EXPECT_THAT(error(foam(with_cutoff, {0}, {0, 0, 0, 0.5}, function())), HasSubstr("give no more than 0.4"));
  EXPECT_THAT(told(foam(by_function, {0}, {0, 0, 0, 0.3}, function())),
              Contains(AllOf(HasSubstr("SIG_COFF"), HasSubstr("Ka is 0"))));
  EXPECT_THAT(error(foam(viscous, {0}, {0}, function())), HasSubstr("with Ka 1"));
}

TEST_F(RadiossFoam, IsNotOfBothAFunctionAndAFormula) {
  EXPECT_THAT(told(foam(by_function, {0}, {0.1}, function())),
              Contains(AllOf(HasSubstr("A, B and C"), HasSubstr("func_IDf is used"))));
}

TEST_F(RadiossFoam, CompactionUnloadsWithAModulusThatGrows) {
  const auto with = [&](const std::string& form, Numbers unloading) {
    std::string first = twenty({0, 500, 0, 100});
    first.pop_back();
    return state(first + "          " + form + "\n" + twenty(unloading) + "\n");
  };
  const EquationOfStateSettings eos = *material(with("         0", {0.02, 0.4, 900})).equation_of_state;
  EXPECT_THAT(eos.coefficients, ElementsAre(0, 500, 0, 100, 0, 0, 0));
  EXPECT_THAT(eos.unloading_modulus, ElementsAre(500, 900));
  EXPECT_EQ(eos.full_compaction, 0.4);
  EXPECT_EQ(eos.elastic_compaction, 0.02);
  EXPECT_EQ(eos.tension_limit, 2);
  EXPECT_THAT(material(with("         1", {0, 0.4, 900})).equation_of_state->unloading_modulus, ElementsAre(900));
  EXPECT_TRUE(material(with("         2", {0, 0, 900})).equation_of_state->unloading_modulus.empty());
  EXPECT_THAT(told(with("         2", {0, 0, 900})), Contains(HasSubstr("without Mue_max it goes back as it came")));
  EXPECT_THAT(error(with("         2", {0, 0.4, 400})), HasSubstr("B: expected a number >= C1 = 500, got 400"));
}

TEST_F(RadiossFoam, CompactionMayHaveAFunction) {
  const auto with = [&](const std::string& form, Numbers moduli) {
    return state("                   6" + std::string(19, ' ') + "2" + std::string(17, ' ') + "0.5" +
                     std::string(30, ' ') + form + "\n" + twenty(moduli) + "\n/FUNCT/6\nf\n" + twenty({-1, -3}) +
                     twenty({0, 0}) + twenty({0.1, 10}) + twenty({0.2, 30}),
                 "COMPACTION2");
  };
  const EquationOfStateSettings eos = *material(with("         2", {0.02, 0.3, 300, 900})).equation_of_state;
  EXPECT_EQ(eos.volume_measure, VolumeMeasure::density);
  EXPECT_THAT(eos.volume_strain, ElementsAre(0, DoubleEq(-0.2), DoubleEq(-0.3), DoubleEq(-0.4)));
  EXPECT_THAT(eos.pressure, ElementsAre(0, 20, DoubleEq(40), 60));
  EXPECT_THAT(eos.unloading_modulus, ElementsAre(300, DoubleEq(700), 900, 900));
  EXPECT_EQ(eos.full_compaction, 0.3);
  EXPECT_EQ(eos.elastic_compaction, 0.02);
  EXPECT_EQ(eos.tension_limit, 2);
  EXPECT_THAT(material(with("         1", {0, 0, 300, 900})).equation_of_state->unloading_modulus, ElementsAre(900));
  EXPECT_THAT(material(with("         2", {0, 0, 300, 900})).equation_of_state->unloading_modulus, ElementsAre(300));
  EXPECT_THAT(told(with("         2", {0, 0, 300, 900})), Contains(HasSubstr("without Mue_max it unloads with Bmin")));
  EXPECT_THAT(error(with("         2", {0.3, 0.3, 300, 900})), HasSubstr("Mue_min: expected less than Mue_max"));
}

TEST_F(RadiossFoam, AStateMayBeALine) {
  EXPECT_THAT(material(state(twenty({0, 700}), "LINEAR")).equation_of_state->coefficients,
              ElementsAre(0, 700, 0, 0, 0, 0, 0));
  EXPECT_THAT(error(state(twenty({5, 700}), "LINEAR")), HasSubstr("bodies press on nothing at the start"));
}

}  // namespace
}  // namespace pinball::test::radioss_foam_test
