#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <tests/device/device_case.hpp>
#include <tests/support/every_input.hpp>

#include "emulated_device.hpp"

/// Penalty contact of balls on the emulated GPU (emulated_device.hpp): what crosses over in its steps, and the same
/// bits whatever the order in which threads take turns, while bodies touch and erode.
namespace pinball::standing_lists_test {
namespace {

using emulated::Counts;

class StandingLists : public testing::Test {
 protected:
  ~StandingLists() override { emulated::set_order(emulated::Order::forward); }
};

/// Of the steps of a run with pairs in contact: those whose lists last and in which nothing erodes, and the others.
struct CountsOfRun {
  std::int64_t standing = 0, others = 0;  ///< steps
  Counts of_standing, of_others;          ///< all together
  Counts most_of_standing;                ///< of any one
  std::int64_t most_waits_of_others = 0;
};

void add(Counts& sum, const Counts& step) {
  sum.launches += step.launches;
  sum.waits += step.waits;
  sum.to_device += step.to_device;
  sum.to_host += step.to_host;
}

void keep_most(Counts& most, const Counts& step) {
  most.launches = std::max(most.launches, step.launches);
  most.waits = std::max(most.waits, step.waits);
  most.to_device = std::max(most.to_device, step.to_device);
  most.to_host = std::max(most.to_host, step.to_host);
}

CountsOfRun counts_of(Scene scene, std::int64_t most_steps) {
  scene.device = Device::cuda;
  Solver<double> solver(scene);
  CountsOfRun counts;
  while (!solver.at_end() && solver.steps() < most_steps) {
    const std::int64_t searches = solver.contact()->searches(), eroded = solver.counts().eroded_elements();
    const Counts before = emulated::counts();
    solver.step();
    const Counts now = emulated::counts();
    if (solver.counts().pairs() == 0) continue;
    const Counts step{now.launches - before.launches, now.waits - before.waits, now.to_device - before.to_device,
                      now.to_host - before.to_host};
    if (solver.contact()->searches() > searches || solver.counts().eroded_elements() > eroded) {
      ++counts.others;
      add(counts.of_others, step);
      counts.most_waits_of_others = std::max(counts.most_waits_of_others, step.waits);
    } else {
      ++counts.standing;
      add(counts.of_standing, step);
      keep_most(counts.most_of_standing, step);
    }
  }
  return counts;
}

struct AtMost {
  std::int64_t launches, waits, waits_with_lists;
};

void report(const CountsOfRun& run) {
  const auto each = [](std::int64_t sum, std::int64_t steps) {
    return static_cast<double>(sum) / static_cast<double>(steps);
  };
  for (const auto& [name, of, steps] :
       {std::tuple("standing", run.of_standing, run.standing), std::tuple("other", run.of_others, run.others)}) {
    std::cout << name << " steps: " << steps << "; each " << each(of.launches, steps) << " launches, "
              << each(of.waits, steps) << " waits, " << each(of.to_device, steps) << " bytes there, "
              << each(of.to_host, steps) << " back\n";
  }
}

/// Neither nodes of the surface nor balls nor pairs: a few sums come back, without a copy. most: of the step that asks
/// for most, found by counting, as the most waits of a step with new lists or erosion.
void expect_nothing_crosses(const Scene& scene, std::int64_t most_steps, AtMost most) {
  const CountsOfRun run = counts_of(scene, most_steps);
  EXPECT_GT(run.standing, 10);
  EXPECT_GT(run.others, 3);
  EXPECT_EQ(run.most_of_standing.to_device, 0);
  EXPECT_EQ(run.most_of_standing.to_host, 0);
  EXPECT_EQ(run.most_of_standing.launches, most.launches);
  EXPECT_EQ(run.most_of_standing.waits, most.waits);
  EXPECT_GT(run.of_others.to_host, 0) << "lists are made on the host";
  EXPECT_LE(run.most_waits_of_others, most.waits_with_lists) << "their arrays cross over in one copy each way";
  report(run);
}

TEST_F(StandingLists, NothingCrosses) { expect_nothing_crosses(test::eroding_rod(), 1000, {10, 6, 11}); }

TEST_F(StandingLists, NothingCrossesWhereRadiiFollow) {
  Scene scene = test::eroding_rod();
  scene.contact.radius = ContactRadius::current;
  expect_nothing_crosses(scene, 1000, {11, 7, 12});
}

/// With a plane of symmetry, which keeps forces of elements and sums up its work once something has eroded.
TEST_F(StandingLists, NothingCrossesInTheReportsFirstProblem) {
  expect_nothing_crosses(test::read_input(std::string(PINBALL_SOURCE_DIR) + "/data/scenes/rod_plate.toml"), 150,
                         {15, 9, 21});
}

/// Contact of faces, whose rows are the host's: in steps whose lists hold and from whose ways no node strays motion and
/// forces of the nodes that it reads cross over, before constraints and, as these change them, after; and no others.
TEST_F(StandingLists, NumbersOfWhatIsListedCrossWhereFacesTouch) {
  Scene scene = test::read_input(std::string(PINBALL_SOURCE_DIR) + "/data/scenes/rod_plate.toml");
  scene.contact.gap = ContactGap::face;
  scene.contact.enforcement = Enforcement::lagrange;
  scene.device = Device::cuda;
  Solver<double> solver(scene);
  constexpr std::int64_t steps = 150, record = 4 * sizeof(double);
  std::int64_t held = 0, back = 0;
  while (solver.steps() < steps) {
    const Counts before = emulated::counts();
    solver.step();
    const Counts now = emulated::counts();
    const std::int64_t read = std::ssize(solver.contact()->read_nodes());
    if (now.to_host - before.to_host <= 2 * 3 * record * read) ++held;
    back += now.to_host - before.to_host;
  }
  const std::int64_t surface = std::ssize(solver.contact()->nodes());
  EXPECT_LT(4 * std::ssize(solver.contact()->read_nodes()), surface);
  EXPECT_GT(solver.counts().pairs_max(), 10);
  EXPECT_GT(held, 60) << "of " << steps;
  EXPECT_LT(back, 0.45 * 2 * 3 * record * surface * steps) << "all of the surface, twice a step";
}

template <class S>
void expect_same_in_any_order(Scene scene) {
  scene.device = Device::cuda;
  std::vector<std::uint64_t> hashes;
  for (const auto& [order, seed] : {std::pair(emulated::Order::forward, 1), std::pair(emulated::Order::reverse, 1),
                                    std::pair(emulated::Order::shuffled, 7)}) {
    emulated::set_order(order, seed);
    Solver<S> solver(scene);
    test::run(solver);
    EXPECT_GT(solver.counts().eroded_elements(), 3);
    hashes.push_back(state_hash(solver.model()));
  }
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
}

TEST_F(StandingLists, HaveTheSameBitsInAnyOrderOfThreads) {
  for (const ContactRadius radius : {ContactRadius::initial, ContactRadius::current}) {
    Scene scene = test::eroding_rod();
    scene.contact.radius = radius;
    expect_same_in_any_order<double>(scene);
    scene.precision = Precision::float32;
    expect_same_in_any_order<float>(scene);
  }
}

}  // namespace
}  // namespace pinball::standing_lists_test
