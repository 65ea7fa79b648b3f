#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <solver/base/packs.hpp>
#include <solver/contact/pinball/host_pinballs.hpp>
#include <solver/device/space_pinballs.hpp>
#include <tests/device/device_case.hpp>
#include <tests/support/support.hpp>

/// The loops over pinballs of a device, by one thread of the host, beside those of the host's packs.
namespace pinball::space_pinballs_test {
namespace {

using namespace test;

constexpr std::int32_t node_count = 150, balls = 90, tiles = 3;

/// Balls of random corners, some of which take no part, and pairs of them, in the host's layout.
template <class S>
struct Case {
  static constexpr int W = native_width<S>;
  Array<S> position{4 * node_count}, velocity{4 * node_count}, force{4 * node_count}, inverse_mass{node_count};
  Array<std::int32_t> corner, expected_node, first, second;
  Array<S> exposed, bulk_modulus, centre, ball_velocity, outward, two_sided, ball_force, start, allowed2, offset,
      stored;
  std::vector<std::int32_t> nodes, all_corners;
  std::vector<S> radius;
  std::array<PairPiece, fixed_pieces> pieces{};
  std::vector<std::int32_t> tile_first{0, 31, 60, balls}, colour_offsets{0, 1, 2, tiles}, by_colour{2, 0, 1};

  Case() {
    Random random(17);
    for (std::int32_t n = 0; n < node_count; ++n) {
      nodes.push_back(n);
      inverse_mass[n] = static_cast<S>(uniform(random, 0.5, 2));
      for (std::size_t k = 0; k < 3; ++k) {
        position[4 * n + k] = static_cast<S>(uniform(random, -1, 1));
        velocity[4 * n + k] = static_cast<S>(uniform(random, -1, 1));
        force[4 * n + k] = static_cast<S>(uniform(random, -1, 1));
      }
    }
    add_balls(random);
    add_pairs(random);
    watch_nodes();
  }
  Case(const Case&) = delete;

  void add_balls(Random& random) {
    const std::size_t padded = (balls + W - 1) / W * W;
    corner.reset(8 * padded);
    exposed.reset(6 * padded);
    bulk_modulus.reset(padded);
    for (Array<S>* records : {&centre, &ball_velocity, &outward, &two_sided, &ball_force}) records->reset(4 * padded);
    for (std::int32_t p = 0; p < balls; ++p) {
      const auto any = static_cast<std::int32_t>(uniform(random, 0, node_count));
      for (int i = 0; i < 8; ++i) {
        all_corners.push_back((any + 11 * i) %
                              node_count);  // no two the same: no face without an area but for round-off
        corner[place_in_packs<W>(p, i, 8)] = all_corners.back();
      }
      for (int f = 0; f < 6; ++f) exposed[place_in_packs<W>(p, f, 6)] = uniform(random, 0, 1) < 0.3 ? S(1) : S(0);
      bulk_modulus[p] = static_cast<S>(uniform(random, 1, 2));
      radius.push_back(static_cast<S>(uniform(random, 0.2, 0.4)));
      centre[4 * p + 3] = radius[p];
      ball_velocity[4 * p + 3] = static_cast<S>(uniform(random, 1, 3));
      outward[4 * p + 3] = p % 9 == 5 ? S(0) : bulk_modulus[p] * radius[p];
    }
  }
  /// In three pieces, and the others empty.
  void add_pairs(Random& random) {
    std::vector<std::int32_t> p_of, q_of;
    std::int32_t begin = 0;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
      const std::int32_t end = piece < 3 ? std::array{20, 50, balls}[piece] : balls;
      pieces[piece] = {std::ssize(p_of), 0, begin, end};
      for (std::int32_t p = begin; p < end; ++p) {
        for (std::int32_t q = p + 1; q < balls; ++q) {
          if (uniform(random, 0, 1) < 0.4) p_of.push_back(p), q_of.push_back(q);
        }
      }
      pieces[piece].end = std::ssize(p_of);
      p_of.resize((p_of.size() + W - 1) / W * W, 0);
      q_of.resize(p_of.size(), 0);
      begin = end;
    }
    for (auto* numbers : {&first, &second}) numbers->reset(p_of.size());
    std::ranges::copy(p_of, first.data());
    std::ranges::copy(q_of, second.data());
    for (auto* numbers : {&offset, &stored}) numbers->reset(p_of.size());
    std::fill_n(offset.data(), offset.size(), S(-1));
  }
  /// Each node is expected where it is now and to stay there.
  void watch_nodes() {
    const std::size_t padded = (node_count + W - 1) / W * W;
    expected_node.reset(padded);
    start.reset(6 * padded);
    allowed2.reset(padded);
    for (std::size_t i = 0; i < padded; ++i) {
      const std::int32_t node = std::min<std::int32_t>(static_cast<std::int32_t>(i), node_count - 1);
      const auto place = static_cast<std::int64_t>(i);
      expected_node[i] = node;
      allowed2[i] = static_cast<S>(1e-4 * (1 + node));
      for (int k = 0; k < 3; ++k) start[place_in_packs<W>(place, k, 6)] = position[4 * node + k];
    }
  }

