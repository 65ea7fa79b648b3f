#include <pinball/kernels/contact_force.hpp>

#include "support.hpp"

namespace pinball {
namespace {

using namespace support;
using V = Vec3<double>;

struct Ball {
  V centre, velocity, outward, two_sided;
  double radius, mass, stiffness;  // stiffness: B R
};

/// The records of pinballs in precision S.
template <class S>
struct Records {
  AlignedVector<S> centre, velocity, outward, two_sided;
  explicit Records(const std::vector<Ball>& balls) {
    const auto add = [](AlignedVector<S>& to, const V& v, double fourth) {
      for (const double value : {v.x, v.y, v.z, fourth}) to.push_back(static_cast<S>(value));
    };
    for (const Ball& b : balls) {
      add(centre, b.centre, b.radius);
      add(velocity, b.velocity, b.mass);
      add(outward, b.outward, b.stiffness);
      add(two_sided, b.two_sided, std::numeric_limits<double>::quiet_NaN());  // unused
    }
  }
  PinballView<S> view() const { return {centre.data(), velocity.data(), outward.data(), two_sided.data()}; }
};

std::vector<Ball> random_balls(Random& random, int count) {
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i) {
    Ball b{};
    b.centre = random_vector(random, 1.5);
    b.velocity = random_vector(random);
    if (i % 4 == 1) b.outward = uniform(random, 0.1, 2) * random_direction(random);
    if (i % 4 == 2) b.two_sided = uniform(random, 0.1, 2) * random_direction(random);
    if (i % 4 == 3) b.outward = random_direction(random), b.two_sided = random_direction(random);
    b.radius = uniform(random, 0.3, 0.8);
    b.mass = uniform(random, 1, 3);
    b.stiffness = uniform(random, 5, 20);
    balls.push_back(b);
  }
  return balls;
}

/// Independent scalar implementation of equations (3.4) to (3.11), with branches and the quadratic formula.
struct Expected {
  V force{0, 0, 0};
  double stiffness = 0, stored = 0, damped = 0, ratio = 0;
  int pairs = 0;

  void add(const Ball& a, const Ball& b, double beta, double damping) {
    const V d = a.centre - b.centre;
    const double reach = a.radius + b.radius;
    if (dot(d, d) >= reach * reach) return;
    const V n1 = normal(a, -1.0 * d), n2 = normal(b, d);
    if (dot(n1, n2) > 0.3) return;
    V n = 0.5 * (n2 - n1);
    if (norm(n) < 0.2) n = d;
    n = (1 / norm(n)) * n;
    if (dot(n, d) < -0.5 * reach) return;
    const double g = -dot(n, d) + std::sqrt(dot(n, d) * dot(n, d) + reach * reach - dot(d, d));
    const double p2 = beta / 2 * (a.stiffness + b.stiffness);
    const double p1 = 2 * damping * std::sqrt(p2 / (1 / a.mass + 1 / b.mass));
    const double rate = dot(b.velocity - a.velocity, n);
    double f = p2 * g + p1 * rate;
    if (f < 0) f = 0;
    force = force + f * n;
    stiffness += p2;
    stored += p2 * g * g / 4;
    damped += (f - p2 * g) * rate / 2;
    ratio = std::max(ratio, g / reach);
    ++pairs;
  }
  static V normal(const Ball& b, const V& towards) {
    const V n = b.outward + (dot(b.two_sided, towards) < 0 ? -1.0 : 1.0) * b.two_sided;
    return norm(n) > 0 ? (1 / norm(n)) * n : n;
  }
};

template <class T>
class ContactForce : public ::testing::Test {};
TYPED_TEST_SUITE(ContactForce, NumberTypes);

TYPED_TEST(ContactForce, EqualsTheFormulasForAnyCountWithGarbageInThePadding) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>;
  Random random(101);
  const std::vector<Ball> balls = random_balls(random, 120);
  const Records<S> records(balls);
  const double beta = 0.8, damping = 0.2;
  int pairs = 0;
  for (std::int32_t self = 0; self < 40; ++self) {
    for (const int count : {0, 1, W - 1, W, W + 1, 3 * W, 3 * W + 1}) {
      std::vector<std::int32_t> neighbour;
      Expected expected;
      while (int(neighbour.size()) < count) {
        const auto other = static_cast<std::int32_t>(random() % balls.size());
        if (other == self) continue;
        neighbour.push_back(other);
        expected.add(balls[std::size_t(self)], balls[std::size_t(other)], beta, damping);
      }
      // Padding: itself and others that overlap it.
      while (neighbour.size() % W != 0 || neighbour.empty()) {
        neighbour.push_back(neighbour.size() % 2 == 0 ? self : std::int32_t(random() % balls.size()));
      }
      const PinballForce<S> found =
          pinball_force<T>(records.view(), {S(beta), S(damping)}, self, neighbour.data(), count);
      const double scale = 10 * epsilon<S> * (10 + 20 * expected.pairs) * 4;
      EXPECT_EQ(found.pairs, expected.pairs);
      EXPECT_VECTOR_NEAR(found.force, expected.force, scale);
      EXPECT_NEAR(found.stiffness, expected.stiffness, scale);
      EXPECT_NEAR(found.stored, expected.stored, scale);
      EXPECT_NEAR(found.damped, expected.damped, scale);
      EXPECT_NEAR(found.penetration_ratio, expected.ratio, 16 * epsilon<S>);
      pairs += expected.pairs;
    }
  }
  EXPECT_GT(pairs, 20);
}

