#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include <solver/output/history.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>
#include <tests/support/thread_ranks.hpp>

/// What a run leaves, and that it is the same on ranks.
namespace pinball::test {

/// What a run leaves that every bit goes into.
struct Outcome {
  std::uint64_t hash = 0;
  std::int64_t steps = 0, eroded = 0, resting = 0, searches = 0, pairs = 0;
  std::vector<double> numbers;
  bool operator==(const Outcome&) const = default;
};

template <class S>
Outcome outcome_of(Solver<S>& solver) {
  Outcome found;
  const auto row = [&] {
    for (const double number : history_numbers(history_row(solver))) found.numbers.push_back(number);
  };
  while (!solver.at_end()) {
    solver.step();
    found.pairs += solver.counts().pairs();
    if (solver.steps() % 7 == 0) row();
  }
  solver.finish();
  row();
  found.hash = state_hash(solver.model());
  found.steps = solver.steps();
  found.eroded = solver.counts().eroded_elements();
  found.resting = solver.counts().work().resting_element_steps;
  if (solver.contact() != nullptr) found.searches = solver.contact()->searches();
  found.numbers.push_back(static_cast<double>(solver.overlap_at_end().points));
  return found;
}

/// How a scene is shared.
struct Shared {
  int ranks;
  Partition partition;
};

/// Few and many, with each way to share.
inline const std::vector<Shared> some_ranks{{1, {}},
                                            {2, {}},
                                            {2, {Partition::By::random, 5}},
                                            {3, {Partition::By::random, 1}},
                                            {4, {Partition::By::graph, 0}},
                                            {7, {Partition::By::random, 2}}};

/// What it is on the ranks is what it is on one process, which is returned.
template <class S>
Outcome expect_same_on(const std::vector<Shared>& all, const Scene& scene) {
  Solver<S> alone(scene);
  const Outcome expected = outcome_of(alone);
  for (const auto& [ranks, partition] : all) {
    const Outcome found = solved_on<S>(ranks, partition, scene, [](Solver<S>& s) { return outcome_of(s); });
    EXPECT_TRUE(found == expected) << ranks << " ranks, partition " << static_cast<int>(partition.by) << ", seed "
                                   << partition.seed;
  }
  return expected;
}

/// What three ranks have saved after some steps, which the one process has made, too.
inline StateBytes state_of_three_ranks(const Scene& scene, Solver<double>& alone) {
  return solved_on<double>(3, {Partition::By::random, 4}, scene, [&](Solver<double>& solver) {
    for (int step = 0; step < 9; ++step) {
      solver.step();
      alone.step();
    }
    return saved(solver);
  });
}

/// From three ranks to one process and two ranks, and from one process to four, at several times: a run goes on from a
/// state to the bits of one without a break.
inline void expect_to_go_on_on_others(const Scene& scene) {
  Solver<double> alone(scene);
  const auto hash = [](Solver<double>& solver) {
    run(solver);
    return state_hash(solver.model());
  };
  const std::uint64_t expected = hash(alone);
  for (const std::int64_t at : {alone.steps() / 3, alone.steps() * 2 / 3}) {
    const auto half = [&](Solver<double>& solver) {
      while (solver.steps() < at) solver.step();
      return saved(solver);
    };
    const StateBytes of_three = solved_on<double>(3, {Partition::By::random, 4}, scene, half);
    Solver<double> first(scene), rest(scene);
    const StateBytes of_one = half(first);
    EXPECT_EQ(load(rest, of_three), 0U);
    EXPECT_EQ(hash(rest), expected);
    EXPECT_EQ(solved_on<double>(2, {}, scene, hash, of_three), expected);
    EXPECT_EQ(solved_on<double>(4, {Partition::By::random, 7}, scene, hash, of_one), expected);
  }
}

}  // namespace pinball::test
