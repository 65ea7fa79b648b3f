#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>
#include <tests/exec/with_threads.hpp>
#include <tests/support/record.hpp>
#include <tests/support/support.hpp>

namespace pinball::sums_test {
namespace {

using namespace test;

template <class Space>
class Sums : public ::testing::Test {};
#if !defined(PINBALL_TEST_SPACES)
#define PINBALL_TEST_SPACES Serial, OpenMP, Mock
#endif
using SumSpaces = ::testing::Types<PINBALL_TEST_SPACES>;
TYPED_TEST_SUITE(Sums, SumSpaces);

/// Numbers of very different size, so that every order of a sum has bits of its own.
std::vector<double> rough_numbers(std::int64_t count) {
  Random random(91);
  std::vector<double> values(static_cast<std::size_t>(count));
  for (double& v : values) v = uniform(random, -1, 1) * std::pow(10, uniform(random, -8, 8));
  return values;
}

template <class Space>
test::Record record_of(const std::vector<double>& values, std::int64_t begin, std::int64_t end) {
  Array<double, typename Space::memory_space> numbers(values.size());
  deep_copy(numbers, values.data(), values.size());
  test::Record record{1, -1e30, 77};  // what was in it does not count
  parallel_reduce("record", RangePolicy<Space>{begin, end}, test::RecordOf{numbers.data()}, record);
  return record;
}

/// The order of sums.hpp, written down once more.
double in_pairs(std::vector<double> lanes) {
  while (lanes.size() > 1) {
    const std::size_t half = lanes.size() / 2;
    for (std::size_t l = 0; l < half; ++l) lanes[l] += lanes[l + half];
    lanes.resize(half);
  }
  return lanes[0];
}

TYPED_TEST(Sums, HaveTheSameBitsOnEverySpaceForAnyNumberOfThreads) {
  const std::int64_t most = 300'000;
  const std::vector<double> values = rough_numbers(most);
  for (const std::int64_t count : {0, 1, 127, 128, 129, 5000, 131'072, 131'073, 300'000}) {
    for (const std::int64_t begin : {std::int64_t(0), most - count}) {
      const test::Record expected = record_of<Serial>(values, begin, begin + count);
      EXPECT_EQ(expected.count, count);
      for (const int threads : {1, 2, 3, 8}) {
        with_threads(threads, [&] { EXPECT_EQ(record_of<TypeParam>(values, begin, begin + count), expected); });
      }
    }
  }
}

TYPED_TEST(Sums, AreInTheOrderThatTheirHeaderTells) {
  const std::int64_t count = 1000;  // 8 pieces of 128
  const std::vector<double> values = rough_numbers(count);
  std::vector<double> pieces(128, 0.0);
  for (std::int64_t p = 0; p < 8; ++p) {
    std::vector<double> lanes(128, 0.0);
    for (std::int64_t i = 128 * p; i < std::min(count, 128 * (p + 1)); ++i) lanes[i % 128] = values[i];
    pieces[std::size_t(p)] = in_pairs(lanes);
  }
  EXPECT_EQ(record_of<TypeParam>(values, 0, count).sum, in_pairs(pieces));
}

struct Squares {
  PINBALL_FUNCTION void operator()(std::int64_t i, std::int64_t& sum) const { sum += i * i; }
};

TYPED_TEST(Sums, OfNumbersNeedNoJoin) {
  std::int64_t sum = 5;
  parallel_reduce("squares", RangePolicy<TypeParam>{10, 200'001}, Squares{}, sum);
  EXPECT_EQ(sum, std::int64_t(200'000) * 200'001 * 400'001 / 6 - 285);
  parallel_reduce("nothing", RangePolicy<TypeParam>{7, 7}, Squares{}, sum);
  EXPECT_EQ(sum, 0);
}

/// The numbers that are marked, in their order.
struct Listed {
  const std::int32_t* marked;
  std::int64_t* list;
  std::int64_t* before;
  PINBALL_FUNCTION void operator()(std::int64_t i, std::int64_t& update, bool final) const {
    if (final) before[i] = update;
    if (final && marked[i] != 0) list[update] = i;
    update += marked[i];
  }
};

TYPED_TEST(Sums, RunningOnesListWhatIsMarkedInItsOrder) {
  using Memory = typename TypeParam::memory_space;
  for (const std::int64_t count : {0, 1, 63, 64, 65, 129, 5000, 200'000}) {
    std::vector<std::int32_t> marks(static_cast<std::size_t>(count));
    std::vector<std::int64_t> expected, before;
    for (std::int64_t i = 0; i < count; ++i) {
      before.push_back(std::int64_t(expected.size()));
      if (i * i % 7 < 3) expected.push_back(i);
      marks[std::size_t(i)] = i * i % 7 < 3 ? 1 : 0;
    }
    Array<std::int32_t, Memory> marked(marks.size());
    deep_copy(marked, marks.data(), marks.size());
    for (const int threads : {1, 3}) {
      with_threads(threads, [&] {
        Array<std::int64_t, Memory> list(expected.size()), sums(marks.size());
        std::int64_t total = -1;
        parallel_scan("list", RangePolicy<TypeParam>{0, count}, Listed{marked.data(), list.data(), sums.data()}, total);
        EXPECT_EQ(total, std::int64_t(expected.size()));
        std::vector<std::int64_t> listed(expected.size()), summed(marks.size());
        deep_copy(listed.data(), list);
        deep_copy(summed.data(), sums);
        EXPECT_EQ(listed, expected);
        EXPECT_EQ(summed, before);
      });
    }
  }
}

struct Numbers {
  std::int64_t first;
  PINBALL_FUNCTION void operator()(std::int64_t i, std::int64_t& update, bool /*final*/) const { update += i - first; }
};

TYPED_TEST(Sums, RunningOnesMayBeginAnywhere) {
  std::int64_t total = 3;
  parallel_scan("numbers", RangePolicy<TypeParam>{1000, 3000}, Numbers{1000}, total);
  EXPECT_EQ(total, 1999 * 1000);
}

}  // namespace
}  // namespace pinball::sums_test
