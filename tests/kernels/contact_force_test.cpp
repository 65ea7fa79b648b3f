#include <kernels/contact_force.hpp>
#include <tests/support/support.hpp>

namespace pinball::contact_force_test {
namespace {

using namespace test;
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
    b.stiffness = i % 7 == 6 ? 0 : uniform(random, 5, 20);  // some take no part
    balls.push_back(b);
  }
  return balls;
}

/// Independent scalar implementation of equations (3.4) to (3.11), with branches, angles and the quadratic formula.
struct Expected {
  V force{0, 0, 0};
  double stiffness = 0, stored = 0, damped = 0, ratio = 0;
  int pairs = 0;

  /// The force of b on a. offset: of the pair, before and (returned) after. energy: what the pair stores.
  double add(const Ball& a, const Ball& b, double beta, double damping, double dt, double offset, double& energy) {
    energy = 0;
    if (a.stiffness == 0) return -1;
    const V d = a.centre - b.centre;
    const double reach = a.radius + b.radius;
    if (norm(d) >= reach || b.stiffness == 0) return -1;
    const V n1 = normal(a, -1.0 * d), n2 = normal(b, d);
    const bool face_each_other = dot(n1, d) < -0.2 * norm(d) && dot(n2, d) > 0.2 * norm(d);
    if (dot(n1, n2) > 0.3 && !face_each_other) return -1;
    V n = 0.5 * (n2 - n1);
    if (norm(n) < 0.2 || dot(n, d) < std::sqrt(0.9045) * norm(n) * norm(d)) n = d;
    n = (1 / norm(n)) * n;
    const double full = -dot(n, d) + std::sqrt(dot(n, d) * dot(n, d) + reach * reach - dot(d, d));
    const V apart = d + full * n, gradient = (1 / dot(apart, n)) * apart;
    const double p2 = beta / 2 * (a.stiffness + b.stiffness);
    const double p1 = 2 * damping * std::sqrt(p2 / (1 / a.mass + 1 / b.mass));
    const double rate = dot(b.velocity - a.velocity, gradient);
    if (offset >= 0) {
      offset = std::min(offset, full);
    } else {
      offset = rate > 0 ? std::max(0.0, full - rate * dt) : full;
    }
    const double g = full - offset;
    double f = p2 * g + p1 * rate;
    if (f < 0) f = 0;
    force = force + f * gradient;
    stiffness += p2;
    energy = p2 * g * g / 2;
    stored += energy;
    damped += (f - p2 * g) * rate;
    ratio = std::max(ratio, full / reach);
    ++pairs;
    return offset;
  }
  static V normal(const Ball& b, const V& towards) {
    const V n = b.outward + (dot(b.two_sided, towards) < 0 ? -1.0 : 1.0) * b.two_sided;
    return norm(n) > 0 ? (1 / norm(n)) * n : n;
  }
};

template <class T>
class ContactForce : public ::testing::Test {};
TYPED_TEST_SUITE(ContactForce, NumberTypes);

TYPED_TEST(ContactForce, EqualsTheFormulasInEveryLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>;
  Random random(101);
  const std::vector<Ball> balls = random_balls(random, 120);
  const Records<S> records(balls);
  const double beta = 0.8, damping = 0.2, dt = 0.3;
  int pairs = 0, apart = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::int32_t first[W], second[W];
    AlignedVector<S> offset(W);
    for (int i = 0; i < W; ++i) {
      first[i] = static_cast<std::int32_t>(random() % balls.size());
      do second[i] = static_cast<std::int32_t>(random() % balls.size());
      while (second[i] == first[i]);
      const std::size_t kind = random() % 3;  // new, in contact from the start, begun deep inside
      offset[std::size_t(i)] = S(kind == 0 ? -1 : kind == 1 ? 0 : uniform(random, 0, 0.5));
    }
    const unsigned touching = touching_pairs<T>(records.centre.data(), first, second, offset.data());
    T offset_now = load<T>(offset.data());
    const PairForce<T> found = pair_force(records.view(), {S(beta), S(damping)}, first, second, offset_now, S(dt));
    int active = 0;
    for (int i = 0; i < W; ++i) {
      const Ball &one = balls[std::size_t(first[i])], &other = balls[std::size_t(second[i])];
      const bool overlap = norm(one.centre - other.centre) < one.radius + other.radius;
      EXPECT_EQ(touching >> i & 1, unsigned(overlap || offset[std::size_t(i)] >= 0));
      apart += !overlap;
      Expected expected;
      double energy = 0;
      const double after = expected.add(one, other, beta, damping, dt, double(offset[std::size_t(i)]), energy);
      const double scale = 10 * epsilon<S> * (10 + 20 * expected.pairs) * 4;
      EXPECT_NEAR(lane(offset_now, i), after, 32 * epsilon<S>);
      EXPECT_NEAR(lane(found.force.x, i), expected.force.x, scale);
      EXPECT_NEAR(lane(found.force.y, i), expected.force.y, scale);
      EXPECT_NEAR(lane(found.force.z, i), expected.force.z, scale);
      EXPECT_NEAR(lane(found.stiffness, i), expected.stiffness, scale);
      EXPECT_NEAR(lane(found.stored, i), energy, scale);
      EXPECT_NEAR(lane(found.damped, i), expected.damped, scale);
      EXPECT_NEAR(lane(found.penetration_ratio, i), expected.ratio, 16 * epsilon<S>);
      active += expected.pairs;
    }
    EXPECT_EQ(count_lanes(found.active), active);
    pairs += active;
  }
  EXPECT_GT(pairs, 20);
  EXPECT_GT(apart, 20);
}

