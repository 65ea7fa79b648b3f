#include <gmock/gmock.h>

#include <regex>

#include <tests/support/folder_case.hpp>
#include <tests/support/program.hpp>
#include <tests/support/scene_text.hpp>

/// How messages say what they say.
namespace pinball::test::wording_test {
namespace {

using testing::HasSubstr;

class Wording : public FolderTest {
 protected:
  std::string scene(const std::string& text) {
    const std::string path = (folder_ / "scene.toml").string();
    std::ofstream(path) << text;
    return path;
  }
  std::string out() const { return " --out " + (folder_ / "out").string(); }
};

TEST_F(Wording, OneOfAnythingIsInTheSingular) {
  const std::string options = scene(cube_scene) + " --threads 1 ";
  const std::string steps = options + "--set time.steps=1 " + out();
  const std::string all = run("info " + options).text + run("run " + steps).text +
                          run("run " + options + out() + " --set body.cube.velocity_noise=1e9").text;
  for (const char* text : {"1 element, 8 nodes, 1 body, end at", "cube: 1 element, 8 nodes",
                           "1 of 1 element has no volume", "1 tile of elements in 1 colour",
                           ": 1 element, 1 step to t = ", "0 of 1 element eroded", ", 1 thread)", "  1 element\n"}) {
    EXPECT_THAT(all, HasSubstr(text));
  }
  const std::regex wrong("[ (]1 (elements|steps|nodes|bodies|tiles|colours|threads|points|pairs)");
  std::smatch found;
  EXPECT_FALSE(std::regex_search(all, found, wrong)) << found.str() << " in\n" << all;
}

TEST_F(Wording, ConvertNamesTheFileThatItCannotWriteNotTheDeck) {
  expect_bad_input("convert " PINBALL_SOURCE_DIR "/data/decks/abaqus/tied.inp " + (folder_ / "nowhere/x.toml").string(),
                   "convert: cannot write " + (folder_ / "nowhere/x.toml").string());
}

}  // namespace
}  // namespace pinball::test::wording_test
