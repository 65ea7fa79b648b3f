#include <gtest/gtest.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/verification/verification.hpp>
#include <tests/support/solver_case.hpp>  // one thread

/// Scenes that somebody has edited are compared by their names, or refused.
namespace pinball::edited_scenes_test {
namespace {

const VerificationCase& case_of(const std::string& scene) {
  const auto& all = verification_cases();
  return *std::find_if(all.begin(), all.end(), [&](const VerificationCase& c) { return c.scene == scene; });
}

Scene scene_of(const std::string& name) { return read_scene(find_scene(name)); }

TEST(EditedScenes, MayHaveAnyOrderOfBodiesAndMaterials) {
  for (const char* name : {"material_laws", "elastic_cycles"}) {
    SCOPED_TRACE(name);
    const std::vector<VerificationRow> rows = compare_scene(case_of(name), scene_of(name));
    for (const bool bodies : {true, false}) {
      Scene edited = scene_of(name);
      if (bodies) {
        std::reverse(edited.bodies.begin(), edited.bodies.end());
      } else {
        std::reverse(edited.materials.begin(), edited.materials.end());
      }
      const std::vector<VerificationRow> others = compare_scene(case_of(name), edited);
      ASSERT_EQ(others.size(), rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_TRUE(others[i].pass) << rows[i].quantity;
        EXPECT_NEAR(others[i].value, rows[i].value, 1e-12 * std::abs(rows[i].value) + 1e-15) << rows[i].quantity;
      }
    }
  }
}

/// Names of the cases, and what is taken from their scenes.
TEST(EditedScenes, WithoutWhatIsComparedAreRefused) {
  const auto refused = [](const char* name, const std::string& part, const auto& edit) {
    Scene scene = scene_of(name);
    edit(scene);
    try {
      compare_scene(case_of(name), scene);
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  refused("material_laws", "a body named power", [](Scene& s) { s.bodies.front().name = "other"; });
  refused("rod_plate", "a body named plate", [](Scene& s) { s.bodies.pop_back(); });
  refused("rod_plate", "a material named copper", [](Scene& s) { s.materials.front().name = "brass"; });
  refused("material_laws", "a law of a material", [](Scene& s) {
    for (Material& m : s.materials) m.drucker_prager.reset();
  });
  refused("patch_test", "a body's mesh",
          [](Scene& s) { s.bodies.front().mesh = scene_of("sphere_wall").bodies.front().mesh; });
  refused("plastic_cantilever", "motion", [](Scene& s) { s.prescribed_velocities.clear(); });
}

}  // namespace
}  // namespace pinball::edited_scenes_test
