#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

#include <solver/contact/faces/found_features.hpp>
#include <solver/contact/faces/row_pieces.hpp>
#include <solver/parallel/rank_sharers.hpp>
#include <tests/support/solver_case.hpp>

#include "outcome.hpp"

/// Ranks that share the search for what may touch, and for what does.
namespace pinball::shared_contact_test {
namespace {

using namespace test;

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

/// The same without impulses.
Scene wide_blocks_of_balls(double end) {
  Scene scene = wide_blocks(end);
  scene.contact.enforcement = Enforcement::penalty;
  scene.contact.gap = ContactGap::pinball;
  scene.contact.friction = scene.contact.static_friction = 0;
  return scene;
}

constexpr double few_steps = 6e-5;

TEST(SharedContact, HasTheBitsOfOneProcess) {
  const std::vector<Shared> few_and_many{{2, {}}, {4, {Partition::By::random, 1}}, {7, {Partition::By::random, 2}}};
  const Outcome faces = expect_same_on<double>(few_and_many, wide_blocks(few_steps));
  EXPECT_GT(faces.pairs, 1000);
  EXPECT_GT(faces.searches, 0);
  const Outcome balls = expect_same_on<double>(few_and_many, wide_blocks_of_balls(few_steps));
  EXPECT_GT(balls.pairs, 1000);
}

TEST(SharedContact, BySearchesOfEachKind) {
  for (const ContactSearch search : {ContactSearch::tree, ContactSearch::hash}) {
    for (Scene scene : {wide_blocks(few_steps), wide_blocks_of_balls(few_steps)}) {
      scene.contact.search = search;
      expect_same_on<double>({{3, {Partition::By::random, 3}}}, scene);
    }
  }
}

TEST(SharedContact, InSinglePrecision) {
  Scene scene = wide_blocks(few_steps);
  scene.precision = Precision::float32;
  expect_same_on<float>({{3, {Partition::By::random, 4}}}, scene);
}

/// Each pair of a list is found by one rank: all messages together have each of them once.
TEST(SharedContact, IsWorkedOnceByAllRanksTogether) {
  const Scene scene = wide_blocks(few_steps);
  const auto bytes_of_first_step = [&](int ranks, std::int64_t worth) {
    return solved_on<double>(
        ranks, {}, scene,
        [](Solver<double>& solver) {
          solver.step();
          return std::pair(solver.shared_work().bytes_per_step, solver.contact()->listed().entries);
        },
        {}, worth);
  };
  for (const int ranks : {2, 3}) {
    const auto [bytes, entries] = bytes_of_first_step(ranks, 0);
    const auto [without, same_entries] = bytes_of_first_step(ranks, never);
    EXPECT_EQ(entries, same_entries);
    EXPECT_GT(entries, 10000);
    // Pairs as they were found, some by several segments, of 8 bytes; then rows.
    EXPECT_GT(bytes - without, 8 * entries);
    EXPECT_LT(bytes - without, 40 * entries);
  }
}

TEST(SharedContact, IsEachRanksOwnWhereThereIsLittle) {
  const Scene scene =
      scene_of({block("a", {3, 3, 3}, 0.01, {0, 0, 0}), block("b", {3, 3, 3}, 0.01, {0, 0, 0.0301})}, 1e-5);
  const auto bytes = [&](std::int64_t worth) {
    return solved_on<double>(
        2, {}, scene,
        [](Solver<double>& solver) {
          solver.step();
          return solver.shared_work().bytes_per_step;
        },
        {}, worth);
  };
  EXPECT_EQ(bytes(Ranks::worth_a_message_by_default), bytes(never));
  EXPECT_GT(bytes(0), bytes(never));
}

/// One number is the first of a third of the pairs: they are in one part.
TEST(SharedContact, IsInPartsThatHaveAllPairsOfTheirFirsts) {
  std::mt19937 random(5);
  const auto below = [&](std::int32_t bound) { return static_cast<std::int32_t>(random() % bound); };
  for (const int count : {0, 10, 3000, 30000, 300000}) {
    SortedPairs list;
    for (int n = 0; n < count; ++n)
      list.found()[n % fixed_pieces].add(below(3) == 0 ? 1000 : below(5000), below(30000));
    list.sort(5000, 8, true);
    EXPECT_EQ(std::ssize(ListShare(list).parts()), list.pieces.count);
    const std::vector<ListPart> parts = ListShare(list, 256).parts();
    EXPECT_LE(std::ssize(parts), fixed_pieces);
    EXPECT_GE(std::ssize(parts), std::max<std::int64_t>(list.pieces.count, std::min(count / 600, 32)));
    std::vector<std::array<std::int32_t, 2>> pairs, expected;
    list.for_each([&](std::int32_t first, std::int32_t second) { expected.push_back({first, second}); });
    std::int64_t most = 0;
    for (const ListPart& part : parts) {
      EXPECT_TRUE(pairs.empty() || part.pairs() == 0 || pairs.back()[0] < list.first[part.begin]);
      for (std::int64_t at = part.begin; at < part.end; ++at) pairs.push_back({list.first[at], list.second[at]});
      most = std::max(most, part.pairs());
    }
    EXPECT_EQ(pairs, expected);
    EXPECT_LE(most, std::max<std::int64_t>(520, list.pieces.entries / 2)) << count;
  }
}

/// What ranks have found of all kinds is found by all, whoever found it.
TEST(SharedContact, TakesInWhatOthersHaveFound) {
  constexpr int ranks = 3;
  const auto find = [](ThreadRanks& rank) {
    rank.worth_a_message = 0;
    RankSharers sharers(rank);
    const PieceShare share(&sharers, fixed_pieces, 1);
    PairOrder::Pieces nodes, edges;
    FoundFeatures::Pieces with_segments, with_spheres;
    for (std::int32_t p = 0; p < fixed_pieces; ++p) {
      if (!share.is_own(p)) continue;
      nodes[p].add(p, 1);
      edges[p].add(p, 2);
      edges[p].add(p, 3);
      with_segments[p] = {{p, 4}};
      if (p % 2 == 0) with_spheres[p] = {{p, 5}, {p, 6}};
    }
    FoundFeatures{nodes, edges, with_segments, with_spheres}.add_from_others(share);
    for (std::int32_t p = 0; p < fixed_pieces; ++p) {
      EXPECT_EQ(nodes[p].pairs, 1U);
      EXPECT_EQ(nodes[p].first[0], p);
      EXPECT_EQ(edges[p].pairs, 2U);
      EXPECT_EQ(edges[p].second[1], 3);
      EXPECT_EQ(with_segments[p], (std::vector<std::array<std::int32_t, 2>>{{p, 4}}));
      EXPECT_EQ(with_spheres[p].size(), p % 2 == 0 ? 2U : 0U);
    }
    return 0;
  };
  on_ranks(ranks, {}, find, find);
}

}  // namespace
}  // namespace pinball::shared_contact_test
