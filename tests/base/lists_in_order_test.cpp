#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <solver/base/lists_in_order.hpp>

namespace pinball::lists_in_order_test {

/// Sizes around those of the pieces, and none.
constexpr std::int64_t sizes[] = {0, 1, 2, 63, 64, 65, 1000};

TEST(ListsInOrder, OffsetsAreSumsOfThoseBefore) {
  std::mt19937 random(7);
  for (const std::int64_t size : sizes) {
    std::vector<std::int32_t> counts(size);
    for (std::int32_t& count : counts) count = static_cast<std::int32_t>(random() % 6);
    std::vector<std::int32_t> expected(size);
    std::exclusive_scan(counts.begin(), counts.end(), expected.begin(), 0);
    const std::int64_t sum = std::reduce(counts.begin(), counts.end());
    EXPECT_EQ(make_offsets(counts), sum) << size;
    EXPECT_EQ(counts, expected) << size;
  }
}

TEST(ListsInOrder, ListsHaveWhatIsChosenFromTheLowestUp) {
  for (const std::int64_t size : sizes) {
    std::vector<std::int32_t> list{-7, -7}, expected;  // what it had is gone
    for (std::int64_t i = 0; i < size; ++i) {
      if (i % 7 == 3 || i % 5 == 1) expected.push_back(static_cast<std::int32_t>(i));
    }
    list_where("chosen", size, list, [](std::int64_t i) { return i % 7 == 3 || i % 5 == 1; });
    EXPECT_EQ(list, expected) << size;
  }
}

TEST(ListsInOrder, TheFirstIsTheLowest) {
  for (const std::int64_t size : sizes) {
    EXPECT_EQ(first_where("none", size, [](std::int64_t) { return false; }), size);
    for (const std::int64_t at : {std::int64_t{0}, size / 3, size - 1}) {
      if (at < 0 || at >= size) continue;
      EXPECT_EQ(first_where("from there on", size, [at](std::int64_t i) { return i >= at; }), at) << size;
      EXPECT_EQ(first_where("there alone", size, [at](std::int64_t i) { return i == at; }), at) << size;
    }
  }
}

TEST(ListsInOrder, SeveralMayMarkCountAndGiveAtTheSameTime) {
  constexpr std::int64_t count = 20000;
  std::uint8_t mark = 0, bits = 0;
  std::int32_t counted = 0, lowest = count;
  std::vector<std::uint8_t> places(count, 0);
  parallel_for("all at once", RangePolicy<>{0, count}, [&](std::int64_t i) {
    set_mark(mark);
    set_bits(bits, static_cast<std::uint8_t>(1U << (i % 6)));
    set_mark(places[count_one(counted)]);
    keep_lowest(lowest, static_cast<std::int32_t>(5 + (i * 7919) % count));
  });
  EXPECT_EQ(mark, 1);
  EXPECT_EQ(bits, 63);
  EXPECT_EQ(counted, count);
  EXPECT_EQ(lowest, 5);
  EXPECT_EQ(std::reduce(places.begin(), places.end(), std::int64_t{0}), count);
}

}  // namespace pinball::lists_in_order_test
