#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <thread>

#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>
#include <tests/support/scene_text.hpp>

/// The program itself, from outside: exit status, messages, files.
namespace pinball::run_test {
namespace {

using test::content;
using test::cube_scene;
using test::Finished;
using test::run;
using testing::HasSubstr;
using testing::Not;

/// Text of a number or string under a key of a JSON file, wherever it stands first; empty if there is none.
std::string value_of(const std::string& json, const std::string& key) {
  std::smatch match;
  const std::regex pattern('"' + key + "\": (\"[^\"]*\"|[^,\\n\\]}]+)");
  return std::regex_search(json, match, pattern) ? match[1].str() : "";
}

class Program : public testing::Test {
 protected:
  std::string scene(const std::string& text) {
    const std::string path = folder_ / "scene.toml";
    std::ofstream(path) << text;
    return path;
  }
  static std::string with(const std::string& what, const std::string& instead) {
    return test::replaced(cube_scene, what, instead);
  }
  std::string out() const { return " --quiet --out " + (folder_ / "out"); }
  std::string result(const std::string& name) const { return content((folder_ / "out/") + name); }

  void expect_bad_input(const std::string& text, int line, const std::string& message) {
    const std::string path = scene(text);
    for (const char* command : {"run ", "info "}) {
      const Finished f = run(command + path + out());
      EXPECT_EQ(f.status, 2) << f.text;
      EXPECT_THAT(f.text, HasSubstr(message));
      if (line > 0) {
        EXPECT_THAT(f.text, HasSubstr(path + ":" + std::to_string(line) + ":"));
      }
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  }

  test::TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
};

TEST_F(Program, HelpAndVersionSucceed) {
  EXPECT_EQ(run("--help").status, 0);
  const Finished version = run("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.text, testing::MatchesRegex("pinball [0-9.]+\n"));
}

TEST_F(Program, BadCommandLinesEndWithTwo) {
  EXPECT_EQ(run("").status, 2);
  EXPECT_EQ(run("fly").status, 2);
  EXPECT_EQ(run("run").status, 2);
  EXPECT_EQ(run("run two_blocks --speed 3").status, 2);
  EXPECT_EQ(run("run two_blocks --refine 0").status, 2);
  EXPECT_EQ(run("run two_blocks --precision half").status, 2);
  EXPECT_EQ(run("run two_blocks --set contact.bta=1").status, 2);
}

TEST_F(Program, BadScenesEndWithTwoAndTheLine) {
  expect_bad_input(with("density = 7850", "densty = 7850"), 9, "density");
  expect_bad_input(with("density = 7850", "density = nan"), 9, "expected");
  expect_bad_input(with("density = 7850", "density = -1"), 9, "expected");
  expect_bad_input(with("end = 1e-4", "end = inf"), 3, "expected");
  expect_bad_input(with("material = \"steel\"", "material = \"stel\""), 14, "steel");
  expect_bad_input(with("size = [0.1, 0.1, 0.1]", "size = [0.1, 0.1, -0.1]"), 16, "size");
  expect_bad_input(with("[1, 1, 1]", "[1, 0, 1]"), 16, "elements");
  expect_bad_input(with("type = \"block\", size = [0.1, 0.1, 0.1], elements = [1, 1, 1]",
                        "type = \"round_nosed_rod\", length = 2, radius = -0.5, layers = 3"),
                   16, "radius");
  expect_bad_input(with("end = 1e-4", "end = "), 0, "scene.toml:3");
}

TEST_F(Program, ASceneWithoutBodiesOrMeshIsBadInput) {
  expect_bad_input(cube_scene.substr(0, cube_scene.find("[[body]]")), 0, "expected at least one [[body]]");
  expect_bad_input(cube_scene.substr(0, cube_scene.find("mesh")), 0, "mesh");
}

TEST_F(Program, AMissingSceneIsBadInput) {
  for (const char* command : {"run ", "info "}) {
    const Finished f = run(std::string(command) + "rod_plat");
    EXPECT_EQ(f.status, 2);
    EXPECT_THAT(f.text, HasSubstr("nearest is rod_plate"));
    EXPECT_EQ(run(command + (folder_ / "none.toml")).status, 2);
    EXPECT_THAT(run(command + (folder_ / "")).text, HasSubstr(": expected a file, this is a folder"));
  }
}

TEST_F(Program, AnUnstableRunEndsWithOneAndLeavesItsLastGoodState) {
  // A free cube on its own has exactly the frequency that its element bounds: above 1 its steps are unstable.
  const std::string path = scene(with("[element]", "cfl = 1.2\n[element]"));
  const Finished f = run("run " + path + out() + " --set time.end=1e-2");
  EXPECT_EQ(f.status, 1) << f.text;
  EXPECT_THAT(f.text, HasSubstr("energy balance"));
  EXPECT_THAT(f.text, HasSubstr("in step"));
  EXPECT_THAT(f.text, HasSubstr("smaller time.cfl"));
  EXPECT_THAT(f.text, HasSubstr("last_good.vtu"));
  EXPECT_THAT(result("last_good.vtu"), HasSubstr("</VTKFile>"));
  EXPECT_THAT(result("last_good.vtu"), Not(HasSubstr("nan")));
  EXPECT_NE(value_of(result("summary.json"), "steps"), "");
  EXPECT_THAT(result("history.csv"), HasSubstr("balance_error"));
}

TEST_F(Program, AnInvertedElementIsNamed) {
  const std::string path = scene(with("[element]", "cfl = 1.2\n[element]"));
  const Finished f = run("run " + path + out() + " --set time.end=1e-2 --set guard.energy_error=1e30");
  EXPECT_EQ(f.status, 1) << f.text;
  EXPECT_THAT(f.text, HasSubstr("element 0 of body cube"));
  EXPECT_THAT(f.text, HasSubstr("no volume"));
}

TEST_F(Program, WhatIsWrongFromTheStartIsToldAtTheStart) {
  const std::string flat = cube_scene + "[contact]\nmethod = \"pinball\"\nenforcement = \"penalty\"\n" + R"(
[[body]]
name = "column"
material = "steel"
position = [0.03, 0.03, 0.11]
mesh = { type = "block", size = [0.04, 0.04, 0.2], elements = [1, 1, 1] }
)";
  const Finished f = run("run " + scene(flat) + " --out " + (folder_ / "out"));
  EXPECT_EQ(f.status, 0) << f.text;
  const std::string warning =
      "pinball: warning: the balls of element 0 of body cube and element 1 of body column meet ";
  ASSERT_THAT(f.text, HasSubstr(warning));
  EXPECT_LT(f.text.find(warning), f.text.find("energy error"));
  EXPECT_THAT(result("summary.json"), HasSubstr("the balls of element 0 of body cube and"));
  const Finished quiet = run("run " + scene(flat) + out());
  EXPECT_EQ(quiet.text.find(warning), quiet.text.rfind(warning)) << "once is enough where nothing else is said";
  EXPECT_LT(quiet.text.find(warning), quiet.text.find("energy:"));
  const Finished failed = run("run " + scene(flat) + out() + " --set time.cfl=1.2 --set guard.energy_error=1e-12");
  EXPECT_EQ(failed.status, 1);
  EXPECT_THAT(failed.text, HasSubstr(warning));
}

TEST_F(Program, WhatWasMadeOfADeckComesFirstAndIsInTheSummary) {
  const std::string deck = std::string(PINBALL_SOURCE_DIR) + "/data/decks/velocities.k";
  const Finished f = run("run " + deck + " --out " + (folder_ / "out"));
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_EQ(f.text.find(deck + ", as this program understands it:"), 0U) << f.text;
  EXPECT_LT(f.text.find("understands it:"), f.text.find("energy error"));
  const auto notes = nlohmann::json::parse(result("summary.json"))["notes"];
  ASSERT_FALSE(notes.empty());
  for (const auto& note : notes) {
    const std::string text = note.get<std::string>(), ignored = "ignored: ";
    EXPECT_THAT(f.text, HasSubstr(text.starts_with(ignored) ? text.substr(ignored.size()) : text));
  }
  EXPECT_EQ(run("run " + deck + out() + " --checkpoint-every 1000").status, 0);
  EXPECT_EQ(run("run --quiet --restart " + (folder_ / "out/checkpoint.pinball")).status, 0);
  EXPECT_EQ(nlohmann::json::parse(result("summary.json"))["notes"], notes);
}

TEST_F(Program, ASuccessfulRunRemovesAnOldLastGoodState) {
  const std::string path = scene(cube_scene);
  std::filesystem::create_directories(folder_ / "out");
  std::ofstream(folder_ / "out/last_good.vtu") << "old";
  EXPECT_EQ(run("run " + path + out()).status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/last_good.vtu"));
}

TEST_F(Program, AFolderThatCannotBeUsedEndsWithTwo) {
  std::ofstream(folder_ / "file") << "x";
  for (const std::string& out : {folder_ / "file/sub", folder_ / "file", std::string("/proc/sub"), std::string("''")}) {
    const Finished f = run("run two_blocks --quiet --out " + out);
    EXPECT_EQ(f.status, 2) << out;
    EXPECT_THAT(f.text, testing::StartsWith("pinball: error: --out" + (out == "''" ? ":" : " " + out + ": cannot ")));
  }
}

/// What the program says, each time that it begins, of the environment in which its threads wait.
Finished run_in(const std::string& environment, const std::string& arguments) {
  const std::string nothing = "env -u GOMP_SPINCOUNT -u OMP_WAIT_POLICY -u OMP_NUM_THREADS OMP_DISPLAY_ENV=verbose ";
  Finished result = run(arguments, nothing + environment);
  const std::regex spins("GOMP_SPINCOUNT = '([^']*)'");
  std::string all;
  for (std::sregex_iterator i(result.text.begin(), result.text.end(), spins), end; i != end; ++i)
    all += (*i)[1].str() + ' ';
  result.text = all;
  return result;
}

TEST_F(Program, ThreadsOfARunSpinBrieflyWhereTheEnvironmentSaysNothing) {
#if !defined(__GLIBC__) || defined(__clang__)
  GTEST_SKIP() << "another OpenMP than GCC's";
#endif
  const std::string scene = "two_blocks --set time.steps=2" + out();
  EXPECT_THAT(run_in("", "run --threads 2 " + scene).text, testing::EndsWith(" 1000 "));
  EXPECT_THAT(run_in("OMP_NUM_THREADS=2", "run " + scene).text, testing::EndsWith(" 1000 "));
  EXPECT_THAT(run_in("", "compare two_blocks --quiet --repeat 1 --threads 2").text, testing::EndsWith(" 1000 "));
  EXPECT_THAT(run_in("OMP_NUM_THREADS=2", "info two_blocks").text, testing::EndsWith(" 1000 "));
  EXPECT_EQ(run_in("GOMP_SPINCOUNT=77", "run --threads 2 " + scene).text, "77 ");
  EXPECT_EQ(run_in("OMP_WAIT_POLICY=passive", "run --threads 2 " + scene).text, "0 ");
  const std::string alone = run_in("", "run --threads 1 " + scene).text;
  EXPECT_EQ(std::count(alone.begin(), alone.end(), ' '), 1) << "begun once: " << alone;
}

TEST_F(Program, ThreadsAreThoseThatTheSizeEarnsUnlessSomebodySaysHowMany) {
  const auto threads_of = [&](const std::string& environment, const std::string& arguments) {
    const Finished f = run("run " + arguments + " --set time.steps=1" + out(), "env -u OMP_NUM_THREADS " + environment);
    EXPECT_EQ(f.status, 0) << f.text;
    return value_of(result("summary.json"), "threads");
  };
  EXPECT_EQ(threads_of("", "two_blocks"), "1");
  EXPECT_EQ(threads_of("", "two_blocks --threads 3"), "3");
  EXPECT_EQ(threads_of("OMP_NUM_THREADS=3", "two_blocks"), "3");
  EXPECT_EQ(threads_of("OMP_NUM_THREADS=3", "two_blocks --threads 2"), "2");
  const unsigned processors = std::clamp(std::thread::hardware_concurrency(), 1U, 6U);
  EXPECT_EQ(threads_of("", "two_blocks --refine 4"), std::to_string(processors)) << "of 8,192 elements";
}

TEST_F(Program, RunWritesSummaryAndHistory) {
  const Finished f = run("run two_blocks --threads 2 --set output.field_interval=0" + out());
  EXPECT_EQ(f.status, 0) << f.text;
  const std::string summary = result("summary.json");
  for (const char* key : {"scene",
                          "version",
                          "precision",
                          "threads",
                          "simd_width",
                          "elements",
                          "nodes",
                          "steps",
                          "end_time",
                          "min",
                          "max",
                          "limited_by",
                          "wall_seconds",
                          "internal_forces",
                          "element_steps",
                          "element_steps_skipped",
                          "element_steps_resting",
                          "element_steps_per_second",
                          "kinetic",
                          "internal",
                          "hourglass",
                          "bulk_viscosity",
                          "contact",
                          "eroded",
                          "external",
                          "initial_total",
                          "final_total",
                          "balance_error_max",
                          "mass_initial",
                          "mass_remaining",
                          "max_plastic_strain",
                          "pinballs",
                          "pairs_max",
                          "searches",
                          "searches_skipped",
                          "max_penetration_ratio",
                          "in_motion",
                          "balance_error_in_motion_max",
                          "state_hash"}) {
    EXPECT_NE(value_of(summary, key), "") << key;
  }
  EXPECT_EQ(value_of(summary, "threads"), "2");
  EXPECT_EQ(value_of(summary, "elements"), "128");
  EXPECT_NEAR(std::stod(value_of(summary, "end_time")), 2e-4, 1e-15);

  std::istringstream history(result("history.csv"));
  std::string line;
  std::size_t rows = 0, columns = 0;
  while (std::getline(history, line)) {
    if (line.starts_with('#')) continue;
    const auto commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
    if (columns == 0) columns = commas;
    EXPECT_EQ(commas, columns);
    EXPECT_THAT(line, Not(HasSubstr("nan")));
    ++rows;
  }
  EXPECT_GT(rows, 50);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/fields.pvd"));  // nobody asks for fields

  EXPECT_EQ(run("run two_blocks --threads 1" + out()).status, 0);
  EXPECT_EQ(value_of(result("summary.json"), "state_hash"), value_of(summary, "state_hash"));
  EXPECT_EQ(run("run two_blocks --precision float --set time.steps=7" + out()).status, 0);
  EXPECT_EQ(value_of(result("summary.json"), "steps"), "7");
  EXPECT_EQ(value_of(result("summary.json"), "precision"), "\"float\"");
}

TEST_F(Program, FieldsAreWrittenAtTheirTimesAlsoAtTheEnd) {
  for (const char* end : {"1e-4", "1.7e-4", "0.9999e-4"}) {
    const Finished f = run("run two_blocks --set time.end=" + std::string(end) +
                           " --set output.field_interval=0 --set 'output.field_times=[0, 5e-5, " + end + "]'" + out());
    EXPECT_EQ(f.status, 0) << f.text;
    const std::string list = result("fields.pvd");
    for (const char* name : {"fields_0000.vtu", "fields_0001.vtu", "fields_0002.vtu"}) {
      EXPECT_THAT(list, HasSubstr(name)) << end;
      EXPECT_THAT(result(name), HasSubstr("</VTKFile>"));
    }
    EXPECT_THAT(list, Not(HasSubstr("fields_0003.vtu")));
  }
}

TEST_F(Program, IntervalsThatTimeCannotCountAreThoseOfSteps) {
  const Finished f = run("run two_blocks --set time.steps=3 --set output.field_interval=1e-300" + out());
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(result("fields.pvd"), HasSubstr("fields_0002.vtu"));
}

TEST_F(Program, InfoListsPartsAndSetsOfMeshFilesAndVolumes) {
  const std::string mesh = PINBALL_SOURCE_DIR "/tests/data/exodus/two_blocks.g";
  const Finished info = run(
      "info " + scene(test::replaced(cube_scene, R"({ type = "block", size = [0.1, 0.1, 0.1], elements = [1, 1, 1] })",
                                     R"({ type = "file", file = ")" + mesh + R"(", scale = 0.1 })")));
  EXPECT_EQ(info.status, 0) << info.text;
  for (const char* text : {"volume 0.0025 m^3", "parts, with their elements: left (10): 2, right (20): 1",
                           "sets of nodes, with their nodes: ends (1): 8, roof (7): 4, bottom (1): 4, 2: 1",
                           "sets of faces, with their faces: ends (1): 2, roof (7): 1",
                           "block 15 (skin) has 1 element of type SHELL4 with 4 nodes: left out"}) {
    EXPECT_THAT(info.text, HasSubstr(text));
  }
}

TEST_F(Program, InfoTellsWhatRunsAndWhatIsSkipped) {
  const Finished rod = run("info rod_plate");
  EXPECT_EQ(rod.status, 0) << rod.text;
  for (const char* text : {"rod: 414 elements", "plate: 1428 elements", "plasticity", "erosion at plastic strain 2",
                           "pinballs on", "lbf s^2/in^4", "bytes per element", "first step", "run time", "thread",
                           "plane of symmetry", "stresses and forces of 1842 elements", "contact of 160 elements",
                           "search of most steps", "update of the pinball radii"}) {
    EXPECT_THAT(rod.text, HasSubstr(text));
  }
  const Finished blocks = run("info two_blocks --set contact.method=none --set output.field_interval=0 --threads 1");
  EXPECT_EQ(blocks.status, 0) << blocks.text;
  for (const char* text : {"contact: off in the scene", "bulk viscosity: off in the scene", "plasticity of steel",
                           "plastic strain array: no material is plastic", "viscous stress array: no bulk viscosity",
                           "memory of these arrays: 24 bytes per element", "field output", "1 thread"}) {
    EXPECT_THAT(blocks.text, HasSubstr(text));
  }
  EXPECT_EQ(run("info two_blocks --precision float --refine 2").status, 0);
  // Boxes wider by an element of 0.025 m each, which near each other at 40 m/s.
  EXPECT_THAT(run("info two_blocks --set body.upper.position=[0,0,0.35]").text,
              HasSubstr("pairs of lower and upper: not listed or tested as long as they cannot meet, until 0.005 s"));
  EXPECT_THAT(run("info two_blocks --set body.upper.position=[0.5,0,0.1065]").text,
              HasSubstr("pairs of lower and upper: not listed or tested as long as they do not near each other"));
  EXPECT_THAT(run("info rod_plate --set skip.resting=false").text, Not(HasSubstr("stresses and forces of")));
  const std::string limits = run("info two_blocks --set material.steel.erosion.tension=1e9 "
                                 "--set material.steel.erosion.step_share=0.1")
                                 .text;
  EXPECT_THAT(limits,
              testing::AllOf(HasSubstr("eroded beyond: mean stress 1e+09 Pa, stable step below 0.1 of the smallest"),
                             HasSubstr("elasticity, erosion beyond limits")));
}

TEST_F(Program, VerifyPassesAndWritesItsTable) {
  const Finished f = run("verify patch_test two_blocks --json " + (folder_ / "table.json"));
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("pass"));
  EXPECT_THAT(f.text, Not(HasSubstr("FAIL")));
  const std::string table = content(folder_ / "table.json");
  for (const char* key : {"scene", "quantity", "value", "reference", "source", "error", "tolerance", "pass"}) {
    EXPECT_NE(value_of(table, key), "") << key;
  }
}

TEST_F(Program, VerifyFailsWhereAnAnswerIsWrong) {
  // Other scenes of the same name: twice the time gives twice the strain.
  std::filesystem::create_directories(folder_ / "scenes");
  std::string text = content(std::string(PINBALL_SOURCE_DIR) + "/data/scenes/patch_test.toml");
  text.replace(text.find("end = 1.0"), 9, "end = 2.0");
  std::ofstream(folder_ / "scenes/patch_test.toml") << text;
  ::setenv("PINBALL_DATA", folder_.path.c_str(), 1);
  const Finished f = run("verify patch_test");
  ::unsetenv("PINBALL_DATA");
  EXPECT_EQ(f.status, 1) << f.text;
  EXPECT_THAT(f.text, HasSubstr("FAIL"));
}

TEST_F(Program, VerifyListsTheScenesItKnows) {
  const Finished f = run("verify two_block");
  EXPECT_EQ(f.status, 2);
  EXPECT_THAT(f.text, HasSubstr("nearest is two_blocks"));
  EXPECT_THAT(f.text, HasSubstr("spinning_block"));
}

}  // namespace
}  // namespace pinball::run_test
