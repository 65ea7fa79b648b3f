#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <solver/elements/schedule.hpp>
#include <solver/model/step_levels.hpp>
#include <solver/step/report.hpp>
#include <tests/support/saved_state.hpp>

#include "thin_section.hpp"

/// Elements that make steps of their own: which, what is conserved, and that the answer stays the same.
namespace pinball::subcycling_test {
namespace {

using namespace test;
using testing::Each;
using testing::ElementsAre;

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(StepLevels, ArePowersOfTwoBelowTheStableStep) {
  EXPECT_THAT(choose_levels({{1, 100}, {2, 100}, {3, 100}, {4.5, 100}, {70, 100}}, 0), ElementsAre(0, 1, 1, 2, 6));
  EXPECT_THAT(choose_levels({{1, 10}, {8, 100, 2}}, 0), ElementsAre(0, 2));
}

TEST(StepLevels, ASmallerSmallestStepMayLetManyElementsOnToTheNextLevel) {
  const std::vector<StepGroup> groups = {{1, 10}, {7.9, 1000}};
  EXPECT_THAT(choose_levels(groups, 0), ElementsAre(0, 3));
  EXPECT_DOUBLE_EQ(smallest_step(groups, {0, 3}), 7.9 / 8);
  EXPECT_DOUBLE_EQ(work_per_time(groups, {0, 3}, 5), (5 + 10 + 1000 / 8.0) / (7.9 / 8));
}

TEST(StepLevels, AreLowerWhereEachStepCostsMuch) {
  EXPECT_THAT(choose_levels({{1, 10}, {1.3, 10}}, 1000), ElementsAre(0, 0));
}

TEST(StepLevels, GroupsWithoutElementsLimitNothing) {
  EXPECT_THAT(choose_levels({{infinite, 0}, {4, 10}, {8, 10}}, 0)[2], 1);
  EXPECT_THAT(choose_levels({{infinite, 0}}, 0), ElementsAre(0));
}

TEST(StepLevels, AnElementAtASmallOneMakesItsStep) {
  const Scene scene = bar_with_thin_section(1);
  const ElementLevels levels = element_step_levels(scene, build_mesh(scene));
  for (int x = 0; x < 32; ++x) {
    const auto e = static_cast<std::size_t>(x);
    const bool thin = x >= 12 && x < 20;
    EXPECT_EQ(levels.own[e] == 0, thin) << x;
    EXPECT_EQ(levels.level[e] == 0, x >= 11 && x < 21) << x;
    EXPECT_LE(levels.level[e], levels.own[e]);
  }
}

TEST(StepLevels, TheStableStepIsTheOneOfTheKernel) {
  Scene scene = bar_with_thin_section(1);
  scene.time.subcycling = false;
  scene.time.cfl = 1;
  Solver<double> solver(scene);
  solver.step();
  const double thin = element_stable_step(scene, solver.mesh(), 15, scene.materials[0]);
  EXPECT_NEAR(solver.dt() / thin, 1, 1e-4);  // the end of time is divided into equal steps
}

/// Free, elastic, without viscosity, spinning and shaken: nothing takes energy out.
Scene shaken_bar(double steps_of_cubes) {
  Scene scene = bar_with_thin_section(1);
  scene.bodies[0].angular_velocity = {3, -5, 20};
  scene.bodies[0].velocity = {10, -20, 30};
  scene.bodies[0].velocity_noise = 1;
  scene.element.hourglass = HourglassControl::stiffness;
  scene.time.end = steps_of_cubes * 1e-4;
  return scene;
}

/// After a cycle nodes with large steps have made theirs: what is reported is where they are at the time of the row.
TEST(Subcycling, ProbesAndFieldsSeeAllNodesAtOneTime) {
  Scene scene = bar_with_thin_section(1e-2);
  scene.bodies[0].velocity = {3, 0, 0};
  for (const double x : {0.0, 12.5, 25.0}) {
    Probe probe;
    probe.name = fmt::format("x{}", scene.probes.size());
    probe.point = {x, 0, 0};
    probe.quantities = {"displacement"};
    scene.probes.push_back(probe);
  }
  Solver<double> solver(scene);
  for (int cycle = 0; cycle < 4; ++cycle) {
    solver.step();
    const std::vector<double> values = solver.probe_values();
    const double way = 3 * solver.force_time();
    for (const std::size_t i : {0U, 3U, 6U}) EXPECT_NEAR(values[i], way, 1e-12) << cycle << ' ' << i;
    const FieldSnapshot fields = snapshot(solver);
    const auto& start = solver.mesh().nodes;
    for (std::size_t n = 0; n < start.size(); ++n) ASSERT_NEAR(fields.position[n][0] - start[n][0], way, 1e-12) << n;
  }
  EXPECT_GT(solver.subcycling()->cycle_steps(), 1);
}

TEST(Subcycling, LeavesElementsOut) {
  Solver<double> solver(shaken_bar(50));
  ASSERT_NE(solver.subcycling(), nullptr);
  EXPECT_THAT(solver.subcycling()->elements_of_levels(), ElementsAre(40, 0, 88));
  run(solver);
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_EQ(summary.steps % 4, 0);
  EXPECT_EQ(summary.element_steps_subcycled, summary.steps / 4 * 3 * 88);
  EXPECT_EQ(summary.element_steps + summary.element_steps_subcycled, summary.steps * 128);
  EXPECT_GT(summary.skipped_seconds.subcycling, 0);
  EXPECT_NEAR(solver.time(), solver.scene().time.end, 1e-12 * solver.time());
}

TEST(Subcycling, ConservesMomentumAndAngularMomentum) {
  Solver<double> solver(shaken_bar(200));
  const Point before = solver.momentum(), spin = angular_momentum(solver);
  run(solver);
  EXPECT_GT(solver.steps(), 1000);
  const Point after = solver.momentum(), spin_after = angular_momentum(solver);
  const double scale = std::hypot(before[0], before[1], before[2]);
  const double spin_scale = std::hypot(spin[0], spin[1], spin[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(after[k], before[k], 1e-12 * scale);
    // Of the smaller steps in the middle of which a velocity is known, nothing remains when the last one ends.
    EXPECT_NEAR(spin_after[k], spin[k], 1e-11 * spin_scale);
  }
}

TEST(Subcycling, KeepsTheEnergyOfALongRun) {
  Solver<double> solver(shaken_bar(1500));
  double early = 0, late = 0;
  const double initial = [&] {
    solver.step();
    return solver.initial_energy();
  }();
  ASSERT_GT(initial, 0);
  while (!solver.at_end()) {
    solver.step();
    double& largest = solver.time() < 0.1 * solver.scene().time.end ? early : late;
    largest = std::max(largest, std::abs(solver.balance_error()));
  }
  EXPECT_LT(early, 0.01);
  EXPECT_LT(late, 2 * early + 1e-6);  // strays, but does not drift
}

TEST(Subcycling, UniformMotionStaysExact) {
  Scene scene = bar_with_thin_section(1e-2);
  scene.bodies[0].velocity = {0.1, -0.7, 0.3};
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t e = 0; e < 128; ++e) EXPECT_THAT(stress_of(solver, e), Each(0.0)) << e;
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    EXPECT_EQ(velocity_of(solver, n), scene.bodies[0].velocity);
  }
}

TEST(Subcycling, ChangesNothingWhereAllElementsAreAlike) {
  Scene scene = scene_of({block("block", {6, 6, 6}, 0.1, {0, 0, 0})}, 2e-4, false);
  scene.bodies[0].velocity_noise = 5;
  Solver<double> without(scene);
  scene.time.subcycling = true;
  Solver<double> with(scene);
  run(without);
  run(with);
  EXPECT_EQ(with.steps(), without.steps());
  EXPECT_EQ(state_hash(with.model()), state_hash(without.model()));
}

TEST(Subcycling, SameBitsForAnyNumberOfThreads) {
  std::uint64_t hash = 0;
  for (const int threads : {1, 2, 3, 8}) {
    DefaultExecutionSpace::set_concurrency(threads);
    Solver<double> solver(shaken_bar(30));
    run(solver);
    DefaultExecutionSpace::set_concurrency(1);
    if (threads == 1) hash = state_hash(solver.model());
    EXPECT_EQ(state_hash(solver.model()), hash) << threads;
  }
}

/// Mean distance of two runs' velocities over that of one of them from zero.
double distance(const Solver<double>& a, const Solver<double>& b) {
  double difference = 0, size = 0;
  for (std::size_t n = 0; n < a.model().mesh.nodes.size(); ++n) {
    const Point u = velocity_of(a, n), v = velocity_of(b, n);
    for (std::size_t k = 0; k < 3; ++k) {
      difference += std::abs(u[k] - v[k]);
      size += std::abs(v[k]);
    }
  }
  return difference / size;
}

TEST(Subcycling, ComesToTheSameAnswer) {
  // A long wave that runs once through the bar: converges with the square of the step.
  std::vector<double> distances;
  for (const double cfl : {0.4, 0.2}) {
    Scene scene = bar_with_thin_section(5e-3);
    scene.bodies[0].velocity_gradient[0][0] = 1;
    scene.time.cfl = cfl;
    Solver<double> with(scene);
    scene.time.subcycling = false;
    Solver<double> without(scene);
    run(with);
    run(without);
    distances.push_back(distance(with, without));
  }
  EXPECT_LT(distances[0], 0.02);
  EXPECT_LT(distances[1], 0.3 * distances[0]);
}

TEST(Subcycling, GoesWithContact) {
  // The surface makes the smallest step: nine of 25 elements across are behind it.
  Scene scene = bar_with_thin_section(2e-3, 5);
  scene.bodies.push_back(block("anvil", {2, 5, 5}, 1, {25 + touching_gap, 0, 0}, {-20, 0, 0}));
  scene.contact.method = ContactMethod::pinball;
  Solver<double> solver(scene);
  EXPECT_THAT(solver.subcycling()->elements_of_levels(), ElementsAre(32 * 25 + 50 - 20 * 9, 0, 20 * 9));
  const Point before = solver.momentum();
  run(solver);
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_GT(summary.pairs_max, 0);
  EXPECT_GT(summary.element_steps_subcycled, 0);
  EXPECT_NEAR(solver.momentum()[0], before[0], 1e-12 * std::abs(before[0]));
  EXPECT_LT(summary.balance_error_max, 0.03);
}

TEST(Subcycling, ContactLimitsTheStepsOfElementsAtTheSurfaceAlone) {
  Scene scene = bar_with_thin_section(1, 5);
  scene.contact.method = ContactMethod::pinball;
  const Model<double> model = build_model<double>(scene);
  const Subcycling<double> subcycling(model, false);
  std::vector<TileResult<double>> tiles(static_cast<std::size_t>(model.tile_count()));
  for (std::size_t t = 0; t < tiles.size(); ++t) tiles[t].time_step = std::ldexp(1.0, model.tile_levels[t].highest);
  EXPECT_DOUBLE_EQ(subcycling.stable_step(tiles, 0).step, 1);
  // Of the surface 2 / sqrt(4/1 + w^2). Elements behind it would allow less with the same w: 2 / sqrt(4/4^2 + w^2) / 4.
  EXPECT_DOUBLE_EQ(subcycling.stable_step(tiles, 0.25).step, 2 / std::sqrt(4.25));
}

/// A bar with a thin section, one of whose tiles behind the surface is squeezed: 2.9 times the smallest step in place
/// of 4, so that tiles beside it are to be lowered. Where contact makes the smallest step half as long, others are.
class SqueezedBar {
 public:
  /// unit: the smallest stable step
  explicit SqueezedBar(double unit) : model_(build_model<double>(scene())) {
    results_.resize(static_cast<std::size_t>(model_.tile_count()));
    bool squeezed = false;
    for (std::size_t t = 0; t < results_.size(); ++t) {
      const TileLevels& levels = model_.tile_levels[t];
      const bool here = !squeezed && levels.highest == 2;
      squeezed = squeezed || here;
      results_[t].time_step = unit * (here ? 2.9 : std::ldexp(1.0, levels.own));
    }
    EXPECT_TRUE(squeezed);
  }

