#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <kernels/boundary/rigid_wall.hpp>
#include <kernels/exec.hpp>

/// Packs of nodes that are told to be far from a wall before any of them is looked at (wall_is_far).
namespace pinball::test::wall_packs_test {
namespace {

constexpr std::int64_t count = 64;

/// Nodes at random heights above a plane that is askew, with velocities and forces that count.
template <class S>
struct Cloud {
  Array<S> position, velocity, force, inverse_mass, reaction;
  std::vector<std::int32_t> node;
  WallPlane<S> plane{};

  Cloud(unsigned seed, S spread) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<S> number(-1, 1);
    for (Array<S>* records : {&position, &velocity, &force}) records->reset(4 * (count + 1));
    inverse_mass.reset(count + 1);
    reaction.reset(count);
    std::array<S, 3> normal{number(random), number(random), S(1.5)};
    const S length = std::hypot(normal[0], normal[1], normal[2]);
    for (int k = 0; k < 3; ++k) plane.normal[k] = normal[k] / length;
    for (int k = 0; k < 3; ++k) plane.point[k] = 3 * number(random);
    const S height = spread * number(random);
    for (std::int64_t n = 0; n <= count; ++n) {
      inverse_mass[n] = S(1) + number(random) / 2;
      for (int k = 0; k < 3; ++k) {
        position[4 * n + k] = plane.point[k] + height * plane.normal[k] + S(0.1) * spread * number(random);
        velocity[4 * n + k] = number(random);
        force[4 * n + k] = number(random);
      }
    }
    for (std::int32_t i = 0; i < count; ++i) node.push_back(i + 1);  // records that are not aligned to packs
    reaction[0] = S(7);                                              // of the step before
  }
  NodeArrays<S> arrays() {
    return {position.data(), velocity.data(), force.data(), inverse_mass.data(), nullptr, nullptr};
  }
  StopAtWall<S> stop(const WallStep<S>& step) {
    return {arrays(), plane, {node.data(), count, nullptr, reaction.data(), nullptr}, step};
  }
};

template <class S>
class WallPacks : public ::testing::Test {};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WallPacks, Numbers);

/// What passes has nothing to do for any of its nodes, one by one; what has nothing to do nearly always passes.
TYPED_TEST(WallPacks, PassWhereNoNodeDoesAnything) {
  using S = TypeParam;
  using T = Pack<S, native_width<S>>;
  constexpr int W = width_of<T>;
  int passed = 0, idle = 0;
  for (unsigned seed = 0; seed < 4000; ++seed) {
    Cloud<S> cloud(seed, S(std::pow(10.0, seed % 5 - 3.0)));
    const WallStep<S> step{S(0.01), S(0.02), S(seed % 3 == 0 ? 0 : 1e-3), S(seed % 3 == 2 ? 2e-3 : 0)};
    const StopAtWall<S> stop = cloud.stop(step);
    const bool passes = stop.template passes<T>(0);
    if (passes) {
      EXPECT_EQ(cloud.reaction[0], 0);
    }
    WallStop sum;
    for (int i = 0; i < W; ++i) stop(i, sum);
    const bool nothing = sum.force == 0 && sum.closing == 0 &&
                         std::all_of(cloud.reaction.data(), cloud.reaction.data() + W, [](S r) { return r == 0; });
    if (passes) {
      EXPECT_TRUE(nothing) << "seed " << seed;
      WallPush push;
      const PushWall<S> pushes{cloud.arrays(), cloud.plane, stop.of, step};
      for (int i = 0; i < W; ++i) pushes(i, push);
      EXPECT_TRUE(push.force == 0 && push.slope == 0) << "seed " << seed;
    }
    passed += passes ? 1 : 0;
    idle += nothing ? 1 : 0;
  }
  EXPECT_GT(passed, 600);
  EXPECT_LT(passed, 3000);
  EXPECT_GT(passed, 0.97 * idle);
}

TYPED_TEST(WallPacks, DoNotPassWithWhatIsNoNumberNorOutOfARow) {
  using S = TypeParam;
  using T = Pack<S, native_width<S>>;
  const WallStep<S> step{S(0.01), S(0.02), S(0), S(0)};
  const auto high = [](Cloud<S>& cloud) {
    for (std::int64_t n = 0; n <= count; ++n) {
      for (int k = 0; k < 3; ++k) cloud.position[4 * n + k] += 100 * cloud.plane.normal[k];
    }
  };
  Cloud<S> cloud(1, S(1)), infinite(1, S(1)), none(1, S(1)), apart(1, S(1));
  for (Cloud<S>* each : {&cloud, &infinite, &none, &apart}) high(*each);
  EXPECT_TRUE(cloud.stop(step).template passes<T>(0));
  infinite.velocity[4 + 2] = std::numeric_limits<S>::infinity();
  EXPECT_FALSE(infinite.stop(step).template passes<T>(0));
  none.force[4] = std::numeric_limits<S>::quiet_NaN();
  EXPECT_FALSE(none.stop(step).template passes<T>(0));
  constexpr int W = width_of<T>;
  if (W > 1) {
    apart.node[0] = 0;
    EXPECT_FALSE(apart.stop(step).template passes<T>(0));
  }
  // Nodes that are held come behind the others, in an order of their own: the first and the last do not tell.
  for (int lane = 1; lane + 1 < W; ++lane) {
    Cloud<S> between(1, S(1));
    high(between);
    between.node[lane] = 40;
    for (int k = 0; k < 3; ++k) between.position[4 * 40 + k] -= 200 * between.plane.normal[k];
    EXPECT_FALSE(between.stop(step).template passes<T>(0));
  }
}

}  // namespace
}  // namespace pinball::test::wall_packs_test
