#include <functional>
#include <set>
#include <utility>

#include <solver/contact/pinball/pair_list.hpp>
#include <solver/contact/search/surface_motion.hpp>
#include <solver/model/stores.hpp>
#include <tests/support/support.hpp>

namespace pinball::pair_list_test {
namespace {

using namespace test;
using Pairs = std::set<std::pair<std::int32_t, std::int32_t>>;

struct Ball {
  Vec3<double> centre, way;
  double radius;
};

/// Balls of bodies of their own, unless a test gives them others.
template <class S>
SurfacePinballs<S> bodies(std::size_t count) {
  SurfacePinballs<S> all;
  all.count = static_cast<std::int32_t>(count);
  for (std::int32_t i = 0; i < all.count; ++i) {
    all.slot.push_back(3 * i);
    all.body.push_back(i);
    std::array<std::int32_t, 8> corners{};
    for (int c = 0; c < 8; ++c) corners[std::size_t(c)] = 8 * i + c;
    all.corners.push_back(corners);
    all.reference.push_back({100.0F * static_cast<float>(i), 0, 0, 1});
    all.radius.push_back(1);
  }
  return all;
}

template <class S>
MovingBalls<S> moving(const std::vector<Ball>& balls) {
  MovingBalls<S> result(static_cast<std::int32_t>(balls.size()));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Ball& b = balls[i];
    result.set(static_cast<std::int32_t>(i), {S(b.centre.x), S(b.centre.y), S(b.centre.z)},
               {S(b.way.x), S(b.way.y), S(b.way.z)}, S(b.radius));
  }
  return result;
}

/// The listed pairs, after a check of how they are listed.
template <class S>
Pairs listed_pairs(const PairList<S>& list) {
  Pairs pairs;
  std::pair<std::int32_t, std::int32_t> last{-1, -1};
  std::set<std::int32_t> pinballs;
  std::int32_t pinballs_end = 0;
  std::int64_t end = 0;
  for (std::int64_t p = 0; p < fixed_pieces; ++p) {
    const auto& piece = list.piece(p);
    EXPECT_EQ(piece.pinballs_begin, pinballs_end);
    EXPECT_EQ(piece.begin % native_width<S>, 0);
    EXPECT_GE(piece.begin, end);
    pinballs_end = piece.pinballs_end, end = piece.end;
    for (std::int64_t place = piece.begin; place < piece.end; ++place) {
      const std::pair<std::int32_t, std::int32_t> pair{list.first()[place], list.second()[place]};
      EXPECT_LT(pair.first, pair.second);
      EXPECT_LT(last, pair) << "sorted, each once";
      EXPECT_GE(pair.first, piece.pinballs_begin);
      EXPECT_LT(pair.first, piece.pinballs_end);
      last = pair;
      pinballs.insert({pair.first, pair.second});
      pairs.insert({list.listed()[std::size_t(pair.first)], list.listed()[std::size_t(pair.second)]});
    }
  }
  EXPECT_EQ(pinballs_end, list.size());
  EXPECT_EQ(pinballs.size(), std::size_t(list.size())) << "all that are listed have a pair";
  EXPECT_TRUE(std::is_sorted(list.listed().begin(), list.listed().end()));
  EXPECT_LE(end, list.places());
  for (std::int64_t place = 0; place < list.places(); ++place) {
    EXPECT_LT(list.first()[place], list.size());
    EXPECT_LT(list.second()[place], list.size());
  }
  EXPECT_EQ(std::size_t(list.pairs()), pairs.size());
  return pairs;
}

template <class S>
void expect_same(const PairList<S>& list, const PairList<S>& other) {
  EXPECT_EQ(list.listed(), other.listed());
  EXPECT_EQ(list.places(), other.places());
  EXPECT_TRUE(std::equal(list.first(), list.first() + list.places(), other.first()));
  EXPECT_TRUE(std::equal(list.second(), list.second() + list.places(), other.second()));
  for (std::int64_t p = 0; p < fixed_pieces; ++p) {
    EXPECT_EQ(list.piece(p).begin, other.piece(p).begin);
    EXPECT_EQ(list.piece(p).end, other.piece(p).end);
    EXPECT_EQ(list.piece(p).pinballs_end, other.piece(p).pinballs_end);
  }
}

/// The pairs that every search finds.
template <class S>
Pairs found(const SurfacePinballs<S>& all, const std::vector<Ball>& balls, bool self = true) {
  const MovingBalls<S> way = moving<S>(balls);
  PairList<S> list, by_hash, automatic;
  list.build(all, way, self, ContactSearch::tree);
  by_hash.build(all, way, self, ContactSearch::hash);
  automatic.build(all, way, self);
  expect_same(by_hash, list);
  expect_same(automatic, list);
  return listed_pairs(list);
}

/// Independent implementation: all pairs; the time of the closest approach is sought by halving.
Pairs brute_force(const std::vector<Ball>& balls, double factor) {
  Pairs pairs;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      const Vec3<double> d = balls[i].centre - balls[j].centre, way = balls[i].way - balls[j].way;
      const auto distance = [&](double t) { return std::sqrt(dot(d + t * way, d + t * way)); };
      if (std::isnan(distance(0)) || std::isnan(distance(1))) continue;
      if (distance(0) - std::sqrt(dot(way, way)) > 2 * factor * (balls[i].radius + balls[j].radius)) continue;
      double low = 0, high = 1;
      for (int k = 0; k < 60; ++k) {
        const double mid = 0.5 * (low + high);
        (dot(d + mid * way, way) < 0 ? low : high) = mid;
      }
      const double least = std::min({distance(0), distance(low), distance(1)});
      if (least < factor * (balls[i].radius + balls[j].radius)) pairs.insert({std::int32_t(i), std::int32_t(j)});
    }
  }
  return pairs;
}

