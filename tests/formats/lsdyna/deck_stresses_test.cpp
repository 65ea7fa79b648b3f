#include <gmock/gmock.h>

#include "deck_case.hpp"

/// *INITIAL_STRESS_SOLID and its sets.
namespace pinball::test::deck_stresses_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class DeckStresses : public DeckTest {
 protected:
  static std::string deck(const std::string& stresses) {
    return cube + ends + "*MAT_003\n1,7.85E-9,210000.,0.3,400.,1000.\n\n*INITIAL_STRESS_SOLID" + stresses;
  }
};

TEST_F(DeckStresses, OfAnElementHaveItsPlasticStrain) {
  const Scene s = scene(deck("\n10,1\n1.,2.,3.,4.,5.,6.,0.01\n"));
  ASSERT_EQ(s.initial_stresses.size(), 1U);
  const InitialStress& given = s.initial_stresses[0];
  EXPECT_THAT(given.elements, ElementsAre(10));
  EXPECT_EQ(given.stress, (Point{1, 2, 3}));
  EXPECT_EQ(given.shear_stress, (Point{4, 5, 6})) << "xy, yz, zx";
  EXPECT_EQ(given.plastic_strain, 0.01);
  const Model<double> model = build_model<double>(s);
  EXPECT_THAT(model.elements.stress_of(model.slot_of_element[0]), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(model.elements.plastic_strain[model.slot_of_element[0]], 0.01);
}

/// Eight columns of ten, of sixteen with LARGE; behind each point its history variables.
TEST_F(DeckStresses, OfSeveralPointsAreTheirMean) {
  const std::string two = "\n10,2\n1.,2.,3.,4.,5.,6.,0.01\n3.,4.,5.,6.,7.,8.,0.03\n";
  const Scene s = scene(deck(two));
  EXPECT_EQ(s.initial_stresses[0].stress, (Point{2, 3, 4}));
  EXPECT_EQ(s.initial_stresses[0].shear_stress, (Point{5, 6, 7}));
  EXPECT_EQ(s.initial_stresses[0].plastic_strain, 0.02);
  EXPECT_THAT(translate(deck(two)).understood, Contains(HasSubstr("the mean of its 2 points")));
  const std::string large =
      "\n        10         1         5         1\n             1.0             2.0             3.0             4.0"
      "             5.0\n             6.0            0.01             0.7\n             0.8             0.9\n"
      "        10         1         0         1\n             9.0\n\n";
  const Scene l = scene(deck(large));
  EXPECT_EQ(l.initial_stresses.size(), 1U) << "the last counts";
  EXPECT_EQ(l.initial_stresses[0].stress, (Point{9, 0, 0}));
  EXPECT_THAT(translate(deck(large)).understood,
              Contains(AllOf(HasSubstr("NHISV, IVEFLG"), HasSubstr("their law's own"))));
}

TEST_F(DeckStresses, OfASetAreThoseOfItsSolids) {
  const std::string set = "*SET_SOLID_LIST\n7\n10\n";
  const Scene s = scene(deck("_SET\n7,1\n1.,2.,3.,4.,5.,6.\n") + set);
  EXPECT_THAT(s.initial_stresses.at(0).elements, ElementsAre(10));
  EXPECT_THAT(error(deck("_SET\n8,1\n1.\n") + set), HasSubstr("no *SET_SOLID has the number 8"));
  EXPECT_THAT(error(deck("\n10,0\n")), HasSubstr("NINT: expected 1 to 27, got 0"));
  EXPECT_THAT(error(deck("\n10,1\n")), HasSubstr("expected a stress"));
  EXPECT_THAT(error_in_cards(deck("\n11,1\n1.\n")), HasSubstr("has no element 11 that a body uses"));
}

}  // namespace
}  // namespace pinball::test::deck_stresses_test
