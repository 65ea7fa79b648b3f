#include <gtest/gtest.h>

#include <tests/support/collapsed_case.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/tetrahedra_case.hpp>

#include "outcome.hpp"

/// Tetrahedra and wedges, of which ranks tell each other volumes: on any ranks the bits of one process.
namespace pinball::tetrahedra_on_ranks_test {
namespace {

using namespace test;

/// What erodes on one rank no longer counts on the others.
TEST(TetrahedraOnRanks, HaveTheBitsOfOneProcessWhereSomeErode) {
  const Outcome found = expect_same_on<double>(some_ranks, torn_tetrahedra());
  EXPECT_GT(found.eroded, 10);
  EXPECT_LT(found.eroded, 7 * 5 * 6 * 6);
}

TEST(TetrahedraOnRanks, HaveThemInSinglePrecision) {
  expect_same_on<float>(some_ranks, torn_tetrahedra(Precision::float32));
}

TEST(TetrahedraOnRanks, HaveThemInMixedPrecision) {
  expect_same_on<double>(some_ranks, torn_tetrahedra(Precision::mixed));
}

TEST(TetrahedraOnRanks, HaveThemBesideHexahedraOfTheSameBody) {
  expect_same_on<double>(some_ranks, striking_bar_of_both());
}

TEST(TetrahedraOnRanks, HaveThemWithWedgesAndPyramids) {
  const Outcome found = expect_same_on<double>(some_ranks, torn_shapes());
  EXPECT_GT(found.eroded, 10);
}

TEST(TetrahedraOnRanks, HaveThemInContact) {
  const Outcome found = expect_same_on<double>(some_ranks, striking_tetrahedra());
  EXPECT_GT(found.pairs, 0);
  EXPECT_GT(found.eroded, 0);
}

TEST(TetrahedraOnRanks, GoOnAtAnotherNumberOfRanks) {
  for (const Scene& scene : {torn_tetrahedra(), torn_shapes(), striking_tetrahedra(), striking_bar_of_both()}) {
    Solver<double> alone(scene);
    for (int step = 0; step < 30; ++step) alone.step();
    const StateBytes bytes = solved_on<double>(3, {Partition::By::random, 4}, scene, [&](Solver<double>& solver) {
      for (int step = 0; step < 30; ++step) solver.step();
      return saved(solver);
    });
    run(alone);
    const auto hash = [](Solver<double>& solver) {
      run(solver);
      return state_hash(solver.model());
    };
    for (const int ranks : {1, 2, 4})
      EXPECT_EQ(solved_on<double>(ranks, {}, scene, hash, bytes), state_hash(alone.model())) << ranks;
    Solver<double> other(scene);
    load(other, bytes);
    EXPECT_EQ(hash(other), state_hash(alone.model()));
  }
}

}  // namespace
}  // namespace pinball::tetrahedra_on_ranks_test
