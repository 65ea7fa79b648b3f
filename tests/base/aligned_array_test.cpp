#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include <solver/base/aligned_array.hpp>

namespace pinball {
namespace {

bool all_zero(const AlignedArray<double>& a) {
  return std::all_of(a.data(), a.data() + a.size(), [](double x) { return x == 0; });
}

TEST(AlignedArray, ResetGivesZerosOnTheSameAlignment) {
  AlignedArray<double> a;
  for (const std::size_t size : {0U, 1U, 8U, 3U, 100U, 1U << 19U, 5U, 0U, 7U}) {
    a.reset(size);
    EXPECT_EQ(a.size(), size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(a.data()) % 64, 0);
    EXPECT_TRUE(all_zero(a));
    std::fill(a.data(), a.data() + size, 1.0);
  }
}

TEST(AlignedArray, RenewLeavesOnlyThePaddingZero) {
  AlignedArray<double> a;
  for (const std::size_t size : {13U, 3U, 1U << 19U, 5U, 0U, 17U}) {
    a.renew(size);
    EXPECT_EQ(a.size(), size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(a.data()) % 64, 0);
    const std::size_t padded = (size + 7) / 8 * 8;
    for (std::size_t i = size; i < padded; ++i) EXPECT_EQ(a.data()[i], 0);
    std::fill(a.data(), a.data() + padded, 1.0);
  }
}

TEST(AlignedArray, WhatWasMovedAwayCanBeUsedAgain) {
  AlignedArray<double> a(100);
  a[99] = 2;
  const AlignedArray<double> b = std::move(a);
  EXPECT_EQ(b[99], 2);
  a.reset(10);  // NOLINT(bugprone-use-after-move): that is what is tested
  ASSERT_NE(a.data(), nullptr);
  EXPECT_TRUE(all_zero(a));
}

}  // namespace
}  // namespace pinball
