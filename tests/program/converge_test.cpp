#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <solver/program/study/convergence_report.hpp>
#include <solver/program/study/run_results.hpp>
#include <tests/program/converge_case.hpp>

/// What a study says, which of its runs it makes, and what it refuses.
namespace pinball::converge_test {
namespace {

using test::content;
using test::Converge;
using test::Finished;
using test::Json;
using test::run;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

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
  ASSERT_EQ(converge("--quiet --only mesh --meshes 1,2,3 --of energy.kinetic").status, 0);
  const std::string twice = (folder_ / "twice").string();
  ASSERT_EQ(run(fmt::format("run {} --quiet --threads 1 --refine 2 --out {}", scene(), twice)).status, 0);
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
  const Finished first = converge("--only mesh --meshes 1/2,1,3/2");
  EXPECT_THAT(first.text, HasSubstr("runs: mesh 1 of 3, elements 1/2 times: bar: elements 1 x 1 x 2"));
  EXPECT_THAT(were_there(), ElementsAre(false, false, false));
  const Json quantities = json()["quantities"];
  EXPECT_THAT(converge("--only mesh --meshes 1/2,1,3/2").text, HasSubstr("is there: mesh 1 of 3"));
  EXPECT_THAT(were_there(), ElementsAre(true, true, true));
  EXPECT_EQ(json()["quantities"], quantities);

  EXPECT_EQ(converge("--quiet --only mesh --meshes 1/2,1,2").status, 0);
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

