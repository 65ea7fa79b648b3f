#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include <solver/base/error.hpp>
#include <solver/program/others/beside_report.hpp>
#include <solver/program/others/curve_difference.hpp>
#include <solver/program/others/other_history.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

#include "other_history_case.hpp"

namespace pinball::other_history_test {
namespace {

using Json = nlohmann::json;
using test::Finished;
using test::OtherHistories;
using test::run;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A block as LS-DYNA's glstat has it.
std::string glstat_block(double time, double kinetic, double internal) {
  return fmt::format(
      " dt of cycle       1 is controlled by solid          1 of part         1\n\n"
      " time...........................   {:.5E}\n time step......................   1.00000E-07\n"
      " kinetic energy.................   {:.5E}\n internal energy................   {:.5E}\n"
      " stonewall energy...............   0.00000E+00\n total energy...................   {:.5E}\n"
      " global x velocity..............   2.00000E+00\n number of nodes................        27\n\n",
      time, kinetic, internal, kinetic + internal);
}

TEST_F(OtherHistories, GlstatIsReadBlockByBlock) {
  const OtherHistory h = read(" Taylor bar       ls-dyna\n\n" + glstat_block(0, 10, 0) + glstat_block(1e-5, 7, 3));
  EXPECT_EQ(h.kind, "glstat of LS-DYNA");
  EXPECT_THAT(h.times, ElementsAre(0, 1e-5));
  EXPECT_THAT(curve(h, "kinetic energy").values, ElementsAre(10, 7));
  EXPECT_THAT(curve(h, "internal energy").values, ElementsAre(0, 3));
  EXPECT_THAT(curve(h, "internal energy").meaning.columns, ElementsAre("internal", "bulk_viscosity", "folding"));
  EXPECT_THAT(curve(h, "total energy").meaning.columns, ElementsAre("total", "external"));
  EXPECT_TRUE(curve(h, "global x velocity").meaning.per_mass);
  EXPECT_THAT(curve(h, "stonewall energy").meaning.columns, ElementsAre());
}

TEST_F(OtherHistories, ARunThatWasTakenUpAgainCountsFromThere) {
  const OtherHistory h =
      read(glstat_block(0, 10, 0) + glstat_block(1, 9, 1) + glstat_block(2, 8, 2) + glstat_block(1, 9.5, 0.5));
  EXPECT_THAT(h.times, ElementsAre(0, 1));
  EXPECT_THAT(curve(h, "kinetic energy").values, ElementsAre(10, 9.5));
}

TEST_F(OtherHistories, ANumberThatDidNotFitIsNone) {
  const OtherHistory h = read("time,kinetic\n0,1\n1,********\n2,1.5D+00\n");
  EXPECT_TRUE(std::isnan(curve(h, "kinetic").values[1]));
  EXPECT_EQ(curve(h, "kinetic").values[2], 1.5);
}

TEST_F(OtherHistories, NodoutIsReadByItsNodesAlsoWhereNumbersTouch) {
  const auto block = [](const char* time, const char* rows) {
    return fmt::format(
        " n o d a l   p r i n t   o u t   f o r   t i m e  s t e p       1              ( at time {} )\n\n"
        " nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl"
        "      z-accl      x-coor      y-coor      z-coor\n{}\n"
        " n o d a l   p r i n t   o u t   f o r   t i m e  s t e p       1              ( at time {} )\n\n"
        " nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot vel\n"
        "        17  9.0000E+00  9.0000E+00  9.0000E+00  9.0000E+00  9.0000E+00  9.0000E+00\n",
        time, rows, time);
  };
  const OtherHistory h = read(block("0.0000000E+00",
                                    "        17  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00 -5.0000E+00"
                                    "  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00") +
                              block("1.0000000E-03",
                                    "        17 1.00000E-03-2.00000E-03-5.00000E-03-1.00000E+00-2.00000E+00-5.00000E+00"
                                    " 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00"));
  EXPECT_EQ(h.kind, "nodout of LS-DYNA");
  EXPECT_THAT(h.times, ElementsAre(0, 1e-3));
  EXPECT_THAT(curve(h, "node_17_displacement_y").values, ElementsAre(0, -2e-3));
  EXPECT_THAT(curve(h, "node_17_velocity_z").values, ElementsAre(-5, -5));
  EXPECT_EQ(h.curves.size(), 6);
}

TEST_F(OtherHistories, TablesOfOpenRadiossAndAbaqusMeanTheSameEnergies) {
  const OtherHistory csv =
      read("\"time\",\"INTERNAL ENERGY\",\"KINETIC ENERGY\",\"X-MOMENTUM\",\"1 IE\",\n0,0,5,1,0,\n1,2,3,1,2,\n");
  EXPECT_EQ(csv.kind, "table");
  EXPECT_THAT(curve(csv, "KINETIC ENERGY").meaning.columns, ElementsAre("kinetic", "kinetic_below_zero"));
  EXPECT_THAT(curve(csv, "X-MOMENTUM").meaning.columns, ElementsAre("momentum_x"));
  EXPECT_THAT(curve(csv, "INTERNAL ENERGY").values, ElementsAre(0, 2));
  const OtherHistory report =
      read("\n      X              ALLKE           ALLIE\n\n  0.   5.   0.\n  1.E-3   3.E+00  2.\n");
  EXPECT_THAT(report.times, ElementsAre(0, 1e-3));
  EXPECT_THAT(curve(report, "ALLIE").meaning.columns, ElementsAre("internal", "hourglass", "folding"));
  EXPECT_THAT(curve(read("time [ms];rod_velocity_x\n0;1\n1;2\n"), "rod_velocity_x").meaning.columns,
              ElementsAre("rod_velocity_x"));
}

TEST_F(OtherHistories, WhatIsNoHistoryIsNamedWithItsLine) {
  EXPECT_THAT(problem("# nothing\n"), HasSubstr("history: expected a history, got an empty file"));
  EXPECT_THAT(problem("a,b\n1,2\n"), HasSubstr("history:1: expected the names of columns, one of them time"));
  EXPECT_THAT(problem("time,a\n0,1\n1,2,3\n4,5\n"), HasSubstr("history:3: expected 2 numbers"));
  EXPECT_THAT(problem("time,a\nx,1\n1,2\n"), HasSubstr("history:2: expected 2 numbers"));
  EXPECT_THAT(problem("time,a\n0,1\n"), HasSubstr("expected two times at least, got 1"));
  EXPECT_THAT(problem(" time.....  soon\n"), HasSubstr("history:1: expected a time, got soon"));
  EXPECT_THAT(problem(std::string("\0\0T01", 5)), HasSubstr("or a T01 file of Radioss, got another binary file"));
  EXPECT_THROW(read_other_history(folder_ / "none"), InputError);
}

/// Texts among numbers, such as those of a decimal comma, were taken for no values, and left out without a word.
TEST_F(OtherHistories, TextsAmongTheNumbersOfAColumnAreNamedWithTheirLine) {
  EXPECT_THAT(problem("time,a,b\n0,1,2\n1,\"3,5\",3\n2,3,4\n"),
              HasSubstr("history:3: column a: expected a number, got '3,5'"));
  EXPECT_THAT(problem("time;a;b\n0;1;9,75\n1;3;3\n"), HasSubstr("history:2: column b: expected a number, got '9,75'"));
  const OtherHistory history = read("time,a,b,step\n0,1,nan,one\n1,n/a,-inf,two\n2,***,4,two\n");
  EXPECT_EQ(curve(history, "a").values[0], 1);
  EXPECT_TRUE(std::isnan(curve(history, "a").values[1]) && std::isnan(curve(history, "a").values[2]));
  EXPECT_TRUE(std::isnan(curve(history, "step").values[0]));
}

/// The last of them counted, without a word.
TEST_F(OtherHistories, ColumnsOfOneNameAreNamedWithTheirLine) {
  EXPECT_THAT(problem("# of two runs\ntime,a,b,a\n0,1,2,3\n1,2,3,4\n"),
              HasSubstr("history:2: expected columns with a name each, columns 2 and 4 are both 'a'"));
  EXPECT_EQ(read("time,,A,a,\n0,0,1,2,\n1,0,3,4,\n").curves.size(), 3);
}

TEST_F(OtherHistories, AFileThatIsStillWrittenEndsWithItsLastWholeLine) {
  EXPECT_THAT(read("time,a,b\n0,1,2\n1,2,3\n2,3").times, ElementsAre(0, 1));
}

/// Here 2 t at the times 0, 1, 2; there t, at other times.
Curves two_t() { return {{"time", "kinetic", "kinetic_below_zero"}, {{0, 0, 0}, {1, 2, 0}, {2, 4, 0}}, 3}; }

TEST(CurveDifferences, OfLinesAreThoseOfTheClosedForm) {
  const OtherHistory other{"", "", {0, 0.5, 1.5, 2}, {{"KE", {{"kinetic"}}, {0, 0.5, 1.5, 2}}}};
  const std::vector<CurveDifference> all = curve_differences(two_t(), other, 1);
  ASSERT_EQ(all.size(), 1);
  EXPECT_DOUBLE_EQ(all[0].here, 4);
  EXPECT_DOUBLE_EQ(all[0].there, 2);
  EXPECT_DOUBLE_EQ(*all[0].at_end, 1);
  EXPECT_DOUBLE_EQ(*all[0].largest, 1);
  EXPECT_DOUBLE_EQ(all[0].largest_time, 2);
  EXPECT_DOUBLE_EQ(*all[0].root_mean_square, std::sqrt(4.0 / 3) / 2);  // of t from 0 to 2, over the largest there
}

TEST(CurveDifferences, AreOfTimesThatBothHave) {
  const OtherHistory other{"", "", {-1, 1, 3}, {{"KE", {{"kinetic"}}, {100, 2, 100}}}};
  const std::vector<CurveDifference> all = curve_differences(two_t(), other, 1);
  ASSERT_EQ(all.size(), 1);
  EXPECT_DOUBLE_EQ(all[0].end_time, 1);
  EXPECT_DOUBLE_EQ(all[0].scale, 2);
  EXPECT_DOUBLE_EQ(*all[0].largest, 0);
  const OtherHistory later{"", "", {5, 6}, {{"KE", {{"kinetic"}}, {1, 1}}}};
  EXPECT_TRUE(curve_differences(two_t(), later, 1).empty());
}

TEST(CurveDifferences, OfWhatIsZeroThereAreNone) {
  const OtherHistory other{"", "", {0, 2}, {{"KE", {{"kinetic"}}, {0, 0}}}};
  const std::vector<CurveDifference> all = curve_differences(two_t(), other, 1);
  ASSERT_EQ(all.size(), 1);
  EXPECT_FALSE(all[0].at_end || all[0].largest || all[0].root_mean_square);
}

TEST(CurveDifferences, AVelocityIsAMomentumOverTheMass) {
  EXPECT_THAT(values_of({{"time", "momentum_x"}, {{0, 6}, {1, 12}}, 2}, {{"momentum_x"}, true}, 3), ElementsAre(2, 4));
  EXPECT_THAT(values_of({{"time", "momentum_x"}, {{0, 6}}, 1}, {{"momentum_y"}, true}, 3), ElementsAre());
}

/// What the page draws: of each file what this run has, too, with all its rows and all of the run.
TEST(CurvesBeside, HaveAllRowsOfBoth) {
  VariantRuns variant;
  variant.repeats.emplace_back();
  variant.curves = {{"time", "kinetic"}, {{0, 5}, {1, 6}, {2, 8}}, 3};
  const OtherHistory other{
      "a/b.csv", "table", {0, 0.5, 2}, {{"KE", {{"kinetic"}}, {5, 5.5, 8}}, {"rest", {{"nothing"}}, {1, 2, 3}}}};
  const Json all = Json::parse(beside_curves_json({variant, variant}, {other, other}));
  ASSERT_EQ(all.size(), 2);
  for (const Json& beside : all) {
    EXPECT_EQ(beside["file"], "b.csv");
    EXPECT_EQ(beside["there"]["columns"], (Json{"time", "KE"}));
    EXPECT_EQ(beside["there"]["data"], (Json{{0, 0.5, 2}, {5, 5.5, 8}}));
    ASSERT_EQ(beside["here"].size(), 2);
    for (const Json& here : beside["here"]) EXPECT_EQ(here["data"], (Json{{5, 6, 8}}));
  }
}

TEST_F(OtherHistories, ARunBesideItsOwnHistoryHasNoDifference) {
  const std::string scene = "two_blocks --quiet --threads 1 --set time.end=5e-5 ";
  ASSERT_EQ(run("run " + scene + "--out " + (folder_ / "out")).status, 0);
  const std::string json_file = folder_ / "table.json";
  const Finished f = run("compare " + scene + "--with " + (folder_ / "out/history.csv") + " --json " + json_file);
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("root mean square"));
  EXPECT_THAT(f.text, Not(HasSubstr("first / this: above 1")));
  const Json beside = Json::parse(test::content(json_file))["beside"][0];
  EXPECT_EQ(beside["kind"], "table");
  EXPECT_GT(beside["quantities"].size(), 20);
  for (const Json& quantity : beside["quantities"]) {
    const Json& of_run = quantity["variants"][0];
    EXPECT_EQ(of_run["here"], of_run["there"]) << quantity;
    EXPECT_TRUE(of_run["largest_difference"].is_null() || of_run["largest_difference"] < 1e-12) << quantity;
  }
  EXPECT_TRUE(beside["not_compared"].empty());
}

TEST_F(OtherHistories, WhatHasNoNumberAtTheTimesOfTheRunIsTold) {
  const std::string file = write("late.csv", "time;kinetic;internal;total\n0;1;2,5;nan\n5e-5;2;3,5;nan\n1;2;3,5;7\n");
  const Finished f = run("compare two_blocks --quiet --threads 1 --set time.end=5e-5 --with " + file);
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("not compared: internal, total"));
}

TEST_F(OtherHistories, EachVariantIsComparedAndWhatIsNotIsTold) {
  const std::string file = write("glstat", glstat_block(0, 100, 0) + glstat_block(5e-5, 50, 50));
  const std::string json_file = folder_ / "table.json", page = folder_ / "page.html";
  const Finished f = run("compare two_blocks --quiet --threads 1 --set time.end=5e-5 --vary time.cfl=0.8,0.4 --with " +
                         file + " --json " + json_file + " --page " + page);
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("time.cfl=0.4"));
  EXPECT_THAT(f.text, HasSubstr("not compared: stonewall energy, number of nodes"));
  const Json quantities = Json::parse(test::content(json_file))["beside"][0]["quantities"];
  EXPECT_EQ(quantities[0]["name"], "time step");
  EXPECT_EQ(quantities[0]["variants"].size(), 2);
  EXPECT_THAT(test::content(page), HasSubstr("\"file\":\"glstat\""));
  test::expect_bad_input("compare two_blocks --with " + (folder_ / "none"), "cannot be read");
}

}  // namespace
}  // namespace pinball::other_history_test
