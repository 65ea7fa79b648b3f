#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include <solver/device/packed_arrays.hpp>

namespace pinball::packed_arrays_test {
namespace {

struct Doubles {
  const std::int32_t* from;
  double* to;
  std::uint8_t* seen;
  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    to[i] += 2 * from[i];
    seen[i] = 1;
  }
};

template <class Space>
class PackedArraysOf : public testing::Test {};
using Spaces = testing::Types<Serial, Mock>;
TYPED_TEST_SUITE(PackedArraysOf, Spaces);

/// Of sizes that are no multiple of anything, and none; twice, with others.
TYPED_TEST(PackedArraysOf, GoThereAndComeBack) {
  PackedArrays<TypeParam> packed;
  for (const std::size_t count : {std::size_t(77), std::size_t(1003), std::size_t(3)}) {
    std::vector<std::int32_t> from(count);
    std::vector<double> sum(count, 0.5), kept(count, 7), empty;
    for (std::size_t i = 0; i < count; ++i) from[i] = static_cast<std::int32_t>(i);
    packed.clear();
    const auto first = packed.add_for_both(sum.data(), count);
    const auto none = packed.add_for_both(empty.data(), 0);
    const auto second = packed.add_for_both(kept.data(), count);
    const auto numbers = packed.add(from);
    const auto seen = packed.template add_room<std::uint8_t>(count);
    packed.send();
    from.assign(count, -1);
    kept.assign(count, -1);
    EXPECT_EQ(packed.data(none), packed.data(second));
    EXPECT_GE(packed.bytes(), count * (2 * sizeof(double) + sizeof(std::int32_t) + 1));
    parallel_for("doubles", RangePolicy<TypeParam>{0, static_cast<std::int64_t>(count)},
                 Doubles{packed.data(numbers), packed.data(first), packed.data(seen)});
    packed.bring_back();
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(sum[i], 0.5 + 2 * static_cast<double>(i));
      ASSERT_EQ(kept[i], 7);
      ASSERT_EQ(from[i], -1);
    }
  }
  packed.clear();
  packed.send();
  packed.bring_back();
}

}  // namespace
}  // namespace pinball::packed_arrays_test
