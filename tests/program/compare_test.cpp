#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <solver/base/error.hpp>
#include <solver/program/comparison_report.hpp>
#include <solver/program/comparison_times.hpp>
#include <solver/recorded_run.hpp>
#include <solver/results/timers.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>
#include <tests/support/solver_case.hpp>

namespace pinball::compare_test {
namespace {

using Json = nlohmann::json;
using test::Finished;
using test::run;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<Variant> variants_of(const std::string& scene, const std::vector<std::string>& vary,
                                 const SceneOverrides& overrides = {}) {
  return make_variants(read_scene_source(find_scene(scene), overrides), vary);
}

void expect_states_of_single_runs(const std::vector<Variant>& variants) {
  const std::vector<VariantRuns> runs = run_comparison(variants, {2, true});
  ASSERT_EQ(runs.size(), variants.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].failure, "");
    EXPECT_EQ(runs[i].settings, variants[i].settings);
    ASSERT_EQ(runs[i].repeats.size(), 2);
    const RunSummary single = run_recorded(variants[i].scene, {"", true});
    EXPECT_NO_THROW(check_repeat(name_of(variants[i].settings), single, runs[i].repeats[1]));
    EXPECT_EQ(runs[i].repeats[0].state_hash, single.state_hash) << name_of(variants[i].settings);
    EXPECT_GT(runs[i].repeats[0].wall_seconds, 0);
  }
}

TEST(Comparison, VariantsThatTakeTurnsEndAsSingleRunsDo) {
  expect_states_of_single_runs(
      variants_of("two_blocks", {"contact.enforcement=penalty,projection,lagrange", "precision=double,float"}));
}

TEST(Comparison, ErodingVariantsEndAsSingleRunsDo) {
  expect_states_of_single_runs(
      variants_of("rod_plate", {"contact.enforcement=penalty,projection"}, {.set = {"time.end=8e-6"}}));
}

TEST(Comparison, KeepsCurvesWhereAskedTo) {
  const auto variants =
      variants_of("rod_plate", {"contact.enforcement=penalty,projection"}, {.set = {"time.end=4e-6"}});
  const std::vector<VariantRuns> with = run_comparison(variants, {2, true, true}),
                                 without = run_comparison(variants, {1, true});
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_TRUE(without[i].curves.rows.empty());
    EXPECT_EQ(with[i].repeats[0].state_hash, without[i].repeats[0].state_hash);
    const Curves& curves = with[i].curves;
    EXPECT_THAT(curves.columns, testing::Contains("rod_velocity_x"));
    ASSERT_EQ(static_cast<std::int64_t>(curves.rows.size()), with[i].repeats[0].steps + 1)
        << "a row per step, where steps are longer than a two hundredth of the run";
    for (const std::vector<double>& row : curves.rows) EXPECT_EQ(row.size(), curves.columns.size());
    EXPECT_EQ(curves.rows.front()[1], 0) << "the time of the first step";
    EXPECT_EQ(curves.rows.back()[1], with[i].repeats[0].end_time);
    EXPECT_EQ(curves.rows.back()[3], with[i].repeats[0].energy.kinetic);
  }
}

TEST(Comparison, RespectsTheLimitOfSteps) {
  // Turns of at least four steps: 10 steps are three turns.
  const auto variants = variants_of("two_blocks", {"contact.beta=1,2"}, {.set = {"time.steps=10"}});
  expect_states_of_single_runs(variants);
  for (const VariantRuns& v : run_comparison(variants, {1, true})) EXPECT_EQ(v.repeats[0].steps, 10);
}

TEST(Comparison, StepsOfDifferentLengthsAreNoHindrance) {
  expect_states_of_single_runs(variants_of("two_blocks", {"time.cfl=0.9,0.1", "time.end=2e-4,1e-6"}));
}

TEST(Comparison, CombinesTheValuesOfSeveralKeys) {
  const auto variants = variants_of("two_blocks", {"time.cfl=0.9,0.5", "body.lower.velocity=[0, 0, 1],[0, 0, 2]"});
  ASSERT_EQ(variants.size(), 4);
  EXPECT_THAT(variants[0].settings, ElementsAre("time.cfl=0.9", "body.lower.velocity=[0, 0, 1]"));
  EXPECT_THAT(variants[1].settings, ElementsAre("time.cfl=0.9", "body.lower.velocity=[0, 0, 2]"));
  EXPECT_THAT(variants[2].settings, ElementsAre("time.cfl=0.5", "body.lower.velocity=[0, 0, 1]"));
  EXPECT_EQ(variants[3].scene.time.cfl, 0.5);
  EXPECT_EQ(variants[3].scene.bodies[0].velocity, (Point{0, 0, 2}));
  EXPECT_EQ(name_of(variants[3].settings), "time.cfl=0.5, body.lower.velocity=[0, 0, 2]");
}

