#pragma once

#include <cmath>
#include <cstdint>

#include "compress.hpp"
#include "simd.hpp"

/// Bounding boxes over balls that move: which balls may come together while each goes its way in a straight line,
///
///     C(t) = M + t H ,    -1 <= t <= 1 ,    with 2 H the way that the ball makes in the time considered.
///
/// Balls are taken in groups of G in the order in which they are numbered, boxes of groups again in groups of G, and so
/// on. This needs no sorting where balls that are near each other have near numbers, as in the tiles of a mesh. A
/// box has its bounds at the beginning and at the end; in between the bounds of its balls lie inside of what linear
/// interpolation gives, so that two boxes that are apart along one axis, on the same side at both times, are apart in
/// all the time between. Bodies that fly together, however fast, have small boxes.
namespace pinball {

/// Balls per group and boxes per group; at least one pack.
template <class S>
inline constexpr int ball_group = native_width<S> < 8 ? 8 : native_width<S>;

inline constexpr int ball_tree_levels = 11;  // 8^11 groups

/// Bounds of a group: lower and upper at the beginning, lower and upper at the end, three axes each.
template <class S>
struct MovingBox {
  S bound[12];
};

/// Levels of boxes: each of the second level holds a group of the first, and so on. Arrays belong to the caller. Every
/// level is padded to whole groups with boxes that nothing is in; the last has one group.
template <class S>
struct BoxTreeView {
  int levels;
  bool moves;                      ///< some box is not the same at the beginning and at the end
  const S* box[ball_tree_levels];  ///< groups of G boxes, 12 components

  PINBALL_FUNCTION const S* boxes(int level, std::int64_t group) const {
    return box[level] + group * 12 * ball_group<S>;
  }
};

/// The same over balls; level 0 has a box per group of balls.
template <class S>
struct BallTreeView : BoxTreeView<S> {
  std::int32_t groups;  ///< of balls
  const S* ball;        ///< groups of G balls, 7 components: M, H, radius; padding is NaN

