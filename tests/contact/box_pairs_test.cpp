#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <solver/contact/search/box_pairs.hpp>
#include <tests/support/support.hpp>

namespace pinball::box_pairs_test {
namespace {

using namespace test;
using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

template <class S>
class BoxPairsTest : public ::testing::Test {};
using Scalars = ::testing::Types<double, float>;
TYPED_TEST_SUITE(BoxPairsTest, Scalars);

/// Centre and half size at the beginning, way to the end.
struct Box {
  Vec3<double> centre, half, way;
};

template <class S>
MovingBox<S> moving_box(const Box& box) {
  const double centre[3] = {box.centre.x, box.centre.y, box.centre.z}, half[3] = {box.half.x, box.half.y, box.half.z},
               way[3] = {box.way.x, box.way.y, box.way.z};
  MovingBox<S> result;
  for (int c = 0; c < 12; ++c) {
    const int k = c % 3;
    result.bound[c] = static_cast<S>(centre[k] + (c % 6 < 3 ? -half[k] : half[k]) + (c < 6 ? 0 : way[k]));
  }
  return result;
}

struct Configuration {
  const char* name;
  int count;
  std::function<Box(Random&, int)> box;
};

double uniform(Random& random, double low, double high) {
  return low + (high - low) * 0.5 * (1 + random_vector(random, 1).x);
}
double graded(Random& random, double ratio) { return std::pow(ratio, uniform(random, -1, 0)); }

const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

std::vector<Configuration> configurations() {
  const Vec3<double> zero{0, 0, 0};
  return {
      {"none", 0, nullptr},
      {"one", 1,
       [=](Random&, int) {
         return Box{zero, {1, 1, 1}, zero};
       }},
      {"uniform", 700,
       [=](Random& r, int) {
         return Box{random_vector(r, 5), {0.5, 0.5, 0.5}, zero};
       }},
      {"graded 1:10,000", 900,
       [=](Random& r, int) {
         const double size = graded(r, 1e4);
         return Box{uniform(r, 0, 2) * size * random_vector(r, 2), {size, size, size}, zero};
       }},
      {"tiny ones in a corner", 600,
       [=](Random& r, int i) {
         const double size = i % 50 == 0 ? 1.0 : 1e-7;
         return Box{Vec3<double>{3, 3, 3} + random_vector(r, 5 * size), {size, size, size}, zero};
       }},
      {"aspects to 1:100", 700,
       [=](Random& r, int) {
         return Box{random_vector(r, 3), {graded(r, 100), graded(r, 100), graded(r, 100)}, zero};
       }},
      {"flat, of one orientation", 700,
       [=](Random& r, int) {
         return Box{random_vector(r, 3), {0.5, 0.5, 0.005}, zero};
       }},
      {"fast", 700,
       [=](Random& r, int) {
         return Box{random_vector(r, 10), {0.5, 0.5, 0.5}, random_vector(r, 10)};
       }},
      {"fast together", 700,
       [=](Random& r, int) {
         return Box{random_vector(r, 5), {0.5, 0.5, 0.5}, Vec3<double>{1e4, -1e3, 0} + random_vector(r, 0.1)};
       }},
      {"two bodies, fast", 700,
       [=](Random& r, int i) {
         const Vec3<double> side{6.0 * (i % 2), 0, 0};
         return Box{side + random_vector(r, 3), {0.3, 0.3, 0.3}, (i % 2 == 0 ? 1.0 : -1.0) * Vec3<double>{3, 0, 0}};
       }},
      {"all fast and graded", 700,
       [=](Random& r, int) {
         const double size = graded(r, 1e3);
         return Box{random_vector(r, 2), size * Vec3<double>{graded(r, 10), 1, 1}, random_vector(r, 1)};
       }},
      {"points", 500,
       [=](Random& r, int) {
         return Box{random_vector(r, 1), zero, zero};
       }},
      {"points of a lattice, boxes that touch", 500,
       [=](Random&, int i) {
         const double half = i % 3 == 0 ? 0 : 0.5;
         return Box{{double(i % 7), double(i / 7 % 7), double(i / 49)}, {half, half, half}, zero};
       }},
      {"identical", 90,
       [=](Random&, int) {
         return Box{{1, 2, 3}, {1, 1, 1}, {0.5, 0, 0}};
       }},
      {"identical points", 90,
       [=](Random&, int) {
         return Box{{1, 2, 3}, zero, zero};
       }},
      {"in a plane", 700,
       [=](Random& r, int) {
         const Vec3<double> p = random_vector(r, 10);
         return Box{{p.x, p.y, 1}, {0.5, 0.5, 0}, zero};
       }},
      {"in a line", 300,
       [=](Random&, int i) {
         return Box{{0.7 * i, 0, 0}, {0.5, 0.5, 0.5}, zero};
       }},
      {"in a line, backwards", 300,
       [=](Random&, int i) {
         return Box{{-0.7 * i, 0, 0}, {0.5, 0.5, 0.5}, zero};
       }},
      {"far from the origin", 500,
       [=](Random& r, int) {
         return Box{Vec3<double>{1e6, -1e6, 1e6} + random_vector(r, 5), {0.5, 0.5, 0.5}, random_vector(r, 1)};
       }},
      {"some not numbers", 500,
       [=](Random& r, int i) {
         Box box{random_vector(r, 4), {0.5, 0.5, 0.5}, random_vector(r, 1)};
         if (i % 7 == 0) box.centre.y = nan;
         if (i % 11 == 0) box.way.z = nan;
         if (i % 13 == 0) box.half.x = nan;
         return box;
       }},
      {"none a number", 100,
       [=](Random&, int) {
         return Box{{0, nan, 0}, {1, 1, 1}, zero};
       }},
      {"some turned inside out", 300,
       [=](Random& r, int i) {
         return Box{random_vector(r, 3), {0.5, i % 5 == 0 ? -0.5 : 0.5, 0.5}, random_vector(r, 1)};
       }},
      {"some without end", 300,
       [=](Random& r, int i) {
         const double half = i % 9 == 0 ? infinite : i % 10 == 0 ? 1e30 : 0.5;
         return Box{random_vector(r, 4), {0.5, half, half}, random_vector(r, 1)};
       }},
      {"of all sizes that numbers have", 300,
       [=](Random& r, int) {
         const double size = std::pow(10.0, uniform(r, -35, 35));
         return Box{size * random_vector(r, 3), {size, size, size}, size * random_vector(r, 1)};
       }},
      {"far outliers", 400,
       [=](Random& r, int i) {
         const double far = i % 10 == 0 ? 1e30 : i % 11 == 0 ? -1e20 : 0;
         return Box{Vec3<double>{0, far, 0} + random_vector(r, 3), {0.5, 0.5, 0.5}, zero};
       }},
  };
}

template <class S>
struct Set {
  std::vector<MovingBox<S>> boxes;
  MovingBoxes<S> moving;