  Schedule<double> schedule() const { return Schedule<double>(model_); }
  /// A step in the middle of a cycle, with contact of this frequency.
  void step_within(Schedule<double>& schedule, double frequency2) const {
    schedule.bound(model_, {1}, results_, 1, 0, frequency2);
  }
  /// A step that works all; contact has let go. Returns the elements of the levels of the cycle that it begins.
  std::vector<std::int64_t> step_of_all(Schedule<double>& schedule) const {
    schedule.begin_step(model_, {}, results_);
    schedule.bound(model_, {}, results_, 1, 0, 0);
    return schedule.subcycling()->elements_of_levels();
  }
  /// The same of another schedule that goes on from the state of this one.
  std::vector<std::int64_t> step_of_all_after_a_restart(Schedule<double>& schedule) const {
    StateBytes bytes;
    StateArchive::save(bytes, [&](StateArchive& archive) { schedule.persist(archive, model_); });
    StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
    Schedule<double> rest = this->schedule();
    rest.persist(archive, model_);
    EXPECT_EQ(archive.left(), 0U);
    return step_of_all(rest);
  }

 private:
  static Scene scene() {
    Scene scene = bar_with_thin_section(1, 9);
    scene.contact.method = ContactMethod::pinball;
    return scene;
  }
  Model<double> model_;
  std::vector<TileResult<double>> results_;
};

TEST(Subcycling, ContactWithinACycleCountsInTheLevelsOfTheNext) {
  const SqueezedBar bar(1);
  Schedule<double> touched = bar.schedule(), free = bar.schedule();
  bar.step_within(touched, 12);  // 2 / sqrt(4 + 12)
  bar.step_within(touched, 0);   // the largest of a cycle counts
  const std::vector<std::int64_t> after_a_restart = bar.step_of_all_after_a_restart(touched);
  const std::vector<std::int64_t> levels = bar.step_of_all(touched);
  EXPECT_EQ(after_a_restart, levels);
  EXPECT_NE(bar.step_of_all(free), levels);
}

/// A frequency of nothing is nothing, however long the steps are.
TEST(Subcycling, WithoutContactTheUnitOfTimeDoesNotMatter) {
  const SqueezedBar bar(1), slow(1024);
  Schedule<double> one = bar.schedule(), other = slow.schedule();
  for (int cycle = 0; cycle < 3; ++cycle) EXPECT_EQ(bar.step_of_all(one), slow.step_of_all(other)) << cycle;
}

/// Torn apart by its own motion.
Scene torn_bar() {
  Scene scene = bar_with_thin_section(1.2e-2);
  scene.materials = {plastic_material("steel", 1e8, 0.02)};
  scene.bodies[0].velocity_gradient[0][0] = 20;
  scene.bodies[0].velocity_noise = 1;
  return scene;
}

struct Stop {
  StateBytes bytes;
  std::vector<std::int64_t> levels;
};

/// Goes on from states on the way; returns these.
std::vector<Stop> expect_same_after_restarts(const Scene& scene) {
  Solver<double> whole(scene);
  std::vector<Stop> stops;
  for (int cycle = 0; !whole.at_end(); ++cycle) {
    if (cycle < 6 || cycle % 16 == 1) stops.push_back({saved(whole), whole.subcycling()->elements_of_levels()});
    whole.step();
  }
  whole.finish();
  RunSummary expected;
  fill_summary(whole, expected);
  for (const Stop& stop : stops) {
    Solver<double> rest(scene);
    EXPECT_EQ(load(rest, stop.bytes), 0U);
    EXPECT_EQ(rest.subcycling()->elements_of_levels(), stop.levels);
    run(rest);
    RunSummary summary;
    fill_summary(rest, summary);
    EXPECT_EQ(summary.state_hash, expected.state_hash);
    EXPECT_EQ(summary.element_steps_subcycled, expected.element_steps_subcycled);
  }
  return stops;
}

TEST(Subcycling, GoesOnFromASavedStateWithTheVelocitiesOfItsLevels) {
  const std::vector<Stop> stops = expect_same_after_restarts(shaken_bar(60));
  EXPECT_EQ(stops.back().levels.size(), 3U) << "there are to be nodes between levels";
}

TEST(Subcycling, GoesOnFromASavedStateWithTheLevelsThatItHad) {
  const std::vector<Stop> stops = expect_same_after_restarts(torn_bar());
  EXPECT_NE(stops.front().levels, stops.back().levels) << "they are to change";
}

TEST(Subcycling, GoesWithErosion) {
  Scene scene = bar_with_thin_section(4e-3);
  scene.materials = {plastic_material("steel", 1e8, 0.02)};
  scene.bodies[0].velocity_gradient[0][0] = 20;  // torn apart
  Solver<double> solver(scene);
  run(solver);
  RunSummary summary;
  fill_summary(solver, summary);
  EXPECT_GT(summary.bodies[0].eroded_elements, 0);
  EXPECT_GT(summary.element_steps_subcycled, 0);
  EXPECT_EQ(summary.element_steps + summary.element_steps_subcycled + summary.element_steps_eroded,
            summary.steps * 128);
  EXPECT_LT(summary.balance_error_max, 0.02);
}

}  // namespace
}  // namespace pinball::subcycling_test
