#include <gtest/gtest.h>

#include <vector>

#include <tests/support/pressed_block.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/torn_block.hpp>

#include "outcome.hpp"

/// A scene that several ranks run ends in the bits of one process, whatever their number and whatever each works.
namespace pinball::same_bits_test {
namespace {

using namespace test;

Scene torn(Precision precision = Precision::float64) {
  Scene scene = torn_block(precision, {11, 7, 9});  // tiles of two sizes
  scene.output.body_energies = true;
  return scene;
}

/// Every kind of boundary condition that ranks know, several of them with names.
Scene held_and_driven() {
  Scene scene = pressed_blocks(1e-3);
  scene.contact.method = ContactMethod::none;
  scene.bodies = {block("a", {9, 8, 7}, 0.1, {0, 0, 0}, {0.5, 0, -20}), block("b", {4, 5, 4}, 0.1, {2, 0, 0.5})};
  scene.prescribed_velocities[0].nodes.plane = Plane{{0, 0, 0.7}, {0, 0, 1}};
  scene.prescribed_velocities[0].name = "press";
  scene.constraints[0].name = "middle";
  scene.rigid_walls[1].plane.point[0] = 0.91;
  scene.rigid_walls[0].friction = 0.2;
  scene.rigid_walls[0].nodes.body = "a";
  RigidWall pushed{"pushed", {{0, 0, 0.45}, {0, 0, 1}}, "b", "here"};
  pushed.mass = 100;
  pushed.speed = 40;
  scene.rigid_walls.push_back(pushed);
  Gravity weight;
  weight.acceleration = {0, 0, -1000};
  weight.name = "weight";
  Gravity of_one = weight;
  of_one.bodies = {"b"};
  of_one.name = "pull";
  scene.gravities = {weight, of_one};
  Pressure blast;
  blast.name = "blast";
  blast.pressure = 3e7;
  blast.faces.plane = Plane{{0.9, 0, 0}, {1, 0, 0}};
  scene.pressures = {blast};
  return scene;
}

Scene resting_bar() {
  Scene scene = scene_of({block("bar", {60, 4, 4}, 0.01, {})}, 8e-5, false);
  NodalLoad pull;
  pull.nodes.plane = Plane{{0.6, 0, 0}, {1, 0, 0}};
  pull.force = {1e5, 0, 0};
  scene.loads = {pull};
  return scene;
}

template <class S>
Outcome expect_same(const Scene& scene) {
  std::vector<Shared> all;
  for (const int ranks : {1, 2, 3, 4, 7}) {
    for (const Partition& partition : {Partition{}, {Partition::By::random, 1}, {Partition::By::graph, 0}})
      all.push_back({ranks, partition});
  }
  return expect_same_on<S>(all, scene);
}

TEST(SameBits, OfABlockThatIsTornForAnyNumberOfRanksAndAnyPartition) {
  EXPECT_GT(expect_same<double>(torn()).eroded, 0);
}

TEST(SameBits, InSinglePrecision) { expect_same<float>(torn(Precision::float32)); }
TEST(SameBits, InMixedPrecision) { expect_same<double>(torn(Precision::mixed)); }

TEST(SameBits, OfTwentyPartitionsAtRandom) {
  Scene scene = torn();
  scene.time.end = 10e-6;
  std::vector<Shared> all;
  for (std::uint64_t seed = 0; seed < 20; ++seed) all.push_back({3, {Partition::By::random, seed}});
  expect_same_on<double>(all, scene);
}

TEST(SameBits, OfLoadsConstraintsPressuresGravityDampingAndWalls) {
  const Scene scene = held_and_driven();
  expect_same<double>(scene);
  Solver<double> alone(scene);
  run(alone);
  EXPECT_GT(alone.boundary().walls()[0].impulse, 0);
  EXPECT_GT(alone.boundary().walls()[2].impulse, 0);
  EXPECT_NE(alone.boundary().pressures()[0].force[0], 0);
  for (const ForceResult& named : alone.boundary().forces(alone.model(), alone.force_time()))
    EXPECT_NE(norm(named.force), 0) << named.name;
}

TEST(SameBits, WhereMostTilesRest) { EXPECT_GT(expect_same<double>(resting_bar()).resting, 0); }

TEST(SameBits, WhereElementsNearlyTurnOver) { expect_same<double>(pressed_block(1)); }

TEST(SameBits, OfAStateThatThreeRanksHaveSavedOnTwoAndAlone) {
  for (const Scene& scene : {torn(), resting_bar(), held_and_driven()}) {
    Solver<double> alone(scene);
    const StateBytes bytes = solved_on<double>(3, {Partition::By::random, 4}, scene, [&](Solver<double>& solver) {
      for (int step = 0; step < 9; ++step) {
        solver.step();
        alone.step();
      }
      return saved(solver);
    });
    run(alone);
    Solver<double> other(scene);
    StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
    other.persist(archive);
    EXPECT_EQ(archive.left(), 0U);
    run(other);
    EXPECT_EQ(state_hash(other.model()), state_hash(alone.model()));
    EXPECT_EQ(other.energies().external, alone.energies().external);
    EXPECT_EQ(other.counts().work().resting_element_steps, alone.counts().work().resting_element_steps);
    const auto hash = [](Solver<double>& solver) {
      run(solver);
      return state_hash(solver.model());
    };
    EXPECT_EQ(solved_on<double>(2, {}, scene, hash, bytes), state_hash(alone.model()));
  }
}

}  // namespace
}  // namespace pinball::same_bits_test
