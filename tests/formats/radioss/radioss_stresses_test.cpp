#include <gmock/gmock.h>

#include "radioss_card_decks.hpp"

/// /INIBRI of stresses and plastic strains.
namespace pinball::test::radioss_stresses_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class RadiossStresses : public RadiossTest {
 protected:
  static std::string number(const char* columns) { return fmt::format("{:>10}", columns); }
};

TEST_F(RadiossStresses, HaveAStressAndAPlasticStrain) {
  const std::string stress = "/INIBRI/STRESS\n" + number("10") + twenty({1, 2, 3}) + twenty({4, 5, 6});
  const Scene s = scene(cube_with(stress + "/INIBRI/EPSP\n" + number("10") + twenty({0.01})));
  ASSERT_EQ(s.initial_stresses.size(), 1U);
  const InitialStress& given = s.initial_stresses[0];
  EXPECT_THAT(given.elements, ElementsAre(10));
  EXPECT_EQ(given.stress, (Point{1, 2, 3}));
  EXPECT_EQ(given.shear_stress, (Point{4, 5, 6})) << "xy, yz, zx";
  EXPECT_EQ(given.plastic_strain, 0.01);
  EXPECT_THAT(translate(cube_with(stress)).understood, Contains(HasSubstr("along x, y and z")));
  const Model<double> model = build_model<double>(scene(cube_with(stress)));
  EXPECT_THAT(model.elements.stress_of(model.slot_of_element[0]), ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST_F(RadiossStresses, OfTheGlobalFrameHaveOnePoint) {
  const auto full = [](const char* points) {
    return cube_with("/INIBRI/STRS_FGLO\n" + ten({"10", points, "8", "1"}) + twenty({0, 0}) + twenty({1, 2, 3}) +
                     twenty({4, 5, 6}) + twenty({0.01}));
  };
  const InitialStress given = scene(full("1")).initial_stresses.at(0);
  EXPECT_EQ(given.stress, (Point{1, 2, 3}));
  EXPECT_EQ(given.shear_stress, (Point{4, 5, 6}));
  EXPECT_EQ(given.plastic_strain, 0.01);
  EXPECT_THAT(error(full("8")), HasSubstr("of several points"));
  EXPECT_THAT(error(cube_with("/INIBRI/ORTHO\n" + ten({"10"}))), HasSubstr("what elements have at the start"));
}

}  // namespace
}  // namespace pinball::test::radioss_stresses_test