  PINBALL_FUNCTION const S* balls(std::int64_t group) const { return ball + group * 7 * ball_group<S>; }
};

/// The box that nothing is in.
template <class S>
PINBALL_FUNCTION MovingBox<S> empty_box() {
  MovingBox<S> box;
  for (int c = 0; c < 12; ++c) box.bound[c] = c % 6 < 3 ? HUGE_VAL : -HUGE_VAL;
  return box;
}

/// How much larger boxes are than what is in them, over the size of the numbers: more than rounding does to a test of
/// two balls, so that balls that pass it are in boxes that meet, whatever other balls are in these.
template <class S>
inline constexpr double box_margin = sizeof(S) == 8 ? 0x1p-49 : 0x1p-20;

/// Box of the balls of a group. A ball with a coordinate that is not a number is in no box.
template <class T>
PINBALL_FUNCTION MovingBox<ScalarOf<T>> box_of_balls(const ScalarOf<T>* ball) {
  using S = ScalarOf<T>;
  constexpr int G = ball_group<S>, W = width_of<T>;
  MovingBox<S> box;
  for (int k = 0; k < 3; ++k) {
    T low[2]{number<T>(HUGE_VAL), number<T>(HUGE_VAL)}, high[2]{number<T>(-HUGE_VAL), number<T>(-HUGE_VAL)};
    for (int first = 0; first < G; first += W) {
      const T middle = load<T>(ball + k * G + first), half = load<T>(ball + (3 + k) * G + first);
      const T radius = load<T>(ball + 6 * G + first);
      const T reach = radius + number<T>(box_margin<S>) * (absolute(middle) + absolute(half) + radius);
      for (int end = 0; end < 2; ++end) {
        const T centre = end == 0 ? middle - half : middle + half;
        // if (it is a number and smaller) low = centre - reach
        low[end] = minimum(low[end], centre - reach);
        high[end] = maximum(high[end], centre + reach);
      }
    }
    for (int end = 0; end < 2; ++end) {
      box.bound[6 * end + k] = lane_minimum(low[end]);
      box.bound[6 * end + 3 + k] = lane_maximum(high[end]);
    }
  }
  return box;
}

/// Box of the boxes of a group.
template <class T>
PINBALL_FUNCTION MovingBox<ScalarOf<T>> box_of_boxes(const ScalarOf<T>* boxes) {
  constexpr int G = ball_group<ScalarOf<T>>, W = width_of<T>;
  MovingBox<ScalarOf<T>> box;
  for (int c = 0; c < 12; ++c) {
    const bool lower = c % 6 < 3;
    T bound = load<T>(boxes + c * G);
    for (int first = W; first < G; first += W) {
      const T other = load<T>(boxes + c * G + first);
      bound = lower ? minimum(bound, other) : maximum(bound, other);
    }
    box.bound[c] = lower ? lane_minimum(bound) : lane_maximum(bound);
  }
  return box;
}

/// Puts a box into its place in a level.
template <class S>
PINBALL_FUNCTION void put_box(const MovingBox<S>& box, S* level, std::int64_t number) {
  constexpr int G = ball_group<S>;
  for (int c = 0; c < 12; ++c) level[(number / G * 12 + c) * G + number % G] = box.bound[c];
}
template <class S>
PINBALL_FUNCTION MovingBox<S> get_box(const S* level, std::int64_t number) {
  constexpr int G = ball_group<S>;
  MovingBox<S> box;
  for (int c = 0; c < 12; ++c) box.bound[c] = level[(number / G * 12 + c) * G + number % G];
  return box;
}

/// The boxes of a group that may meet a box, one bit each. moves: the ends of the time differ.
template <class T, bool moves = true>
PINBALL_FUNCTION unsigned meeting_boxes(const ScalarOf<T>* boxes, const MovingBox<ScalarOf<T>>& box) {
  constexpr int G = ball_group<ScalarOf<T>>, W = width_of<T>;
  unsigned bits = 0;
  for (int first = 0; first < G; first += W) {
    const auto bound = [&](int c) { return load<T>(boxes + c * G + first); };
    const auto meet = [&](int k) {  // false for empty boxes
      if constexpr (moves) {
        return (bound(k) <= T(box.bound[3 + k]) || bound(6 + k) <= T(box.bound[9 + k])) &&
               (bound(3 + k) >= T(box.bound[k]) || bound(9 + k) >= T(box.bound[6 + k]));
      } else {
        return bound(k) <= T(box.bound[3 + k]) && bound(3 + k) >= T(box.bound[k]);
      }
    };
    bits |= lane_bits<T>(meet(0) && meet(1) && meet(2)) << first;
  }
  return bits;
}

/// Calls visit(number) for the boxes of a level, from number `from` on, that may meet a box; in rising order.
template <class T, class Visit>
PINBALL_FUNCTION void for_each_meeting_box(const BoxTreeView<ScalarOf<T>>& tree, const MovingBox<ScalarOf<T>>& box,
                                           int lowest, std::int32_t from, const Visit& visit) {
  constexpr int G = ball_group<ScalarOf<T>>;
  std::int32_t first[ball_tree_levels];  // box of each level that holds `from`
  std::int32_t group[ball_tree_levels];
  unsigned bits[ball_tree_levels];
  const int top = tree.levels - 1;
  for (int l = lowest; l <= top; ++l) first[l] = l == lowest ? from : first[l - 1] / G;
  const auto meeting = [&](int l, std::int32_t g) {
    const unsigned all = meeting_boxes<T>(tree.boxes(l, g), box);
    const std::int32_t before = first[l] - g * G;
    return before > 0 ? all >> before << before : all;
  };
  int level = top;
  group[level] = 0;
  bits[level] = meeting(level, 0);
  while (true) {
    if (bits[level] == 0) {
      if (level == top) return;
      ++level;
      continue;
    }
    const std::int32_t child = group[level] * G + lowest_bit(bits[level]);
    bits[level] &= bits[level] - 1;
    if (level == lowest) {
      visit(child);
    } else {
      --level;
      group[level] = child;
      bits[level] = meeting(level, child);
    }
  }
}

/// A bit for each ball of a group and each of another: bit i * G + j, in words of 64.
template <int G>
struct BallBits {
  static constexpr int words = G * G / 64;
  std::uint64_t word[words];

