#include <gmock/gmock.h>

#include "abaqus_case.hpp"

/// *INITIAL CONDITIONS, TYPE=STRESS and TYPE=HARDENING.
namespace pinball::test::abaqus_stresses_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class AbaqusStresses : public AbaqusTest {
 protected:
  static std::string deck(const std::string& conditions) {
    return abaqus_cube + abaqus_steel + "*PLASTIC\n400., 0.\n" + conditions + abaqus_step();
  }
};

/// 11, 22, 33, 12, 13, 23; of both conditions together.
TEST_F(AbaqusStresses, HaveTheirComponentsInTheOrderOfTheDeck) {
  const Scene s =
      scene(deck("*INITIAL CONDITIONS, TYPE=STRESS\nCube, 1., 2., 3., 4., 5., 6.\n"
                 "*INITIAL CONDITIONS, TYPE=HARDENING\nCube, 0.02\n"));
  ASSERT_EQ(s.initial_stresses.size(), 1U);
  const InitialStress& given = s.initial_stresses[0];
  EXPECT_EQ(given.stress, (Point{1, 2, 3}));
  EXPECT_EQ(given.shear_stress, (Point{4, 6, 5})) << "xy, yz, zx";
  EXPECT_EQ(given.plastic_strain, 0.02);
  const Model<double> model = build_model<double>(s);
  EXPECT_THAT(model.elements.stress_of(model.slot_of_element[0]), ElementsAre(1, 2, 3, 4, 6, 5));
}

TEST_F(AbaqusStresses, AreRefusedWhereTheyAreOfMore) {
  const std::string stress = "*INITIAL CONDITIONS, TYPE=STRESS\n";
  EXPECT_THAT(error(deck(stress + "1, 1, 1., 2., 3., 4., 5., 6.\n")), HasSubstr("of single points of integration"));
  EXPECT_THAT(error(deck("*INITIAL CONDITIONS, TYPE=STRESS, GEOSTATIC\nCube, 1.\n")), HasSubstr("GEOSTATIC"));
  EXPECT_THAT(error(deck("*INITIAL CONDITIONS, TYPE=HARDENING\nCube, 0.02, 1.\n")), HasSubstr("with a back stress"));
  EXPECT_THAT(error(deck(stress + "nothing, 1.\n")), HasSubstr("nothing"));
}

}  // namespace
}  // namespace pinball::test::abaqus_stresses_test
