#include <gmock/gmock.h>

#include "deck_case.hpp"

/// *MAT_063: foams that crush.
namespace pinball::test::deck_foam_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class DeckFoam : public DeckTest {
 protected:
  /// first: its card behind RO; points: of its curve.
  static std::string foam(const std::string& first, const std::string& points) {
    return cube + ends + "*MAT_063\n1,6.E-11," + first + "\n*DEFINE_CURVE\n7\n" + points;
  }
  Material material(const std::string& deck) { return scene(deck).materials.at(0); }
  std::vector<std::string> told(const std::string& deck) { return translate(deck).understood; }
};

TEST_F(DeckFoam, HasItsCurveItsCutoffAndItsDamping) {
  const Material m = material(foam("20.,0.1,7,0.15,0.2", "0,0.2\n0.5,1.\n0.7,9.\n"));
  ASSERT_TRUE(m.plastic && m.crushable_foam);
  EXPECT_EQ(*m.crushable_foam, (CrushableFoamSettings{{0, 0.5, 0.7}, {0.2, 1, 9}, 0.15, 0.2}));
  EXPECT_NEAR(m.shear_modulus, 20 / 2.2, 1e-12);
  EXPECT_NEAR(m.bulk_modulus, 20 / (3 * 0.8), 1e-12);
  const std::string usual = foam("20.,0.,7", "0,0.2\n0.5,1.\n");
  EXPECT_EQ(*material(usual).crushable_foam, (CrushableFoamSettings{{0, 0.5}, {0.2, 1}, 0, 0.1}));
  EXPECT_THAT(told(usual), Contains(HasSubstr("a DAMP of 0 is 0.1")));
}

TEST_F(DeckFoam, MayHaveACurveOfEitherSign) {
  for (const char* points : {"-0.5,-1.\n0,-0.2\n", "-0.5,1.\n0,0.2\n", "0,-0.2\n0.5,-1.\n"}) {
    const Material m = material(foam("20.,0.,7", points));
    EXPECT_EQ(m.crushable_foam->compaction, (std::vector<double>{0, 0.5})) << points;
    EXPECT_EQ(m.crushable_foam->yield_stress, (std::vector<double>{0.2, 1})) << points;
  }
  EXPECT_THAT(told(foam("20.,0.,7", "-0.5,1.\n0,0.2\n")), Contains(HasSubstr("strains below 0 are compressions")));
}

TEST_F(DeckFoam, LeavesOutWhatNoStrainReaches) {
  const std::string wide = foam("20.,0.,7", "-1,0.\n1,2.\n1.5,52.\n");
  const CrushableFoamSettings law = *material(wide).crushable_foam;
  EXPECT_EQ(law.compaction, (std::vector<double>{0, 0.999}));
  EXPECT_EQ(law.yield_stress.front(), 1);
  EXPECT_NEAR(law.yield_stress.back(), 1.999, 1e-12);
  EXPECT_THAT(told(wide), Contains(HasSubstr("what lies below 0 is left out")));
  EXPECT_THAT(told(wide), Contains(HasSubstr("what lies beyond 1, which no strain reaches, is left out")));
}

TEST_F(DeckFoam, TellsOfAModulusThatIsLessThanASlope) {
  EXPECT_THAT(told(foam("20.,0.,7", "0,0.2\n0.5,1.\n0.7,9.\n")),
              Contains(HasSubstr("steepest slope of its curve, 40")));
  EXPECT_THAT(told(foam("40.1,0.,7", "0,0.2\n0.5,1.\n0.7,9.\n")), Not(Contains(HasSubstr("steepest"))));
}

TEST_F(DeckFoam, RefusesWhatIsNotDone) {
  EXPECT_THAT(error(foam("20.,0.,7,0.,0.,1", "0,0.2\n0.5,1.\n")), HasSubstr("principal stresses yield each by itself"));
  EXPECT_THAT(error(foam("20.,0.,8", "0,0.2\n0.5,1.\n")), HasSubstr("no *DEFINE_CURVE has the number 8"));
  EXPECT_THAT(error(foam("20.,0.,7,-1.", "0,0.2\n0.5,1.\n")), HasSubstr("TSC"));
  EXPECT_THAT(error(foam("20.,0.,7", "0,0.\n0.5,0.\n")), HasSubstr("what has no strength is a fluid"));
}

}  // namespace
}  // namespace pinball::test::deck_foam_test
