#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <kernels/exec.hpp>
#include <tests/exec/with_threads.hpp>

/// Where an access dies: of the signal, but for a sanitizer that handles it.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EXPECT_CLOSED(access) EXPECT_DEATH(access, "SEGV")
#else
#define EXPECT_CLOSED(access) EXPECT_EXIT(access, ::testing::KilledBySignal(SIGSEGV), "")
#endif

namespace pinball::mock_test {
namespace {

using namespace test;
using MockArray = Array<std::int64_t, MockSpace>;

struct Fill {
  std::int64_t* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const { to[i] = 3 * i; }
};

std::int64_t read(const MockArray& array, std::size_t i) {
  return *(static_cast<const volatile std::int64_t*>(array.data()) + i);
}
void write(MockArray& array, std::size_t i) { *(static_cast<volatile std::int64_t*>(array.data()) + i) = 1; }

std::vector<std::int64_t> on_the_host(const MockArray& array) {
  std::vector<std::int64_t> copy(array.size());
  deep_copy(copy.data(), array);
  return copy;
}

TEST(Mock, HasMemoryForKernelsAndCopies) {
  for (const int threads : {1, 3}) {
    with_threads(threads, [] {
      MockArray array(10'000);
      EXPECT_EQ(on_the_host(array), std::vector<std::int64_t>(10'000, 0));
      parallel_for("fill", RangePolicy<Mock>{5000, 10'000}, Fill{array.data()});
      const std::vector<std::int64_t> filled = on_the_host(array);
      for (std::int64_t i = 0; i < 10'000; ++i) ASSERT_EQ(filled[std::size_t(i)], i < 5000 ? 0 : 3 * i);
    });
  }
}

TEST(Mock, KillsAHostThatTouchesItsMemory) {
  MockArray array(3);
  EXPECT_CLOSED(read(array, 0));
  EXPECT_CLOSED(write(array, 2));
  EXPECT_CLOSED(read(array, 511)) << "to the end of the page";
  with_threads(3, [&] { parallel_for("fill", RangePolicy<Mock>{0, 3}, Fill{array.data()}); });
  EXPECT_CLOSED(read(array, 0)) << "after a kernel";
  EXPECT_EQ(on_the_host(array)[2], 6);
  EXPECT_CLOSED(read(array, 0)) << "after a copy";
}

/// Also where mprotect closes it, which takes long: then it stays open in between.
TEST(Mock, KillsAHostAgainAndAgainInALongRun) {
  MockArray array(3);
  const auto times = [&](std::int64_t kernels) {
    for (std::int64_t i = 0; i < kernels; ++i) parallel_for("fill", RangePolicy<Mock>{0, 3}, Fill{array.data()});
  };
  times(MockMemory::always_closed - 10);
  EXPECT_CLOSED(read(array, 0));
  times(MockMemory::turn / 4);
  if (!MockMemory::instance().has_keys()) {
    EXPECT_EQ(read(array, 2), 6) << "open in between";
  }
  times(MockMemory::turn - (MockMemory::always_closed + MockMemory::turn / 4) % MockMemory::turn + 20);
  EXPECT_CLOSED(read(array, 0));
}

TEST(Mock, IsClosedAfterAKernelThatThrows) {
  MockArray array(100);
  for (const int threads : {1, 3}) {
    with_threads(threads, [&] {
      const std::int64_t* const at = array.data();
      const auto fail = [at](std::int64_t i) {
        if (at[i] == 0) throw std::runtime_error("zero");
      };
      EXPECT_THROW(parallel_for("throws", RangePolicy<Mock>{0, 100}, fail), std::runtime_error);
      EXPECT_CLOSED(read(array, 0));
    });
  }
}

TEST(Mock, IsOpenInAKernelAfterOneWithinAndClosedAfterBoth) {
  MockArray outer(8), inner(80);
  for (const int threads : {1, 3}) {
    with_threads(threads, [&] {
      const Fill fill{inner.data()};
      std::int64_t* const at = outer.data();
      parallel_for("outer", RangePolicy<Mock>{0, 8}, [fill, at](std::int64_t i) {
        parallel_for("inner", RangePolicy<Mock>{10 * i, 10 * i + 10}, fill);
        at[i] = i;
      });
      EXPECT_CLOSED(read(outer, 0));
    });
  }
  EXPECT_EQ(on_the_host(outer)[7], 7);
  EXPECT_EQ(on_the_host(inner)[79], 237);
}

TEST(Mock, WorksForSeveralThreadsOfTheHost) {
  std::vector<std::thread> hosts;
  std::vector<int> right(4, 0);
  for (std::size_t host = 0; host < right.size(); ++host) {
    hosts.emplace_back([host, &right] {
      for (int repeat = 0; repeat < 50; ++repeat) {
        MockArray array(100 * (host + 1));
        parallel_for("fill", RangePolicy<Mock>{0, std::int64_t(array.size())}, Fill{array.data()});
        right[host] += on_the_host(array).back() == 3 * std::int64_t(array.size() - 1);
      }
    });
  }
  for (std::thread& host : hosts) host.join();
  EXPECT_EQ(right, std::vector<int>(4, 50));
  MockArray array(1);
  EXPECT_CLOSED(read(array, 0));
}

TEST(Mock, CopiesTheFunctor) {
  MockArray array(4);
  struct Number {
    std::int64_t* to;
    const Number* given;
    void operator()(std::int64_t i) const { to[i] = this == given ? 1 : 2; }
  };
  Number number{array.data(), nullptr};
  number.given = &number;
  parallel_for("number", RangePolicy<Mock>{0, 4}, number);
  EXPECT_EQ(on_the_host(array), std::vector<std::int64_t>(4, 2));
}

TEST(Mock, GivesMemoryThatWasReleasedAgain) {
  const std::int64_t* first = nullptr;
  for (int repeat = 0; repeat < 3; ++repeat) {
    std::vector<MockArray> arrays;
    for (std::size_t size : {1U, 600U, 1U << 20U, 5U}) arrays.emplace_back(size);
    for (const MockArray& array : arrays) EXPECT_EQ(on_the_host(array), std::vector<std::int64_t>(array.size(), 0));
    for (MockArray& array : arrays) {
      parallel_for("fill", RangePolicy<Mock>{0, std::int64_t(array.size())}, Fill{array.data()});
    }
    if (first == nullptr) first = arrays[0].data();
    EXPECT_EQ(arrays[0].data(), first);
    arrays.erase(arrays.begin() + 1);  // a gap between others
    arrays.emplace_back(512U);
    EXPECT_EQ(on_the_host(arrays.back()), std::vector<std::int64_t>(512, 0));
  }
  EXPECT_THROW(MockArray(std::size_t(1) << 50), std::bad_alloc);
}

TEST(Mock, UsesTheAddressesOfWhatComesAndGoesAgain) {
  const MockArray stays(600);
  MockArray replaced(5000);
  const std::int64_t* const first = replaced.data();
  const std::int64_t* last = nullptr;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    MockArray next(5000);
    last = next.data();
    parallel_for("fill", RangePolicy<Mock>{0, 5000}, Fill{next.data()});
    replaced = std::move(next);
  }
  EXPECT_LE(last > first ? last - first : first - last, 2 * 5120);
  EXPECT_EQ(on_the_host(MockArray(5000)), std::vector<std::int64_t>(5000, 0));
}

TEST(Mock, SaysWhatProtectsIt) {
#if defined(PINBALL_MOCK_KEYS)
  const int key = pkey_alloc(0, 0);
  EXPECT_STREQ(MockSpace::protection(), key >= 0 ? "protection keys" : "mprotect");
  if (key >= 0) pkey_free(key);
#else
  EXPECT_STREQ(MockSpace::protection(), "mprotect");
#endif
}

}  // namespace
}  // namespace pinball::mock_test