  explicit Set(const Configuration& configuration, unsigned seed = 5) {
    Random random(seed);
    moving.reset(configuration.count);
    for (int i = 0; i < configuration.count; ++i) {
      boxes.push_back(moving_box<S>(configuration.box(random, i)));
      moving.set(i, boxes.back());
    }
  }
};

/// Independent implementation: all pairs.
template <class S, class Keep>
Pairs brute_force(const std::vector<MovingBox<S>>& boxes, const Keep& keep) {
  Pairs pairs;
  const auto nothing = [](const MovingBox<S>& b) {
    for (int c = 0; c < 6; ++c) {
      if (!(b.bound[c + c / 3 * 3] <= b.bound[c + c / 3 * 3 + 3])) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (nothing(boxes[i])) continue;
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const S *a = boxes[i].bound, *b = boxes[j].bound;
      bool apart = nothing(boxes[j]);
      for (int k = 0; k < 3; ++k) {  // on one side at both times
        apart = apart || (a[3 + k] < b[k] && a[9 + k] < b[6 + k]) || (b[3 + k] < a[k] && b[9 + k] < a[6 + k]);
      }
      const auto first = static_cast<std::int32_t>(i), second = static_cast<std::int32_t>(j);
      if (!apart && keep(first, second)) pairs.emplace_back(first, second);
    }
  }
  return pairs;
}

template <class S>
Pairs pairs_of(const BoxPairs<S>& list, std::int32_t count) {
  Pairs pairs;
  EXPECT_EQ(list.piece_begin(0), 0);
  EXPECT_EQ(list.piece_begin(fixed_pieces), count);
  for (std::int64_t piece = 0; piece < fixed_pieces; ++piece) {
    const auto firsts = list.firsts(piece), seconds = list.seconds(piece);
    EXPECT_EQ(firsts.size(), seconds.size());
    for (std::size_t p = 0; p < firsts.size(); ++p) {
      EXPECT_GE(firsts[p], list.piece_begin(piece));
      EXPECT_LT(firsts[p], list.piece_begin(piece + 1));
      pairs.emplace_back(firsts[p], seconds[p]);
    }
  }
  EXPECT_EQ(list.pairs(), static_cast<std::int64_t>(pairs.size()));
  return pairs;
}

const auto all = [](std::int32_t, std::int32_t) { return true; };
constexpr ContactSearch searches[] = {ContactSearch::tree, ContactSearch::hash, ContactSearch::automatic};

TYPED_TEST(BoxPairsTest, AreThoseOfBruteForceInOrder) {
  using S = TypeParam;
  BoxPairs<S> list;  // one for all sets: nothing is left of the one before
  for (const Configuration& configuration : configurations()) {
    SCOPED_TRACE(configuration.name);
    const Set<S> set(configuration);
    const Pairs expected = brute_force(set.boxes, all);
    for (const ContactSearch how : searches) {
      list.find(set.moving, how, all);
      EXPECT_EQ(pairs_of(list, configuration.count), expected) << "search " << int(how);
    }
  }
}

/// Groups look anywhere: of those that have something with each other no pair is left out.
TYPED_TEST(BoxPairsTest, OfGroupsThatHaveSomethingWithEachOtherAreAllThere) {
  using S = TypeParam;
  constexpr int G = ball_group<S>;
  std::int64_t left_out = 0;
  for (const Configuration& configuration : configurations()) {
    SCOPED_TRACE(configuration.name);
    const Set<S> set(configuration);
    Random random(11);
    GroupDirections<S> directions;
    directions.reset(set.moving.groups());
    std::vector<Vec3<double>> normal;
    std::vector<double> reach;
    for (std::int64_t group = 0; group < set.moving.groups(); ++group) {
      const Vec3<double> n = random_vector(random, 1);
      normal.push_back((1 / std::sqrt(dot(n, n))) * n);
      reach.push_back(group % 5 == 0 ? infinite : uniform(random, -0.5, 0.2));
      const Vec3<double>& of = normal.back();
      directions.set(group, {static_cast<S>(of.x), static_cast<S>(of.y), static_cast<S>(of.z)},
                     static_cast<S>(reach.back()));
    }
    const auto some = [&](std::int32_t a, std::int32_t b) {
      const auto g = static_cast<std::size_t>(a / G), h = static_cast<std::size_t>(b / G);
      return dot(normal[g], normal[h]) < reach[g] + reach[h] - 1e-5;
    };
    const Pairs wanted = brute_force(set.boxes, some), all_pairs = brute_force(set.boxes, all);
    left_out += std::ssize(all_pairs);
    BoxPairs<S> list;
    for (const ContactSearch how : searches) {
      list.find(set.moving, how, all, &directions);
      const Pairs found = pairs_of(list, configuration.count);
      EXPECT_TRUE(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end())) << "search " << int(how);
      EXPECT_TRUE(std::includes(all_pairs.begin(), all_pairs.end(), found.begin(), found.end()));
      if (how == ContactSearch::tree) left_out -= std::ssize(found);
    }
  }
  EXPECT_GT(left_out, 1000);
}

TYPED_TEST(BoxPairsTest, AreFoundOneByOneWhenBoxesHaveChanged) {
  using S = TypeParam;
  for (const Configuration& configuration : configurations()) {
    SCOPED_TRACE(configuration.name);
    Set<S> set(configuration), others(configuration, 6);
    BoxPairs<S> list;
    for (const ContactSearch how : searches) {
      list.find(set.moving, how, all);
      list.prepare_to_look_up(set.moving);
      for (int i = 0; i < configuration.count; i += 17) {
        const auto at = static_cast<std::size_t>(i);
        set.boxes[at] = others.boxes[at];
        set.moving.set(i, set.boxes[at]);
        list.include(set.moving.box(i), i);
      }
      Pairs found;
      constexpr int together = 4;  // groups near some boxes are looked for at once
      for (int first = 0; first < configuration.count; first += 3 * together) {
        std::vector<MovingBox<S>> some;
        const int end = std::min(configuration.count, first + 3 * together);
        for (int i = first; i < end; i += 3) some.push_back(set.moving.box(i));
        std::vector<std::int32_t> groups;
        list.find_groups(some, groups);
        for (int i = first; i < end; i += 3) {
          const auto add = [&](std::int32_t other) {
            if (other > i) found.emplace_back(i, other);
          };
          for (const std::int32_t group : groups) list.for_each_meeting(group, set.moving.box(i), add);
        }
      }
      EXPECT_EQ(found, brute_force(set.boxes, [](std::int32_t a, std::int32_t) { return a % 3 == 0; }));
    }
  }
}

TYPED_TEST(BoxPairsTest, AreThoseOfBruteForceForEveryNumberOfBoxes) {
  using S = TypeParam;
  BoxPairs<S> list;
  constexpr int G = ball_group<S>;
  for (const int count : {1, 2, G - 1, G, G + 1, 2 * G, G * G - 1, G * G, G * G + 1, 3 * G * G}) {
    const Configuration configuration{"", count, [](Random& r, int) {
                                        return Box{random_vector(r, 3), {0.5, 0.5, 0.5}, random_vector(r, 0.5)};
                                      }};
    const Set<S> set(configuration);
    for (const ContactSearch how : searches) {
      list.find(set.moving, how, all);
      EXPECT_EQ(pairs_of(list, count), brute_force(set.boxes, all)) << count << " boxes, search " << int(how);
    }
  }
}

/// Many more than one search alone would be good for.
TYPED_TEST(BoxPairsTest, AreTheSameFromBothSearchesWhereNumbersSayNothing) {
  using S = TypeParam;
  BoxPairs<S> tree, hash, automatic;
  const Configuration configuration{"", 20000, [](Random& r, int) {
                                      return Box{random_vector(r, 15), {0.5, 0.5, 0.5}, random_vector(r, 0.5)};
                                    }};
  const Set<S> set(configuration);
  tree.find(set.moving, ContactSearch::tree, all);
  hash.find(set.moving, ContactSearch::hash, all);
  automatic.find(set.moving, ContactSearch::automatic, all);
  const Pairs pairs = pairs_of(tree, configuration.count);
  EXPECT_GT(pairs.size(), 20000U);
  EXPECT_EQ(pairs_of(hash, configuration.count), pairs);
  EXPECT_EQ(pairs_of(automatic, configuration.count), pairs);
}

TYPED_TEST(BoxPairsTest, AreOnlyThoseThatAreWanted) {
  using S = TypeParam;
  BoxPairs<S> list;
  const auto keep = [](std::int32_t first, std::int32_t second) { return (first + second) % 3 == 0; };
  for (const Configuration& configuration : configurations()) {
    SCOPED_TRACE(configuration.name);
    const Set<S> set(configuration);
    const Pairs meeting = brute_force(set.boxes, all);
    const auto asked = [&](std::int32_t first, std::int32_t second) {
      const std::pair<std::int32_t, std::int32_t> pair{first, second};
      EXPECT_TRUE(std::binary_search(meeting.begin(), meeting.end(), pair)) << "asked of a pair that does not meet";
      return keep(first, second);
    };
    for (const ContactSearch how : searches) {
      list.find(set.moving, how, asked);
      EXPECT_EQ(pairs_of(list, configuration.count), brute_force(set.boxes, keep)) << "search " << int(how);
    }
  }
}

TYPED_TEST(BoxPairsTest, AreTheSameFromEveryNumberOfThreads) {
  using S = TypeParam;
  const int before = DefaultExecutionSpace::concurrency();
  for (const Configuration& configuration : configurations()) {
    SCOPED_TRACE(configuration.name);
    const Set<S> set(configuration);
    for (const ContactSearch how : searches) {
      BoxPairs<S> one;
      DefaultExecutionSpace::set_concurrency(1);
      one.find(set.moving, how, all);
      for (const int threads : {2, 3}) {
        DefaultExecutionSpace::set_concurrency(threads);
        BoxPairs<S> list;
        list.find(set.moving, how, all);
        EXPECT_EQ(pairs_of(list, configuration.count), pairs_of(one, configuration.count)) << threads << " threads";
      }
    }
  }
  DefaultExecutionSpace::set_concurrency(before);
}

}  // namespace
}  // namespace pinball::box_pairs_test