struct Configuration {
  const char* name;
  std::function<Ball(Random&, int)> ball;
};
std::vector<Configuration> configurations() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {
      {"at rest",
       [](Random& r, int) {
         return Ball{random_vector(r, 5), {0, 0, 0}, uniform(r, 0.4, 0.6)};
       }},
      {"moving",
       [](Random& r, int) {
         return Ball{random_vector(r, 5), random_vector(r, 2), uniform(r, 0.4, 0.6)};
       }},
      {"two fast bodies",
       [](Random& r, int i) {
         const double side = i % 2 == 0 ? 1 : -1;
         return Ball{{6 * side + uniform(r, -2, 2), uniform(r, -3, 3), uniform(r, -3, 3)}, {-9 * side, 0.1, 0}, 0.5};
       }},
      {"one body and debris",
       [](Random& r, int i) {
         return Ball{random_vector(r, 4), i % 20 == 0 ? random_vector(r, 50) : Vec3<double>{3, 0, 0}, 0.3};
       }},
      {"all in one point",
       [](Random&, int) {
         return Ball{{0.3, -0.2, 0.1}, {1, 0, 0}, 0.5};
       }},
      {"radii over four decades",
       [](Random& r, int) {
         return Ball{random_vector(r, 20), random_vector(r, 1), std::pow(10.0, uniform(r, -3, 1))};
       }},
      {"far apart",
       [](Random& r, int i) {
         return Ball{random_vector(r, i % 3 == 0 ? 1e12 : 5), {0, 0, 0}, 0.5};
       }},
      {"not a number",
       [nan](Random& r, int i) {
         Ball b{random_vector(r, 5), random_vector(r, 2), 0.5};
         if (i % 9 == 4) b.centre.y = nan;
         if (i % 11 == 5) b.way.x = nan;
         return b;
       }},
  };
}

TEST(PairList, IsWhatAllPairsGive) {
  for (const Configuration& configuration : configurations()) {
    for (const int count : {0, 1, 2, 7, 8, 9, 63, 64, 65, 400}) {
      SCOPED_TRACE(::testing::Message() << configuration.name << ", " << count);
      Random random(81);
      std::vector<Ball> balls;
      for (int i = 0; i < count; ++i) balls.push_back(configuration.ball(random, i));
      // Pairs that just touch may be decided either way.
      const Pairs surely = brute_force(balls, 1 - 1e-9), perhaps = brute_force(balls, 1 + 1e-9);
      const Pairs pairs = found(bodies<double>(balls.size()), balls);
      EXPECT_TRUE(std::includes(pairs.begin(), pairs.end(), surely.begin(), surely.end())) << "a pair is lost";
      EXPECT_TRUE(std::includes(perhaps.begin(), perhaps.end(), pairs.begin(), pairs.end())) << "a pair too many";
      const Pairs surely_float = brute_force(balls, 1 - 1e-4), perhaps_float = brute_force(balls, 1 + 1e-4);
      const Pairs single = found(bodies<float>(balls.size()), balls);
      EXPECT_TRUE(std::includes(single.begin(), single.end(), surely_float.begin(), surely_float.end()));
      EXPECT_TRUE(std::includes(perhaps_float.begin(), perhaps_float.end(), single.begin(), single.end()));
      if (count == 400) {
        EXPECT_GT(surely.size(), 20U) << "the test is to find something";
      }
    }
  }
}