TEST(Comparison, CommasInQuotesBelongToTheValue) {
  const auto variants = variants_of("two_blocks", {R"(title="a, b",'c, d',e)"});
  ASSERT_EQ(variants.size(), 3);
  EXPECT_EQ(variants[0].scene.title, "a, b");
  EXPECT_EQ(variants[1].scene.title, "c, d");
  EXPECT_EQ(variants[2].scene.title, "e");
}

TEST(Comparison, ARepeatThatDiffersIsAnError) {
  RunSummary first = run_recorded(variants_of("two_blocks", {"time.steps=3"})[0].scene, {"", true});
  RunSummary again = first;
  again.wall_seconds *= 2;
  again.skipped_seconds.searches += 1;
  again.phases[0].seconds += 1;
  EXPECT_NO_THROW(check_repeat("a=b", first, again));
  again.state_hash ^= 1;
  try {
    check_repeat("a=b", first, again);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a=b"));
    EXPECT_THAT(error.what(), HasSubstr("another result"));
  }
  again = first;
  again.energy.internal = std::nextafter(again.energy.internal, 1e300);
  EXPECT_THROW(check_repeat("a=b", first, again), RunError);
}

/// Runs of these total and contact times [s]; half of the contact is search, the rest in equal parts.
VariantRuns runs_of(const std::vector<double>& totals, const std::vector<double>& contacts) {
  VariantRuns runs{{"key=value"}, {}, {}, ""};
  for (std::size_t i = 0; i < totals.size(); ++i) {
    RunSummary s;
    s.wall_seconds = totals[i];
    for (const char* name : phase_names) s.phases.push_back({name, 0});
    const auto seconds = [&s](Phase phase) -> double& { return s.phases[static_cast<std::size_t>(phase)].seconds; };
    seconds(Phase::internal_forces) = totals[i] - contacts[i];
    seconds(Phase::contact_search) = contacts[i] / 2;
    for (const Phase p : {Phase::pinballs, Phase::contact_forces, Phase::contact_scatter}) seconds(p) = contacts[i] / 6;
    runs.repeats.push_back(s);
  }
  return runs;
}

TEST(ComparisonTimes, MedianSpreadAndShare) {
  const VariantTimes odd = times_of(runs_of({5, 3, 40}, {1, 2, 30}));
  EXPECT_EQ(odd.total.median, 5);
  EXPECT_EQ(odd.total.smallest, 3);
  EXPECT_EQ(odd.total.largest, 40);
  EXPECT_DOUBLE_EQ(odd.contact.median, 2);
  EXPECT_DOUBLE_EQ(odd.search.median, 1);
  EXPECT_DOUBLE_EQ(odd.surface.median, 1.0 / 3);
  EXPECT_DOUBLE_EQ(odd.forces.median, 2.0 / 3);
  EXPECT_DOUBLE_EQ(odd.contact_share, 0.4);
  EXPECT_EQ(times_of(runs_of({4, 2, 8, 6}, {1, 1, 1, 1})).total.median, 5);
  EXPECT_EQ(times_of(runs_of({4}, {0})).contact_share, 0);
}

TEST(ComparisonTimes, RatioAboveOneMeansFasterThanTheFirst) {
  const VariantRuns slow = runs_of({4}, {3}), fast = runs_of({2}, {1});
  EXPECT_DOUBLE_EQ(first_over(slow, fast).total.value(), 2);
  EXPECT_DOUBLE_EQ(first_over(slow, fast).contact.value(), 3);
  EXPECT_DOUBLE_EQ(first_over(fast, slow).total.value(), 0.5);
  EXPECT_FALSE(first_over(slow, runs_of({2}, {0})).contact.has_value());
  VariantRuns failed = fast;
  failed.failure = "energy";
  EXPECT_FALSE(first_over(slow, failed).total.has_value());
  EXPECT_FALSE(first_over(failed, slow).total.has_value());
}

