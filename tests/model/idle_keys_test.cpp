#include <gmock/gmock.h>

#include <solver/model/look/idle_keys.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/solver_case.hpp>

/// Keys that say nothing are told with what makes them so. That all of them are: key_effects_test.cpp.
namespace pinball::idle_keys_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> idle(Scene scene) {
  complete_scene(scene);
  return idle_keys(scene);
}

/// A block of plastic copper above one of elastic steel.
Scene two_blocks() {
  Scene scene = scene_of({block("a", {1, 1, 1}, 1, {}), block("b", {1, 1, 1}, 1, {0, 0, 2}, {}, "copper")}, 1);
  scene.materials.push_back(plastic_material("copper", 1e8, 0));
  scene.contact = {};
  scene.contact.method = ContactMethod::pinball;
  return scene;
}

TEST(IdleKeys, AreNamedForEachTableAndReason) {
  Scene scene = two_blocks();
  EXPECT_THAT(idle(scene), IsEmpty());
  scene.contact.beta = 2;
  scene.contact.damping = 0.2;
  scene.contact.radius = ContactRadius::current;
  scene.output.fields = {"stress"};
  EXPECT_THAT(
      idle(scene),
      ElementsAre(
          "contact: beta and damping are not used where enforcement is not \"penalty\"",
          "contact: radius is not used where no balls touch, but faces: gap = \"face\" or method = \"slideline\"",
          "output: fields is not used without field_interval or field_times"));
  scene.contact.enforcement = Enforcement::penalty;
  scene.output.field_interval = 0.1;
  EXPECT_THAT(idle(scene), IsEmpty());
  scene.contact.method = ContactMethod::slideline;
  EXPECT_THAT(idle(scene), ElementsAre("contact: radius is not used where no balls touch, but faces: gap = \"face\" or "
                                       "method = \"slideline\""));
}

TEST(IdleKeys, OfTheSceneAreThoseThatNoBodyUses) {
  Scene scene = two_blocks();
  scene.element.folding_resistance = 0.3;
  EXPECT_THAT(idle(scene), IsEmpty()) << "copper yields";
  scene.bodies[0].element = scene.element;
  EXPECT_THAT(idle(scene), IsEmpty()) << "what a body has from the scene is not its own";
  scene.bodies[0].element->folding_resistance = 0.4;
  EXPECT_THAT(idle(scene),
              ElementsAre("body.a.element: folding_resistance is not used where no material of the elements yields"));
  scene.bodies[0].element.reset();
  scene.bodies[1].material = "steel";
  EXPECT_THAT(idle(scene), testing::Contains("element: folding_resistance is not used where no material of the "
                                             "elements yields"));
}

TEST(IdleKeys, OfTablesWithinTablesHaveTheirNames) {
  Scene scene = two_blocks();
  scene.materials[1].johnson_cook = JohnsonCookSettings{};
  scene.materials[1].johnson_cook->softening_exponent = 2;
  scene.materials[1].johnson_cook->damage_weakening = 0.3;
  scene.materials[1].plastic_modulus = 0;
  scene.probes.resize(1);
  scene.fixed_constraints.resize(1);
  scene.fixed_constraints[0].nodes.body = "a";
  scene.fixed_constraints[0].nodes.tolerance = 0.1;
  EXPECT_THAT(idle(scene),
              ElementsAre("material.copper: johnson_cook.softening_exponent is not used without melting_temperature",
                          "material.copper: johnson_cook.damage_weakening is not used without failure",
                          "constraint.0: tolerance is not used without plane, line or box"));
}

}  // namespace
}  // namespace pinball::idle_keys_test
