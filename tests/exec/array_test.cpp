#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <kernels/exec.hpp>

namespace pinball::array_test {
namespace {

template <class Memory>
class ArrayIn : public ::testing::Test {};
#if !defined(PINBALL_TEST_MEMORIES)
#define PINBALL_TEST_MEMORIES HostSpace, MockSpace
#endif
using Memories = ::testing::Types<PINBALL_TEST_MEMORIES>;
TYPED_TEST_SUITE(ArrayIn, Memories);

/// The array with the padding that fills its last line of 64 bytes.
template <class Memory>
std::vector<double> with_padding(const Array<double, Memory>& array) {
  std::vector<double> copy((array.size() + 7) / 8 * 8);
  if (!copy.empty()) Memory::copy_to_host(copy.data(), array.data(), 8 * copy.size());
  return copy;
}
template <class Memory>
void fill_with_padding(Array<double, Memory>& array) {
  const std::vector<double> ones((array.size() + 7) / 8 * 8, 1.0);
  if (!ones.empty()) Memory::copy_from_host(array.data(), ones.data(), 8 * ones.size());
}

TYPED_TEST(ArrayIn, ResetGivesZerosOnTheSameAlignment) {
  Array<double, TypeParam> a;
  for (const std::size_t size : {0U, 1U, 8U, 3U, 100U, 1U << 19U, 5U, 0U, 7U}) {
    a.reset(size);
    EXPECT_EQ(a.size(), size);
    EXPECT_EQ(a.bytes(), 8 * size);
    EXPECT_EQ(a.empty(), size == 0);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(a.data()) % 64, 0);
    EXPECT_EQ(with_padding(a), std::vector<double>((size + 7) / 8 * 8, 0.0));
    fill_with_padding(a);
  }
}

TYPED_TEST(ArrayIn, RenewLeavesOnlyThePaddingZero) {
  Array<double, TypeParam> a;
  for (const std::size_t size : {13U, 3U, 1U << 19U, 5U, 0U, 17U}) {
    a.renew(size);
    EXPECT_EQ(a.size(), size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(a.data()) % 64, 0);
    const std::vector<double> whole = with_padding(a);
    for (std::size_t i = size; i < whole.size(); ++i) EXPECT_EQ(whole[i], 0);
    fill_with_padding(a);
  }
}

TYPED_TEST(ArrayIn, WhatWasMovedAwayCanBeUsedAgain) {
  Array<double, TypeParam> a(100);
  fill_with_padding(a);
  Array<double, TypeParam> b = std::move(a);
  EXPECT_EQ(with_padding(b), std::vector<double>(104, 1.0));
  a.reset(10);  // NOLINT(bugprone-use-after-move): that is what is tested
  ASSERT_NE(a.data(), nullptr);
  EXPECT_EQ(with_padding(a), std::vector<double>(16, 0.0));
  b = std::move(a);
  EXPECT_EQ(b.size(), 10);
  static_assert(!std::is_copy_constructible_v<Array<double, TypeParam>>);
}

TYPED_TEST(ArrayIn, GoesToAnyOtherMemoryAndBack) {
  Array<std::int32_t> host(1000);
  std::iota(host.data(), host.data() + host.size(), 7);
  Array<std::int32_t, TypeParam> first(1000), second(1000);
  Array<std::int32_t, MockSpace> third(1000);
  deep_copy(first, host);
  deep_copy(second, first);
  deep_copy(third, second);
  Array<std::int32_t> mirror = create_mirror(third);
  EXPECT_EQ(mirror.size(), 1000);
  EXPECT_EQ(mirror[999], 0);
  deep_copy(mirror, third);
  EXPECT_EQ(std::vector<std::int32_t>(mirror.data(), mirror.data() + 1000),
            std::vector<std::int32_t>(host.data(), host.data() + 1000));
}

TYPED_TEST(ArrayIn, IsCopiedToArraysOfItsSizeAlone) {
  Array<double, TypeParam> three(3);
  const Array<double> four(4);
  try {
    deep_copy(three, four);
    FAIL() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "deep_copy of 4 elements to 3");
  }
  EXPECT_THROW(deep_copy(three, four.data(), 4), std::invalid_argument);
}

template <class A>
concept HasElements = requires(A a) {
  a[0];
};

std::size_t mappings() {
  std::ifstream maps("/proc/self/maps");
  return std::count(std::istreambuf_iterator<char>(maps), {}, '\n');
}

TEST(Array, LargeOnesInTheHostsMemoryBeginAsZeroAndAreGivenBack) {
  constexpr std::size_t numbers = 3 * 131072 + 5;  // 3 MB and a little: two huge pages
  const auto sum_of = [](const Array<double>& array) {
    return std::accumulate(array.data(), array.data() + array.size(), 0.0);
  };
  const std::size_t before = mappings();
  for (int turn = 0; turn < 50; ++turn) {
    Array<double> large(numbers);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.data()) % HostSpace::alignment, 0u);
    ASSERT_EQ(sum_of(large), 0);
    std::fill_n(large.data(), large.size(), 1.0);
    large.reset(numbers - 7);  // in the same memory
    ASSERT_EQ(sum_of(large), 0);
    std::fill_n(large.data(), large.size(), 1.0);
    large.reset(3 * numbers);  // in new one
    ASSERT_EQ(sum_of(large), 0);
    large.renew(numbers);
    large.data()[numbers - 1] = 2;
    const Array<double> moved = std::move(large);
    ASSERT_EQ(moved[numbers - 1], 2);
  }
  EXPECT_LE(mappings(), before + 4);
}

TEST(Array, HasElementsThatTheHostCanNameInItsOwnMemoryAlone) {
  static_assert(HasElements<Array<double>>);
  static_assert(!HasElements<Array<double, MockSpace>>);
  Array<double> a(2);
  a[1] = 4;
  EXPECT_EQ(std::as_const(a)[1], 4);
}

}  // namespace
}  // namespace pinball::array_test