TYPED_TEST(ContactForce, DoesNotDependOnWhichPinballIsTheFirst) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  Random random(102);
  int active = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Ball> balls = random_balls(random, 2 + trial % 4);
    balls.back().centre = balls[0].centre + random_vector(random, 0.6);
    const Records<S> records(balls);
    const std::vector<std::int32_t> one(width_of<T>, 0),
        other(width_of<T>, static_cast<std::int32_t>(balls.size() - 1));
    const PenaltyConstants<S> constants{S(1), S(0.3)};
    T offset_a(S(-1)), offset_b(S(-1));
    const PairForce<T> a = pair_force(records.view(), constants, one.data(), other.data(), offset_a, S(0.5));
    const PairForce<T> b = pair_force(records.view(), constants, other.data(), one.data(), offset_b, S(0.5));
    ASSERT_EQ(lane(offset_a, 0), lane(offset_b, 0));
    ASSERT_EQ(lane(a.force.x, 0), -lane(b.force.x, 0));
    ASSERT_EQ(lane(a.force.y, 0), -lane(b.force.y, 0));
    ASSERT_EQ(lane(a.force.z, 0), -lane(b.force.z, 0));
    ASSERT_EQ(lane(a.stored, 0), lane(b.stored, 0));
    ASSERT_EQ(lane(a.damped, 0), lane(b.damped, 0));
    ASSERT_EQ(lane(a.stiffness, 0), lane(b.stiffness, 0));
    active += count_lanes(a.active) > 0 ? 1 : 0;
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
/// Of the lower ball on the upper one. offset: 0 for a pair in contact from the beginning, -1 for a new one; changed.
PairForce<double> upper_force(double velocity, double damping, double& offset, double dt = 0.1) {
  const Records<double> records({ball(0, 0), ball(1, velocity)});
  const std::int32_t upper = 1, lower = 0;
  return pair_force<double>(records.view(), {1, damping}, &upper, &lower, offset, dt);
}
PairForce<double> upper_force(double velocity, double damping) {
  double offset = 0;
  return upper_force(velocity, damping, offset);
}

TEST(ContactForceOfTwo, IsPenaltyTimesPenetration) {
  const PairForce<double> f = upper_force(0, 0);
  EXPECT_VECTOR_NEAR(f.force, (V{0, 0, 10 * 0.2}), 1e-14);
  EXPECT_NEAR(f.stored, 0.5 * 10 * 0.2 * 0.2, 1e-14);  // p2 g^2 / 2
  EXPECT_EQ(f.damped, 0);
  EXPECT_TRUE(f.active);
}

TEST(ContactForceOfTwo, IsDampedOnTheWayInAndNeverAdheres) {
  const double p1 = 2 * 0.3 * std::sqrt(10.0 * 1.0);
  const PairForce<double> in = upper_force(-0.5, 0.3), out = upper_force(0.5, 0.3), fast = upper_force(10, 0.3);
  EXPECT_NEAR(in.force.z, 2 + p1 * 0.5, 1e-14);
  EXPECT_NEAR(out.force.z, 2 - p1 * 0.5, 1e-14);
  EXPECT_NEAR(in.damped, p1 * 0.25, 1e-14);
  EXPECT_NEAR(out.damped, p1 * 0.25, 1e-14);
  EXPECT_EQ(fast.force.z, 0);               // would pull
  EXPECT_NEAR(fast.damped, 2 * 10, 1e-13);  // gives up only the elastic force
  EXPECT_GT(fast.damped, 0);
}

TEST(ContactForceOfTwo, BeginsWhereThePairIsFound) {
  double offset = -1;  // found at depth 0.2 at rest: no force
  EXPECT_NEAR(norm(upper_force(0, 0, offset).force), 0, 1e-14);
  EXPECT_NEAR(offset, 0.2, 1e-15);
  offset = -1;  // approached by 0.05 in the last step: that much counts
  EXPECT_NEAR(upper_force(-0.5, 0, offset).force.z, 10 * 0.05, 1e-14);
  EXPECT_NEAR(offset, 0.15, 1e-15);
  offset = -1;  // approached by more than the depth: all of it counts
  EXPECT_NEAR(upper_force(-5, 0, offset).force.z, 10 * 0.2, 1e-14);
  EXPECT_EQ(offset, 0);
  offset = 0.5;  // separated since: the offset follows the depth
  EXPECT_NEAR(norm(upper_force(0, 0, offset).force), 0, 1e-14);
  EXPECT_NEAR(offset, 0.2, 1e-15);
}

TEST(ContactForceOfTwo, ForgetsAPairThatParts) {
  const Records<double> apart({ball(0, 0), ball(1.3, 0)});
  const std::int32_t upper = 1, lower = 0;
  double offset = 0.1;
  EXPECT_EQ(touching_pairs<double>(apart.centre.data(), &upper, &lower, &offset), 1U) << "it is to be forgotten";
  const PairForce<double> f = pair_force<double>(apart.view(), {1, 0}, &upper, &lower, offset, 0.1);
  EXPECT_FALSE(f.active);
  EXPECT_LT(offset, 0);
  EXPECT_EQ(f.stored, 0);
  EXPECT_EQ(touching_pairs<double>(apart.centre.data(), &upper, &lower, &offset), 0U);
}

}  // namespace
}  // namespace pinball::contact_force_test
