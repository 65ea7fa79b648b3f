#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include <solver/contact/faces/sorted_pairs.hpp>

namespace pinball {
namespace {

using Pair = SortedPairs::Pair;
using Found = SortedPairs::Found;

/// Pairs at random in all pieces, many of them several times; one number is the first of a tenth of them.
Found random_pairs(std::mt19937& random, int count, std::int32_t firsts, std::int32_t seconds) {
  const auto below = [&](std::int32_t bound) { return static_cast<std::int32_t>(random() % bound); };
  Found found;
  for (int n = 0; n < count; ++n) {
    const std::int32_t first = below(10) == 0 ? firsts / 3 : below(firsts);
    const Pair pair{first, below(seconds)};
    for (std::int32_t times = below(3); times >= 0; --times) found[below(fixed_pieces)].push_back(pair);
  }
  return found;
}

std::vector<Pair> once_each(const Found& found) {
  std::set<Pair> pairs;
  for (const std::vector<Pair>& some : found) pairs.insert(some.begin(), some.end());
  return {pairs.begin(), pairs.end()};
}

std::vector<Pair> pairs_of(const SortedPairs& list) {
  std::vector<Pair> pairs;
  for (std::int64_t piece = 0; piece < list.pieces.count; ++piece) {
    for (std::int64_t at = list.pieces.begin[piece]; at < list.pieces.end[piece]; ++at) {
      pairs.push_back({list.first[at], list.second[at]});
    }
  }
  return pairs;
}

/// Whole packs can be read from where each piece begins, and name valid things.
void expect_whole_packs(const SortedPairs& list, std::int64_t width, std::int32_t firsts, std::int32_t seconds) {
  std::int64_t end = 0, entries = 0;
  for (std::int64_t piece = 0; piece < list.pieces.count; ++piece) {
    EXPECT_EQ(list.pieces.begin[piece] % width, 0);
    EXPECT_GE(list.pieces.begin[piece], end);
    EXPECT_GE(list.pieces.end[piece], list.pieces.begin[piece]);
    end = list.pieces.end[piece];
    entries += end - list.pieces.begin[piece];
  }
  EXPECT_EQ(list.pieces.entries, entries);
  EXPECT_EQ(list.pieces.places % width, 0);
  EXPECT_GE(list.pieces.places, end);
  ASSERT_EQ(static_cast<std::int64_t>(list.first.size()), list.pieces.places);
  ASSERT_EQ(static_cast<std::int64_t>(list.second.size()), list.pieces.places);
  for (std::size_t at = 0; at < list.first.size(); ++at) {
    EXPECT_TRUE(list.first[at] >= 0 && list.first[at] < firsts);
    EXPECT_TRUE(list.second[at] >= 0 && list.second[at] < seconds);
  }
}

TEST(SortedPairs, HasEachPairOnceInOrderAndPiecesOfWholePacks) {
  std::mt19937 random(3);
  SortedPairs list;  // one for all: nothing of a list before is left
  for (const int count : {1, 7, 20000, 300, 100000, 64}) {
    for (const std::int64_t width : {1, 4, 8, 16}) {
      const Found found = random_pairs(random, count, 500, 300);
      list.sort(found, 500, width);
      EXPECT_EQ(pairs_of(list), once_each(found));
      expect_whole_packs(list, width, 500, 300);
      EXPECT_EQ(list.pieces.count > 1, count >= 20000);
    }
  }
}

TEST(SortedPairs, OfOneFirstAreInOnePiece) {
  std::mt19937 random(5);
  SortedPairs list;
  list.sort(random_pairs(random, 50000, 500, 300), 500, 8);
  ASSERT_GT(list.pieces.count, 8);
  int before = -1;
  for (std::int64_t piece = 0; piece < list.pieces.count; ++piece) {
    if (list.pieces.begin[piece] == list.pieces.end[piece]) continue;
    EXPECT_GT(list.first[list.pieces.begin[piece]], before);
    before = list.first[list.pieces.end[piece] - 1];
  }
}

TEST(SortedPairs, OfNothingAreNone) {
  for (const std::size_t firsts : {0, 1, 100}) {
    SortedPairs list;
    list.sort({}, firsts, 8);
    EXPECT_EQ(list.pieces.entries, 0);
    EXPECT_EQ(list.pieces.places, 0);
    EXPECT_TRUE(pairs_of(list).empty());
    for (std::size_t f = 0; f < firsts; ++f) EXPECT_FALSE(list.has({static_cast<std::int32_t>(f), 0}));
  }
}

TEST(SortedPairs, KnowWhatTheyHave) {
  std::mt19937 random(7);
  for (const int count : {30, 600, 30000}) {
    const Found found = random_pairs(random, count, 200, 100);
    SortedPairs list;
    list.sort(found, 200, 8);
    const std::vector<Pair> pairs = once_each(found);
    const std::set<Pair> expected(pairs.begin(), pairs.end());
    std::size_t had = 0;
    for (std::int32_t first = 0; first < 200; ++first) {
      for (std::int32_t second = -1; second <= 100; ++second) {
        EXPECT_EQ(list.has({first, second}), expected.count({first, second}) == 1);
        had += list.has({first, second});
      }
    }
    EXPECT_EQ(had, expected.size());
  }
}

TEST(SortedPairs, AreGivenBackAsIfTheyHadBeenFound) {
  std::mt19937 random(11);
  for (const int count : {0, 300, 30000}) {
    SortedPairs list, again;
    list.sort(random_pairs(random, count, 500, 300), 500, 8);
    Found back = random_pairs(random, 100, 500, 300);  // what was found before is no part of it
    list.give_back(back);
    std::size_t given = 0;
    for (const std::vector<Pair>& some : back) given += some.size();
    EXPECT_EQ(static_cast<std::int64_t>(given), list.pieces.entries);
    // With more pairs, as erosion brings them.
    back[5].push_back({17, 299});
    back[2].push_back({499, 0});
    back[3].push_back({17, 299});
    again.sort(back, 500, 8);
    std::vector<Pair> pairs = pairs_of(list);
    std::set<Pair> expected(pairs.begin(), pairs.end());
    expected.insert({{17, 299}, {499, 0}});
    EXPECT_EQ(pairs_of(again), std::vector<Pair>(expected.begin(), expected.end()));
  }
}

}  // namespace
}  // namespace pinball
