#include <algorithm>
#include <numeric>

#include <kernels/exec.hpp>
#include <tests/support/support.hpp>

namespace pinball {
namespace {

using namespace test;

/// Runs body with the given number of threads.
template <class Body>
void with_threads(int threads, const Body& body) {
#if defined(_OPENMP)
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  body();
  omp_set_num_threads(before);
#else
  (void)threads;
  body();
#endif
}

template <class Space>
class Exec : public ::testing::Test {};
using Spaces = ::testing::Types<Serial, OpenMP>;
TYPED_TEST_SUITE(Exec, Spaces);

TYPED_TEST(Exec, ParallelForCallsEachIndexOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    with_threads(threads, [&] {
      for (const std::int64_t begin : {0, 5}) {
        for (const std::int64_t count : {0, 1, 7, 1000}) {
          std::vector<int> calls(1100, 0);
          parallel_for("test", RangePolicy<TypeParam>{begin, begin + count},
                       [&](std::int64_t i) { ++calls[std::size_t(i)]; });
          for (std::int64_t i = 0; i < 1100; ++i) {
            EXPECT_EQ(calls[std::size_t(i)], i >= begin && i < begin + count ? 1 : 0);
          }
        }
      }
    });
  }
}

template <class Space>
double ordered_sum(const std::vector<double>& values) {
  double sum = 0;
  parallel_reduce(
      "sum", RangePolicy<Space>{0, std::int64_t(values.size())}, sum,
      [&](std::int64_t begin, std::int64_t end, double& partial) {
        for (std::int64_t i = begin; i < end; ++i) partial += values[std::size_t(i)];
      },
      [](double& result, double partial) { result += partial; });
  return sum;
}

TYPED_TEST(Exec, ParallelReduceHasTheSameBitsForAnyNumberOfThreads) {
  Random random(81);
  for (const int count : {0, 1, 63, 64, 65, 1000, 12345}) {
    std::vector<double> values(std::size_t(count), 0.0);
    for (double& v : values) v = uniform(random, -1, 1) * std::pow(10, uniform(random, -8, 8));
    const double serial = ordered_sum<Serial>(values);
    for (const int threads : {1, 2, 3, 8}) {
      with_threads(threads, [&] { EXPECT_EQ(ordered_sum<TypeParam>(values), serial); });
    }
  }
}

TYPED_TEST(Exec, ParallelReduceJoinsConsecutivePiecesInOrder) {
  struct Pieces {
    std::vector<std::int64_t> index;
  };
  for (const std::int64_t count : {0, 1, 63, 64, 65, 999}) {
    Pieces result;
    parallel_reduce(
        "order", RangePolicy<TypeParam>{10, 10 + count}, result,
        [](std::int64_t begin, std::int64_t end, Pieces& partial) {
          for (std::int64_t i = begin; i < end; ++i) partial.index.push_back(i);
        },
        [](Pieces& all, const Pieces& partial) {
          all.index.insert(all.index.end(), partial.index.begin(), partial.index.end());
        });
    std::vector<std::int64_t> expected(static_cast<std::size_t>(count));
    std::iota(expected.begin(), expected.end(), 10);
    EXPECT_EQ(result.index, expected);
  }
}

TYPED_TEST(Exec, ParallelReduceKeepsTheInitialValue) {
  double sum = 5;
  parallel_reduce(
      "sum", RangePolicy<TypeParam>{0, 0}, sum, [](std::int64_t, std::int64_t, double&) {},
      [](double& result, double partial) { result += partial; });
  EXPECT_EQ(sum, 5);
}

// Items of one colour share nothing; items of different colours write to the same places, in the order of the colours.
TYPED_TEST(Exec, ColoursRunOneAfterTheOther) {
  constexpr std::int32_t colours = 5, places = 97;
  std::vector<std::int32_t> offsets = {0}, items;
  for (std::int32_t c = 0; c < colours; ++c) {
    const std::int32_t used = c == 2 ? 0 : places;  // one colour is empty
    for (std::int32_t p = 0; p < used; ++p) items.push_back(c * places + (p * 31) % places);
    offsets.push_back(std::int32_t(items.size()));
  }
  for (const int threads : {1, 2, 3, 8}) {
    with_threads(threads, [&] {
      for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<std::vector<std::int32_t>> seen(places);
        parallel_for_coloured("test", TypeParam{}, offsets.data(), colours, items.data(),
                              [&](std::int32_t item) { seen[std::size_t(item % places)].push_back(item / places); });
        for (const std::vector<std::int32_t>& order : seen) {
          ASSERT_EQ(order, (std::vector<std::int32_t>{0, 1, 3, 4}));
        }
      }
    });
  }
}

TYPED_TEST(Exec, NoColoursMeanNoWork) {
  const std::int32_t offsets[] = {0, 0};
  int calls = 0;
  parallel_for_coloured("none", TypeParam{}, offsets, 0, static_cast<const std::int32_t*>(nullptr),
                        [&](std::int32_t) { ++calls; });
  parallel_for_coloured("empty", TypeParam{}, offsets, 1, static_cast<const std::int32_t*>(nullptr),
                        [&](std::int32_t) { ++calls; });
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace pinball
