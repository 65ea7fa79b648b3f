#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <solver/contact/search/moving_boxes.hpp>
#include <tests/support/support.hpp>

/// Boxes that are set a pack at a time, against the same ones set one by one.
namespace pinball::test::moving_boxes_test {
namespace {

template <class S>
class MovingBoxesTest : public ::testing::Test {};
using Scalars = ::testing::Types<double, float>;
TYPED_TEST_SUITE(MovingBoxesTest, Scalars);

/// A proper box, or, now and then, one with bounds that are the wrong way round, infinite or no numbers.
template <class S>
MovingBox<S> any_box(Random& random) {
  MovingBox<S> box;
  for (int c = 0; c < 12; ++c) {
    box.bound[c] = static_cast<S>(c % 6 < 3 ? uniform(random, -1, 0.1) : uniform(random, 0, 1));
  }
  const auto some = static_cast<int>(uniform(random, 0, 12));
  const double kind = uniform(random, 0, 8);
  if (kind < 1) box.bound[some] = std::numeric_limits<S>::quiet_NaN();
  if (kind > 7)
    box.bound[some] = some % 6 < 3 ? -std::numeric_limits<S>::infinity() : std::numeric_limits<S>::infinity();
  return box;
}

TYPED_TEST(MovingBoxesTest, SetAsAPackAreThoseSetOneByOne) {
  using S = TypeParam;
  using T = Pack<S, native_width<S>>;
  constexpr int W = width_of<T>;
  constexpr std::int32_t count = 20 * ball_group<S> - 1;
  Random random(5);
  MovingBoxes<S> one_by_one(count), packs(count);
  int nothing = 0;
  for (std::int32_t first = 0; first < count; first += W) {
    alignas(64) S lanes[12][W];
    for (int i = 0; i < W; ++i) {
      const MovingBox<S> box = first + i < count ? any_box<S>(random) : empty_box<S>();
      for (int c = 0; c < 12; ++c) lanes[c][i] = box.bound[c];
      if (first + i < count) one_by_one.set(first + i, box);
    }
    T bound[12];
    for (int c = 0; c < 12; ++c) bound[c] = load<T>(lanes[c]);
    packs.set_pack(first, bound);
  }
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(packs.groups()) * ball_group<S>; ++i) {
    for (int c = 0; c < 12; ++c) EXPECT_EQ(packs.box(i).bound[c], one_by_one.box(i).bound[c]) << i << ", " << c;
    nothing += packs.box(i).bound[0] > packs.box(i).bound[3] ? 1 : 0;
  }
  EXPECT_GT(nothing, 10);
  EXPECT_LT(nothing, count / 2);
}

}  // namespace
}  // namespace pinball::test::moving_boxes_test
