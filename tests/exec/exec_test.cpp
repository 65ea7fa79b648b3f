#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include <kernels/contact_friction.hpp>
#include <kernels/exec.hpp>
#include <tests/exec/with_threads.hpp>
#include <tests/support/support.hpp>

namespace pinball::exec_test {
namespace {

using namespace test;

template <class Space>
class Exec : public ::testing::Test {};
using Spaces = ::testing::Types<Serial, OpenMP, Mock>;
TYPED_TEST_SUITE(Exec, Spaces);

/// Colours are of the host alone.
template <class Space>
class ExecColours : public ::testing::Test {};
using HostSpaces = ::testing::Types<Serial, OpenMP>;
TYPED_TEST_SUITE(ExecColours, HostSpaces);

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
TYPED_TEST(ExecColours, RunOneAfterTheOther) {
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

TYPED_TEST(ExecColours, AreNoWorkWhereThereAreNone) {
  const std::int32_t offsets[] = {0, 0};
  int calls = 0;
  parallel_for_coloured("none", TypeParam{}, offsets, 0, static_cast<const std::int32_t*>(nullptr),
                        [&](std::int32_t) { ++calls; });
  parallel_for_coloured("empty", TypeParam{}, offsets, 1, static_cast<const std::int32_t*>(nullptr),
                        [&](std::int32_t) { ++calls; });
  EXPECT_EQ(calls, 0);
}

/// Index whose exception leaves a region in which those above 700 and below 300 throw; -1: none has.
template <class Space>
std::int64_t thrown_by_many() {
  try {
    parallel_for("test", RangePolicy<Space>{0, 1000}, [](std::int64_t i) {
      if (i == 0 || (i >= 300 && i < 700)) return;
      throw std::out_of_range(std::to_string(i));
    });
  } catch (const std::out_of_range& error) {
    return std::stoll(error.what());
  }
  return -1;
}

TYPED_TEST(Exec, TheFirstExceptionLeavesTheRegion) {
  for (const int threads : {1, 2, 3, 8}) {
    with_threads(threads, [&] {
      for (int repeat = 0; repeat < 20; ++repeat) ASSERT_EQ(thrown_by_many<TypeParam>(), 1);
      double sum = 0;
      EXPECT_THROW(parallel_reduce(
                       "sum", RangePolicy<TypeParam>{0, 64}, sum,
                       [](std::int64_t begin, std::int64_t, double&) {
                         if (begin > 40) throw std::bad_alloc();
                       },
                       [](double& result, double partial) { result += partial; }),
                   std::bad_alloc);
      int calls = 0;
      parallel_for("after", RangePolicy<TypeParam>{0, 1}, [&](std::int64_t) { ++calls; });
      EXPECT_EQ(calls, 1);
    });
  }
}

TYPED_TEST(ExecColours, LetExceptionsOut) {
  for (const int threads : {1, 2, 3, 8}) {
    with_threads(threads, [&] {
      const std::int32_t offsets[] = {0, 2, 4}, items[] = {0, 1, 2, 3};
      EXPECT_THROW(parallel_for_coloured("test", TypeParam{}, offsets, 2, items,
                                         [](std::int32_t item) {
                                           if (item % 2 == 1) throw std::runtime_error("odd");
                                         }),
                   std::runtime_error);
    });
  }
}

TYPED_TEST(Exec, SumsLetExceptionsOut) {
  std::int64_t result = 0;
  const auto at_ninety = [](std::int64_t i) {
    if (i == 90) throw std::out_of_range("ninety");
  };
  EXPECT_THROW(
      parallel_reduce(
          "test", RangePolicy<TypeParam>{0, 1000}, [&](std::int64_t i, std::int64_t&) { at_ninety(i); }, result),
      std::out_of_range);
  EXPECT_THROW(
      parallel_scan(
          "test", RangePolicy<TypeParam>{0, 1000}, [&](std::int64_t i, std::int64_t&, bool) { at_ninety(i); }, result),
      std::out_of_range);
}

TYPED_TEST(Exec, ARegionInARegionIsWorkedByItsThread) {
  with_threads(3, [] {
    std::vector<int> calls(30 * 40, 0);
    parallel_for("outer", RangePolicy<TypeParam>{0, 30}, [&](std::int64_t i) {
      const auto thread = std::this_thread::get_id();
      parallel_for("inner", RangePolicy<TypeParam>{0, 40}, [&](std::int64_t j) {
        if (std::this_thread::get_id() == thread) ++calls[std::size_t(40 * i + j)];
      });
    });
    EXPECT_EQ(calls, std::vector<int>(30 * 40, 1));
  });
}

#if defined(_OPENMP)

/// How many threads have worked on a region that is long enough for all of them to arrive.
int threads_of_long_region() {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  parallel_for("long", RangePolicy<OpenMP>{0, 64}, [&](std::int64_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const std::lock_guard<std::mutex> lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  return static_cast<int>(seen.size());
}

TEST(ExecThreads, AreAsManyAsOpenMPWouldTake) {
  for (const int threads : {1, 4, 2}) {
    with_threads(threads, [&] { EXPECT_EQ(threads_of_long_region(), threads); });
  }
  int within = 0;
#pragma omp parallel num_threads(2)
  {
#pragma omp single
    within = threads_of_long_region();
  }
  EXPECT_EQ(within, 1) << "in a region of the host";
}

/// The bits of a number that a compiler may fuse in one way here and in another there.
TEST(ExecThreads, OneAndSeveralRunTheSameMachineCode) {
  std::vector<double> x(1000), one(1000), several(1000);
  Random random(7);
  for (double& value : x) value = uniform(random, -1, 1);
  const auto fill = [&x](std::vector<double>& result) {
    parallel_for("fill", RangePolicy<OpenMP>{0, 1000}, [&](std::int64_t i) {
      const double a = x[std::size_t(i)], b = x[std::size_t(999 - i)];
      result[std::size_t(i)] = (a * a - b * b) * (a * b - 0.1 * a) + b * a;
    });
  };
  with_threads(1, [&] { fill(one); });
  with_threads(3, [&] { fill(several); });
  EXPECT_EQ(one, several);
}

/// A thread's part may end anywhere, and what it makes of an index must not depend on that. Friction branches: a loop
/// that makes several rounds at once fuses it in another way.
TEST(ExecThreads, MakeTheSameBitsWhereverARangeIsCut) {
  constexpr std::int64_t size = 61;
  std::vector<Vec3<double>> wanted(size), normal(size), one(size), cut(size);
  Random random(11);
  for (std::int64_t i = 0; i < size; ++i) {
    wanted[std::size_t(i)] = random_vector(random, 1);
    normal[std::size_t(i)] = random_direction(random);
  }
  const auto fill = [&](std::vector<Vec3<double>>& result) {
    return [&](std::int64_t i) {
      const auto k = std::size_t(i);
      result[k] = allowed_impulse(wanted[k], normal[k], {0.3, 0.01});
    };
  };
  const auto work = [](const auto& body, std::int64_t begin, std::int64_t end) {
    const RangeOf<std::decay_t<decltype(body)>> range{body};
    range.work(&range, begin, end);
  };
  work(fill(one), 0, size);
  for (std::int64_t end = 1; end < size; ++end) {
    work(fill(cut), 0, end);
    work(fill(cut), end, size);
    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(norm(cut[i] - one[i]), 0) << i << " of a range cut at " << end;
  }
}

TEST(ExecThreads, AreNotCalledForOnePieceOfWork) {
  with_threads(3, [] {
    parallel_for("one", RangePolicy<OpenMP>{5, 6}, [](std::int64_t) { EXPECT_EQ(omp_get_level(), 0); });
    parallel_for("two", RangePolicy<OpenMP>{5, 7}, [](std::int64_t) { EXPECT_EQ(omp_get_level(), 1); });
    const std::int32_t offsets[] = {0, 0, 1}, items[] = {8};
    parallel_for_coloured("one", OpenMP{}, offsets, 2, items, [](std::int32_t) { EXPECT_EQ(omp_get_level(), 0); });
  });
}

TEST(ExecThreads, HostThreadsHaveTeamsOfTheirOwn) {
  std::vector<std::thread> hosts;
  std::atomic<int> wrong{0};
  for (int host = 0; host < 4; ++host) {
    hosts.emplace_back([host, &wrong] {
      omp_set_num_threads(1 + host);
      for (int repeat = 0; repeat < 200; ++repeat) {
        std::vector<std::int64_t> squares(100);
        parallel_for("test", RangePolicy<OpenMP>{0, 100}, [&](std::int64_t i) { squares[std::size_t(i)] = i * i; });
        for (std::int64_t i = 0; i < 100; ++i) wrong += squares[std::size_t(i)] != i * i;
      }
    });
  }
  for (std::thread& host : hosts) host.join();
  EXPECT_EQ(wrong, 0);
}

/// Exit status of work() in a process that is forked off here; negative: it had to be killed.
template <class Work>
int status_of_fork(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(20);
    ::_exit(work());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The helpers of the thread that goes on in a fork are not there: it would wait for them for ever.
TEST(ExecThreads, AForkedThreadWorksAloneAndNewOnesDoNot) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "it lets no threads begin after a fork";
#endif
  with_threads(3, [] {
    EXPECT_EQ(threads_of_long_region(), 3);
    EXPECT_EQ(status_of_fork(threads_of_long_region), 1);
    EXPECT_EQ(status_of_fork([] { return status_of_fork(threads_of_long_region); }), 1);
    EXPECT_EQ(status_of_fork([] {
                int seen = 0;
                std::thread([&seen] {
                  OpenMP::set_concurrency(3);
                  seen = threads_of_long_region();
                }).join();
                return seen;
              }),
              3);
    EXPECT_EQ(status_of_fork([] {
                OpenMP::set_concurrency(5);  // leaves the host's number alone
                return 10 * OpenMP::concurrency() + omp_get_max_threads();
              }),
              13);
    EXPECT_EQ(threads_of_long_region(), 3);
  });
}

#endif

}  // namespace
}  // namespace pinball::exec_test