TEST(ComparisonReport, TableAndJsonAgreeWithTheTimesOfTheRepeats) {
  const auto runs = run_comparison(variants_of("two_blocks", {"contact.method=pinball,none"}), {3, true});
  const Json json = Json::parse(comparison_json(runs));
  EXPECT_EQ(json["scene"], "two_blocks");
  EXPECT_EQ(json["repeats"], 3);
  EXPECT_NE(json["machine"]["cpu"], "");
  EXPECT_EQ(json["machine"]["threads"], 1);
  EXPECT_GE(json["machine"]["simd_width"]["double"], 1);
  ASSERT_EQ(json["variants"].size(), 2);
  EXPECT_EQ(json["variants"][1]["settings"]["contact.method"], "none");
  const Json& first = json["variants"][0];
  for (const Json& v : json["variants"]) {
    EXPECT_TRUE(v["failure"].is_null());
    std::vector<double> totals, contacts;
    double in_phases = 0;
    for (const Json& repeat : v["repeats"]) {
      double phases = 0, contact = 0;
      for (const auto& [name, seconds] : repeat["phase_seconds"].items()) {
        EXPECT_GE(seconds.get<double>(), 0);
        phases += seconds.get<double>();
        if (name == "pinballs" || name.starts_with("contact_")) contact += seconds.get<double>();
      }
      totals.push_back(repeat["wall_seconds"]);
      contacts.push_back(contact);
      EXPECT_LE(phases, totals.back());
      in_phases = std::max(in_phases, phases / totals.back());
    }
    ASSERT_EQ(totals.size(), 3);
    EXPECT_GT(in_phases, 0.5);  // a step is hardly more than its phases
    std::sort(totals.begin(), totals.end());
    std::sort(contacts.begin(), contacts.end());
    EXPECT_EQ(v["seconds"]["total"]["median"], totals[1]);
    EXPECT_EQ(v["seconds"]["total"]["min"], totals[0]);
    EXPECT_EQ(v["seconds"]["total"]["max"], totals[2]);
    EXPECT_NEAR(v["seconds"]["contact"]["median"], contacts[1], 1e-12);
    EXPECT_GE(v["contact_share"], 0);
    EXPECT_LE(v["contact_share"], 1);
    EXPECT_DOUBLE_EQ(v["first_over_this"]["total"], first["seconds"]["total"]["median"].get<double>() / totals[1]);
    EXPECT_FALSE(v["summary"].contains("wall_seconds"));
    EXPECT_THAT(comparison_table(runs), HasSubstr(v["summary"]["state_hash"].get<std::string>()));
  }
  EXPECT_GT(first["contact_share"], 0);
  EXPECT_LT(first["momentum_error"], 1e-12);
  EXPECT_EQ(json["variants"][1]["contact_share"], 0);
  EXPECT_TRUE(json["variants"][1]["first_over_this"]["contact"].is_null());
  const std::string table = comparison_table(runs);
  for (const char* text : {"contact.method", "total time, first / this", "1.000", "share of contact",
                           "lower: mass remaining", "upper: exit velocity z [m/s]", "of 3 repeats"}) {
    EXPECT_THAT(table, HasSubstr(text));
  }
  EXPECT_THAT(table, Not(HasSubstr("failed")));
}

class CompareProgram : public testing::Test {
 protected:
  std::string json_file() const { return folder_ / "table.json"; }
  Json json() const { return Json::parse(test::content(json_file())); }

  test::TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
};

TEST_F(CompareProgram, EndsInTheStateOfARun) {
  const std::string limits = " --quiet --threads 1 --set time.end=5e-5 --set 'output.field_times=[0]' ";
  ASSERT_EQ(run("run two_blocks --out " + (folder_ / "out") + limits).status, 0);
  const Json single = Json::parse(test::content(folder_ / "out/summary.json"));
  const Finished f = run("compare two_blocks --vary contact.beta=1,2 --repeat 2 --json " + json_file() + limits);
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("median (smallest..largest) of 2 repeats"));
  const Json summary = json()["variants"][0]["summary"];
  EXPECT_EQ(summary["state_hash"], single["state_hash"]);
  EXPECT_EQ(summary["energy"], single["energy"]);
  EXPECT_EQ(summary["contact"], single["contact"]);
  EXPECT_NE(json()["variants"][1]["summary"]["state_hash"], single["state_hash"]);
}

TEST_F(CompareProgram, DecksAreComparedAsScenesAre) {
  const std::string deck = std::string(PINBALL_SOURCE_DIR) + "/data/decks/taylor_bar.k";
  ASSERT_EQ(run("run " + deck + " --quiet --threads 1 --set time.steps=20 --out " + (folder_ / "out")).status, 0);
  const Json single = Json::parse(test::content(folder_ / "out/summary.json"));
  const Finished f =
      run("compare " + deck + " --vary time.cfl=" + "0.9,0.5 --repeat 1 --threads 1 --set time.steps=20 --json " +
          json_file());
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("as this program understands it"));
  EXPECT_EQ(json()["variants"].size(), 2);
  EXPECT_NE(json()["variants"][0]["summary"]["state_hash"], json()["variants"][1]["summary"]["state_hash"]);
  const Finished beside = run("compare " + deck + " --quiet --threads 1 --set time.steps=20 --with " +
                              (folder_ / "out/history.csv") + " --json " + json_file());
  EXPECT_EQ(beside.status, 0) << beside.text;
  EXPECT_EQ(json()["variants"][0]["summary"]["state_hash"], single["state_hash"]);
}

