#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include <solver/parallel/partition.hpp>
#include <solver/parallel/planned_ranks.hpp>
#include <solver/parallel/subdomain.hpp>
#include <solver/step/integration.hpp>
#include <tests/elements/thin_section.hpp>
#include <tests/support/pressed_block.hpp>
#include <tests/support/tetrahedra_case.hpp>
#include <tests/support/thread_ranks.hpp>

/// How ranks share a scene, what they send, and what they do where something is wrong.
namespace pinball::ranks_test {
namespace {

using namespace test;

Scene cube(int n = 12) { return scene_of({block("cube", {n, n, n}, 0.01, {}, {1, 2, 3})}, 1e-5, false); }

std::vector<std::int32_t> partition_of(const Model<double>& model, int count, const Partition& partition) {
  return on_ranks(
      count, partition, [&](ThreadRanks& ranks) { return ranks_of_tiles(model, ranks); }, [](ThreadRanks&) {});
}

TEST(Partition, OfRangesGivesEachRankItsShareOfConsecutiveTiles) {
  const Model<double> model = build_model<double>(cube());
  const std::vector<std::int32_t> elements = elements_of_tiles(model);
  EXPECT_EQ(std::accumulate(elements.begin(), elements.end(), 0), 12 * 12 * 12);
  for (const int count : {1, 2, 3, 7}) {
    const std::vector<std::int32_t> rank = partition_of(model, count, {});
    EXPECT_TRUE(std::is_sorted(rank.begin(), rank.end()));
    std::vector<int> of_rank(count, 0);
    for (std::size_t t = 0; t < rank.size(); ++t) of_rank[rank[t]] += elements[t];
    const int largest = *std::max_element(elements.begin(), elements.end());
    for (const int own : of_rank) EXPECT_NEAR(own, 12.0 * 12 * 12 / count, largest) << count;
  }
}

/// With subcycling elements of small steps are worked more often.
TEST(Partition, OfRangesGivesEachRankItsShareOfTheStepsOfElements) {
  const Scene scene = bar_with_thin_section(1, 4);
  const Model<double> model = build_model<double>(scene);
  const std::vector<std::int32_t> work = work_of_tiles(model);
  const int all = std::reduce(work.begin(), work.end()), fine = 16 * 10, cubes = 16 * 22;
  EXPECT_EQ(all, 4 * fine + cubes);
  for (const int count : {2, 3, 4}) {
    const std::vector<std::int32_t> rank = partition_of(model, count, {});
    std::vector<int> of_rank(count, 0);
    for (std::size_t t = 0; t < rank.size(); ++t) of_rank[rank[t]] += work[t];
    const int largest = *std::ranges::max_element(work);
    for (const int own : of_rank) EXPECT_NEAR(own, static_cast<double>(all) / count, largest) << count;
    const SharedWork shared =
        solved_on<double>(count, {}, scene, [](Solver<double>& solver) { return solver.shared_work(); });
    EXPECT_EQ(shared.imbalance, *std::ranges::max_element(of_rank) * count / static_cast<double>(all));
  }
}

TEST(Partition, AtRandomFollowsItsSeedAndUsesAllRanks) {
  const Model<double> model = build_model<double>(cube());
  const std::vector<std::int32_t> rank = partition_of(model, 4, {Partition::By::random, 1});
  EXPECT_EQ(std::set<std::int32_t>(rank.begin(), rank.end()), (std::set<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(partition_of(model, 4, {Partition::By::random, 1}), rank);
  EXPECT_NE(partition_of(model, 4, {Partition::By::random, 2}), rank);
}

/// Two ranks: each corner of an element at a node that both hold goes once to the other. Counted here from the elements
/// alone; nodes that a rank holds for a sum come on top, fewer than two spans of them.
TEST(Ranks, SendTheForceOfEachCornerAtASharedNode) {
  const Model<double> model = build_model<double>(cube());
  const std::vector<std::int32_t> rank = partition_of(model, 2, {});
  std::vector<int> seen(model.nodes.count, 0);
  const auto for_each_corner = [&](const auto& visit) {
    for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
      for (const std::int64_t slot : model.slots_of(tile)) {
        if (model.is_padding(slot)) continue;
        for (const std::int32_t node : model.elements.corners(slot)) visit(node, rank[tile]);
      }
    }
  };
  for_each_corner([&](std::int32_t node, std::int32_t r) { seen[node] |= 1 << r; });
  std::int64_t corners = 0;
  for_each_corner([&](std::int32_t node, std::int32_t) { corners += seen[node] == 3 ? 1 : 0; });
  EXPECT_EQ(corners, 2 * 4 * 12 * 12);  // halves of a cube: four corners of the elements on each side of the cut
  const SharedWork work = solved_on<double>(2, {}, cube(), [](Solver<double>& solver) { return solver.shared_work(); });
  EXPECT_EQ(work.ranks, 2);
  EXPECT_GE(work.records, corners);
  EXPECT_LE(work.records, corners + 8 * 2 * nodes_per_span);
  EXPECT_EQ(work.messages, 2);
  EXPECT_LE(work.imbalance, 1.1);
  std::int64_t elements[2] = {0, 0};
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) elements[rank[tile]] += elements_of_tiles(model)[tile];
  EXPECT_EQ(elements[0] + elements[1], 12 * 12 * 12);
  EXPECT_EQ(work.most_elements, std::max(elements[0], elements[1]));
  EXPECT_EQ(work.imbalance, work.most_elements / (12 * 12 * 12 / 2.0));
}

/// All bytes of each step, as the messages have them, on three ranks. steps: cycles of them; of a cycle the mean is
/// reported, a whole number. Returns what is reported in the end.
SharedWork expect_reported_bytes(const Scene& scene, int steps) {
  std::vector<std::int64_t> sent(3, 0);
  std::int64_t reported = 0, rounded = 0;
  SharedWork work;
  on_ranks(
      3, {},
      [&](ThreadRanks& ranks) {
        ranks.worth_a_message = 0;
        Solver<double> solver(scene, &ranks);
        ranks.sent = 0;
        for (int step = 0; step < steps; ++step) {
          const std::int64_t before = solver.steps();
          solver.step();
          work = solver.shared_work();
          const std::int64_t steps_of_cycle = solver.steps() - before;
          reported += steps_of_cycle * work.bytes_per_step;
          rounded += steps_of_cycle - 1;
        }
        sent[0] = ranks.sent;
        return 0;
      },
      [&](ThreadRanks& ranks) {
        ranks.worth_a_message = 0;
        Solver<double> solver(scene, &ranks);
        ranks.sent = 0;
        solver.follow_rank_0();
        sent[ranks.number()] = ranks.sent;
      });
  const std::int64_t all = std::reduce(sent.begin(), sent.end());
  EXPECT_GE(all, reported);
  EXPECT_LE(all, reported + rounded);
  return work;
}

/// The same where all elements are worked in each step.
void expect_reported_bytes_of_all(const Scene& scene, int steps) {
  const SharedWork work = expect_reported_bytes(scene, steps);
  EXPECT_GT(work.bytes_per_step, 24 * (work.records + work.common_nodes));
}

TEST(Ranks, SendAsManyBytesInAStepAsTheyReport) { expect_reported_bytes_of_all(cube(), 5); }

/// Forces and results of elements whose own step is not over are not sent.
TEST(Ranks, SendTheLessTheFewerElementsAreWorked) {
  const Scene scene = bar_with_thin_section(1e-2, 4);
  const std::int64_t of_first = expect_reported_bytes(scene, 1).bytes_per_step;  // which works all
  const SharedWork work = expect_reported_bytes(scene, 6);
  EXPECT_GT(of_first, 24 * work.records);
  EXPECT_LT(work.bytes_per_step, of_first * 3 / 4);
}

/// Nor are kinetic energies of spans whose own step is not over.
TEST(Ranks, SendEnergiesOfSpansThatAreDueAlone) {
  const auto moving = [] {
    Model<double> model = build_model<double>(cube());
    for (std::int32_t n = 0; n < model.nodes.count; ++n) model.nodes.velocity_of(n)[0] = n;
    return model;
  };
  const auto check = [&](ThreadRanks& ranks) {
    Model<double> model = moving(), alone = moving();
    Subdomain<double> domain(model, ranks);
    domain.connect(model, 0);
    std::vector<std::int8_t> levels(span_count(model.nodes.count), 3);
    levels[2] = levels.back() = 0;
    const std::int64_t before = ranks.bytes_given;
    const StepLengths none{.before = 0, .after = 0};
    const MotionEnergy energy = integrate_nodes(model, {&levels, 0}, none, &domain);
    EXPECT_EQ(ranks.bytes_given - before, 2 * std::int64_t{sizeof(MotionEnergy)});
    EXPECT_EQ(energy.kinetic, integrate_nodes<double>(alone, {&levels, 0}, none, nullptr).kinetic);
    EXPECT_GT(energy.kinetic, 0);
    EXPECT_TRUE(ranks.number() == 0 || domain.next_order() == RankOrder::end);
  };
  on_ranks(3, {}, check, check);
}

/// Nodes deep inside what another rank works, as if erosion had brought them to the surface.
TEST(Ranks, MoveNodesThatHaveBecomeCommonFromThenOn) {
  constexpr std::int32_t first = 10, last = 50;
  constexpr double own = 1, others = 2;
  const auto check = [&](ThreadRanks& ranks) {
    Model<double> model = build_model<double>(cube(16));
    Subdomain<double> domain(model, ranks);
    domain.connect(model, 0);
    const auto works = [&](std::int32_t node) {
      return std::ranges::any_of(domain.node_blocks().worked(), [node](const SharedBlocks::Run& run) {
        return node >= run.begin * nodes_per_span && node < run.end * nodes_per_span;
      });
    };
    std::vector<std::int32_t> nodes(last - first);
    std::iota(nodes.begin(), nodes.end(), first);
    EXPECT_TRUE(ranks.number() < 2 || !works(first));
    for (const std::int32_t n : nodes) {
      const double value = domain.rank_of_node(n) == ranks.number() ? own : others;
      for (int k = 0; k < 3; ++k)
        model.nodes.position_of(n)[k] = model.nodes.velocity_of(n)[k] = model.nodes.force_of(n)[k] = value + k;
    }
    domain.take_in(model, nodes);
    for (const std::int32_t n : nodes) {
      EXPECT_TRUE(works(n));
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(model.nodes.position_of(n)[k], own + k);
        EXPECT_EQ(model.nodes.velocity_of(n)[k], own + k);
        EXPECT_EQ(model.nodes.force_of(n)[k], own + k);
      }
      for (int k = 0; k < 3; ++k) model.nodes.force_of(n)[k] = domain.rank_of_node(n) == ranks.number() ? 7 : -7;
    }
    domain.collect(model.nodes, 0);
    for (const std::int32_t n : nodes) EXPECT_EQ(model.nodes.force_of(n)[1], 7);
    EXPECT_EQ(domain.work().common_nodes, last - first);
    EXPECT_TRUE(ranks.number() == 0 || domain.next_order() == RankOrder::end);
  };
  on_ranks(3, {}, check, check);
}

TEST(Ranks, SendAsManyBytesOfContactInAStepAsTheyReport) {
  Scene scene = pressed_blocks(1e-3);
  scene.materials = {plastic_material("steel", 4e8, 0.02)};
  expect_reported_bytes_of_all(scene, 25);
}

TEST(Ranks, SendAsManyBytesOfTetrahedraInAStepAsTheyReport) { expect_reported_bytes_of_all(torn_tetrahedra(), 40); }

/// What three processes share and send in their first step, counted by one of them alone.
TEST(PlannedRanks, CountWhatRanksSend) {
  for (const Scene& scene : {cube(), pressed_blocks(1e-3), torn_tetrahedra(), bar_with_thin_section(1e-2, 4)}) {
    const auto first_step = [](Solver<double>& solver) {
      solver.step();
      return solver.shared_work();
    };
    PlannedRanks ranks(3, {});
    const SharedWork real = solved_on<double>(3, {}, scene, first_step, {}, ranks.worth_a_message);
    Solver<double> solver(scene, &ranks);
    const SharedWork planned = first_step(solver);
    EXPECT_EQ(planned.records, real.records);
    EXPECT_EQ(planned.messages, real.messages);
    EXPECT_EQ(planned.common_nodes, real.common_nodes);
    EXPECT_EQ(planned.bytes_per_step, real.bytes_per_step);
    EXPECT_EQ(planned.most_elements, real.most_elements);
    EXPECT_EQ(planned.imbalance, real.imbalance);
    EXPECT_TRUE(real.messages >= 4 && real.messages <= 6) << real.messages;  // each has one or two neighbours
    EXPECT_GT(real.bytes_per_step, 24 * real.records);
  }
}

TEST(Ranks, WithoutTilesTakePart) {
  const Scene scene = scene_of({block("cube", {2, 2, 2}, 0.01, {}, {1, 2, 3})}, 1e-5, false);
  const auto hash = [](Solver<double>& solver) {
    run(solver);
    return state_hash(solver.model());
  };
  Solver<double> alone(scene);
  EXPECT_EQ(solved_on<double>(5, {}, scene, hash), hash(alone));
}

TEST(Ranks, FailAllInOneWayWhereAGuardEndsTheRun) {
  Scene scene = pressed_block(0);
  scene.element.inside_out = InsideOut::stop;
  const auto error = [](Solver<double>& solver) { return error_of<RunError>([&] { run(solver); }); };
  Solver<double> alone(scene);
  const std::string expected = error(alone);
  EXPECT_NE(expected, no_error);
  for (const int count : {1, 2, 3})
    EXPECT_EQ(solved_on<double>(count, {Partition::By::random, 3}, scene, error), expected) << count;
}

/// What rank 0 says where another is set up as given.
std::string disagreement(const RankReady& first, const RankReady& second, std::uint64_t program = 1) {
  return error_of([&] {
    on_ranks(
        2, {},
        [&](ThreadRanks& ranks) {
          agree(ranks, first);
          return 0;
        },
        [&](ThreadRanks& ranks) {
          ranks.set_program(program);
          try {
            agree(ranks, second);
          } catch (const InputError&) {  // as rank 0 has it
          }
        });
  });
}

TEST(Ranks, OfUnlikeProgramsPacksOrMeshesAreRefused) {
  const RankReady own{0, "", 8, 5};
  EXPECT_EQ(disagreement(own, own), no_error);
  EXPECT_EQ(disagreement(own, {0, "", 4, 5}),
            "rank 1 has packs of 4, rank 0 of 8: expected one kind of processors, or a build for the least of them");
  EXPECT_THAT(disagreement(own, {0, "", 8, 6}), testing::HasSubstr("rank 1 has made another mesh"));
  EXPECT_THAT(disagreement(own, own, 2), testing::HasSubstr("rank 1 runs another program than rank 0"));
  EXPECT_EQ(disagreement(own, {2, "no such file", 0, 0}), "rank 1: no such file");
  EXPECT_EQ(disagreement({2, "no such scene", 0, 0}, own), no_error);  // it has its own to say
}

}  // namespace
}  // namespace pinball::ranks_test