/// As hosts may have spheres: balls near each other do not have near numbers.
TEST(PairList, IsTheSameFromEverySearchInAnyOrderOfBalls) {
  for (const double reach : {5.0, 12.0}) {
    Random random(83);
    std::vector<Ball> balls;
    for (int i = 0; i < 6000; ++i) balls.push_back({random_vector(random, reach), random_vector(random, 0.5), 0.3});
    EXPECT_GT(found(bodies<double>(balls.size()), balls).size(), 1000U);
    EXPECT_GT(found(bodies<float>(balls.size()), balls).size(), 1000U);
  }
}

TEST(PairList, LeavesOutWhatTheMeshKeepsApart) {
  // Three balls of one body in one place, and one of another body.
  SurfacePinballs<double> all = bodies<double>(4);
  all.body = {0, 0, 0, 1};
  const std::vector<Ball> balls(4, {{0, 0, 0}, {0, 0, 0}, 1});
  const Pairs other_body = {{0, 3}, {1, 3}, {2, 3}};
  EXPECT_EQ(found(all, balls), (Pairs{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}}));
  EXPECT_EQ(found(all, balls, false), other_body);
  all.corners[1][5] = all.corners[0][2];  // 0 and 1 share a corner
  all.reference[2] = {101.9F, 0, 0, 1};   // 1 and 2 overlap in the undeformed mesh
  EXPECT_EQ(found(all, balls), (Pairs{{0, 2}, {0, 3}, {1, 3}, {2, 3}}));
}

TEST(PairList, RemembersPairsOverARebuild) {
  SurfacePinballs<double> all = bodies<double>(40);
  Random random(82);
  std::vector<Ball> balls;
  for (int i = 0; i < 40; ++i) balls.push_back({random_vector(random, 2), {0, 0, 0}, 0.8});
  PairList<double> list;
  list.build(all, moving<double>(balls), true);
  const auto visit = [&](const std::function<void(std::int32_t, std::int32_t, double&, double&)>& visitor) {
    for (std::int64_t p = 0; p < fixed_pieces; ++p) {
      for (std::int64_t i = list.piece(p).begin; i < list.piece(p).end; ++i) {
        visitor(list.listed()[std::size_t(list.first()[i])], list.listed()[std::size_t(list.second()[i])],
                list.offset()[i], list.stored()[i]);
      }
    }
  };
  const auto in_contact = [](std::int32_t a, std::int32_t b) { return (a + b) % 3 == 0; };
  visit([&](std::int32_t a, std::int32_t b, double& offset, double& stored) {
    EXPECT_LT(offset, 0);
    if (in_contact(a, b)) offset = a + b, stored = a * b;
  });
  for (Ball& b : balls) b.radius = 1.2;  // more pairs than before
  list.build(all, moving<double>(balls), true);
  const Pairs before = brute_force(balls, 0.8 / 1.2);
  int remembered = 0;
  visit([&](std::int32_t a, std::int32_t b, double& offset, double& stored) {
    const bool kept = in_contact(a, b) && before.count(std::minmax(a, b)) == 1;
    EXPECT_EQ(offset, kept ? a + b : -1);
    EXPECT_EQ(stored, kept ? a * b : 0);
    remembered += kept;
  });
  EXPECT_GT(remembered, 20);
  // The pairs of pinball 5 and of pinball 6 end.
  std::vector<double> outward(4 * 40, 1);
  double expected = 0;
  visit([&](std::int32_t a, std::int32_t b, double& offset, double& stored) {
    if (offset >= 0 && (a == 5 || a == 6 || b == 5 || b == 6)) expected += stored;
  });
  ASSERT_EQ(list.size(), 40);
  outward[4 * 5 + 3] = outward[4 * 6 + 3] = 0;
  EXPECT_GT(expected, 0);
  EXPECT_EQ(list.end_pairs_of_inactive(outward.data()), expected);
  EXPECT_EQ(list.end_pairs_of_inactive(outward.data()), 0);
}

/// Elements of a cloud, whose nodes fly and stray.
class Straying : public ::testing::Test {
 protected:
  static constexpr int count = 150;
  Random random{83};
  SurfacePinballs<double> all = bodies<double>(count);
  NodeStore<double> nodes{8 * count};
  SurfaceMotion<double> motion;

