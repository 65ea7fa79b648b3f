#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

#include <kernels/exec.hpp>
#include <tests/support/saved_state.hpp>

#include "simulation_case.hpp"

/// How a simulation runs, and what its host may change on the way.
namespace pinball::simulation_test {
namespace {

using test::block;
using test::hash_of_run;
using test::impact;
using test::scene_of;

TEST(Simulation, CallsBackAfterEachStepAndOnceAtTheEnd) {
  Simulation simulation(impact());
  std::vector<std::int64_t> steps;
  int completed = 0;
  simulation.on_step([&](Simulation& s) {
    EXPECT_EQ(&s, &simulation);
    steps.push_back(s.steps());
    completed += s.complete() ? 1 : 0;
    return AfterStep::go_on;
  });
  EXPECT_TRUE(simulation.run());
  ASSERT_EQ(steps.size(), static_cast<std::size_t>(simulation.steps()) + 1);
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) EXPECT_EQ(steps[i], static_cast<std::int64_t>(i) + 1);
  EXPECT_EQ(completed, 1);
  EXPECT_DOUBLE_EQ(simulation.time(), 1e-4);
  EXPECT_FALSE(simulation.step());
  EXPECT_EQ(steps.size(), static_cast<std::size_t>(simulation.steps()) + 1);
}

TEST(Simulation, ACallbackStopsARunAndAnotherCallGoesOn) {
  Simulation simulation(impact());
  simulation.on_step([](Simulation& s) { return s.steps() == 3 ? AfterStep::stop : AfterStep::go_on; });
  EXPECT_FALSE(simulation.run());
  EXPECT_EQ(simulation.steps(), 3);
  EXPECT_TRUE(simulation.run());
  EXPECT_EQ(simulation.state_hash(), hash_of_run(impact()));
}

TEST(Simulation, AnExceptionOfACallbackPassesAndTheRunMayGoOn) {
  Simulation simulation(impact());
  simulation.on_step([](Simulation& s) {
    if (s.steps() == 2) throw std::logic_error("of the host");
    return AfterStep::go_on;
  });
  EXPECT_THROW(simulation.run(), std::logic_error);
  EXPECT_TRUE(simulation.run());
  EXPECT_EQ(simulation.state_hash(), hash_of_run(impact()));
}

TEST(Simulation, AStopAtATimeChangesNothing) {
  Simulation simulation(impact());
  EXPECT_TRUE(simulation.run_until(0.5e-4));
  EXPECT_GE(simulation.time(), 0.5e-4 * (1 - 1e-12));
  EXPECT_LT(simulation.time() - simulation.dt(), 0.5e-4);
  EXPECT_TRUE(simulation.run());
  EXPECT_EQ(simulation.state_hash(), hash_of_run(impact()));
}

TEST(Simulation, TwoOnTwoThreadsGiveTheBitsOfOneAfterTheOther) {
  const Scene scenes[] = {impact(Precision::float64), impact(Precision::float32)};
  std::uint64_t together[2] = {};
  {
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 2; ++i) {
      threads.emplace_back([&, i] {
        Simulation simulation(scenes[i], {2});
        simulation.run();
        together[i] = simulation.state_hash();
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(together[i], hash_of_run(scenes[i]));
  EXPECT_NE(together[0], together[1]);
}

TEST(Simulation, LeavesTheNumberOfThreadsOfTheHostAlone) {
  const int before = DefaultExecutionSpace::concurrency();
  Simulation simulation(impact(), {before + 1});
  simulation.step();
  EXPECT_EQ(simulation.summary().threads, before + 1);
  EXPECT_EQ(DefaultExecutionSpace::concurrency(), before);
}

/// Adds a velocity along x to all nodes.
void push(Simulation& simulation, double speed) {
  const ArrayView v = simulation.velocities_to_change();
  for (std::int64_t n = 0; n < v.count; ++n) *v.at<double>(n, 0) += speed;
}

TEST(Simulation, WhatAChangeOfVelocitiesBringsIsWorkFromOutside) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1e-4);  // at rest: its elements are left out
  const double mass = 7850 * 0.2 * 0.2 * 0.2;
  Simulation simulation(scene);
  simulation.step();
  simulation.step();
  push(simulation, 2.0);
  simulation.run();
  EXPECT_NEAR(simulation.history_row().momentum[0], 2 * mass, 1e-9);
  EXPECT_NEAR(simulation.energies().external, 0.5 * mass * 4, 1e-9);
  EXPECT_NEAR(simulation.energies().kinetic, 0.5 * mass * 4, 1e-9);
  EXPECT_LT(std::abs(simulation.balance_error()), 1e-12);
}

/// Of what moves already, by the difference of both energies; twice in a row it is one change.
TEST(Simulation, WhatAChangeBringsToAMovingBodyIsTheDifference) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}, {3, 0, 4})}, 1e-4, false);
  const double mass = 7850 * 0.2 * 0.2 * 0.2;
  Simulation simulation(scene);
  simulation.step();
  simulation.step();
  push(simulation, 1.0);
  push(simulation, 1.0);
  simulation.run();
  EXPECT_NEAR(simulation.energies().external, 0.5 * mass * (25 - 9), 1e-9);
  EXPECT_NEAR(simulation.energies().kinetic, 0.5 * mass * (25 + 16), 1e-9);
  EXPECT_LT(std::abs(simulation.balance_error()), 1e-12);
}

