#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include <tests/support/folder_case.hpp>
#include <tests/support/program.hpp>
#include <tests/support/scene_text.hpp>

/// What info and run say of a scene before its first step, and what summary.json has of it.
namespace pinball::test::look_program_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string second_cube = R"([[body]]
name = "other"
material = "steel"
position = [0, 0, 0.11]
velocity = [0, 0, -400]
mesh = { type = "block", size = [0.1, 0.1, 0.1], elements = [1, 1, 1] }
)";

class LookProgram : public FolderTest {
 protected:
  std::string scene(const std::string& text) {
    const std::string path = (folder_ / "scene.toml").string();
    std::ofstream(path) << text;
    return path;
  }
  std::string out() const { return " --out " + (folder_ / "out").string(); }
  nlohmann::json summary() const { return nlohmann::json::parse(content((folder_ / "out" / "summary.json").string())); }
};

TEST_F(LookProgram, ContactIsOnWhereBodiesMeetAndSaysSo) {
  const Finished f = run("run " + scene(cube_scene + second_cube) + out());
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("contact is on (contact.method is left out): bodies cube and other can meet"));
  EXPECT_EQ(summary()["contact"]["method"], "pinball");
  EXPECT_THAT(summary()["contact"]["because"], HasSubstr("can meet"));
  EXPECT_GT(summary()["contact"]["pairs_max"], 0);
  const Finished away = run("run " + scene(replaced(cube_scene + second_cube, "-400", "400")) + out());
  EXPECT_THAT(away.text, HasSubstr("contact is off (contact.method is left out): no two bodies can meet"));
  EXPECT_EQ(summary()["contact"]["method"], "none");
  const Finished none = run("run " + scene(cube_scene + second_cube) + " --set contact.method=none" + out());
  EXPECT_THAT(none.text, Not(HasSubstr("contact.method")));
  EXPECT_TRUE(summary()["contact"]["because"].is_null());
}

TEST_F(LookProgram, WarningsStandBeforeTheFirstStepAndInTheSummary) {
  const std::string path = scene(replaced(cube_scene, "kg-m-s", "g/mm/ms"));
  EXPECT_THAT(run("info " + path).text, HasSubstr("warning: material steel: density 7850"));
  const Finished f = run("run " + path + out());
  EXPECT_LT(f.text.find("warning: material steel"), f.text.find("0.0 %")) << f.text;
  EXPECT_THAT(summary()["warnings"].dump(), HasSubstr("both are those of steel in kg-m-s"));
}

TEST_F(LookProgram, InfoHasAllWarningsOfTheStart) {
  const std::string path = scene(replaced(cube_scene + second_cube, "[0, 0, 0.11]", "[0, 0, 0.08]"));
  const Finished info = run("info " + path);
  EXPECT_THAT(info.text, HasSubstr("warning: bodies cube and other overlap at the start"));
  run("run " + path + out());
  const auto warnings = summary()["warnings"];
  EXPECT_THAT(warnings.dump(), HasSubstr("overlap at the start"));
}

TEST_F(LookProgram, InfoSaysWhyContactIsLeftOut) {
  const std::string text = replaced(cube_scene + second_cube, "-400", "400");
  EXPECT_THAT(run("info " + scene(text)).text, HasSubstr("  contact: no two bodies can meet\n"));
  EXPECT_THAT(run("info " + scene(text) + " --set contact.method=none").text,
              HasSubstr("  contact: off in the scene (contact.method = none)\n"));
  EXPECT_THAT(run("info " + scene(cube_scene)).text,
              HasSubstr("  contact: there is one body, and contact.method is left out, or none\n"));
}

/// One probe and its body have columns of one name.
TEST_F(LookProgram, ColumnsOfOneNameAreRefused) {
  const std::string path =
      scene(cube_scene + "[[probe]]\nname = \"cube_max\"\nkind = \"element\"\npoint = [0, 0, 0]\n");
  for (const char* command : {"info ", "run "})
    expect_bad_input(command + path + out(), "would have the name cube_max_plastic_strain");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(LookProgram, UnitsThatNameNothingAreRefused) {
  const Finished f = run("info " + scene(replaced(cube_scene, "kg-m-s", "foo-bar-baz")));
  EXPECT_EQ(f.status, 2);
  EXPECT_THAT(f.text, HasSubstr("scene.toml:1:9: units: expected a length, a time and a mass, a force or a stress"));
}

TEST_F(LookProgram, InfoMakesAShortRunToItsEnd) {
  const std::string path = scene(cube_scene);
  const Finished info = run("info " + path);
  EXPECT_THAT(info.text, AllOf(HasSubstr("all made just now, run time "), HasSubstr("first step")));
  run("run " + path + out());
  EXPECT_THAT(info.text, HasSubstr(std::to_string(summary()["steps"].get<int>()) + " steps to"));
}

TEST_F(LookProgram, InfoTellsARunThatFailsAtOnce) {
  const Finished f = run("info " + scene(cube_scene) + " --set guard.energy_error=1e-300");
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("the run fails: the energy balance is off"));
}

}  // namespace
}  // namespace pinball::test::look_program_test