  PINBALL_FUNCTION bool any() const {
    std::uint64_t all = 0;
    for (const std::uint64_t w : word) all |= w;
    return all != 0;
  }
  PINBALL_FUNCTION unsigned row(int i) const {
    return static_cast<unsigned>(word[i * G / 64] >> i * G % 64) & static_cast<unsigned>((1ULL << G) - 1);
  }
  PINBALL_FUNCTION void add_to_row(int i, unsigned bits) {
    word[i * G / 64] |= static_cast<std::uint64_t>(bits) << i * G % 64;
  }
  PINBALL_FUNCTION void clear_in_row(int i, unsigned bits) {
    word[i * G / 64] &= ~(static_cast<std::uint64_t>(bits) << i * G % 64);
  }
};

/// For each ball of a group the balls of another for which a test holds. pack_from(first) gives, of the pack of the
/// other group that begins with ball `first`, a function of i: the mask of those that ball i of the first group passes
/// the test with.
template <class T, int G, class PackFrom>
PINBALL_FUNCTION BallBits<G> test_all_balls(const PackFrom& pack_from) {
  BallBits<G> bits{};
  for (int first = 0; first < G; first += width_of<T>) {
    const auto mask_of = pack_from(first);
    PINBALL_UNROLL
    for (int i = 0; i < G; ++i) bits.add_to_row(i, lane_bits<T>(mask_of(i)) << first);
  }
  return bits;
}

/// The same for one ball of the group, one bit each.
template <class T, int G, class PackFrom>
PINBALL_FUNCTION unsigned test_ball(int i, const PackFrom& pack_from) {
  unsigned bits = 0;
  for (int first = 0; first < G; first += width_of<T>) bits |= lane_bits<T>(pack_from(first)(i)) << first;
  return bits;
}

/// Test whether balls of two groups may come nearer than the sum of the radii. moves: some ball makes a way; then some
/// pass too many.
///
/// Where half the relative way is h and the relative position at half time m, the distance is never below |m| - |h|.
/// The sum of the components of h takes the place of its length: no root. Bodies that fly together have h = 0.
template <class T, bool moves>
PINBALL_FUNCTION auto maybe_meeting_test(const ScalarOf<T>* own, const ScalarOf<T>* others) {
  constexpr int G = ball_group<ScalarOf<T>>;
  return [own, others](int first) {
    const auto component = [&](int c) { return load<T>(others + c * G + first); };
    const T x = component(0), y = component(1), z = component(2), radius = component(6);
    T u(0), v(0), w(0);
    if constexpr (moves) u = component(3), v = component(4), w = component(5);
    return [=](int i) {
      const T dx = x - T(own[i]), dy = y - T(own[G + i]), dz = z - T(own[2 * G + i]);
      T reach = radius + T(own[6 * G + i]);
      if constexpr (moves) {
        reach = reach +
                (absolute(u - T(own[3 * G + i])) + absolute(v - T(own[4 * G + i])) + absolute(w - T(own[5 * G + i])));
      }
      return dx * dx + dy * dy + dz * dz < reach * reach;
    };
  };
}

template <class T, bool moves>
PINBALL_FUNCTION BallBits<ball_group<ScalarOf<T>>> maybe_meeting_balls(const ScalarOf<T>* own,
                                                                       const ScalarOf<T>* others) {
  return test_all_balls<T, ball_group<ScalarOf<T>>>(maybe_meeting_test<T, moves>(own, others));
}

/// The balls of a group that come nearer to ball i of another group than the sum of the radii, one bit each.
template <class T>
PINBALL_FUNCTION unsigned meeting_balls(const ScalarOf<T>* own, int i, const ScalarOf<T>* others) {
  constexpr int G = ball_group<ScalarOf<T>>, W = width_of<T>;
  unsigned bits = 0;
  for (int first = 0; first < G; first += W) {
    const auto difference = [&](int c) { return T(own[c * G + i]) - load<T>(others + c * G + first); };
    const T x = difference(0), y = difference(1), z = difference(2);  // at half time
    const T u = difference(3), v = difference(4), w = difference(5);  // what it changes by in half the time
    const T reach = T(own[6 * G + i]) + load<T>(others + 6 * G + first), reach2 = reach * reach;
    const T way2 = u * u + v * v + w * w;
    // The time at which the distance is smallest; if (nothing changes) t = 0
    const auto moves = way2 > T(0);
    const T t = minimum(T(1), maximum(T(-1), (T(0) - (x * u + y * v + z * w)) / select(moves, way2, T(1))));
    const T nx = x + t * u, ny = y + t * v, nz = z + t * w;
    bits |= lane_bits<T>(nx * nx + ny * ny + nz * nz < reach2) << first;
  }
  return bits;
}

}  // namespace pinball