TEST(Simulation, AChangeBeforeTheFirstStepIsAnInitialVelocity) {
  Scene scene = impact();
  Simulation changed(scene);
  push(changed, 5);
  changed.run();
  for (Body& body : scene.bodies) body.velocity[0] = 5;
  Simulation given(scene);
  given.run();
  EXPECT_EQ(changed.state_hash(), given.state_hash());
  EXPECT_EQ(changed.summary().momentum_initial, given.summary().momentum_initial);
  EXPECT_EQ(changed.energies().external, 0);
}

TEST(Simulation, ExternalForcesActAsTheLoadsOfASceneDo) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1e-4, false);
  Simulation hosted(scene);
  const double mass = 7850 * 0.2 * 0.2 * 0.2, force = 1e5;
  const ArrayView f = hosted.external_forces();
  for (std::int64_t n = 0; n < f.count; ++n) *f.at<double>(n, 1) = force * hosted.masses().number(n) / mass;
  hosted.run();
  scene.loads.emplace_back().nodes.body = "a";
  scene.loads[0].force = {0, force, 0};
  Simulation loaded(scene);
  loaded.run();
  EXPECT_NEAR(hosted.history_row().momentum[1], force * 1e-4, 1e-9);
  EXPECT_NEAR(hosted.history_row().momentum[1], loaded.history_row().momentum[1], 1e-12);
  EXPECT_NEAR(hosted.energies().external, loaded.energies().external, 1e-12);
  EXPECT_LT(std::abs(hosted.balance_error()), 1e-12);
}

TEST(Simulation, ASavedStateGoesOnInAnotherSimulation) {
  Simulation first(impact());
  first.run_until(0.4e-4);
  const StateBytes bytes = test::saved(first);
  Simulation second(impact());
  test::load(second, bytes);
  EXPECT_EQ(second.time(), first.time());
  second.run();
  EXPECT_EQ(second.state_hash(), hash_of_run(impact()));
}

TEST(Simulation, GoesOnFromTheStateAtItsEndWithNothingToDo) {
  Simulation first(impact());
  first.run();
  const StateBytes bytes = test::saved(first);
  Simulation second(impact());
  test::load(second, bytes);
  EXPECT_TRUE(second.complete());
  EXPECT_FALSE(second.step());
  EXPECT_EQ(second.state_hash(), first.state_hash());
  EXPECT_EQ(second.steps(), first.steps());
}

/// Read once, and not, as test::load does, twice.
TEST(Simulation, ASavedStateKnowsWhetherItIsTheEnd) {
  for (const bool complete : {false, true}) {
    Simulation first(impact());
    first.run_until(0.4e-4);
    if (complete) first.run();
    const StateBytes bytes = test::saved(first);
    EXPECT_EQ(bytes[bytes.size() - 1], std::byte{complete}) << "of files that other programs of this version read";
    Simulation second(impact());
    StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
    second.persist(archive);
    EXPECT_EQ(second.complete(), complete);
    EXPECT_EQ(second.summary().status, complete ? RunStatus::done : RunStatus::running);
  }
}

TEST(Simulation, NothingCannotBeCalledBack) {
  Simulation simulation(impact());
  EXPECT_THROW(simulation.on_step({}), InputError);
  EXPECT_TRUE(simulation.step());
}

TEST(Simulation, KnowsWhereItsNodesBegan) {
  Simulation simulation(impact());
  std::vector<double> before(3 * simulation.nodes()), after(before.size());
  simulation.copy(NodeField::position, view_records(before.data(), simulation.nodes(), 3));
  simulation.run_until(0.4e-4);
  simulation.copy(NodeField::initial_position, view_records(after.data(), simulation.nodes(), 3));
  EXPECT_EQ(after, before);
}

}  // namespace
}  // namespace pinball::simulation_test
