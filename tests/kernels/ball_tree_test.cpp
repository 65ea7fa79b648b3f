#include <kernels/ball_tree.hpp>
#include <kernels/reference_balls.hpp>
#include <tests/support/support.hpp>

namespace pinball::ball_tree_test {
namespace {

using namespace test;

template <class T>
class BallTreeKernels : public ::testing::Test {
 protected:
  using Scalar = ScalarOf<T>;
  static constexpr int group = ball_group<Scalar>;
  Random random{17};
  AlignedVector<Scalar> one = AlignedVector<Scalar>(7 * group), other = AlignedVector<Scalar>(7 * group);

  void fill(AlignedVector<Scalar>& balls, double way) {
    for (int i = 0; i < group; ++i) {
      for (int k = 0; k < 3; ++k) {
        balls[std::size_t(k * group + i)] = Scalar(uniform(random, -2, 2));
        balls[std::size_t((3 + k) * group + i)] = Scalar(uniform(random, -way, way));
      }
      balls[std::size_t(6 * group + i)] = Scalar(uniform(random, 0.1, 0.8));
    }
  }
  /// Least distance over the sum of the radii, at many times.
  double nearest(int i, int j) const {
    double least = 1e300;
    for (int step = -200; step <= 200; ++step) {
      double d2 = 0;
      for (int k = 0; k < 3; ++k) {
        const auto at = [&](const AlignedVector<Scalar>& b, int ball) {
          return double(b[std::size_t(k * group + ball)]) +
                 step / 200.0 * double(b[std::size_t((3 + k) * group + ball)]);
        };
        d2 += (at(one, i) - at(other, j)) * (at(one, i) - at(other, j));
      }
      least = std::min(least, std::sqrt(d2));
    }
    return least / double(one[std::size_t(6 * group + i)] + other[std::size_t(6 * group + j)]);
  }
};
/// Groups hold whole packs of these.
using GroupTypes =
    ::testing::Types<double, float, Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>, Pack<float, 8>,
                     Pack<double, native_width<double>>, Pack<float, native_width<float>>>;
TYPED_TEST_SUITE(BallTreeKernels, GroupTypes);

TYPED_TEST(BallTreeKernels, LosesNoPairAndTheSharpTestTakesNoneTooMany) {
  using T = TypeParam;
  constexpr int G = TestFixture::group;
  int meeting = 0, passing = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const double way = trial % 2 == 0 ? 0 : 3;
    this->fill(this->one, way);
    this->fill(this->other, way);
    const auto maybe = way > 0 ? maybe_meeting_balls<T, true>(this->one.data(), this->other.data())
                               : maybe_meeting_balls<T, false>(this->one.data(), this->other.data());
    bool any = false;
    for (int i = 0; i < G; ++i) {
      const unsigned sharp = meeting_balls<T>(this->one.data(), i, this->other.data());
      EXPECT_EQ(sharp & ~maybe.row(i), 0U);
      any = any || maybe.row(i) != 0;
      for (int j = 0; j < G; ++j) {
        const double ratio = this->nearest(i, j);
        if (ratio < 0.999) {
          EXPECT_EQ(sharp >> j & 1, 1U);
        }
        if (ratio > 1.02) {
          EXPECT_EQ(sharp >> j & 1, 0U);
        }
        meeting += ratio < 0.999;
        passing += ratio > 1.02 && (maybe.row(i) >> j & 1) != 0;
        if (way == 0) {
          EXPECT_EQ(maybe.row(i) >> j & 1, sharp >> j & 1);
        }
      }
    }
    EXPECT_EQ(maybe.any(), any);
  }
  EXPECT_GT(meeting, 100);
  EXPECT_GT(passing, 10) << "something is left for the sharp test";
}

TYPED_TEST(BallTreeKernels, BoxesHoldTheirBallsAtBothEnds) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  constexpr int G = TestFixture::group;
  this->fill(this->one, 2);
  this->one[3] = std::numeric_limits<S>::quiet_NaN();  // in no box
  const MovingBox<S> box = box_of_balls<T>(this->one.data());
  for (int k = 0; k < 3; ++k) {
    for (int end = 0; end < 2; ++end) {
      S low = std::numeric_limits<S>::infinity(), high = -low;
      double size = 0;
      for (int i = 0; i < G; ++i) {
        if (k == 0 && i == 3) continue;
        const S half = this->one[std::size_t((3 + k) * G + i)], middle = this->one[std::size_t(k * G + i)];
        const S centre = end == 0 ? middle - half : middle + half, radius = this->one[std::size_t(6 * G + i)];
        low = std::min(low, centre - radius);
        high = std::max(high, centre + radius);
        size = std::max(size, double(std::abs(middle) + std::abs(half) + radius));
      }
      EXPECT_LT(box.bound[6 * end + k], low);
      EXPECT_GT(box.bound[6 * end + 3 + k], high);
      EXPECT_NEAR(box.bound[6 * end + k], low, 1.5 * box_margin<S> * size);
      EXPECT_NEAR(box.bound[6 * end + 3 + k], high, 1.5 * box_margin<S> * size);
    }
  }
  // A group of boxes: this one, and others that are empty.
  AlignedVector<S> level(12 * G);
  for (int i = 0; i < G; ++i) put_box(i == 5 ? box : empty_box<S>(), level.data(), i);
  const MovingBox<S> all = box_of_boxes<T>(level.data());
  for (int c = 0; c < 12; ++c) EXPECT_EQ(all.bound[c], box.bound[c]);
  EXPECT_EQ(meeting_boxes<T>(level.data(), box), 1U << 5);
  EXPECT_EQ((meeting_boxes<T, false>(level.data(), box)), 1U << 5);
}

TEST(BallBits, AreRowsOfAGroup) {
  const auto check = [](auto bits, int group) {
    EXPECT_FALSE(bits.any());
    for (int i = 0; i < group; ++i) bits.add_to_row(i, unsigned(i) + 1);
    bits.clear_in_row(2, 1);
    for (int i = 0; i < group; ++i) EXPECT_EQ(bits.row(i), i == 2 ? 2U : unsigned(i) + 1);
    EXPECT_TRUE(bits.any());
  };
  check(BallBits<8>{}, 8);
  check(BallBits<16>{}, 16);
}

TEST(ReferenceBalls, TellBodiesAndDistances) {
  constexpr int G = ball_group<double>;
  AlignedVector<float> own(reference_components * G), others(reference_components * G);
  for (std::size_t i = 0; i < G; ++i) {
    own[i] = float(i);
    own[3 * G + i] = others[3 * G + i] = 0.5F;
    own[4 * G + i] = float(i % 2);
    others[2 * G + i] = 0.5F * float(i);  // along z
    others[4 * G + i] = 1;
  }
  const auto same = balls_of_one_body<double>(own.data(), others.data());
  const auto apart = balls_apart<double>(own.data(), others.data());
  for (int i = 0; i < G; ++i) {
    EXPECT_EQ(same.row(i), i % 2 == 1 ? (1U << G) - 1 : 0U);
    for (int j = 0; j < G; ++j) EXPECT_EQ(apart.row(i) >> j & 1, unsigned(i * i + 0.25 * j * j > 1.0001));
  }
}

}  // namespace
}  // namespace pinball::ball_tree_test
