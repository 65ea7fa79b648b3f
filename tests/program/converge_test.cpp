#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <solver/program/study/convergence_report.hpp>
#include <solver/program/study/run_results.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/program.hpp>

/// The command from outside, with a block of a few elements that meets a wall.
namespace pinball {
namespace {

using Json = nlohmann::json;
using test::content;
using test::Finished;
using test::run;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Converge : public test::FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    write_scene("type = \"block\", size = [1, 1, 2], elements = [2, 2, 4]");
  }
  void write_scene(const std::string& mesh, const std::string& more = "") const {
    std::ofstream(scene()) << "units = \"g-mm-ms\"\n"
                              "[time]\nend = 4e-3\n"
                              "[[material]]\nname = \"m\"\nmodel = \"elastic\"\ndensity = 1e-3\n"
                              "young_modulus = 1e3\npoisson_ratio = 0.25\n"
                              "[[body]]\nname = \"bar\"\nmaterial = \"m\"\nvelocity = [0, 0, -10]\nmesh = { "
                           << mesh
                           << " }\n"
                              "[[rigid_wall]]\nname = \"wall\"\nnormal = [0, 0, 1]\n"
                              "[[probe]]\nname = \"tail\"\npoint = [0, 0, 2]\nquantities = [\"displacement\"]\n"
                           << more;
  }
  std::string scene() const { return (folder_ / "bar.toml").string(); }
  std::string out() const { return (folder_ / "out").string(); }
  std::string json_file() const { return (folder_ / "table.json").string(); }
  Finished converge(const std::string& options) const {
    return run(fmt::format("converge {} --threads 1 --out {} --json {} {}", scene(), out(), json_file(), options));
  }
  Json json() const { return Json::parse(content(json_file())); }
  static Json of(const Json& table, const std::string& name) {
    for (const Json& quantity : table["quantities"]) {
      if (quantity["name"] == name) return quantity;
    }
    return nullptr;
  }

  static constexpr const char* coarse = " --quiet --meshes 1/2,1,3/2 ";
};

TEST_F(Converge, SaysWhatTheRunsOnItsMeshesSay) {
  const Finished f = converge(coarse);
  ASSERT_EQ(f.status, 0) << f.text;
  const Json table = json();
  EXPECT_EQ(table["scene"], "bar");
  ASSERT_EQ(table["meshes"].size(), 3);
  EXPECT_EQ(table["meshes"][0]["counts"], "bar: elements 1 x 1 x 2");
  EXPECT_EQ(table["meshes"][2]["counts"], "bar: elements 3 x 3 x 6");
  EXPECT_EQ(table["meshes"][2]["elements"], 54);
  const Json tail = of(table, "tail_displacement_z:min");
  ASSERT_FALSE(tail.is_null()) << f.text;
  EXPECT_EQ(tail["unit"], "mm");
  std::vector<MeshValue> values;
  for (std::size_t i = 0; i < 3; ++i) {
    const RunResults results = read_run_results(table["meshes"][i]["folder"]);
    EXPECT_EQ(results.status, "done");
    EXPECT_EQ(tail["values"][i], results.value("tail_displacement_z:min").value());
    values.push_back({2.0 / static_cast<double>(i + 1), tail["values"][i]});
  }
  const GridConvergence expected = grid_convergence(values);
  EXPECT_EQ(tail["observed_order"].is_null(), !expected.observed_order);
  const char* range = expected.has_band() ? "band" : "spread";
  EXPECT_NEAR(tail[range][0], expected.low, 1e-9);
  EXPECT_NEAR(tail[range][1], expected.high, 1e-9);
  for (const char* text : {"mesh 1/2", "mesh 3/2", "band (or spread)", "error of mesh 1", "energy.kinetic [mJ]",
                           "bar_velocity_z [mm/ms]", "rigid_walls.wall.force_max [N]", "elements 3 x 3 x 6"}) {
    EXPECT_THAT(f.text, HasSubstr(text));
  }
  EXPECT_THAT(f.text, HasSubstr(table["sentence"].get<std::string>()));
  EXPECT_TRUE(of(table, "bar_velocity_x").is_null());  // noise
}