  SurfaceNodes<S> surface() { return {position.data(), velocity.data(), force.data(), inverse_mass.data()}; }
  PinballArrays<S> arrays() {
    PinballArrays<S> of;
    of.pinballs = balls;
    of.geometry = {corner.data(),        exposed.data(), bulk_modulus.data(), centre.data(),
                   ball_velocity.data(), outward.data(), two_sided.data(),    W};
    of.force = ball_force.data();
    of.pairs = {std::ssize(first), first.data(), second.data(), offset.data(), stored.data()};
    of.pieces = pieces;
    of.nodes = nodes;
    of.node_count = node_count;
    of.expected = {std::ssize(expected_node), expected_node.data(), start.data(), allowed2.data(), W};
    of.balls = balls;
    of.corner = all_corners.data();
    of.radius = radius.data();
    of.tile_first = tile_first;
    of.colour_offsets = colour_offsets;
    of.tiles = by_colour;
    return of;
  }
};

template <class S>
void expect_equal(const Array<S>& found, const Array<S>& expected, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (same_bits) {
      ASSERT_EQ(found[i], expected[i]) << i;
    } else {
      ASSERT_NEAR(found[i], expected[i], 1e3 * epsilon<S> * (1 + std::abs(expected[i]))) << i;
    }
  }
}

template <class S>
class SpacePinballsOf : public testing::Test {};
using Numbers = testing::Types<double, float>;
TYPED_TEST_SUITE(SpacePinballsOf, Numbers);

TYPED_TEST(SpacePinballsOf, OneThreadAreThoseOfPacks) {
  using S = TypeParam;
  for (const bool radii : {false, true}) {
    Case<S> of_host, of_space;
    HostPinballs<S> host;
    SpacePinballs<S, Serial> space;
    host.take(of_host.arrays());
    space.take(of_space.arrays());
    for (int step = 0; step < 3; ++step) {  // pairs remember where they began
      host.update_geometry(of_host.surface(), radii);
      space.update_geometry(of_space.surface(), radii);
      const PairSums<S> expected = host.find_forces({S(1), S(0.1)}, S(1e-2));
      const PairSums<S> found = space.find_forces({S(1), S(0.1)}, S(1e-2));
      EXPECT_GT(expected.pairs, 30);
      EXPECT_EQ(found.pairs, expected.pairs);
      EXPECT_EQ(found.deepest, expected.deepest);
      EXPECT_NEAR(found.penetration_ratio, expected.penetration_ratio, 1e2 * epsilon<S>);
      EXPECT_NEAR(found.stored, expected.stored, 1e3 * epsilon<S> * expected.stored);
      EXPECT_NEAR(found.damped, expected.damped, 1e3 * epsilon<S> * expected.damped);
      host.add_forces(of_host.surface());
      space.add_forces(of_space.surface());
      expect_equal(of_space.force, of_host.force, of_host.force.size());
      EXPECT_NEAR(space.largest_row(of_space.surface()), host.largest_row(of_host.surface()),
                  1e2 * epsilon<S> * host.largest_row(of_host.surface()));
      for (Case<S>* some : {&of_host, &of_space}) {
        for (std::size_t i = 0; i < some->position.size(); ++i) some->position[i] *= S(0.98);
      }
    }
    space.bring_back();
    expect_equal(of_space.offset, of_host.offset, of_host.offset.size());
    expect_equal(of_space.stored, of_host.stored, of_host.stored.size());
    expect_equal(of_space.centre, of_host.centre, 4 * balls);
    expect_equal(of_space.outward, of_host.outward, 4 * balls);
    expect_equal(of_space.ball_force, of_host.ball_force, 4 * balls);
  }
}

/// Of each node alone, and for one that is no number.
TYPED_TEST(SpacePinballsOf, OneThreadFindNodesThatStray) {
  using S = TypeParam;
  Case<S> of;
  HostPinballs<S> host;
  SpacePinballs<S, Serial> space;
  host.take(of.arrays());
  space.take(of.arrays());
  const auto expect = [&](bool expected) {
    EXPECT_EQ(host.any_strays(of.surface(), S(0)), expected);
    EXPECT_EQ(space.any_strays(of.surface(), S(0)), expected);
  };
  expect(false);
  for (const std::int32_t node : {0, 1, 77, node_count - 1}) {
    S& x = of.position[4 * node + 1];
    const S before = x;
    const S allowed = std::sqrt(static_cast<S>(1e-4 * (1 + node)));
    x = before + S(0.95) * allowed;
    expect(false);
    x = before + S(1.05) * allowed;
    expect(true);
    x = std::numeric_limits<S>::quiet_NaN();
    expect(true);
    x = before;
  }
}

/// Padding of the pairs names no pair.
TEST(PinballEntries, AreInTheHostsOrder) {
  const std::vector<std::int32_t> first{0, 0, 1, 9, 2, 9}, second{1, 3, 3, 9, 3, 9};
  const std::vector<PairPiece> pieces{{0, 3, 0, 2}, {4, 5, 2, 4}};
  const EntryLists of_balls = entries_of_pinballs(pieces, first.data(), second.data(), 4);
  EXPECT_EQ(of_balls.first, (std::vector<std::uint32_t>{0, 2, 4, 5, 8}));
  EXPECT_EQ(of_balls.entry, (std::vector<std::uint32_t>{1, 3, 0, 5, 9, 2, 4, 8}));

  // Two balls of one lane each; the second tile comes first.
  const std::vector<std::int32_t> corner{3, 3, 3, 3, 5, 5, 7, 7, 5, 3, 5, 3, 3, 3, 3, 3}, nodes{3, 5, 7};
  const EntryLists of_nodes = NodeEntries().of(nodes, 8, corner.data(), 1, std::vector{0, 1, 2}, std::vector{1, 0});
  EXPECT_EQ(of_nodes.first, (std::vector<std::uint32_t>{0, 10, 14, 16}));
  EXPECT_EQ(of_nodes.entry, (std::vector<std::uint32_t>{1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace pinball::space_pinballs_test
