#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <solver/base/error.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/model/ordering.hpp>

namespace pinball::ordering_test {
namespace {

std::vector<Point> lattice(int nx, int ny, int nz) {
  std::vector<Point> points;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) points.push_back({i + 0.5, j + 0.5, k + 0.5});
  return points;
}

bool is_permutation_of_indices(std::vector<std::int32_t> order) {
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] != static_cast<std::int32_t>(i)) return false;
  return true;
}

std::vector<std::int32_t> all_of(const std::vector<Point>& points) {
  std::vector<std::int32_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

TEST(CompactTiles, CutABlockIntoBlocks) {
  const std::vector<Point> points = lattice(24, 16, 8), unit(points.size(), Point{1, 1, 1});
  const TileOrder tiles = compact_tiles(points, unit, all_of(points), 512, 8);
  EXPECT_TRUE(is_permutation_of_indices(tiles.order));
  ASSERT_EQ(tiles.offsets.size(), 9u);  // 3072 elements: three halvings to 384
  for (std::size_t t = 0; t < 8; ++t) {
    EXPECT_EQ(tiles.offsets[t + 1] - tiles.offsets[t], 384);
    Point low = points[tiles.order[tiles.offsets[t]]], high = low;
    for (auto i = tiles.offsets[t]; i < tiles.offsets[t + 1]; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], points[tiles.order[i]][k]);
        high[k] = std::max(high[k], points[tiles.order[i]][k]);
      }
    }
    EXPECT_EQ((high[0] - low[0] + 1) * (high[1] - low[1] + 1) * (high[2] - low[2] + 1), 384) << "tile " << t;
  }
}

TEST(CompactTiles, LieInRowsAlongTheirLongestDirection) {
  const std::vector<Point> points = lattice(5, 3, 4), unit(points.size(), Point{1, 1, 1});
  const TileOrder tiles = compact_tiles(points, unit, all_of(points), 100, 8);
  ASSERT_EQ(tiles.offsets, (std::vector<std::int32_t>{0, 60}));
  for (std::size_t i = 1; i < 60; ++i) {
    const Point &a = points[tiles.order[i - 1]], &b = points[tiles.order[i]];
    if (i % 5 != 0) {
      EXPECT_EQ(b, (Point{a[0] + 1, a[1], a[2]}));  // along x, five of them
    } else if (i % 15 != 0) {
      EXPECT_EQ(b, (Point{0.5, a[1] + 1, a[2]}));  // then y, three
    } else {
      EXPECT_EQ(b, (Point{0.5, 0.5, a[2] + 1}));
    }
  }
}

/// Layers are of elements whose centres are nearer to theirs than to the next ones.
TEST(CompactTiles, LieInLayersThatNeedNotBeFlat) {
  const std::vector<Point> points = lattice(40, 3, 2), unit(points.size(), Point{1, 1, 1});
  std::vector<Point> rough = points;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-0.24, 0.24);
  for (Point& p : rough) {
    for (double& x : p) x += any(random);  // layers are counted from the lowest element
  }
  for (const std::int64_t largest : {300, 64}) {
    const TileOrder flat = compact_tiles(points, unit, all_of(points), largest, 8);
    const TileOrder tiles = compact_tiles(rough, unit, all_of(points), largest, 8);
    EXPECT_EQ(tiles.offsets, flat.offsets);
    EXPECT_EQ(tiles.order, flat.order);
  }
}

TEST(CompactTiles, AreWholePacksButTheLastAndNotLargerThanAsked) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 1);
  for (const std::size_t n : {1u, 7u, 100u, 1237u}) {
    std::vector<Point> points(n), extents(n, Point{0.1, 0.1, 0.1});
    for (Point& p : points) p = {3 * place(random), place(random), 0.3 * place(random)};
    const TileOrder tiles = compact_tiles(points, extents, all_of(points), 64, 8);
    EXPECT_TRUE(is_permutation_of_indices(tiles.order));
    EXPECT_EQ(tiles.offsets.back(), static_cast<std::int32_t>(n));
    for (std::size_t t = 0; t + 1 < tiles.offsets.size(); ++t) {
      const std::int32_t size = tiles.offsets[t + 1] - tiles.offsets[t];
      EXPECT_GT(size, 0);
      EXPECT_LE(size, 64);
      if (t + 2 < tiles.offsets.size()) {
        EXPECT_EQ(size % 8, 0);
      }
    }
  }
}

TEST(CompactTiles, DependOnPositionsAlone) {
  const std::vector<Point> points = lattice(13, 9, 7), unit(points.size(), Point{1, 1, 1});
  const TileOrder tiles = compact_tiles(points, unit, all_of(points), 64, 8);
  std::vector<Point> shuffled = points;
  std::mt19937 random(7);
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  const TileOrder others = compact_tiles(shuffled, unit, all_of(points), 64, 8);
  EXPECT_EQ(tiles.offsets, others.offsets);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[tiles.order[i]], shuffled[others.order[i]]);
}

TEST(CompactTiles, TakeWhatTheyAreGiven) {
  const std::vector<Point> same(40, Point{1, 2, 3}), flat(40, Point{0, 0, 0});
  EXPECT_EQ(compact_tiles(same, flat, {}, 8, 8).offsets, (std::vector<std::int32_t>{0}));
  const TileOrder tiles = compact_tiles(same, flat, {30, 2, 7, 31, 5, 9, 11, 13, 1, 0}, 8, 8);  // all at one place
  EXPECT_EQ(tiles.offsets, (std::vector<std::int32_t>{0, 8, 10}));
  EXPECT_EQ(tiles.order, (std::vector<std::int32_t>{0, 1, 2, 5, 7, 9, 11, 13, 30, 31}));
}

TEST(FirstTouchNodeOrder, FollowsTheElementsAndPutsUnusedNodesLast) {
  const std::vector<std::array<std::int32_t, 8>> hexahedra{{9, 8, 7, 6, 5, 4, 3, 2}, {9, 8, 11, 12, 5, 4, 1, 13}};
  const auto order = first_touch_node_order(hexahedra, 14);
  EXPECT_EQ(order, (std::vector<std::int32_t>{9, 8, 7, 6, 5, 4, 3, 2, 11, 12, 1, 13, 0, 10}));
  const auto number = inverse_permutation(order);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(number[order[i]], static_cast<std::int32_t>(i));
  EXPECT_THROW(first_touch_node_order(hexahedra, 13), InputError);
}

TEST(FirstTouchNodeOrder, IsAPermutation) {
  const Mesh mesh = generate_round_nosed_rod({6, 1, true, {2, 2}, 1, 20});
  const auto order = first_touch_node_order(mesh.hexahedra, static_cast<std::int32_t>(mesh.nodes.size()));
  EXPECT_EQ(order.size(), mesh.nodes.size());
  EXPECT_TRUE(is_permutation_of_indices(order));
}

}  // namespace
}  // namespace pinball::ordering_test
