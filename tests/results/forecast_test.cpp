#include <gtest/gtest.h>

#include <cmath>

#include <solver/results/forecast.hpp>
#include <solver/results/run_outputs.hpp>

/// What a run will take, from made-up first steps: no clock decides anything here.
namespace pinball::forecast_test {
namespace {

Scene scene_of(double yield_stress, double erosion_strain) {
  Scene scene;
  scene.time.end = 1;
  Material material;
  material.density = 1;
  material.plastic = yield_stress > 0;
  material.yield_stress = yield_stress;
  material.erosion_strain = erosion_strain;
  scene.materials.push_back(material);
  return scene;
}

/// Of steps of 1e-3 that take 2 s each, the first `made` of them.
ExpectedRun after(Forecast forecast, std::int64_t made, double at_rest = 0, bool touching = false) {
  for (std::int64_t n = 1; n <= made; ++n) {
    forecast.take({1e-3 * static_cast<double>(n), 1e-3, n, 2.0 * static_cast<double>(n), touching});
  }
  return forecast.expected(at_rest);
}

TEST(Forecast, GoesOnAsTheRunHasBegun) {
  const ExpectedRun run = after(Forecast(scene_of(0, 0), 0, 0), 10);
  EXPECT_NEAR(run.steps, 1000, 1e-6);
  EXPECT_NEAR(run.seconds, 2000, 1e-5);
  EXPECT_NEAR(run.time, 1, 1e-12);
}

TEST(Forecast, HasStepsThatShrinkByWhatAnImpactMakesOfElements) {
  const auto factor = [](double yield_stress, double erosion, double speed) {
    return after(Forecast(scene_of(yield_stress, erosion), speed, 0), 2).steps / 1000;
  };
  EXPECT_NEAR(factor(1, 0, 0), 1, 1e-6) << "no impact";
  EXPECT_NEAR(factor(0, 0, 100), 1, 1e-6) << "elastic";
  EXPECT_NEAR(factor(3.5, 0, 1), std::exp(0.6), 0.02);
  EXPECT_NEAR(factor(1, 0, 100), std::exp(0.6 * 3.72), 0.15) << "the most";
  EXPECT_NEAR(factor(1, 0.5, 100), std::exp(0.6 * 0.5), 0.02) << "eroded before";
}

TEST(Forecast, KnowsEachStrainAtWhichAMaterialErodes) {
  const auto factor = [](const auto& change) {
    Scene scene = scene_of(1, 0);
    change(scene.materials[0]);
    return after(Forecast(scene, 100, 0), 2).steps / 1000;
  };
  const double unlimited = factor([](Material&) {});
  const auto fails = [](Material& m) {
    m.johnson_cook.emplace();
    m.johnson_cook->failure = {0.05, 3.44, -2.12, 0.002, 0.61};  // 1.75 under tension
  };
  EXPECT_NEAR(factor(fails), std::exp(0.6 * 1.747), 0.05);
  EXPECT_NEAR(factor([](Material& m) { m.erosion = {.principal_strain = 0.8}; }), std::exp(0.6 * 0.8), 0.02);
  EXPECT_NEAR(factor([](Material& m) { m.erosion = {.shear_strain = 0.4}; }), std::exp(0.6 * 0.4), 0.02);
  EXPECT_EQ(factor([](Material& m) { m.erosion = {.tension = 1}; }), unlimited);
}

TEST(Forecast, HasElementsThatComeToYield) {
  const ExpectedRun elastic = after(Forecast(scene_of(1e9, 0), 0, 0), 2);
  const ExpectedRun yields = after(Forecast(scene_of(3.5, 0), 1, 0), 2);
  EXPECT_NEAR(yields.seconds / yields.steps, 1.25 * elastic.seconds / elastic.steps, 0.01);
  const ExpectedRun stretched = after(Forecast(scene_of(3.5, 0.5), 0, 0), 2);
  EXPECT_NEAR(stretched.seconds / stretched.steps, elastic.seconds / elastic.steps, 0.01) << "nothing strikes it";
}

TEST(Forecast, TrustsItsLastStepsTheMoreTheFurtherTheRunIs) {
  Forecast forecast(scene_of(1, 0), 100, 0);
  double before = after(forecast, 2).steps;
  for (const std::int64_t made : {100, 300, 500}) {
    const double now = after(forecast, made).steps;
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_NEAR(after(forecast, 700).steps, 1000, 1e-6);
}

TEST(Forecast, StopsWhereTheNumberOfStepsIsBounded) {
  Scene scene = scene_of(0, 0);
  scene.time.steps = 50;
  const ExpectedRun run = after(Forecast(scene, 0, 0), 10);
  EXPECT_NEAR(run.steps, 50, 1e-9);
  EXPECT_NEAR(run.time, 0.05, 1e-9);
  const ExpectedRun whole = after(Forecast(scene, 0, 0), 50);
  EXPECT_EQ(whole.steps, 50);
  EXPECT_EQ(whole.seconds, 100);
  EXPECT_EQ(after(Forecast(scene, 0, 0), 51).steps, 51) << "what is made is made";
}

TEST(Forecast, CountsContactAndElementsThatAreStillToCome) {
  const Forecast inside(scene_of(0, 0), 1, 0), outside(scene_of(0, 0), 1, 1);
  const double without = after(inside, 2).seconds;
  Scene two = scene_of(0, 0);
  two.bodies.resize(2);
  EXPECT_NEAR(after(Forecast(two, 1, 1), 2).seconds, 1.2 * without, 0.01 * without);
  EXPECT_NEAR(after(outside, 2).seconds, 1.7 * without, 0.01 * without);
  EXPECT_NEAR(after(outside, 2, 0, true).seconds, without, 1e-6) << "it is there";
  EXPECT_NEAR(after(Forecast(scene_of(0, 0), 0, 1), 2).seconds, without, 1e-6) << "nothing is expected to meet";
  EXPECT_GT(after(inside, 2, 0.5).seconds, 1.4 * without) << "half of what rests wakes";
  EXPECT_NEAR(after(inside, 200, 0.5).seconds, after(inside, 200).seconds, 1e-6) << "what rests now will rest";
}

TEST(Forecast, LeavesOutWhatOnlyABeginningHas) {
  StepPhases phases;
  EXPECT_EQ(phases.settled(1.5), 1.5) << "nothing is known";
  phases = {.elements = 6, .searches = 0, .impulses = 0, .others = 2};
  EXPECT_DOUBLE_EQ(phases.settled(1), 1);
  EXPECT_DOUBLE_EQ(phases.settled(1.5), 11.0 / 8) << "elements alone wake";
  phases = {.elements = 6, .searches = 4, .impulses = 0, .others = 0, .steps = 20, .lists = 4};
  EXPECT_DOUBLE_EQ(phases.settled(1), 0.7) << "one list in 20 steps";
  phases.lists = 1;
  EXPECT_DOUBLE_EQ(phases.settled(1), 1);
  phases = {.elements = 6, .searches = 0, .impulses = 4, .others = 0, .touching = false};
  EXPECT_DOUBLE_EQ(phases.settled(1), 0.7) << "first lists are long";
  phases = {
      .elements = 6, .searches = 0, .impulses = 0, .others = 0, .steps = 10, .lists = 0, .iterations = 0, .of_list = 4};
  EXPECT_DOUBLE_EQ(phases.settled(1), 8.0 / 6) << "none yet";
  phases = {.elements = 5, .searches = 0, .impulses = 5, .others = 0, .steps = 20, .lists = 1, .iterations = 197};
  EXPECT_DOUBLE_EQ(phases.settled(1), 0.5 * (1 + 13.0 / 200)) << "iterations of an impact";
  phases.iterations = 2;
  EXPECT_DOUBLE_EQ(phases.settled(1), 1);
}

TEST(RunOutputs, AreCountedByTheirTimes) {
  Scene scene = scene_of(0, 0);
  EXPECT_EQ(outputs_of(scene, 1000, 1).rows, 201);
  EXPECT_EQ(outputs_of(scene, 1000, 0.5).rows, 101);
  EXPECT_EQ(outputs_of(scene, 30, 1).rows, 31) << "one in a step at most";
  EXPECT_EQ(outputs_of(scene, 1000, 1).fields, 0);
  scene.output.every_step = true;
  EXPECT_EQ(outputs_of(scene, 1000, 1).rows, 1001);
  scene.output.field_interval = 0.1;
  EXPECT_EQ(outputs_of(scene, 1000, 1).fields, 11);
  scene.output.field_interval = 0;
  scene.output.field_times = {0, 0.5, 2};
  EXPECT_EQ(outputs_of(scene, 1000, 1).fields, 2);
}

}  // namespace
}  // namespace pinball::forecast_test