  // Another run in the folder of one leaves results that are none of the study.
  ASSERT_EQ(run(fmt::format("run {} --quiet --threads 1 --out {}/mesh_1", scene(), out())).status, 0);
  EXPECT_EQ(converge(coarse).status, 0);
  EXPECT_THAT(were_there(), ElementsAre(true, false, true));
  const std::string steps = "--set time.steps=3 --out " + out() + "/mesh_3_2";
  ASSERT_EQ(run(fmt::format("run {} --quiet --threads 1 {}", scene(), steps)).status, 0);
  EXPECT_EQ(converge(coarse).status, 0);
  EXPECT_THAT(were_there(), ElementsAre(true, true, false));
  EXPECT_EQ(json()["quantities"], quantities);
}

/// An ensemble goes side by side where there are threads, with the bits that its runs have one after the other.
TEST_F(Converge, AnEnsembleHasTheSameBitsSideBySide) {
  const std::string options = " --quiet --only chance --ensemble 5 --meshes 1/2,1,3/2 --of energy.internal";
  ASSERT_EQ(converge(options).status, 0);
  const Json alone = of(json(), "energy.internal");
  ASSERT_GT(alone["moved_by"]["chance"], 0);
  std::filesystem::remove_all(out());
  ASSERT_EQ(
      run(fmt::format("converge {} --threads 3 --out {} --json {} {}", scene(), out(), json_file(), options)).status,
      0);
  EXPECT_EQ(of(json(), "energy.internal"), alone);
}

TEST_F(Converge, SaysApartWhatStepPrecisionHourglassAndChanceDo) {
  const std::string quantity = "tail_displacement_z:min";
  const Finished f = converge("--quiet --ensemble 3 --meshes 1/2,1,3/2 --of " + quantity);
  ASSERT_EQ(f.status, 0) << f.text;
  const Json table = json(), moved = of(table, quantity)["moved_by"];
  EXPECT_EQ(table["sources_mesh"], "1");
  std::vector<std::string> names;
  const double base = of(table, quantity)["values"][1];
  for (const Json& source : table["sources"]) {
    names.push_back(source["name"]);
    std::vector<double> values;
    for (const Json& run : source["runs"]) values.push_back(read_run_results(run["folder"]).value(quantity).value());
    if (names.back() != "chance") {
      ASSERT_EQ(values.size(), 1);
      EXPECT_EQ(moved[names.back()], values[0] - base);
      continue;
    }
    ASSERT_EQ(values.size(), 3);
    const double mean = (base + values[0] + values[1] + values[2]) / 4;
    EXPECT_NEAR(of(table, quantity)["mean_of_chance"], mean, 1e-15);
    double squares = (base - mean) * (base - mean);
    for (const double value : values) squares += (value - mean) * (value - mean);
    EXPECT_NEAR(moved["chance"], std::sqrt(squares / 3), 1e-15);
    EXPECT_GT(moved["chance"], 0);
    EXPECT_LT(moved["chance"], 1e-8 * std::abs(base));  // nothing here is chaotic
  }
  EXPECT_THAT(names, ElementsAre("time step", "float", "mixed", "hourglass viscous", "hourglass stiffness", "chance"));
  EXPECT_LT(std::abs(moved["float"].get<double>()), 1e-4 * std::abs(base));
  EXPECT_FALSE(of(table, quantity)["chance_rules"]);
  EXPECT_THAT(f.text, HasSubstr("the largest source of error is: "));
  EXPECT_THAT(f.text, HasSubstr("time step: time.cfl = 0.45"));

  const std::string folder = (folder_ / "run").string();
  const auto expect_run = [&](const std::string& name, const std::string& options) {
    ASSERT_EQ(run(fmt::format("run {} --quiet --threads 1 --out {} {}", scene(), folder, options)).status, 0);
    EXPECT_EQ(hash(out() + "/mesh_1_" + name), hash(folder));
  };
  expect_run("half_step", "--set time.cfl=0.45");
  expect_run("float", "--precision float");
  expect_run("mixed", "--precision mixed");
  expect_run("hourglass_viscous", "--set element.hourglass=viscous");
  expect_run("chance_2", "--set body.bar.velocity_noise=2e-8");
}

/// Distances of curves from the extrapolated one fall as the numbers do, and the sources are distances, too.
TEST_F(Converge, CurvesAndLengthsAreQuantities) {
  write_scene("type = \"block\", size = [1, 1, 2], elements = [2, 2, 4]",
              "[[probe]]\nname = \"top\"\npoint = [0, 0, 2]\nquantities = [\"position\"]\n"
              "[[probe]]\nname = \"foot\"\npoint = [0, 0, 0]\nquantities = [\"position\"]\n");
  const Finished f = converge(
      "--quiet --set output.interval=step --meshes 2,3,4,6 --only step --only chance --ensemble 1 "
      "--of bar_velocity_z:curve --of 'length(top,foot):min' --of 'length(top,foot):curve'");
  ASSERT_EQ(f.status, 0) << f.text;
  const Json table = json(), velocity = of(table, "bar_velocity_z:curve"), length = of(table, "length(top,foot):min");
  EXPECT_EQ(length["unit"], "mm");
  EXPECT_GT(length["values"][3], 1.9);
  EXPECT_LT(length["values"][3], 2);
  ASSERT_FALSE(velocity["band"].is_null()) << f.text;
  EXPECT_EQ(velocity["extrapolated"], 0);
  EXPECT_EQ(velocity["band"][0], 0);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(velocity["values"][i], velocity["values"][i - 1]);
  EXPECT_LE(velocity["values"][3], velocity["band"][1]);
  const RunResults fine = read_run_results(table["meshes"][3]["folder"]),
                   half = read_run_results(table["sources"][0]["runs"][0]["folder"]),
                   base = read_run_results(table["meshes"][0]["folder"]);
  const auto curve = [](const RunResults& run) { return run.curve("bar_velocity_z:curve").value(); };
  EXPECT_NEAR(velocity["moved_by"]["time step"], distance(curve(half), curve(base)), 1e-12);
  EXPECT_NEAR(velocity["scale"], norm(curve(fine)), 0.05 * norm(curve(fine)));
  EXPECT_NEAR(velocity["values"][0], distance(curve(fine), curve(base)), 1.5 * velocity["values"][3].get<double>());
  EXPECT_NEAR(table["points"][0]["errors"][0], velocity["values"][0].get<double>() / velocity["scale"].get<double>(),
              1e-12);
}

/// Bands that are kept are those of the same scene: a run of it has them, one with another key has not.
TEST_F(Converge, KeptBandsAreInTheResultsOfTheSceneAlone) {
  const std::string kept = (folder_ / "bar.converged.json").string(), folder = (folder_ / "run").string();
  const auto run_scene = [&](const std::string& options) {
    const Finished f = run(fmt::format("run {} --threads 1 --out {} {}", scene(), folder, options));
    EXPECT_EQ(f.status, 0) << f.text;
    return f.text;
  };
  const auto summary = [&folder] { return Json::parse(content(folder + "/summary.json")); };
  run_scene("--quiet");
  const Json before = summary();
  EXPECT_FALSE(before.contains("converged"));
  EXPECT_THAT(content(folder + "/index.html"), HasSubstr("id=\"converged\">null<"));
  ASSERT_EQ(converge(std::string(coarse) + "--of bar_velocity_z --of energy.internal --keep").status, 0);
  const Json velocity = of(json(), "bar_velocity_z");
  ASSERT_TRUE(of(json(), "energy.internal")["band"].is_null());  // has none to show

  EXPECT_THAT(run_scene(""),
              HasSubstr("  bar_velocity_z [mm/ms]: 8.09133 +- 0.99, with finer meshes 7.59851 .. 9.08594\n"));
  const Json after = summary();
  ASSERT_EQ(after["converged"].size(), 1);
  EXPECT_EQ(after["converged"][0]["name"], "bar_velocity_z");
  EXPECT_EQ(after["converged"][0]["value"], velocity["values"][1]);
  EXPECT_EQ(after["converged"][0]["value"], read_run_results(folder).value("bar_velocity_z"));
  EXPECT_EQ(after["converged"][0]["error"], velocity["together"]);
  EXPECT_EQ(after["converged"][0]["low"], velocity["band"][0]);
  EXPECT_EQ(after["converged"][0]["high"], velocity["band"][1]);
  EXPECT_EQ(after["state_hash"], before["state_hash"]);
  EXPECT_THAT(content(folder + "/index.html"), HasSubstr("id=\"converged\">[{"));
  for (const auto& [key, value] : before.items()) EXPECT_TRUE(after.contains(key)) << key;

  EXPECT_THAT(run_scene("--set time.cfl=0.5"), HasSubstr(kept + " is of other settings"));
  EXPECT_FALSE(summary().contains("converged"));
  EXPECT_THAT(run_scene("--set output.field_interval=1e-3"), HasSubstr("with finer meshes"));  // fields change nothing
  const Json sound = Json::parse(content(kept));
  Json number = sound, word = sound, list = sound;
  number["settings"] = 1;
  word["quantities"][0]["value"] = "much";
  list["quantities"] = {1, 2};
  for (const std::string& text : {std::string("["), number.dump(), word.dump(), list.dump()}) {
    std::ofstream(kept) << text;
    EXPECT_THAT(run_scene(""), HasSubstr(kept + " is no file of bands")) << text;
  }
}

/// What a search says is what its runs say: nothing that it made reaches the error in less time.
TEST_F(Converge, AnErrorIsReachedByTheFastestOfTheRuns) {
  const std::string quantity = "bar_velocity_z";
  const Finished f = converge("--quiet --ensemble 1 --meshes 1,2,3 --error 2% --of " + quantity);
  ASSERT_EQ(f.status, 0) << f.text;
  const Json table = json(), found = table["costs"][0]["cheapest"];
  EXPECT_EQ(table["error"], 0.02);
  EXPECT_EQ(table["budget_seconds"], 600);
  ASSERT_FALSE(found.is_null()) << f.text;
  const Json best = table["points"][found.get<std::size_t>()];
  EXPECT_LE(best["errors"][0], 0.02);
  EXPECT_GT(table["points"].size(), 3 + 5) << "no run beyond those that were asked for";
  for (const Json& point : table["points"]) {
    const bool finer_fails = std::any_of(table["points"].begin(), table["points"].end(), [&](const Json& other) {
      return other["variation"] == point["variation"] && other["bytes"] > point["bytes"] && other["errors"][0] > 0.02;
    });
    if (point["of_chance"] || finer_fails || point["errors"][0] > 0.02) continue;
    EXPECT_GE(point["seconds"], best["seconds"]) << point["settings"];
  }
  EXPECT_THAT(f.text, HasSubstr("for 2 % of bar_velocity_z [mm/ms] take " + best["settings"].get<std::string>()));
  const double extrapolated = of(table, quantity)["extrapolated"];
  const double value = of(table, quantity)["values"][0];
  EXPECT_NEAR(table["points"][0]["errors"][0], std::abs(value / extrapolated - 1), 1e-9);

  // The search goes the same way again, over the runs that are there.
  const Finished again = converge("--ensemble 1 --meshes 1,2,3 --error 2% --of " + quantity);
  EXPECT_THAT(again.text, Not(HasSubstr("runs: ")));
  EXPECT_EQ(json()["points"], table["points"]);
}

TEST_F(Converge, WhatDoesNotFitIntoTheBudgetIsLeftOut) {
  const Finished f = converge("--quiet --only mesh --meshes 1,2,3,256 --budget 2s --of energy.kinetic");
  ASSERT_EQ(f.status, 0) << f.text;
  const Json table = json();
  const Json last = table["meshes"].back();
  EXPECT_EQ(last["factor"], "256");
  EXPECT_THAT(last["left_out"].get<std::string>(), HasSubstr("of the budget are left"));
  EXPECT_TRUE(last["failure"].is_null());
  EXPECT_FALSE(std::filesystem::exists(out() + "/mesh_256"));
  EXPECT_THAT(f.text, HasSubstr("mesh 256 left out: it is expected to take "));
  EXPECT_THAT(f.text, HasSubstr("in 2 s the finest mesh is "));
}

/// Meshes as fine as the time is enough for, each at most twice as fine as the one before.
TEST_F(Converge, WhatIsLeftOfABudgetGoesIntoFinerMeshes) {
  const Finished f = converge("--quiet --only mesh --meshes 1/2,1,3/2 --budget 1.5s --of energy.kinetic");
  ASSERT_EQ(f.status, 0) << f.text;
  const Json table = json();
  ASSERT_GT(table["meshes"].size(), 3) << f.text;
  double seconds = 0;
  for (const Json& mesh : table["meshes"]) {
    if (mesh["left_out"].is_null()) seconds += mesh["wall_seconds"].get<double>();
  }
  EXPECT_LT(seconds, 1.5 * 1.5);
  EXPECT_EQ(table["meshes"][3]["factor"], "3");
}

TEST_F(Converge, OnlyNamesWhatIsLookedAt) {
  EXPECT_EQ(converge("--quiet --meshes 1/2,1,3/2 --only step --of energy.kinetic").status, 0);
  ASSERT_EQ(json()["sources"].size(), 1);
  EXPECT_EQ(json()["sources"][0]["name"], "time step");
  EXPECT_EQ(converge(coarse).status, 0);
  EXPECT_EQ(json()["sources"].size(), 0);
  EXPECT_TRUE(of(json(), "energy.kinetic")["moved_by"].is_null());
}

/// A run with one body of finer elements is that of the scene with these counts.
TEST_F(Converge, RunsThatFailAreNamed) {
  const Finished f = converge(std::string(coarse) + "--set guard.energy_error=1e-12");
  EXPECT_EQ(f.status, 1) << f.text;
  EXPECT_THAT(f.text, HasSubstr("mesh 1/2 failed: the energy balance is off by"));
  EXPECT_THAT(f.text, HasSubstr("no run came to its end"));
  EXPECT_THAT(json()["meshes"][0]["failure"].get<std::string>(), HasSubstr("energy balance"));
  EXPECT_FALSE(std::filesystem::exists(out() + "/mesh_1/study_settings.txt"));
}

/// A run whose history is a folder cannot write it.
TEST_F(Converge, TheOthersCountWhereARunFails) {
  const std::string of_kinetic = "--quiet --of energy.kinetic --only step --meshes ";
  ASSERT_EQ(converge(of_kinetic + "1/2,1,2").status, 0);
  const Json whole = of(json(), "energy.kinetic");
  std::filesystem::create_directories(out() + "/mesh_3_2/history.csv");
  const Finished four = converge(of_kinetic + "1/2,1,3/2,2");
  EXPECT_EQ(four.status, 1) << four.text;
  EXPECT_THAT(four.text, HasSubstr("mesh 3/2 failed: "));
  const Json of_three = of(json(), "energy.kinetic");
  EXPECT_TRUE(of_three["values"][2].is_null());
  for (const char* key : {"verdict", "observed_order", "band", "spread", "own_error", "moved_by"}) {
    EXPECT_EQ(of_three[key], whole[key]) << key;
  }

  EXPECT_EQ(converge(of_kinetic + "1/2,1,3/2").status, 1);
  const Json of_two = of(json(), "energy.kinetic");
  EXPECT_TRUE(of_two["verdict"].is_null());
  EXPECT_TRUE(of_two["moved_by"]["mesh"].is_null());
  EXPECT_EQ(of_two["moved_by"]["time step"], whole["moved_by"]["time step"]);
  EXPECT_EQ(of_two["largest_source"], "time step");
}

TEST_F(Converge, ASceneInWhichNothingHappensSaysSo) {
  const Finished f = converge(std::string(coarse) + "--set body.bar.velocity=[0,0,0] --set time.end=1e-3");
  EXPECT_EQ(f.status, 0);
  EXPECT_THAT(f.text, HasSubstr("are all zero; --of names other quantities"));
}

TEST_F(Converge, BadInputEndsWithTwoBeforeAnythingRuns) {
  const auto expect_bad = [this](const std::string& options, const std::string& message) {
    test::expect_bad_input(command("--quiet " + options), message);
  };
  expect_bad("--meshes 1,2", "--meshes 1,2: expected three");
  expect_bad("--meshes 1/4,1,2", "body.bar.mesh.elements: expected a number that 1/4 times leaves whole, got 2");
  expect_bad("--set time.steps=5", "time.steps = 5: expected none");
  expect_bad("--of", "--of");
  expect_bad("--only luck", "--only");
  expect_bad("--error 1%", "--error: expected --of QUANTITY");
  expect_bad("--error 200% --of energy.kinetic", "--error 200%: expected a part of the value");
  expect_bad("--refine rod=2 --meshes 1,2,3", "--refine rod=2: expected one of the bodies, nearest is bar");
  expect_bad("--refine bar=1", "--refine bar=1: expected a number, or BODY=K");
  expect_bad("--budget soon", "--budget soon: expected a time above 0");
  expect_bad("--of tail_displacement", "--of tail_displacement: expected a column");
  expect_bad("--of energy.kinetic --of enrgy.total", "nearest is ");
  expect_bad("--of bar_velocity_z:mean", "--of bar_velocity_z:mean: expected a column");
  EXPECT_FALSE(std::filesystem::exists(out()));
  EXPECT_EQ(run("converge").status, 2);
  test::expect_bad_input("converge crushed_tube --quiet --meshes 1/2,1,2 --out " + out(),
                         "body.tube.mesh.file: expected factors 1, 2, 4, ..., got 1/2");
}

}  // namespace
}  // namespace pinball::converge_test