TEST_F(Converge, ItsRunsAreThoseOfTheRunCommand) {
  ASSERT_EQ(converge("--quiet --meshes 1,2,3 --of energy.kinetic").status, 0);
  const std::string twice = (folder_ / "twice").string();
  ASSERT_EQ(run(fmt::format("run {} --quiet --threads 1 --refine 2 --out {}", scene(), twice)).status, 0);
  const auto hash = [](const std::string& folder) {
    return Json::parse(content(folder + "/summary.json"))["state_hash"].get<std::string>();
  };
  EXPECT_EQ(hash(json()["meshes"][1]["folder"]), hash(twice));
  ASSERT_EQ(json()["quantities"].size(), 1);
}

TEST_F(Converge, ARunThatIsThereIsNotMadeAgain) {
  const auto were_there = [this] {
    std::vector<bool> there;
    const Json table = json();
    for (const Json& mesh : table["meshes"]) there.push_back(mesh["was_there"]);
    return there;
  };
  const Finished first = converge("--meshes 1/2,1,3/2");
  EXPECT_THAT(first.text, HasSubstr("runs: mesh 1 of 3, elements 1/2 times: bar: elements 1 x 1 x 2"));
  EXPECT_THAT(were_there(), ElementsAre(false, false, false));
  const Json quantities = json()["quantities"];
  EXPECT_THAT(converge("--meshes 1/2,1,3/2").text, HasSubstr("is there: mesh 1 of 3"));
  EXPECT_THAT(were_there(), ElementsAre(true, true, true));
  EXPECT_EQ(json()["quantities"], quantities);

  EXPECT_EQ(converge("--quiet --meshes 1/2,1,2").status, 0);
  EXPECT_THAT(were_there(), ElementsAre(true, true, false));
  EXPECT_EQ(converge(std::string(coarse) + "--set time.cfl=0.5").status, 0);
  EXPECT_THAT(were_there(), ElementsAre(false, false, false));
  EXPECT_NE(json()["quantities"], quantities);
  EXPECT_EQ(converge(coarse).status, 0);
  EXPECT_THAT(were_there(), ElementsAre(false, false, false));
  EXPECT_EQ(json()["quantities"], quantities);

  std::filesystem::remove(out() + "/mesh_1/history.csv");
  std::ofstream(out() + "/mesh_1_2/summary.json") << "{";
  EXPECT_EQ(converge(coarse).status, 0);
  EXPECT_THAT(were_there(), ElementsAre(false, false, true));
  EXPECT_EQ(json()["quantities"], quantities);
}

TEST_F(Converge, ARunThatFailsIsNamedAndTheOthersCount) {
  const Finished f = converge(std::string(coarse) + "--set guard.energy_error=1e-12");
  EXPECT_EQ(f.status, 1) << f.text;
  EXPECT_THAT(f.text, HasSubstr("mesh 1/2 failed: the energy balance is off by"));
  EXPECT_THAT(f.text, HasSubstr("no run came to its end"));
  EXPECT_THAT(json()["meshes"][0]["failure"].get<std::string>(), HasSubstr("energy balance"));
  EXPECT_FALSE(std::filesystem::exists(out() + "/mesh_1/settings.txt"));
}

TEST_F(Converge, BadInputEndsWithTwoBeforeAnythingRuns) {
  const auto expect_bad = [this](const std::string& options, const std::string& message) {
    const Finished f = converge("--quiet " + options);
    EXPECT_EQ(f.status, 2) << f.text;
    EXPECT_THAT(f.text, HasSubstr(message));
  };
  expect_bad("--meshes 1,2", "--meshes 1,2: expected three");
  expect_bad("--meshes 1/4,1,2", "body.bar.mesh.elements: expected a number that 1/4 times leaves whole, got 2");
  expect_bad("--set time.steps=5", "time.steps = 5: expected none");
  expect_bad("--of", "--of");
  EXPECT_FALSE(std::filesystem::exists(out()));
  expect_bad("--of tail_displacement", "--of tail_displacement: expected a column");
  EXPECT_FALSE(std::filesystem::exists(out() + "/mesh_1"));  // the coarsest has shown it
  EXPECT_EQ(run("converge").status, 2);
  const Finished file = run("converge crushed_tube --quiet --out " + out());
  EXPECT_EQ(file.status, 2);
  EXPECT_THAT(file.text, HasSubstr("those of files are not refined yet"));
}

}  // namespace
}  // namespace pinball
