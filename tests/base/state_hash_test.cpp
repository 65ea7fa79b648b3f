#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include <solver/base/state_hash.hpp>

namespace pinball::state_hash_test {
namespace {

std::uint64_t hash(std::vector<double> values) {
  StateHash h;
  h.add(std::span<const double>(values));
  return h.value();
}

TEST(StateHash, DependsOnBytesAndTheirOrder) {
  EXPECT_EQ(hash({1.0, 2.0}), hash({1.0, 2.0}));
  EXPECT_NE(hash({1.0, 2.0}), hash({2.0, 1.0}));
  EXPECT_NE(hash({1.0}), hash({std::nextafter(1.0, 2.0)}));
  EXPECT_NE(hash({0.0}), hash({-0.0}));
  EXPECT_NE(hash({}), hash({0.0}));
  EXPECT_NE(hash({0.0}), hash({0.0, 0.0}));
  EXPECT_NE(hash({1.0, 2.0}), hash({-1.0, -2.0})) << "two flipped signs must not cancel";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hash({nan}), hash({nan}));
}

TEST(StateHash, DoesNotDependOnHowTheBytesAreCut) {
  std::vector<unsigned char> bytes(61);
  std::iota(bytes.begin(), bytes.end(), static_cast<unsigned char>(200));
  StateHash whole;
  whole.add(bytes.data(), bytes.size());
  for (std::size_t first = 0; first <= bytes.size(); ++first) {
    for (std::size_t second = 0; first + second <= bytes.size(); ++second) {
      StateHash cut;
      cut.add(bytes.data(), first);
      cut.value();  // reading does not disturb
      cut.add(bytes.data() + first, second);
      cut.add(bytes.data() + first + second, bytes.size() - first - second);
      ASSERT_EQ(cut.value(), whole.value()) << first << " + " << second;
    }
  }
}

TEST(StateHash, TellsEveryFlippedBitApart) {
  std::vector<unsigned char> bytes(43);
  std::set<std::uint64_t> seen;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<unsigned char>(1U << (bit % 8));
    StateHash h;
    h.add(bytes.data(), bytes.size());
    seen.insert(h.value());
    bytes[bit / 8] ^= static_cast<unsigned char>(1U << (bit % 8));
  }
  EXPECT_EQ(seen.size(), 8 * bytes.size());
}

TEST(StateHash, KeepsItsValue) {
  // Values in summary files of different versions are compared: the scheme must not change by accident.
  EXPECT_EQ(hash({}), 16760284063755336091U);
  EXPECT_EQ(hash({1.0, -2.5, 3.0}), 12482258988109434174U);
}

}  // namespace
}  // namespace pinball::state_hash_test