  Straying() {
    for (int e = 0; e < count; ++e) {
      const Vec3<double> centre = random_vector(random, 6), velocity = random_vector(random, 3);
      for (int n = 8 * e; n < 8 * e + 8; ++n) {
        const Vec3<double> x = centre + random_vector(random, 1), v = velocity + random_vector(random, 0.5);
        put(nodes.position, n, x);
        put(nodes.velocity, n, v);
      }
    }
    motion.watch(
        nodes.count, 8 * count, [&](std::int64_t i) { return all.corners[i / 8][i % 8]; },
        [](std::int64_t /*i*/) { return 1.0; });
  }
  static void put(Array<double>& records, int n, const Vec3<double>& v) {
    double* r = records.data() + 4 * std::size_t(n);
    r[0] = v.x, r[1] = v.y, r[2] = v.z;
  }
  static Vec3<double> get(const Array<double>& records, int n) {
    const double* r = records.data() + 4 * std::size_t(n);
    return {r[0], r[1], r[2]};
  }
  Vec3<double> mean(const Array<double>& records, int e) const {
    Vec3<double> sum{0, 0, 0};
    for (int n = 8 * e; n < 8 * e + 8; ++n) sum = sum + get(records, n);
    return 0.125 * sum;
  }
  /// Straight on for a time, and each node up to `fraction` of its element's allowance off.
  void fly(double time, double fraction) {
    for (int n = 0; n < 8 * count; ++n) {
      const double off = fraction * motion.allowance(all.corners[std::size_t(n / 8)]);
      put(nodes.position, n, get(nodes.position, n) + time * get(nodes.velocity, n) + off * random_direction(random));
    }
  }
};

TEST_F(Straying, AListThatHoldsHasEveryPairThatTouches) {
  constexpr double horizon = 0.7;
  for (const double skin : {0.5, 2.0}) {
    motion.start(nodes.position.data(), nodes.velocity.data(), skin);
    std::vector<Ball> balls;
    for (int e = 0; e < count; ++e) {
      balls.push_back({mean(nodes.position, e), horizon * mean(nodes.velocity, e),
                       0.6 + motion.allowance(all.corners[std::size_t(e)])});
    }
    const Pairs pairs = found(all, balls);
    const Array<double>& position = nodes.position;
    std::vector<double> before(position.data(), position.data() + position.size());
    for (const double time : {0.0, 0.2, 0.5, horizon}) {
      std::copy(before.begin(), before.end(), nodes.position.data());
      fly(time, 0.999);
      ASSERT_TRUE(motion.holds(nodes.position.data(), time));
      std::vector<Ball> now;
      for (int e = 0; e < count; ++e) now.push_back({mean(nodes.position, e), {0, 0, 0}, 0.6});
      const Pairs touching = brute_force(now, 1);
      EXPECT_GT(touching.size(), 5U);
      EXPECT_TRUE(std::includes(pairs.begin(), pairs.end(), touching.begin(), touching.end()));
    }
  }
}

TEST_F(Straying, OneNodeTooFarOffEndsIt) {
  for (const int node : {0, 7, 8 * count / 2 + 3, 8 * count - 1}) {
    motion.start(nodes.position.data(), nodes.velocity.data(), 0.5);
    fly(1, 0.9);
    ASSERT_TRUE(motion.holds(nodes.position.data(), 1));
    EXPECT_FALSE(motion.holds(nodes.position.data(), 2)) << "a wrong time is no proof";
    const Vec3<double> x = get(nodes.position, node);
    put(nodes.position, node, x + Vec3<double>{0.3, 0, 0});
    EXPECT_FALSE(motion.holds(nodes.position.data(), 1));
    put(nodes.position, node, Vec3<double>{std::numeric_limits<double>::quiet_NaN(), 0, 0});
    EXPECT_FALSE(motion.holds(nodes.position.data(), 1));
    put(nodes.position, node, x);
  }
  motion.start(nodes.position.data(), nodes.velocity.data(), 0);
  EXPECT_TRUE(motion.holds(nodes.position.data(), 0));
  put(nodes.position, 11, get(nodes.position, 11) + Vec3<double>{0, 1e-12, 0});
  EXPECT_FALSE(motion.holds(nodes.position.data(), 0)) << "without a skin nothing may stray";
}

TEST_F(Straying, AllowancesFollowWhatANodeHasStrayed) {
  motion.start(nodes.position.data(), nodes.velocity.data(), 0.5);
  const double at_rest = motion.allowance(all.corners[3]);
  put(nodes.position, 8 * 3, get(nodes.position, 8 * 3) + Vec3<double>{0.1, 0, 0});
  for (int n = 0; n < 8 * count; ++n) put(nodes.position, n, get(nodes.position, n) + get(nodes.velocity, n));
  motion.adapt(nodes.position.data(), 1, 1);
  motion.start(nodes.position.data(), nodes.velocity.data(), 0.5);
  EXPECT_GT(motion.allowance(all.corners[3]), 0.1);
  EXPECT_EQ(motion.allowance(all.corners[4]), at_rest);
}

/// All of a surface has eroded, or there is none.
TEST(PairList, NoBallsHaveNoPairs) {
  EXPECT_TRUE(found(bodies<double>(0), {}).empty());
  EXPECT_TRUE(found(bodies<float>(0), {}).empty());
}

}  // namespace
}  // namespace pinball::pair_list_test
