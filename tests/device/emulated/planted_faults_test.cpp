#include <gtest/gtest.h>

#include <csignal>
#include <cstdint>
#include <functional>
#include <vector>

#include <kernels/exec.hpp>

#include "emulated_device.hpp"

/// What kernels for a GPU may do wrong, planted, is found on the emulated one (emulated_device.hpp) every time.
namespace pinball::planted_faults_test {
namespace {

using emulated::Order;
using DeviceArray = Array<std::int64_t, GpuSpace>;
constexpr std::int64_t count = 1000;
constexpr std::uint32_t seeds = 20;

std::vector<std::int64_t> on_the_host(const DeviceArray& array) {
  std::vector<std::int64_t> copy(array.size());
  deep_copy(copy.data(), array);
  return copy;
}

/// Results in the shuffled orders of 20 seeds.
void for_shuffled_orders(const std::function<void(std::uint32_t)>& test) {
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    emulated::set_order(Order::shuffled, seed);
    test(seed);
  }
  emulated::set_order(Order::forward);
}

struct Fill {
  std::int64_t* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const { to[i] = i * i; }
};
struct Adds {
  const std::int64_t* value;
  PINBALL_FUNCTION void operator()(std::int64_t i, std::int64_t& sum) const { sum += value[i]; }
};

TEST(PlantedFaults, NoneAreFoundWhereThereAreNone) {
  for_shuffled_orders([](std::uint32_t) {
    DeviceArray array(count);
    parallel_for("fill", RangePolicy<Gpu>{0, count}, Fill{array.data()});
    std::int64_t sum = 0;
    parallel_reduce("sum", RangePolicy<Gpu>{0, count}, Adds{array.data()}, sum);
    EXPECT_EQ(sum, (count - 1) * count * (2 * count - 1) / 6);
    EXPECT_EQ(on_the_host(array)[31], 31 * 31);
  });
}

/// Reads what another thread writes; distance: to that thread.
struct TakesFromAnother {
  std::int64_t* to;
  std::int64_t distance;
  PINBALL_FUNCTION void operator()(std::int64_t i) const { to[i] = i < distance ? 1 : to[i - distance] + 1; }
};

TEST(PlantedFaults, KernelsWhoseThreadsWaitForNoneButReadWhatAnotherWrites) {
  for (const std::int64_t distance : {1, 128, 300}) {  // in the block, in the next, two further
    for_shuffled_orders([distance](std::uint32_t seed) {
      DeviceArray array(count);
      parallel_for("prefix", RangePolicy<Gpu>{0, count}, TakesFromAnother{array.data(), distance});
      std::vector<std::int64_t> right(count);
      for (std::int64_t i = 0; i < count; ++i) TakesFromAnother{right.data(), distance}(i);
      EXPECT_NE(on_the_host(array), right) << distance << " " << seed;
    });
  }
}

/// A race: the last of the threads to write one number wins.
struct AllWriteOne {
  std::int64_t* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const { *to = i; }
};

TEST(PlantedFaults, KernelsWhoseThreadsWriteTheSameNumber) {
  for_shuffled_orders([](std::uint32_t seed) {
    DeviceArray array(1);
    parallel_for("race", RangePolicy<Gpu>{0, count}, AllWriteOne{array.data()});
    EXPECT_NE(on_the_host(array)[0], count - 1) << seed;
  });
}

/// As join_lanes of gpu.hpp, with its first or its second barrier left out.
template <bool first, bool second>
__global__ void sum_of_block(const std::int64_t* from, std::int64_t* to) {
  static std::int64_t upper[sum_lanes / 2];  // shared by the block
  const int lane = static_cast<int>(threadIdx.x);
  std::int64_t own = from[lane];
  for (int width = sum_lanes / 2; width > 0; width /= 2) {
    if (lane >= width && lane < 2 * width) upper[lane - width] = own;
    if constexpr (first) __syncthreads();
    if (lane < width) own += upper[lane];
    if constexpr (second) __syncthreads();
  }
  if (lane == 0) *to = own;
}

template <bool first, bool second>
std::int64_t sum_by_a_block() {
  DeviceArray from(sum_lanes), to(1);
  parallel_for("fill", RangePolicy<Gpu>{0, sum_lanes}, Fill{from.data()});
  launch("sum", 1, &sum_of_block<first, second>, from.data(), to.data());
  return on_the_host(to)[0];
}

TEST(PlantedFaults, BarriersThatAreMissing) {
  static constexpr std::int64_t right = 127 * 128 * 255 / 6;
  for_shuffled_orders([](std::uint32_t seed) {
    EXPECT_EQ((sum_by_a_block<true, true>()), right);
    EXPECT_NE((sum_by_a_block<false, true>()), right) << seed;
    EXPECT_NE((sum_by_a_block<true, false>()), right) << seed;
  });
}

/// Nor what an array had that was there before.
TEST(PlantedFaults, MemoryThatNobodyHasSet) {
  constexpr std::size_t bytes = count * sizeof(double);
  const std::vector<double> zeros(count);
  for (std::uint32_t round = 0; round < seeds; ++round) {
    void* const memory = GpuSpace::allocate(GpuSpace::room(bytes));
    std::vector<double> found(count);
    GpuSpace::copy_to_host(found.data(), memory, bytes);
    for (const double number : found) EXPECT_NE(number, number) << "is a number";
    GpuSpace::copy_from_host(memory, zeros.data(), bytes);
    GpuSpace::release(memory, 0);
  }
}

TEST(PlantedFaults, AHostThatDoesNotWait) {
  for_shuffled_orders([](std::uint32_t seed) {
    auto* const result = GpuScratch::results<std::int64_t>(1);
    *result = -1;
    launch("write", 1, &call_for_each<AllWriteOne>, 5, 6, AllWriteOne{result});
    EXPECT_EQ(*result, -1) << seed;
    fence<Gpu>();
    EXPECT_EQ(*result, 5) << seed;
  });
}

TEST(PlantedFaultsDeathTest, AHostThatReadsMemoryOfTheDevice) {
  const DeviceArray array(count);
  EXPECT_EXIT(static_cast<void>(*static_cast<const volatile std::int64_t*>(array.data())),
              testing::KilledBySignal(SIGSEGV), "");
}

/// Parameters of a kernel that have an address somewhere among them.
struct WithAddress {
  double before = 1.5e-310;  // as bits an address, but of nothing
  int numbers[2] = {7, 32'000};
  bool flag = true;
  const void* address = nullptr;
  PINBALL_FUNCTION void operator()(std::int64_t) const {}
};

TEST(PlantedFaultsDeathTest, KernelsThatAreGivenAnAddressOfTheHost) {
  const auto give = [](const void* address) {
    parallel_for("given", RangePolicy<Gpu>{0, 1}, WithAddress{.address = address});
  };
  const std::vector<std::int64_t> heap(count);
  static const double constant = 1;
  const std::int64_t stack = 1;
  for (const void* address : {static_cast<const void*>(heap.data() + 20), static_cast<const void*>(&constant),
                              static_cast<const void*>(&stack)}) {
    EXPECT_DEATH(give(address), "a kernel is given an address of the host");
  }
  const DeviceArray array(count);
  give(array.data() + count);
  give(GpuScratch::results<std::int64_t>(1));
  give(nullptr);
}

TEST(PlantedFaultsDeathTest, CopiesOfTheWrongKindAndBeyondTheEnd) {
  DeviceArray first(count), second(count);
  std::vector<std::int64_t> host(count);
  const char* const what = "a copy of the wrong kind, or beyond the end of memory";
  EXPECT_DEATH(GpuSpace::copy(first.data(), host.data(), 8), what);
  EXPECT_DEATH(GpuSpace::copy_from_host(host.data(), first.data(), 8), what);
  EXPECT_DEATH(GpuSpace::copy_from_host(first.data(), second.data(), 8), what);
  EXPECT_DEATH(GpuSpace::copy_to_host(host.data(), first.data() + 512, 8 * count), what);
  EXPECT_DEATH(GpuSpace::zero(host.data(), 8), "memory is set that the device has not given out");
}

__global__ void half_wait() {
  if (threadIdx.x % 2 == 0) __syncthreads();
}

TEST(PlantedFaultsDeathTest, BarriersThatNotAllReachAndMemoryReleasedTwice) {
  EXPECT_DEATH(
      {
        launch("half", 1, &half_wait);
        fence<Gpu>();
      },
      "a barrier that not all threads of a block reach");
  EXPECT_DEATH(
      {
        void* const memory = GpuSpace::allocate(4096);
        GpuSpace::release(memory, 0);
        GpuSpace::release(memory, 0);
      },
      "memory is released that is not given out");
}

}  // namespace
}  // namespace pinball::planted_faults_test
