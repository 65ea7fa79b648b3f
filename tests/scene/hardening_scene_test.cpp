#include <solver/scene_rules.hpp>
#include <tests/support/scene_fixture.hpp>

/// Keys of a material on hardening, yield curves and strain rates.
namespace pinball::hardening_scene_test {
namespace {

using namespace test;

class HardeningScene : public SceneTest {
 protected:
  /// The minimal scene with these lines in the place of its yield stress, line 10.
  Material material(const std::string& text) { return read(with(10, text)).materials.at(0); }
  std::string problem(const std::string& text) { return error(with(10, text)); }
};

TEST_F(HardeningScene, DefaultsAreIsotropicWithoutRates) {
  const Material m = material("yield_stress = 4e8");
  EXPECT_EQ(m.isotropic_share, 1);
  EXPECT_EQ(m.rate_constant, 0);
  EXPECT_TRUE(m.yield_curves.empty());
}

TEST_F(HardeningScene, ReadsSharesAndRates) {
  const Material m = material(
      "yield_stress = 4e8\nplastic_modulus = 1e9\nisotropic_share = 0.25\nrate_constant = 40\nrate_exponent = 5\n"
      "strain_rate = \"plastic\"\nrate_stress = 3e8");
  EXPECT_EQ(m.isotropic_share, 0.25);
  EXPECT_EQ(m.rate_constant, 40);
  EXPECT_EQ(m.rate_exponent, 5);
  EXPECT_EQ(m.rate_stress, 3e8);
  EXPECT_EQ(m.strain_rate, StrainRate::plastic);
}

TEST_F(HardeningScene, ReadsCurves) {
  const Material one = material("yield_curve = { plastic_strain = [0, 0.1], stress = [3e8, 4e8] }");
  ASSERT_EQ(one.yield_curves.size(), 1U);
  EXPECT_EQ(one.yield_curves[0].stress, (std::vector<double>{3e8, 4e8}));
  EXPECT_EQ(one.yield_stress, 3e8);  // where it begins
  const Material two = material(
      "rate_interpolation = \"logarithmic\"\n"
      "yield_curves = [{ rate = 1, plastic_strain = [0], stress = [3e8] },\n"
      "                { rate = 10, plastic_strain = [0, 0.2], stress = [4e8, 5e8] }]");
  ASSERT_EQ(two.yield_curves.size(), 2U);
  EXPECT_EQ(two.yield_curves[1].rate, 10);
  EXPECT_EQ(two.rate_interpolation, RateInterpolation::logarithmic);
}

TEST_F(HardeningScene, AnElasticMaterialKeepsNothingOfIt) {
  const Scene scene = read(with(10,
                                "yield_curve = { plastic_strain = [0], stress = [3e8] }\nisotropic_share = 1\n"
                                "rate_constant = 40\nrate_exponent = 5"),
                           {.set = {"material.copper.model=elastic"}});
  const Material& m = scene.materials[0];
  EXPECT_TRUE(m.yield_curves.empty());
  EXPECT_EQ(m.rate_constant, 0);
  EXPECT_EQ(m.yield_stress, 0);
  EXPECT_EQ(m.bulk_modulus, 143e9);
}

TEST_F(HardeningScene, RefusesWhatDoesNotGoTogether) {
  EXPECT_EQ(problem("yield_stress = 4e8\nisotropic_share = 1.5"),
            "11:19: material.copper.isotropic_share: expected a number >= 0 and <= 1, got 1.5");
  EXPECT_EQ(problem("yield_stress = 4e8\nisotropic_share = 0.5\nultimate_stress = 5e8"),
            "12:19: material.copper.ultimate_stress: expected none beside isotropic_share = 0.5");
  EXPECT_EQ(problem("yield_stress = 4e8\nyield_curve = { plastic_strain = [0], stress = [3e8] }"),
            "10:16: material.copper.yield_stress: expected none beside yield_curve");
  EXPECT_EQ(problem("isotropic_share = 0.5\nyield_curve = { plastic_strain = [0], stress = [3e8] }"),
            "10:19: material.copper.isotropic_share: expected 1 beside yield curves, got 0.5: with them the yield "
            "surface only grows");
  EXPECT_EQ(problem("yield_stress = 4e8\nrate_constant = 40"),
            "4:1: material.copper.rate_exponent: expected a number > 0 beside rate_constant");
  EXPECT_EQ(problem("yield_stress = 4e8\nrate_stress = 40"),
            "11:15: material.copper.rate_stress: expected 0 without rate_constant");
  EXPECT_EQ(problem("yield_stress = 4e8\nstrain_rate = \"fast\""),
            "11:15: material.copper.strain_rate: expected \"total\", \"deviatoric\" or \"plastic\", got \"fast\"");
}

TEST_F(HardeningScene, RefusesBadCurves) {
  const auto curve = [this](const std::string& text) { return problem("yield_curve = { " + text + " }"); };
  EXPECT_EQ(curve("stress = [3e8]"),
            "10:15: material.copper.yield_curve.plastic_strain: missing, expected numbers from 0 on");
  EXPECT_EQ(curve("plastic_strain = [0.1], stress = [3e8]"),
            "10:34: material.copper.yield_curve.plastic_strain: expected 0 as the first, got 0.1");
  EXPECT_EQ(curve("plastic_strain = [0, 0.2, 0.1], stress = [3e8, 3e8, 3e8]"),
            "10:34: material.copper.yield_curve.plastic_strain: expected ascending numbers, got 0.1 after 0.2");
  EXPECT_EQ(curve("plastic_strain = [0, 0.2], stress = [3e8]"),
            "10:53: material.copper.yield_curve.stress: expected one number for each of the 2 plastic strains, got 1");
  EXPECT_EQ(curve("plastic_strain = [0, 0.2], stress = [3e8, 0]"),
            "10:59: material.copper.yield_curve.stress[1]: expected a number > 0, got 0");
  EXPECT_EQ(curve("plastic_strain = [0, 0.001], stress = [3e8, 1e8]"),
            "10:15: material.copper.yield_curve: expected slopes > -3 shear_modulus = -1.32e+11, got -2e+11 behind "
            "plastic strain 0");
  EXPECT_EQ(problem("yield_curves = [{ rate = 2, plastic_strain = [0], stress = [3e8] },\n"
                    "                { rate = 1, plastic_strain = [0], stress = [4e8] }]"),
            "10:16: material.copper.yield_curves: expected curves of ascending rates, got 1 after 2");
  EXPECT_EQ(problem("rate_interpolation = \"logarithmic\"\n"
                    "yield_curves = [{ rate = 0, plastic_strain = [0], stress = [3e8] },\n"
                    "                { rate = 1, plastic_strain = [0], stress = [4e8] }]"),
            "11:16: material.copper.yield_curves: expected rates > 0 for rate_interpolation = \"logarithmic\", got 0");
}

TEST_F(HardeningScene, ChecksCurvesOfAHost) {
  Scene scene = read(minimal);
  scene.materials[0].yield_curves = {{0, {0, 0.1}, {3e8, -1}}};
  try {
    checked_scene(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "material.copper.yield_curves.0.stress: expected numbers > 0, got -1");
  }
  scene.materials[0].yield_curves = {{0, {0, 0.1}, {3e8, 4e8}}};
  EXPECT_EQ(checked_scene(scene).materials[0].yield_stress, 3e8);
}

}  // namespace
}  // namespace pinball::hardening_scene_test