TEST_F(CompareProgram, WritesNothingButTheTable) {
  const std::string go = "cd " + folder_.path.string() + " && ";
  const std::string arguments =
      "compare two_blocks --quiet --vary contact.beta=1 --repeat 1 --json table.json "
      "--set time.steps=3 --set 'output.field_times=[0]'";
  EXPECT_EQ(std::system((go + PINBALL_PROGRAM + ' ' + arguments + " > /dev/null").c_str()), 0);
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path)) left.push_back(entry.path().filename());
  EXPECT_THAT(left, ElementsAre("table.json"));
}

TEST_F(CompareProgram, BadInputEndsWithTwoAndNamesTheOption) {
  const auto expect_bad = [](const std::string& arguments, const std::string& message) {
    test::expect_bad_input("compare two_blocks --quiet " + arguments, message);
  };
  expect_bad("--vary contact.beta", "--vary contact.beta: expected KEY=V1,V2,...");
  expect_bad("--vary =1,2", "--vary =1,2: expected KEY=V1,V2,...");
  expect_bad("--vary contact.beta=", "--vary contact.beta=: expected KEY=V1,V2,...");
  expect_bad("--vary contact.beta=1,,2", "got an empty value");
  expect_bad("--vary contact.betta=1,2", "--vary contact.betta=1: unknown key, nearest is contact.beta");
  expect_bad("--vary contact.beta=1,-2", "--vary contact.beta=-2: expected a number >= 0");
  expect_bad("--vary body.middle.velocity=[0,0,1]", "--vary body.middle.velocity=[0,0,1]: no body is named");
  expect_bad("--vary contact.enforcement=lagrange,penalty --vary contact.gap=face",
             "(with contact.enforcement=penalty, contact.gap=face)");
  expect_bad("--vary contact.beta=1,2 --vary contact.beta=3", "--vary contact.beta=3: contact.beta is varied");
  expect_bad("--vary precision=float,double --precision float",
             "--vary precision=float,double: expected no --precision");
  expect_bad("--vary body.lower.position='[0,0,0],[1,0,0]' --set 'rigid_wall=[{point=[0.5,0,0],normal=[1,0,0]}]'",
             "behind the plane at the start (with body.lower.position=[0,0,0])");
  expect_bad("--repeat 0", "--repeat");
  expect_bad("--vary", "--vary");
  EXPECT_EQ(run("compare").status, 2);
  EXPECT_EQ(run("compare two_block").status, 2);
}

TEST_F(CompareProgram, ComparesTheTwoMethodsOfContactByDefault) {
  const Finished f = run("compare two_blocks --quiet --repeat 1 --set time.steps=3");
  EXPECT_THAT(f.text, HasSubstr("contact.method"));
  EXPECT_THAT(f.text, HasSubstr("pinball"));
  EXPECT_THAT(f.text, HasSubstr("slideline"));
}

TEST_F(CompareProgram, TellsWhatTheRunsAreWarnedOf) {
  const Finished f = run("compare two_blocks --quiet --repeat 1 --vary 'body.upper.velocity=[0,0,-20],[0,0,-9e4]' " +
                         std::string("--set time.steps=3"));
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("warning: body.upper.velocity=[0,0,-9e4]: "));
  EXPECT_THAT(f.text, Not(HasSubstr("warning: body.upper.velocity=[0,0,-20]: ")));
}

TEST_F(CompareProgram, AVariantThatFailsIsNamedAndTheOthersGoOn) {
  const std::string arguments = "compare two_blocks --quiet --repeat 2 --vary guard.energy_error=1e-9,0.5 --json ";
  const Finished f = run(arguments + json_file());
  EXPECT_EQ(f.status, 1) << f.text;
  EXPECT_THAT(f.text, HasSubstr("FAILED"));
  EXPECT_THAT(f.text, HasSubstr("guard.energy_error=1e-9 failed: the energy balance is off by"));
  EXPECT_THAT(f.text, HasSubstr("in step"));
  const Json failed = json()["variants"][0], done = json()["variants"][1];
  EXPECT_THAT(failed["failure"].get<std::string>(), HasSubstr("energy balance"));
  EXPECT_TRUE(done["failure"].is_null());
  EXPECT_LT(failed["summary"]["end_time"], 2e-4);
  EXPECT_NEAR(done["summary"]["end_time"], 2e-4, 1e-15);
  EXPECT_TRUE(done["first_over_this"]["total"].is_null());
}

}  // namespace
}  // namespace pinball::compare_test
