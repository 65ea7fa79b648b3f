#include <gtest/gtest.h>

#include <vector>

#include "outcome.hpp"
#include "shared_scenes.hpp"

/// A scene that several ranks run ends in the bits of one process, whatever their number and whatever each works.
namespace pinball::same_bits_test {
namespace {

using namespace test;

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
  for (const ForceResult& named : alone.boundary().forces(alone.model())) EXPECT_NE(norm(named.force), 0) << named.name;
}

TEST(SameBits, OfPointMasses) {
  Scene scene = held_and_driven();
  PointMass point;
  point.nodes.plane = Plane{{0.9, 0, 0}, {1, 0, 0}};
  point.mass = 300;
  scene.point_masses = {point};
  point.nodes = {};
  point.nodes.nearest = Point{0, 0, 0.7};
  scene.point_masses.push_back(point);
  scene.gravities = {{{0, 0, -1e4}, {}, {"a"}}};
  scene.output.body_energies = true;
  expect_same<double>(scene);
}

TEST(SameBits, OfEquations) { expect_same<double>(with_equations()); }

TEST(SameBits, WhereMostTilesRest) { EXPECT_GT(expect_same<double>(resting_bar()).resting, 0); }

TEST(SameBits, WhereElementsNearlyTurnOver) { expect_same<double>(pressed_block(1)); }

TEST(SameBits, OfAStateThatThreeRanksHaveSavedOnTwoAndAlone) {
  for (const Scene& scene : {torn(), resting_bar(), held_and_driven()}) {
    Solver<double> alone(scene);
    const StateBytes bytes = state_of_three_ranks(scene, alone);
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
