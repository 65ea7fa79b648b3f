#include <random>

#include <kernels/compress.hpp>
#include <tests/support/support.hpp>

namespace pinball::compress_test {
namespace {

/// Every mask of 8 lanes and many of 16, written one after the other as a list grows.
template <int lanes, class Value>
void expect_lanes_of_masks() {
  Value from[lanes];
  for (int i = 0; i < lanes; ++i) from[i] = Value(100 + 3 * i);
  std::vector<Value> to, expected;
  int count = 0;
  for (unsigned mask = 0; mask < 1U << lanes; mask += lanes == 16 ? 37 : 1) {
    to.resize(std::size_t(count + lanes), Value(-1));
    count += write_lanes<lanes>(mask, from, to.data() + count);
    for (int i = 0; i < lanes; ++i) {
      if ((mask >> i & 1) != 0) expected.push_back(from[i]);
    }
    ASSERT_EQ(std::size_t(count), expected.size()) << "mask " << mask;
  }
  to.resize(expected.size());
  EXPECT_EQ(to, expected);
}

TEST(WriteLanes, WritesWhatTheMaskTells) {
  expect_lanes_of_masks<1, double>();
  expect_lanes_of_masks<2, double>();
  expect_lanes_of_masks<4, float>();
  expect_lanes_of_masks<8, std::int32_t>();
  expect_lanes_of_masks<8, double>();
  expect_lanes_of_masks<8, float>();
  expect_lanes_of_masks<16, std::int32_t>();
  expect_lanes_of_masks<16, double>();
  expect_lanes_of_masks<16, float>();
}

TEST(WriteNumbers, CountsFromTheFirst) {
  std::int32_t to[16];
  EXPECT_EQ(write_numbers<8>(0b10100110, 1000, to), 4);
  EXPECT_EQ(std::vector<std::int32_t>(to, to + 4), (std::vector<std::int32_t>{1001, 1002, 1005, 1007}));
  EXPECT_EQ(write_numbers<16>(0x8001, -3, to), 2);
  EXPECT_EQ(std::vector<std::int32_t>(to, to + 2), (std::vector<std::int32_t>{-3, 12}));
  EXPECT_EQ(write_numbers<8>(0, 7, to), 0);
}

}  // namespace
}  // namespace pinball::compress_test
