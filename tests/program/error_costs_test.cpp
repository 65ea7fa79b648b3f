#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/base/error.hpp>
#include <solver/program/study/costs/cost_report.hpp>

namespace pinball::error_costs_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

StudyRun run_of(double value, double seconds, double elements) {
  StudyRun run;
  run.results = RunResults{};
  run.results->status = "done";
  run.results->numbers = {{"q", value}, {"wall_seconds", seconds}, {"elements", elements}, {"bytes_per_element", 400}};
  return run;
}

/// Values 1 + 0.1 h^2 on meshes of h = 2, 1 and 1/2, with one source that errs less and one of chance.
ConvergenceStudy study_of(double chance = 1e-4) {
  ConvergenceStudy study;
  study.scene = "scene";
  study.meshes = {{{1, 2}, "bar: 4", run_of(1.4, 0.1, 8)},
                  {{1, 1}, "bar: 8", run_of(1.1, 1, 64)},
                  {{2, 1}, "bar: 16", run_of(1.025, 16, 512)}};
  study.sources_mesh = 1;
  study.sources = {{ErrorSource::hourglass, "viscous", "hourglass = \"viscous\"", {run_of(1.02, 0.7, 64)}},
                   {ErrorSource::chance, "chance", "4 runs", {run_of(1.0, 0.9, 64)}}};
  StudyQuantity quantity{"q", "mm", {1.4, 1.1, 1.025}, 1.4, {}, {-0.08, chance}, 1.1};
  quantity.convergence = grid_convergence({{2, 1.4}, {1, 1.1}, {0.5, 1.025}});
  study.quantities = {quantity};
  return study;
}

TEST(ErrorCosts, ErrorsAreAgainstTheExtrapolatedValue) {
  const auto points = cost_points(study_of());
  ASSERT_EQ(points.size(), 5);
  EXPECT_NEAR(points[0].errors[0].value(), 0.4, 1e-12);
  EXPECT_NEAR(points[2].errors[0].value(), 0.025, 1e-12);
  EXPECT_NEAR(points[3].errors[0].value(), 0.02, 1e-12);
  EXPECT_EQ(points[3].settings, "mesh 1, viscous");
  EXPECT_EQ(points[3].what, "bar: 8; hourglass = \"viscous\"");
  EXPECT_EQ(points[2].seconds, 16);
  EXPECT_EQ(points[2].bytes, 512 * 400);
}

TEST(ErrorCosts, TheFrontierHasWhatNothingElseBeats) {
  const ConvergenceStudy study = study_of();
  const auto points = cost_points(study);
  EXPECT_THAT(frontier(points, 0), ElementsAre(0, 3));  // it is both faster and better than meshes 1 and 2
  EXPECT_EQ(cheapest(points, {0}, 0.5), 0);
  EXPECT_EQ(cheapest(points, {0}, 0.1), 3);
  EXPECT_FALSE(cheapest(points, {0}, 0.01));  // that chance hits the value is not for anyone to choose
}

TEST(ErrorCosts, ACoarseMeshThatIsRightByChanceDoesNotCount) {
  ConvergenceStudy study = study_of();
  study.meshes[0].run = run_of(1.0001, 0.1, 8);
  const auto points = cost_points(study);
  EXPECT_NEAR(points[0].errors[0].value(), 1e-4, 1e-9);
  EXPECT_NEAR(points[0].held[0].value(), 0.1, 1e-9);
  EXPECT_EQ(cheapest(points, {0}, 0.03), 3);
}

TEST(ErrorCosts, AnotherPrecisionIsNoBetterThanItsMesh) {
  ConvergenceStudy study = study_of();
  study.sources[0].source = ErrorSource::precision;
  const auto points = cost_points(study);
  EXPECT_NEAR(points[3].errors[0].value(), 0.02, 1e-12);
  EXPECT_NEAR(points[3].held[0].value(), 0.1, 1e-12);
  EXPECT_EQ(cheapest(points, {0}, 0.03), 2);
}

TEST(ErrorCosts, TheWorstOfTheQuantitiesCounts) {
  ConvergenceStudy study = study_of();
  study.quantities.push_back(study.quantities.front());
  study.quantities.back().convergence.reset();
  const auto points = cost_points(study);
  EXPECT_FALSE(cheapest(points, {0, 1}, 0.5));  // of one nothing is known
  EXPECT_FALSE(worst_error(points[0], {0, 1}));
}

TEST(ErrorCosts, WhatCannotBeToldIsChanceOrTheExtrapolatedValue) {
  const KnownTo by_mesh = known_to(study_of(), study_of().quantities[0]).value();
  EXPECT_FALSE(by_mesh.chance);
  EXPECT_NEAR(by_mesh.error, 0.25 * 0.025, 1e-12);  // a quarter of the error of the finest mesh
  const ConvergenceStudy study = study_of(0.05);
  const KnownTo by_chance = known_to(study, study.quantities[0]).value();
  EXPECT_TRUE(by_chance.chance);
  EXPECT_NEAR(by_chance.error, 0.05, 1e-12);
}

TEST(ErrorCosts, SentencesNameSettingsTimeAndMemory) {
  ConvergenceStudy study = study_of();
  EXPECT_EQ(
      cost_sentence(study, cost_points(study), 0),
      "1 % of q [mm]: not reached; the best is mesh 1, viscous: 0.7 s, 25.6 kB, errs by 2 %; what finer meshes say is "
      "known to 0.62 %");
  study.limits.error = 0.1;
  EXPECT_THAT(search_sentence(study),
              HasSubstr("for 10 % of q [mm] take mesh 1, viscous: 0.7 s, 25.6 kB, errs by 2 % (bar: 8; hourglass"));
  study = study_of(0.05);
  EXPECT_EQ(cost_sentence(study, cost_points(study), 0), "1 % of q [mm]: not known; finer than 5 % is chance");
  study.limits.error = 0.02;
  EXPECT_EQ(search_sentence(study), "2 % of q [mm] is not reached: chance alone moves q by 5 %");
}

TEST(StudyLimits, AreReadAsTheyAreWritten) {
  EXPECT_DOUBLE_EQ(parse_error_share("1%"), 0.01);
  EXPECT_DOUBLE_EQ(parse_error_share("0.5 %"), 0.005);
  EXPECT_DOUBLE_EQ(parse_error_share("0.02"), 0.02);
  EXPECT_DOUBLE_EQ(parse_budget("90"), 90);
  EXPECT_DOUBLE_EQ(parse_budget("1.5s"), 1.5);
  EXPECT_DOUBLE_EQ(parse_budget("10min"), 600);
  EXPECT_DOUBLE_EQ(parse_budget("2 h"), 7200);
  for (const char* text : {"", "%", "0", "-1%", "1", "100%", "nan", "1 percent"}) {
    EXPECT_THROW(parse_error_share(text), InputError) << text;
  }
  for (const char* text : {"", "min", "0s", "-5", "10 minutes", "inf", "nan"}) {
    EXPECT_THROW(parse_budget(text), InputError) << text;
  }
}

}  // namespace
}  // namespace pinball::error_costs_test
