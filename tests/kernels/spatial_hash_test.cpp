#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <kernels/spatial_hash.hpp>
#include <tests/support/support.hpp>

namespace pinball::spatial_hash_test {
namespace {

using namespace test;

constexpr std::int32_t last_unit = (1 << cell_coordinate_bits) - 1;

HashBox box_of(const std::array<std::int32_t, 3>& low, const std::array<std::int32_t, 3>& high, std::int32_t number) {
  HashBox box{};
  std::int32_t longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    box.value[k] = low[k];
    box.value[3 + k] = -high[k];
    longest = std::max(longest, high[k] - low[k]);
  }
  box.value[6] = number;
  box.value[7] = level_of(longest);
  return box;
}

/// Boxes with sides up to 4^levels units.
std::vector<HashBox> random_boxes(int count, std::int32_t reach, int levels) {
  std::mt19937 random(3);
  std::vector<HashBox> boxes;
  for (std::int32_t n = 0; n < count; ++n) {
    std::array<std::int32_t, 3> low{}, high{};
    const std::int32_t most = 1 << std::uniform_int_distribution<int>(0, 2 * levels)(random);
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::uniform_int_distribution<std::int32_t>(0, reach)(random);
      high[k] = std::min(last_unit, low[k] + std::uniform_int_distribution<std::int32_t>(0, most)(random));
    }
    boxes.push_back(box_of(low, high, n));
  }
  return boxes;
}

TEST(CellGrid, IsTheFloor) {
  const CellGrid grid{{0.5, 0, -1}, 4.0};
  for (double x = 1; x < 7; x += 0.0625) {
    EXPECT_EQ(grid.coordinate(x, 0), int(std::floor((x - 0.5) * 4))) << x;
    EXPECT_EQ(grid.coordinate(x, 2), int(std::floor((x + 1) * 4))) << x;
  }
}

TEST(CellGrid, TakesWhatLiesOutsideToTheBorder) {
  const CellGrid grid{{0.5, 0, -1}, 4.0};
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double x : {1e10, 1e300, infinite}) EXPECT_EQ(grid.coordinate(x, 1), last_unit) << x;
  for (const double x : {-1e-10, -1e300, -infinite}) EXPECT_EQ(grid.coordinate(x, 1), 0) << x;
}

TEST(CellGrid, KeepsTheOrderOfNumbers) {
  const CellGrid grid{{0.1, 0, 0}, 1 / 0.3};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 100);
  for (int i = 0; i < 1000; ++i) {
    const double x = place(random);
    EXPECT_LE(grid.coordinate(x, 0), grid.coordinate(std::nextafter(x, 1000), 0));
    const double y = place(random);
    EXPECT_LE(grid.coordinate(std::min(x, y), 0), grid.coordinate(std::max(x, y), 0));
  }
}

TEST(LevelOfBox, IsTheLowestWhoseCellsAreNotShorter) {
  for (const std::int32_t side : {0, 1}) EXPECT_EQ(level_of(side), 0);
  for (int level = 1; level <= 15; ++level) {
    const std::int32_t cell = 1 << 2 * level;
    EXPECT_EQ(level_of(cell / 4 + 1), level);
    EXPECT_EQ(level_of(std::min(cell, last_unit)), level);
  }
}

TEST(HashCell, HoldsWhatReachesIntoTheNextOneAtMost) {
  for (const HashBox& box : random_boxes(2000, last_unit, 15)) {
    const HashCell cell = cell_of(box);
    EXPECT_TRUE(is_in_cell(box, cell));
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(in_cells(box.high(k), cell.level), cell.at[k] + 1);
      HashCell other = cell;
      ++other.at[k];
      EXPECT_FALSE(is_in_cell(box, other));
    }
    // No box has the level after the last, by which nothing can be shifted.
    const std::int32_t level = cell.level < level_of(last_unit) ? cell.level + 1 : cell.level - 1;
    EXPECT_FALSE(is_in_cell(box, {level, {cell.at[0], cell.at[1], cell.at[2]}}));
  }
}

TEST(HashBox, MeetsWhatItOverlaps) {
  const auto boxes = random_boxes(300, 60, 3);
  int meeting = 0;
  for (const HashBox& a : boxes) {
    for (const HashBox& b : boxes) {
      bool overlap = true;
      for (int k = 0; k < 3; ++k) overlap = overlap && a.low(k) <= b.high(k) && b.low(k) <= a.high(k);
      EXPECT_EQ(meets(a, limits_of(b)), overlap);
      meeting += overlap ? 1 : 0;
    }
  }
  EXPECT_GT(meeting, 1000);
  EXPECT_LT(meeting, 80000);
}

TEST(BucketOfCell, SpreadsAGridEvenly) {
  constexpr int bits = 8;
  std::vector<int> load(1 << bits, 0);
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 32; ++j)
      for (int k = 0; k < 32; ++k) ++load[bucket_of({2, {i, j, k}}, bits)];
  const double mean = 32768.0 / (1 << bits);  // 128, standard deviation of a random hash 11
  for (const int n : load) {
    EXPECT_GT(n, 0.5 * mean);
    EXPECT_LT(n, 1.5 * mean);
  }
}

TEST(BucketOfCell, IsAnotherForEachCellOfABlock) {
  for (const int bits : {9, 20, 31}) {
    std::set<std::uint32_t> buckets;
    for (int c = 0; c < 8; ++c) {
      buckets.insert(bucket_of({1, {1000 + (c & 1), 2000 + (c >> 1 & 1), 3000 + (c >> 2)}}, bits));
    }
    EXPECT_EQ(buckets.size(), 8U);
    EXPECT_EQ(*buckets.rbegin() - *buckets.begin(), 7U);
    EXPECT_LT(*buckets.rbegin(), 1U << bits);
  }
}

/// Few buckets, so that many cells share one.
TEST(CopyCell, CopiesThoseOfTheCellThatKeepWithinLimits) {
  constexpr int bits = 4;
  std::vector<HashBox> boxes = random_boxes(400, 40, 2);
  const auto bucket = [](const HashBox& box) { return bucket_of(cell_of(box), bits); };
  std::sort(boxes.begin(), boxes.end(), [&](const HashBox& x, const HashBox& y) {
    return std::pair(bucket(x), x.number()) < std::pair(bucket(y), y.number());
  });
  std::vector<std::int32_t> start((1 << bits) + 1, 0);
  for (const HashBox& box : boxes) ++start[bucket(box) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  const SpatialHashView hash{{{0, 0, 0}, 1}, bits, 7, start.data(), boxes.data()};
  std::vector<HashBox> copies(boxes.size() + 1);
  int copied = 0;
  for (std::size_t n = 0; n < boxes.size(); n += 3) {
    const HashCell cell = cell_of(boxes[n]);
    for (std::size_t other = 0; other < boxes.size(); other += 7) {
      const HashBoxLimits limits = limits_of(boxes[other]);
      const HashBox* end = copy_cell(hash, bucket(boxes[n]), cell, limits, copies.data());
      const HashBox* copy = copies.data();
      for (const HashBox& box : boxes) {
        if (!is_in_cell(box, cell) || !meets(box, limits)) continue;
        ASSERT_LT(copy, end);
        EXPECT_TRUE(std::equal(copy->value, copy->value + 8, box.value));
        ++copy, ++copied;
      }
      EXPECT_EQ(copy, end);
    }
  }
  EXPECT_GT(copied, 100);
}

}  // namespace
}  // namespace pinball::spatial_hash_test
