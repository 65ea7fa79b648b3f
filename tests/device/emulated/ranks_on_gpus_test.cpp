#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <tests/parallel/outcome.hpp>
#include <tests/parallel/shared_scenes.hpp>
#include <tests/support/tetrahedra_case.hpp>

#include "emulated_device.hpp"

/// Several ranks on the emulated GPU (emulated_device.hpp): the same bits in any order of its threads, and what crosses
/// over in a step.
namespace pinball::ranks_on_gpus_test {
namespace {

using namespace test;
using emulated::Counts;
using emulated::Order;

class RanksOnGpus : public testing::Test {
 protected:
  ~RanksOnGpus() override { emulated::set_order(Order::forward); }
};

Scene torn_on_gpu() {
  Scene scene = torn();
  scene.device = Device::cuda;
  scene.time.end = 10e-6;
  return scene;
}

TEST_F(RanksOnGpus, HaveTheSameBitsInAnyOrderOfThreads) {
  const Scene scene = torn_on_gpu();
  Solver<double> alone(scene);
  const Outcome expected = outcome_of(alone);
  for (const auto& [order, seed] :
       {std::pair(Order::forward, 1), std::pair(Order::reverse, 1), std::pair(Order::shuffled, 7)}) {
    emulated::set_order(order, seed);
    const Outcome found =
        solved_on<double>(3, {Partition::By::random, 2}, scene, [](Solver<double>& s) { return outcome_of(s); });
    EXPECT_TRUE(found == expected);
  }
}

/// Of each rank since its solver was there, of so many steps.
std::vector<Counts> counts_of(const Scene& scene, int count, int steps, SharedWork& work, bool reaches_cuda) {
  std::vector<Counts> of_rank(count);
  const auto count_of = [&](int rank, const auto& make_steps) {
    const Counts before = emulated::counts();
    make_steps();
    const Counts after = emulated::counts();
    of_rank[rank] = {after.launches - before.launches, after.waits - before.waits, after.to_device - before.to_device,
                     after.to_host - before.to_host};
  };
  on_ranks(
      count, {},
      [&](ThreadRanks& ranks) {
        Solver<double> solver(scene, &ranks);
        count_of(0, [&] {
          for (int step = 0; step < steps; ++step) solver.step();
        });
        work = solver.shared_work();
        return 0;
      },
      [&](ThreadRanks& ranks) {
        Solver<double> solver(scene, &ranks);
        count_of(ranks.number(), [&] { solver.follow_rank_0(); });
      },
      reaches_cuda);
  return of_rank;
}

/// What each rank asks for in one step. Where what a rank sums up lies in several ranges each further one takes a
/// launch and a wait.
void expect_in_a_step(int ranks, bool reaches_cuda, std::int64_t launches, std::int64_t waits) {
  Scene scene = scene_of({block("cube", {12, 12, 12}, 0.01, {})}, 1e-5, false);
  scene.bodies[0].velocity_gradient = {Point{4000, 300, 0}, Point{0, -1500, 200}, Point{500, 0, -1200}};
  scene.device = Device::cuda;
  constexpr int steps = 3;
  SharedWork work;
  const std::vector<Counts> fewer = counts_of(scene, ranks, steps, work, reaches_cuda),
                            more = counts_of(scene, ranks, steps + 1, work, reaches_cuda);
  std::int64_t there = 0, back = 0;
  for (int rank = 0; rank < ranks; ++rank) {
    const Counts step{more[rank].launches - fewer[rank].launches, more[rank].waits - fewer[rank].waits,
                      more[rank].to_device - fewer[rank].to_device, more[rank].to_host - fewer[rank].to_host};
    EXPECT_GE(step.launches, launches);
    EXPECT_LE(step.launches, launches + 2 * (ranks > 1));
    EXPECT_EQ(step.waits - waits, step.launches - launches);
    there += step.to_device;
    back += step.to_host;
  }
  constexpr std::int64_t of_force = 24;
  EXPECT_EQ(there, reaches_cuda ? 0 : of_force * work.records);
  EXPECT_EQ(back, there);
  EXPECT_EQ(work.records > 0, ranks > 1);
}

/// Forces of corners cross in one copy there and one back; sums come without a copy.
TEST_F(RanksOnGpus, CopyForcesOnceThereAndOnceBack) {
  expect_in_a_step(1, false, 2, 2);
  expect_in_a_step(2, false, 4, 4);
  expect_in_a_step(4, false, 4, 4);
}

TEST_F(RanksOnGpus, CopyNothingWhereMessagesReachTheDevice) { expect_in_a_step(3, true, 4, 3); }

/// Beside forces of corners a number for each element that another rank has around one of its nodes.
TEST_F(RanksOnGpus, CopyVolumesOnceThereAndOnceBack) {
  Scene scene = torn_tetrahedra(Precision::float64, {6, 6, 12});
  scene.device = Device::cuda;
  for (const int ranks : {1, 2, 3}) {
    SharedWork work;
    const std::vector<Counts> fewer = counts_of(scene, ranks, 3, work, false),
                              more = counts_of(scene, ranks, 4, work, false);
    std::int64_t there = 0, back = 0;
    for (int rank = 0; rank < ranks; ++rank) {
      there += more[rank].to_device - fewer[rank].to_device;
      back += more[rank].to_host - fewer[rank].to_host;
    }
    EXPECT_EQ(there, back);
    const std::int64_t of_volumes = there - 24 * work.records, of_one = 8;
    EXPECT_EQ(of_volumes % of_one, 0);
    EXPECT_EQ(of_volumes > 0, ranks > 1);
    EXPECT_LT(of_volumes / of_one, (ranks - 1) * 6 * 6 * 6 * 12 + 1);
    EXPECT_LE(there, work.bytes_per_step);
  }
}

/// Blocks that do not meet yet: in a step whose lists hold forces alone cross of the nodes of the surface, those of
/// each from one rank, to all, and what contact reads of its lists on any rank as on one. Of some steps the one in
/// which least crosses.
TEST_F(RanksOnGpus, CopyForcesOfTheSurfaceOnceInEachDirection) {
  Scene scene =
      scene_of({block("low", {8, 8, 8}, 0.01, {}), block("high", {8, 8, 8}, 0.01, {0.003, 0.002, 0.5})}, 1e-4);
  for (Body& body : scene.bodies) body.velocity_gradient = {Point{40, 3, 0}, Point{0, -15, 2}, Point{5, 0, -12}};
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.device = Device::cuda;
  std::int64_t read_of_lists = 0;
  for (const int ranks : {1, 2, 3}) {
    SharedWork work;
    std::int64_t there = std::numeric_limits<std::int64_t>::max(), back = there;
    Counts before;
    for (int steps = 5; steps < 14; ++steps) {
      Counts all;
      for (const Counts& of : counts_of(scene, ranks, steps, work, false)) {
        all.to_device += of.to_device;
        all.to_host += of.to_host;
      }
      if (steps > 5) {
        there = std::min(there, all.to_device - before.to_device);
        back = std::min(back, all.to_host - before.to_host);
      }
      before = all;
    }
    constexpr std::int64_t of_force = 24, of_record = 32;
    EXPECT_GT(work.common_nodes, 700);
    EXPECT_EQ(there, of_force * work.records + ranks * of_record * work.common_nodes);
    const std::int64_t of_forces = of_force * work.records + of_record * work.common_nodes;
    if (ranks == 1) read_of_lists = back - of_forces;
    EXPECT_LT(read_of_lists, 1000);
    EXPECT_EQ(back, of_forces + ranks * read_of_lists);
  }
}

TEST_F(RanksOnGpus, HaveTheSameBitsWhereMessagesReachTheDevice) {
  const Scene scene = torn_on_gpu();
  Solver<double> alone(scene);
  const Outcome expected = outcome_of(alone);
  const Outcome found = on_ranks(
      3, {},
      [&](ThreadRanks& ranks) {
        Solver<double> solver(scene, &ranks);
        return outcome_of(solver);
      },
      [&](ThreadRanks& ranks) { Solver<double>(scene, &ranks).follow_rank_0(); }, true);
  EXPECT_TRUE(found == expected);
}

}  // namespace
}  // namespace pinball::ranks_on_gpus_test
