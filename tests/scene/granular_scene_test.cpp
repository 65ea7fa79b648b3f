#include <gmock/gmock.h>

#include <solver/scene_rules.hpp>
#include <tests/support/scene_fixture.hpp>

/// drucker_prager of a material, and equations of state that crush.
namespace pinball::granular_scene_test {
namespace {

using namespace test;
using testing::HasSubstr;

class GranularScene : public SceneTest {
 protected:
  /// In the place of the yield stress, beside both moduli.
  std::vector<std::string> with_strength(const std::string& keys, const std::string& more = "") {
    return with(10, "drucker_prager = { " + keys + " }\n" + more);
  }
  /// In the place of the bulk modulus, too.
  std::vector<std::string> with_pressure(const std::string& keys) {
    std::vector<std::string> all =
        with_strength("constant = 1e10, linear = 1e5, quadratic = 0.3", "equation_of_state = { " + keys + " }");
    all[7] = "";
    return all;
  }
  std::string problem_of_table(const std::string& more) {
    return error(with_pressure("form = \"tabulated\", " + more));
  }
};

constexpr const char* soil =
    "form = \"tabulated\", volume_strain = [0, -0.05, -0.3], pressure = [0, 1e6, 6e7], unloading_modulus = [2e8, 3e8, "
    "4e8]";

TEST_F(GranularScene, ReadsAStrengthOfThePressure) {
  const Material m = read(with_strength("constant = 1e10, linear = 1e5, quadratic = 0.3")).materials.at(0);
  EXPECT_EQ(*m.drucker_prager, (DruckerPragerSettings{1e10, 1e5, 0.3}));
  EXPECT_FALSE(has_yield_stress(m));
  const Material limited = read(with_strength("linear = 1e5, largest = 1e16, tension_limit = 0")).materials.at(0);
  EXPECT_EQ(*limited.drucker_prager, (DruckerPragerSettings{0, 1e5, 0, 1e16, 0}));
  EXPECT_THAT(error(with_strength("")), HasSubstr("drucker_prager.constant: expected this, linear or quadratic > 0"));
  EXPECT_THAT(error(with_strength("linear = -1")), HasSubstr("drucker_prager.linear: expected a number >= 0, got -1"));
  EXPECT_THAT(error(with_strength("linear = 1, largest = 0")),
              HasSubstr("drucker_prager.largest: expected a number > 0"));
}

TEST_F(GranularScene, RefusesOtherStrengthsBesideIt) {
  for (const char* other : {"yield_stress = 1e9", "plastic_modulus = 1e9", "ultimate_stress = 1e9",
                            "isotropic_share = 0.5", "rate_constant = 40\nrate_exponent = 5",
                            "power_hardening = { coefficient = 1e9, exponent = 0.2 }", "johnson_cook = {}"})
    EXPECT_THAT(error(with_strength("constant = 1", other)), HasSubstr("expected none beside drucker_prager")) << other;
  EXPECT_THAT(error(with_strength("constant = 1", "fluid = {}")), HasSubstr("expected none beside fluid"));
}

TEST_F(GranularScene, ReadsWhatCrushes) {
  const Material m = read(with_pressure(soil)).materials.at(0);
  EXPECT_EQ(m.equation_of_state->unloading_modulus, (std::vector<double>{2e8, 3e8, 4e8}));
  EXPECT_EQ(m.bulk_modulus, 2e8);
  EXPECT_TRUE(m.equation_of_state->bears_tension);
  const Material foam =
      read(with_pressure("form = \"tabulated\", volume_strain = [-0.5, -0.1, 0], pressure = [9e6, 1e6, 0], "
                         "volume_measure = \"density\", bears_tension = false, unloading_modulus = [5e6], "
                         "full_compaction = 0.4"))
          .materials.at(0);
  EXPECT_EQ(foam.equation_of_state->volume_measure, VolumeMeasure::density);
  EXPECT_EQ(foam.equation_of_state->full_compaction, 0.4);
  EXPECT_FALSE(foam.equation_of_state->bears_tension);
  EXPECT_EQ(foam.bulk_modulus, 1e7) << "the curve is the stiffer one";
  const Material polynomial = read(with_pressure("form = \"polynomial\", coefficients = [0, 1e9, 2e9, 0, 0, 0, 0], "
                                                 "unloading_modulus = [4e9]"))
                                  .materials.at(0);
  EXPECT_EQ(polynomial.bulk_modulus, 4e9);
}

TEST_F(GranularScene, ReadsWhatTearsAndWhatIsElasticAtFirst) {
  const EquationOfStateSettings eos =
      *read(with_pressure("form = \"polynomial\", coefficients = [0, 1e9, 0, 0, 0, 0, 0], unloading_modulus = [1e9, "
                          "2e9], full_compaction = 0.4, elastic_compaction = 0, tension_limit = 1e5, tears = true"))
           .materials.at(0)
           .equation_of_state;
  EXPECT_EQ(eos.unloading_modulus, (std::vector<double>{1e9, 2e9}));
  EXPECT_EQ(eos.elastic_compaction, 0);
  EXPECT_TRUE(eos.tears);
  EXPECT_LT(read(with_pressure(soil)).materials.at(0).equation_of_state->elastic_compaction, 0);
}

TEST_F(GranularScene, RefusesCurvesThatAreNone) {
  const std::string curve = "volume_strain = [0, -0.05, -0.3], pressure = [0, 1e6, 6e7], ";
  EXPECT_THAT(problem_of_table(curve + "unloading_modulus = [1e8, 2e8]"),
              HasSubstr("equation_of_state.unloading_modulus: expected one number, or as many as volume_strain has, 3, "
                        "got 2"));
  EXPECT_THAT(problem_of_table(curve + "unloading_modulus = [0]"), HasSubstr("expected numbers > 0, got 0"));
  EXPECT_THAT(problem_of_table("volume_strain = [0.1, 0, -0.3], pressure = [-1e6, 0, 6e7], unloading_modulus = [1e8]"),
              HasSubstr("equation_of_state.volume_strain: expected a curve that begins at 0 beside unloading_modulus"));
  EXPECT_THAT(problem_of_table("volume_strain = [-0.1, -0.3], pressure = [1e6, 3e6], unloading_modulus = [1e8]"),
              HasSubstr("expected a curve that begins at 0"));
  EXPECT_THAT(problem_of_table(curve + "full_compaction = 0.2"),
              HasSubstr("equation_of_state.full_compaction: not used without unloading_modulus"));
  EXPECT_THAT(problem_of_table(curve + "tension_limit = 1e5, bears_tension = false"),
              HasSubstr("equation_of_state.tension_limit: expected 0 beside bears_tension = false, got 100000"));
  EXPECT_THAT(error(with_pressure("sound_speed = 2000, unloading_modulus = [1e8]")),
              HasSubstr("unloading_modulus: not used but with form = \"polynomial\" or \"tabulated\""));
  EXPECT_THAT(error(with_pressure("form = \"polynomial\", coefficients = [0, 1e9, 0, 0, 0, 0, 0], "
                                  "unloading_modulus = [1e9, 2e9]")),
              HasSubstr("full_compaction: missing, expected that of the second unloading_modulus"));
  EXPECT_THAT(error(with_pressure("form = \"polynomial\", coefficients = [0, 1e9, 0, 0, 0, 0, 0], "
                                  "unloading_modulus = [1e9, 2e9, 3e9]")),
              HasSubstr("unloading_modulus: expected one number of a polynomial, or two, got 3"));
  EXPECT_THAT(problem_of_table(curve + "unloading_modulus = [1e8], full_compaction = 0.2, elastic_compaction = 0.2"),
              HasSubstr("equation_of_state.elastic_compaction: expected a number < full_compaction = 0.2, got 0.2"));
  EXPECT_THAT(problem_of_table(curve + "tears = true"),
              HasSubstr("equation_of_state.tension_limit: expected a number > 0 beside tears, got 0"));
  std::vector<std::string> eroding = with_pressure(std::string(soil) + ", bears_tension = false");
  eroding[9] += "\nerosion = { tension = 1e5 }";
  EXPECT_THAT(error(eroding), HasSubstr("erosion.tension: expected 0 beside equation_of_state.bears_tension = false"));
}

}  // namespace
}  // namespace pinball::granular_scene_test
