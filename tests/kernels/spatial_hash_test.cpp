#include <algorithm>
#include <functional>
#include <string>

#include <kernels/spatial_hash.hpp>
#include <tests/support/support.hpp>

namespace pinball {
namespace {

using namespace test;

/// A hash with its memory.
template <class S>
struct Hash {
  std::vector<std::int32_t> bucket_start, entry_point;
  std::vector<std::uint64_t> entry_cell, cells;
  std::vector<S> entry_record;
  SpatialHashView<S> view;

  Hash(const std::vector<S>& records, double size, int bits, const double (&origin)[3]) {
    const std::size_t count = records.size() / 4;
    bucket_start.assign((std::size_t(1) << bits) + 1, -1);
    entry_point.assign(count, -1);
    entry_cell.assign(count, 0);
    cells.assign(count, 0);
    entry_record.assign(4 * count, S(0));
    view = {{{origin[0], origin[1], origin[2]}, 1 / size},
            bits,
            bucket_start.data(),
            entry_cell.data(),
            entry_point.data(),
            entry_record.data()};
    build_spatial_hash(view, records.data(), std::int32_t(count), cells.data());
  }
};

struct Configuration {
  const char* name;
  std::function<Vec3<double>(Random&, int)> point;
};
std::vector<Configuration> configurations() {
  return {
      {"random", [](Random& r, int) { return random_vector(r, 4); }},
      {"clustered",
       [](Random& r, int i) {
         return Vec3<double>{3.0 * (i % 3), -2.0 * (i % 2), 0} + random_vector(r, 0.6);
       }},
      {"one point",
       [](Random&, int) {
         return Vec3<double>{0.3, -0.2, 0.1};
       }},
      {"line",
       [](Random&, int i) {
         return Vec3<double>{0.1 * i, 0, 0};
       }},
      {"cell corners",
       [](Random&, int i) {
         return Vec3<double>{double(i % 5), double(i / 5 % 5), double(i / 25)};
       }},
      {"around the origin", [](Random& r, int) { return random_vector(r, 1e-9); }},
      {"huge coordinates",
       [](Random& r, int) {
         return Vec3<double>{1e5, -1e5, 5e5} + random_vector(r, 4);
       }},
      {"at the clamp",
       [](Random& r, int) {
         return Vec3<double>{1048574, -1048574, 0} + random_vector(r, 3);
       }},
      {"far outliers",
       [](Random& r, int i) {
         const Vec3<double> near = random_vector(r, 2);
         return i % 10 == 0 ? Vec3<double>{1e9, 0, 0} + near : i % 10 == 1 ? Vec3<double>{-1e9, 1e12, 0} + near : near;
       }},
  };
}

class SpatialHash : public ::testing::TestWithParam<int> {};

/// Independent implementation: all pairs.
TEST_P(SpatialHash, FindsEveryNeighbourOnce) {
  const int bits = GetParam();
  const double origin[3] = {0.25, -0.5, 0};
  for (const Configuration& configuration : configurations()) {
    SCOPED_TRACE(configuration.name);
    Random random(71);
    std::vector<double> points;
    constexpr int count = 200, stride = 4;
    for (int i = 0; i < count; ++i) {
      const Vec3<double> p = configuration.point(random, i);
      points.insert(points.end(), {p.x, p.y, p.z, double(i)});
    }
    const double size = 1.0;
    const Hash<double> hash(points, size, bits, origin);
    for (int i = 0; i < count; ++i) {
      std::vector<int> visits(count, 0);
      for_each_near(hash.view, points.data() + stride * i, [&](std::int32_t j, const double* record) {
        ++visits[std::size_t(j)];
        for (int c = 0; c < 4; ++c) ASSERT_EQ(record[c], points[std::size_t(stride * j + c)]);
      });
      for (int j = 0; j < count; ++j) {
        const double* p = points.data() + stride * i;
        const double* q = points.data() + stride * j;
        const double distance = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        ASSERT_LE(visits[std::size_t(j)], 1);
        if (distance < size * (1 - 1e-12)) {
          ASSERT_EQ(visits[std::size_t(j)], 1) << i << ' ' << j;
        }
        // Inside the clamp nothing from further than the 27 cells.
        if (distance > size * 3.5 && std::abs(p[0]) < 1e6 && std::abs(p[1]) < 1e6) {
          ASSERT_EQ(visits[std::size_t(j)], 0) << i << ' ' << j;
        }
      }
    }
  }
}

TEST_P(SpatialHash, HoldsEveryPointOnceInBucketsInTheOrderOfThePoints) {
  const int bits = GetParam();
  Random random(72);
  std::vector<float> points;  // single precision
  for (int i = 0; i < 4 * 500; ++i) points.push_back(float(uniform(random, -3, 3)));
  const double origin[3] = {0, 0, 0};
  const Hash<float> hash(points, 0.7, bits, origin);
  const std::size_t buckets = std::size_t(1) << bits;
  EXPECT_EQ(hash.bucket_start[0], 0);
  EXPECT_EQ(hash.bucket_start[buckets], 500);
  std::vector<int> found(500, 0);
  for (std::size_t b = 0; b < buckets; ++b) {
    ASSERT_LE(hash.bucket_start[b], hash.bucket_start[b + 1]);
    for (std::int32_t e = hash.bucket_start[b]; e < hash.bucket_start[b + 1]; ++e) {
      const std::int32_t point = hash.entry_point[std::size_t(e)];
      ++found[std::size_t(point)];
      EXPECT_EQ(hash_cell(hash.entry_cell[std::size_t(e)], bits), b);
      EXPECT_EQ(hash.entry_cell[std::size_t(e)], hash.cells[std::size_t(point)]);
      if (e > hash.bucket_start[b]) {
        EXPECT_GT(point, hash.entry_point[std::size_t(e - 1)]);
      }
    }
  }
  EXPECT_EQ(std::count(found.begin(), found.end(), 1), 500);
}
INSTANTIATE_TEST_SUITE_P(Bits, SpatialHash, ::testing::Values(1, 2, 7, 16));

TEST(CellGrid, IsTheFloor) {
  const CellGrid grid{{0.5, 0, -1}, 4.0};
  for (double x = -3; x < 3; x += 0.0625) {
    EXPECT_EQ(grid.coordinate(x, 0), int(std::floor((x - 0.5) * 4))) << x;
    EXPECT_EQ(grid.coordinate(x, 2), int(std::floor((x + 1) * 4))) << x;
  }
  EXPECT_EQ(grid.coordinate(1e300, 1), 1048575);
  EXPECT_EQ(grid.coordinate(-1e300, 1), -1048575);
  EXPECT_EQ(grid.coordinate(std::numeric_limits<double>::infinity(), 1), 1048575);
}

TEST(PackCell, IsDifferentForDifferentCells) {
  Random random(73);
  std::vector<std::uint64_t> packed;
  const int values[] = {-1048576, -1048575, -1, 0, 1, 2, 1048574, 1048575};
  for (const int i : values)
    for (const int j : values)
      for (const int k : values) packed.push_back(pack_cell(i, j, k));
  std::sort(packed.begin(), packed.end());
  EXPECT_EQ(std::adjacent_find(packed.begin(), packed.end()), packed.end());
}

TEST(HashCell, SpreadsAGridEvenly) {
  constexpr int bits = 8;
  std::vector<int> load(1 << bits, 0);
  for (int i = -16; i < 16; ++i)
    for (int j = -16; j < 16; ++j)
      for (int k = -16; k < 16; ++k) ++load[hash_cell(pack_cell(i, j, k), bits)];
  const double mean = 32768.0 / (1 << bits);  // 128, standard deviation of a random hash 11
  for (const int n : load) {
    EXPECT_GT(n, 0.5 * mean);
    EXPECT_LT(n, 1.5 * mean);
  }
}

}  // namespace
}  // namespace pinball
