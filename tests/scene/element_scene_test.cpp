#include <gmock/gmock.h>

#include <solver/scene/toml/listing.hpp>
#include <tests/support/scene_fixture.hpp>

/// [element], what a body has in its place, and mass scaling, as scene files have them.
namespace pinball::test::element_scene_test {
namespace {

class ElementScene : public SceneTest {
 protected:
  /// [element] above the minimal scene, and body.element behind it.
  Scene read_both(const std::string& all, const std::string& own) {
    auto lines = minimal;
    lines.push_back("element = { " + own + " }");
    lines.insert(lines.begin(), "element = { " + all + " }");
    return read(lines);
  }
};

TEST_F(ElementScene, OfABodyIsThatOfTheSceneWhereItSaysNothing) {
  const Scene scene = read_both("hourglass = \"viscous\", hourglass_coefficient = 0.03, linear_viscosity = 0.1",
                                "quadratic_viscosity = 2, bulk_viscosity = false, negative_volume = \"erode\"");
  const ElementSettings& own = scene.bodies.at(0).element.value();
  EXPECT_EQ(own.hourglass, HourglassControl::viscous);
  EXPECT_EQ(own.hourglass_coefficient, 0.03);
  EXPECT_EQ(own.linear_viscosity, 0.1);
  EXPECT_EQ(own.quadratic_viscosity, 2);
  EXPECT_FALSE(own.bulk_viscosity);
  EXPECT_EQ(own.negative_volume, NegativeVolume::erode);
  EXPECT_EQ(scene.element.quadratic_viscosity, 1.2);
  EXPECT_TRUE(scene.element.bulk_viscosity);
}

TEST_F(ElementScene, OfABodyHasTheCoefficientOfItsForm) {
  const Scene scene = read_both("hourglass = \"viscous\", hourglass_coefficient = 0.03", "hourglass = \"stiffness\"");
  EXPECT_EQ(scene.bodies.at(0).element->hourglass_coefficient, 0.05);
  EXPECT_EQ(error(with({"element = { hourglass_coefficient = 0.1 }"})),
            "15:37: body.bar.element.hourglass_coefficient: needs hourglass beside it, the form that it is a "
            "coefficient of");
  EXPECT_EQ(error(with({"element = { linear = 0.1 }"})).substr(0, 45), "15:13: body.bar.element.linear: unknown key, ");
  EXPECT_EQ(error(with({"element = { linear_viscosity = -1 }"})),
            "15:32: body.bar.element.linear_viscosity: expected a number >= 0, got -1");
}

TEST_F(ElementScene, OfABodyIsSetFromTheCommandLine) {
  const Scene scene = read(minimal, {.set = {"body.bar.element.hourglass=viscous"}});
  EXPECT_EQ(scene.bodies.at(0).element->hourglass, HourglassControl::viscous);
}

TEST_F(ElementScene, OfABodyIsListed) {
  std::vector<std::string> values;
  for (const SceneEntry& entry : list_scene(read(with({"element = { linear_viscosity = 0.5 }"})))) {
    if (entry.table == "body.bar.element" && !entry.is_default) values.push_back(entry.key + " = " + entry.value);
  }
  EXPECT_THAT(values, testing::ElementsAre("linear_viscosity = 0.5"));
}

TEST_F(ElementScene, MassScalingIsOfTheStep) {
  const Scene scene = read(with(3, "end = 1.0\nsmallest_step = 1e-3\nmass_scaling = \"all\""));
  EXPECT_EQ(scene.time.smallest_step, 1e-3);
  EXPECT_EQ(scene.time.mass_scaling, MassScaling::all);
  EXPECT_EQ(error(with(3, "end = 1.0\nsmallest_step = -1")),
            "4:17: time.smallest_step: expected a number >= 0, got -1");
  EXPECT_EQ(error(with(3, "end = 1.0\nmass_scaling = \"some\"")),
            "4:16: time.mass_scaling: expected \"small\" or \"all\", got \"some\"");
}

}  // namespace
}  // namespace pinball::test::element_scene_test
