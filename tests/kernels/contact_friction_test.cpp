#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <kernels/contact_friction.hpp>
#include <tests/support/support.hpp>

/// What a row with friction may give, and in which way that may change.
namespace pinball::contact_friction_test {
namespace {

using namespace test;
using V = Vec3<double>;

double size_of(const V& v) { return std::sqrt(dot(v, v)); }

/// A direction, one across it, and one across both.
struct Frame {
  explicit Frame(Random& random) : a(random_direction(random)) {
    const V other = random_direction(random), aside = cross(a, other);
    along = (1 / size_of(aside)) * aside;
    third = cross(a, along);
  }
  V a, along, third;
};

/// A node moves in a plane or along a line with the mobility that it has there.
TEST(ContactFriction, MobilityIsThatOfWhatAConstraintLeaves) {
  Random random(3);
  const double m = 0.7;
  EXPECT_NEAR(friction_mobility({{m, m, m, 0, 0, 0}, false}), m, 1e-15);
  EXPECT_EQ(friction_mobility({{0, 0, 0, 0, 0, 0}, true}), 0);
  for (int sample = 0; sample < 20; ++sample) {
    const Frame frame(random);
    ImpulseNode node{{m, m, m, 0, 0, 0}, true};
    for (const V& held : {frame.a, frame.along}) {  // then along `third` alone
      const double of_held[6] = {held.x * held.x, held.y * held.y, held.z * held.z,
                                 held.x * held.y, held.y * held.z, held.z * held.x};
      for (std::size_t i = 0; i < 6; ++i) node.inverse_mass[i] -= m * of_held[i];
      EXPECT_NEAR(friction_mobility(node), m, 1e-14);
    }
  }
}

/// Nothing pulls; across the direction no more than the bound, in the way that was asked for.
TEST(ContactFriction, IsNoMoreThanItsBound) {
  Random random(4);
  for (int sample = 0; sample < 20; ++sample) {
    const Frame frame(random);
    const double p = uniform(random, 0.5, 2);
    const FrictionBound bound{0.4, 0.1};
    const double most = 0.4 * p + 0.1;
    for (const double share : {0.0, 0.5, 0.99, 1.01, 7.0}) {
      const V b = p * frame.a + share * most * frame.along;
      const V expected = p * frame.a + std::min(share, 1.0) * most * frame.along;
      EXPECT_VECTOR_NEAR(allowed_impulse(b, frame.a, bound), expected, 1e-14);
      EXPECT_VECTOR_NEAR(allowed_impulse(b, frame.a, FrictionBound{}), p * frame.a, 1e-14);
      const V pulls = share * frame.along - p * frame.a;
      EXPECT_VECTOR_NEAR(allowed_impulse(pulls, frame.a, bound), V(0, 0, 0), 0);
    }
  }
}

/// Any change along the direction; across it any while the friction holds, turning alone while it slides, and none
/// where nothing rubs. What turns has the sliding beside it: changes of q by a small angle keep t along q.
TEST(ContactFriction, LeavesTheFreedomOfItsState) {
  Random random(5);
  for (int sample = 0; sample < 20; ++sample) {
    const Frame frame(random);
    const double p = uniform(random, 0.5, 2), most = 0.4 * p;
    const FrictionBound bound{0.4, 0};
    const V change = uniform(random, -1, 1) * frame.a + uniform(random, -1, 1) * frame.along + 0.3 * frame.third;
    const V on_axis = dot(change, frame.a) * frame.a, turning = dot(change, frame.third) * frame.third;
    const auto freedom = [&](const V& b, const FrictionBound& of, const V& t = {0, 0, 0}) {
      return freedom_of(b, frame.a, of, t);
    };
    const auto expect_free = [&](const FreeRow& row, RowFreedom expected, const V& part) {
      EXPECT_EQ(row.freedom, expected);
      EXPECT_VECTOR_NEAR(free_part(row, frame.a, change), part, 1e-14);
    };
    expect_free(freedom({0, 0, 0}, bound), RowFreedom::none, {0, 0, 0});
    expect_free(freedom(p * frame.a, FrictionBound{}), RowFreedom::along, on_axis);
    expect_free(freedom(p * frame.a + 0.9 * most * frame.along, bound), RowFreedom::all, change);
    const V slides = p * frame.a + most * frame.along, t = 0.6 * frame.along + 0.2 * frame.third;
    const FreeRow round = freedom(slides, bound, t);
    expect_free(round, RowFreedom::round, on_axis + turning);
    EXPECT_NEAR(std::abs(dot(round.turning, frame.third)), 1, 1e-14);
    EXPECT_NEAR(round.stiffness, 0.6 / most, 1e-13);
    EXPECT_EQ(freedom(slides, bound, -1.0 * t).stiffness, 0) << "it slides back";
  }
}

}  // namespace
}  // namespace pinball::contact_friction_test
