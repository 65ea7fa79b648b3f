#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include <solver/contact/faces/sorted_pairs.hpp>

namespace pinball::sorted_pairs_test {
namespace {

using Pair = std::array<std::int32_t, 2>;

/// Pairs at random in all pieces of what a list finds, many of them several times; one number is the first of a tenth
/// of them. Returns each once.
std::set<Pair> find_random(SortedPairs& list, std::mt19937& random, int count, std::int32_t firsts,
                           std::int32_t seconds) {
  const auto below = [&](std::int32_t bound) { return static_cast<std::int32_t>(random() % bound); };
  std::set<Pair> pairs;
  for (PairColumns& piece : list.found()) piece.pairs = 0;
  for (int n = 0; n < count; ++n) {
    const std::int32_t first = below(10) == 0 ? firsts / 3 : below(firsts), second = below(seconds);
    for (std::int32_t times = below(3); times >= 0; --times) {
      list.found()[below(fixed_pieces)].add(first, second);
      pairs.insert({first, second});
    }
  }
  return pairs;
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
      for (const bool grows : {false, true}) {
        const std::set<Pair> expected = find_random(list, random, count, 500, 300);
        list.sort(500, width, grows);
        EXPECT_EQ(pairs_of(list), std::vector<Pair>(expected.begin(), expected.end()));
        expect_whole_packs(list, width, 500, 300);
        EXPECT_EQ(list.pieces.count > 1, count >= 20000);
      }
    }
  }
}

/// Of each piece with pairs, its first number lies behind the last one of the pieces before.
void expect_firsts_in_one_piece(const SortedPairs& list) {
  int before = -1;
  for (std::int64_t piece = 0; piece < list.pieces.count; ++piece) {
    if (list.pieces.begin[piece] == list.pieces.end[piece]) continue;
    EXPECT_GT(list.first[list.pieces.begin[piece]], before);
    before = list.first[list.pieces.end[piece] - 1];
  }
}

TEST(SortedPairs, ThatAreFewAreInOnePieceWithoutRoom) {
  std::mt19937 random(7);
  SortedPairs list;
  for (const int count : {0, 1, 5, 300}) {
    const std::set<Pair> expected = find_random(list, random, count, 100, 50);
    list.sort_few();
    EXPECT_EQ(pairs_of(list), std::vector<Pair>(expected.begin(), expected.end()));
    EXPECT_EQ(list.pieces.count, 1);
    EXPECT_EQ(list.pieces.entries, std::ssize(expected));
    EXPECT_EQ(list.pieces.places, std::ssize(expected));
  }
}

TEST(SortedPairs, OfOneFirstAreInOnePiece) {
  std::mt19937 random(5);
  SortedPairs list;
  find_random(list, random, 50000, 500, 300);
  list.sort(500, 8);
  ASSERT_GT(list.pieces.count, 8);
  expect_firsts_in_one_piece(list);
}

TEST(SortedPairs, OfNothingAreNone) {
  for (const std::int32_t firsts : {0, 1, 100}) {
    SortedPairs list;
    EXPECT_FALSE(list.has(0, 0)) << "before it is made";
    list.sort(firsts, 8);
    EXPECT_EQ(list.pieces.entries, 0);
    EXPECT_EQ(list.pieces.places, 0);
    EXPECT_TRUE(pairs_of(list).empty());
    for (std::int32_t f = 0; f < firsts; ++f) EXPECT_FALSE(list.has(f, 0));
  }
}

TEST(SortedPairs, KnowWhatTheyHave) {
  std::mt19937 random(7);
  for (const int count : {30, 600, 30000}) {
    SortedPairs list;
    const std::set<Pair> expected = find_random(list, random, count, 200, 100);
    list.sort(200, 8);
    std::size_t had = 0;
    for (std::int32_t first = 0; first < 200; ++first) {
      for (std::int32_t second = -1; second <= 100; ++second) {
        EXPECT_EQ(list.has(first, second), expected.count({first, second}) == 1);
        had += list.has(first, second) ? 1 : 0;
      }
    }
    EXPECT_EQ(had, expected.size());
  }
}

/// As erosion brings them, until there is no room: then the list is as it was.
TEST(SortedPairs, TakeInMoreWhereThereIsRoom) {
  std::mt19937 random(11);
  for (const int count : {1, 300, 10000}) {
    SortedPairs list, more;
    std::set<Pair> expected = find_random(list, random, count, 500, 300);
    list.sort(500, 8, true);
    int taken = 0;
    for (bool room = true; room; ++taken) {
      const int some = taken == 0 ? 0 : std::max(1, count / 40);
      std::set<Pair> others = find_random(more, random, some, 500, 300);
      for (PairColumns& piece : more.found()) piece.pairs = 0;
      std::erase_if(others, [&](const Pair& pair) { return expected.count(pair) == 1; });
      for (const Pair& pair : others) more.found()[random() % fixed_pieces].add(pair[0], pair[1]);
      more.sort(500, 1);
      std::vector<std::int32_t> along(list.first.begin(), list.first.end());  // an array along the list
      const auto made = list.insert(more);
      room = made.has_value();
      if (room) {
        expected.insert(others.begin(), others.end());
        made->make_in(along.data());
        std::size_t places = 0;
        made->for_each_place([&](std::int64_t place) {
          along[static_cast<std::size_t>(place)] = list.first[static_cast<std::size_t>(place)];
          ++places;
        });
        EXPECT_EQ(places, others.size());
        EXPECT_TRUE(std::equal(along.begin(), along.end(), list.first.begin()));
      }
      ASSERT_EQ(pairs_of(list), std::vector<Pair>(expected.begin(), expected.end()));
      for (const Pair& pair : expected) ASSERT_TRUE(list.has(pair[0], pair[1]));
      for (int n = 0; n < 1000; ++n) {
        const Pair pair{static_cast<std::int32_t>(random() % 500), static_cast<std::int32_t>(random() % 300)};
        ASSERT_EQ(list.has(pair[0], pair[1]), expected.count(pair) == 1);
      }
      expect_whole_packs(list, 8, 500, 300);
      expect_firsts_in_one_piece(list);
    }
    EXPECT_GT(taken, 2) << count;
  }
}

TEST(SortedPairs, WithoutRoomTakeInNothing) {
  SortedPairs list, more;
  for (std::int32_t n = 0; n < 8; ++n) list.found()[0].add(n, n);
  list.sort(100, 8);
  more.found()[0].add(3, 4);
  more.sort(100, 1);
  EXPECT_FALSE(list.insert(more).has_value());
  EXPECT_EQ(pairs_of(list).size(), 8U);
  EXPECT_FALSE(SortedPairs().insert(more).has_value());
}

}  // namespace
}  // namespace pinball::sorted_pairs_test
