#include <kernels/gather.hpp>
#include <tests/support/support.hpp>

namespace pinball::gather_test {
namespace {

using namespace test;

template <class T>
class Records : public ::testing::Test {
 protected:
  AlignedVector<ScalarOf<T>> random_records() {
    AlignedVector<ScalarOf<T>> data(4 * 37);
    for (ScalarOf<T>& value : data) value = static_cast<ScalarOf<T>>(uniform(random, -1, 1));
    return data;
  }
  /// `count` record numbers below 37, padded to whole packs with the first one. repeats: how many different ones at
  /// most.
  std::vector<std::int32_t> random_index(int count, int repeats) {
    std::vector<std::int32_t> index;
    for (int i = 0; i < count; ++i) index.push_back(static_cast<std::int32_t>(random() % std::uint64_t(repeats)));
    while (index.size() % width_of<T> != 0) index.push_back(index[0]);
    return index;
  }
  Random random{51};
};
TYPED_TEST_SUITE(Records, NumberTypes);

TYPED_TEST(Records, GatherFillsLaneAfterLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  const AlignedVector<S> base = this->random_records();
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<std::int32_t> index = this->random_index(width_of<T>, trial % 2 == 0 ? 37 : 3);
    T a, b, c, d;
    gather_records(base.data(), index.data(), a, b, c, d);
    const Vec3<T> v = gather_vectors<T>(base.data(), index.data());
    for (int i = 0; i < width_of<T>; ++i) {
      const S* record = base.data() + 4 * index[std::size_t(i)];
      EXPECT_EQ(lane(a, i), record[0]);
      EXPECT_EQ(lane(b, i), record[1]);
      EXPECT_EQ(lane(c, i), record[2]);
      EXPECT_EQ(lane(d, i), record[3]);
      EXPECT_VECTOR_NEAR(lane_of(v, i), (Vec3<S>{record[0], record[1], record[2]}), 0);
    }
  }
}

TYPED_TEST(Records, GatherDoesNotNeedAnAlignedIndex) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  const AlignedVector<S> base = this->random_records();
  std::vector<std::int32_t> index = this->random_index(4 * width_of<T>, 37);
  for (int start = 0; start < width_of<T>; ++start) {
    T a, b, c, d;
    gather_records(base.data(), index.data() + start, a, b, c, d);
    for (int i = 0; i < width_of<T>; ++i) {
      EXPECT_EQ(lane(a, i), base[std::size_t(4 * index[std::size_t(start + i)])]);
    }
  }
}

// Independent scalar implementation: one loop over lanes. Equal to the bit, also where lanes share a record.
TYPED_TEST(Records, AddSumsRepeatedRecordsInLaneOrder) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>;
  for (const int repeats : {1, 2, 3, 37}) {
    for (const int count : {1, W - 1, W, W + 1, 3 * W + 1}) {
      if (count == 0) continue;
      AlignedVector<S> found = this->random_records(), expected = found;
      const std::vector<std::int32_t> index = this->random_index(count, repeats);
      AlignedVector<S> values[4];
      for (AlignedVector<S>& component : values) {
        for (std::size_t i = 0; i < index.size(); ++i) {  // sums whose order shows; padding lanes add nothing
          const double size = std::pow(10.0, uniform(this->random, -6, 6));
          component.push_back(int(i) < count ? static_cast<S>(uniform(this->random, -size, size)) : S(0));
        }
      }
      for (std::size_t first = 0; first < index.size(); first += W) {
        add_to_records(found.data(), index.data() + first, load<T>(values[0].data() + first),
                       load<T>(values[1].data() + first), load<T>(values[2].data() + first),
                       load<T>(values[3].data() + first));
      }
      for (std::size_t i = 0; i < index.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) expected[4 * std::size_t(index[i]) + c] += values[c][i];
      }
      EXPECT_EQ(found, expected) << "width " << W << ", count " << count << ", records " << repeats;
    }
  }
}

TYPED_TEST(Records, AddTouchesOnlyTheRecordsOfTheIndex) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  AlignedVector<S> base = this->random_records();
  const AlignedVector<S> before = base;
  const std::vector<std::int32_t> index(width_of<T>, 17);
  add_to_records(base.data(), index.data(), T(1), T(2), T(3), T(4));
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (i / 4 == 17) {
      EXPECT_NEAR(base[i], before[i] + S(width_of<T> * int(i % 4 + 1)), 16 * epsilon<S> * 64);
    } else {
      EXPECT_EQ(base[i], before[i]);
    }
  }
}

template <class T>
class Lanes : public ::testing::Test {};
TYPED_TEST_SUITE(Lanes, NumberTypes);

TYPED_TEST(Lanes, SelectMinimumMaximumAndReductions) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>;
  const T a = from_lanes<T>([](int i) { return (i * 7) % 5 - 2; }), b = from_lanes<T>([](int i) { return i - 3; });
  const auto mask = a < b;
  S sum(0), largest = lane(a, 0), smallest = lane(a, 0);
  int count = 0;
  for (int i = 0; i < W; ++i) {
    const S x = lane(a, i), y = lane(b, i);
    EXPECT_EQ(lane(select(mask, a, b), i), x < y ? x : y);
    EXPECT_EQ(lane(minimum(a, b), i), std::min(x, y));
    EXPECT_EQ(lane(maximum(a, b), i), std::max(x, y));
    EXPECT_EQ(lane(absolute(b), i), std::abs(y));
    EXPECT_EQ(lane(square_root(b * b), i), std::abs(y));
    EXPECT_EQ(lane(lane_numbers<T>(), i), S(i));
    EXPECT_EQ(lane(number<T>(0.1), i), S(0.1));
    sum += x;
    largest = std::max(largest, x);
    smallest = std::min(smallest, x);
    count += x < y ? 1 : 0;
  }
  EXPECT_EQ(lane_sum(a), sum);
  EXPECT_EQ(lane_maximum(a), largest);
  EXPECT_EQ(lane_minimum(a), smallest);
  EXPECT_EQ(count_lanes(mask), count);
  EXPECT_EQ(any_lane(mask), count > 0);
  EXPECT_FALSE(any_lane(a < a));
}

TYPED_TEST(Lanes, LoadAndStoreAreInverse) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  AlignedVector<S> from(3 * width_of<T>), to(3 * width_of<T>, S(-1));
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = S(i);
  store(load<T>(from.data() + width_of<T>), to.data() + width_of<T>);
  for (std::size_t i = 0; i < from.size(); ++i) {
    EXPECT_EQ(to[i], i / width_of<T> == 1 ? S(i) : S(-1));
  }
}

}  // namespace
}  // namespace pinball::gather_test
