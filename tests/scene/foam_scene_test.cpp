#include <gmock/gmock.h>

#include <solver/scene_rules.hpp>
#include <tests/support/scene_fixture.hpp>

/// crushable_foam of a material.
namespace pinball::foam_scene_test {
namespace {

using namespace test;
using testing::HasSubstr;

class FoamScene : public SceneTest {
 protected:
  /// In the place of the yield stress.
  std::vector<std::string> foam(const std::string& keys, const std::string& more = "") {
    return with(10, "crushable_foam = { " + keys + " }\n" + more);
  }
};

constexpr const char* curve = "compaction = [0, 0.1, 0.7], yield_stress = [1e5, 3e5, 4e6]";

TEST_F(FoamScene, ReadsACurveAndWhatIsBesideIt) {
  const Material m = read(foam(curve)).materials.at(0);
  EXPECT_EQ(*m.crushable_foam, (CrushableFoamSettings{{0, 0.1, 0.7}, {1e5, 3e5, 4e6}}));
  EXPECT_FALSE(has_yield_stress(m));
  const Material all = read(foam(std::string(curve) + ", tension_cutoff = 0, damping = 0.1, air_pressure = 1e5, "
                                                      "solid_share = 0.05"))
                           .materials.at(0);
  EXPECT_EQ(*all.crushable_foam, (CrushableFoamSettings{{0, 0.1, 0.7}, {1e5, 3e5, 4e6}, 0, 0.1, 1e5, 0.05}));
}

TEST_F(FoamScene, RefusesCurvesThatAreNone) {
  const auto wrong = [&](const std::string& keys) { return error(foam(keys)); };
  EXPECT_THAT(wrong("compaction = [], yield_stress = []"), HasSubstr("crushable_foam.compaction: "));
  EXPECT_THAT(wrong("yield_stress = [1]"), HasSubstr("crushable_foam.compaction: missing"));
  EXPECT_THAT(wrong("compaction = [0, 1], yield_stress = [1, 2]"),
              HasSubstr("crushable_foam.compaction: expected numbers < 1, of what is left of a volume, got 1"));
  EXPECT_THAT(wrong("compaction = [0, 0.2, 0.2], yield_stress = [1, 2, 3]"),
              HasSubstr("crushable_foam.compaction: expected ascending numbers, got 0.2 after 0.2"));
  EXPECT_THAT(wrong("compaction = [0, 0.2], yield_stress = [1]"),
              HasSubstr("crushable_foam.yield_stress: expected one number for each of the 2 compactions, got 1"));
  EXPECT_THAT(wrong("compaction = [0, 0.2], yield_stress = [-1, 1]"), HasSubstr("crushable_foam.yield_stress"));
  EXPECT_THAT(wrong("compaction = [0], yield_stress = [0]"), HasSubstr("what has no strength is a fluid"));
  EXPECT_THAT(wrong(std::string(curve) + ", air_pressure = 1e5, solid_share = 1"), HasSubstr("solid_share"));
}

TEST_F(FoamScene, RefusesOtherStrengthsBesideIt) {
  for (const char* other :
       {"yield_stress = 1e9", "plastic_modulus = 1e9", "isotropic_share = 0.5", "rate_constant = 40\nrate_exponent = 5",
        "johnson_cook = {}", "power_hardening = { coefficient = 1e9, exponent = 0.2 }"})
    EXPECT_THAT(error(foam(curve, other)), HasSubstr("expected none beside crushable_foam")) << other;
  EXPECT_THAT(error(foam(curve, "drucker_prager = { constant = 1 }")), HasSubstr("expected none beside"));
}

TEST_F(FoamScene, HasNoDampingBesideSubcycling) {
  Scene scene = read(foam(std::string(curve) + ", damping = 0.1"));
  EXPECT_FALSE(problem_of(scene.bodies.at(0), scene));
  scene.time.subcycling = true;
  ASSERT_TRUE(problem_of(scene.bodies.at(0), scene));
  EXPECT_THAT(problem_of(scene.bodies.at(0), scene)->text, HasSubstr("whose crushable_foam has a damping"));
  scene.materials.at(0).crushable_foam->damping = 0;
  EXPECT_FALSE(problem_of(scene.bodies.at(0), scene));
}

}  // namespace
}  // namespace pinball::foam_scene_test