TYPED_TEST(ContactForce, OfAPairIsEqualAndOppositeToTheBit) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  Random random(102);
  int active = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Ball> balls = random_balls(random, 2 + trial % 4);
    balls[1].centre = balls[0].centre + random_vector(random, 0.6);
    const Records<S> records(balls);
    const auto second = static_cast<std::int32_t>(balls.size() - 1);
    const std::vector<std::int32_t> to_second(width_of<T>, second), to_first(width_of<T>, 0);
    const PenaltyConstants<S> constants{S(1), S(0.3)};
    const PinballForce<S> a = pinball_force<T>(records.view(), constants, 0, to_second.data(), 1);
    const PinballForce<S> b = pinball_force<T>(records.view(), constants, second, to_first.data(), 1);
    ASSERT_EQ(a.force.x, -b.force.x);
    ASSERT_EQ(a.force.y, -b.force.y);
    ASSERT_EQ(a.force.z, -b.force.z);
    ASSERT_EQ(a.stored, b.stored);
    ASSERT_EQ(a.damped, b.damped);
    ASSERT_EQ(a.stiffness, b.stiffness);
    active += a.pairs;
  }
  EXPECT_GT(active, 50);
}

Ball ball(double z, double velocity) {
  Ball b{};
  b.centre = {0, 0, z};
  b.velocity = {0, 0, velocity};
  b.outward = {0, 0, z > 0.5 ? -1.0 : 1.0};
  b.radius = 0.6, b.mass = 2, b.stiffness = 10;
  return b;
}
PinballForce<double> upper_force(double gap_velocity, double damping) {
  const Records<double> records({ball(0, 0), ball(1, gap_velocity)});
  const std::int32_t neighbour[1] = {0};
  return pinball_force<double>(records.view(), {1, damping}, 1, neighbour, 1);
}

TEST(ContactForceOfTwo, IsPenaltyTimesPenetration) {
  const PinballForce<double> f = upper_force(0, 0);
  EXPECT_VECTOR_NEAR(f.force, (V{0, 0, 10 * 0.2}), 1e-14);
  EXPECT_NEAR(2 * f.stored, 0.5 * 10 * 0.2 * 0.2, 1e-14);  // p2 g^2 / 2 over both lists
  EXPECT_EQ(f.damped, 0);
  EXPECT_EQ(f.pairs, 1);
}

TEST(ContactForceOfTwo, IsDampedOnTheWayInAndNeverAdheres) {
  const double p1 = 2 * 0.3 * std::sqrt(10.0 * 1.0);
  const PinballForce<double> in = upper_force(-0.5, 0.3), out = upper_force(0.5, 0.3), fast = upper_force(10, 0.3);
  EXPECT_NEAR(in.force.z, 2 + p1 * 0.5, 1e-14);
  EXPECT_NEAR(out.force.z, 2 - p1 * 0.5, 1e-14);
  EXPECT_NEAR(2 * in.damped, p1 * 0.25, 1e-14);
  EXPECT_NEAR(2 * out.damped, p1 * 0.25, 1e-14);
  EXPECT_EQ(fast.force.z, 0);                   // would pull
  EXPECT_NEAR(2 * fast.damped, 2 * 10, 1e-13);  // gives up only the elastic force
  EXPECT_GT(fast.damped, 0);
}

}  // namespace
}  // namespace pinball
