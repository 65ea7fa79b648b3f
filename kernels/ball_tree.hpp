#pragma once

#include <cmath>
#include <cstdint>
#include <pinball/kernels/simd.hpp>

/// Bounding boxes over balls that move: which balls may come together while each goes its way in a straight line,
///
///     C(t) = C + t D ,    0 <= t <= 1 ,    with D the way that the ball makes in the time considered.
///
/// Balls are taken in groups of G in the order in which they are numbered, boxes of groups again in groups of G, and so
/// on. This needs no sorting where balls that are near each other have near numbers, as along a space-filling curve. A
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

/// Memory of the tree; arrays belong to the caller. Every level is padded to whole groups; the last has one.
template <class S>
struct BallTreeView {
  std::int32_t groups;       ///< of balls
  int levels;                ///< of boxes
  const S* ball;             ///< groups of G balls, 7 components: C, D, radius; padding is NaN
  S* box[ball_tree_levels];  ///< groups of G boxes, 12 components; level 0: a box per group of balls
};

/// Box of the balls of a group. A ball with a coordinate that is not a number is in no box.
template <class S>
PINBALL_FUNCTION MovingBox<S> box_of_balls(const S* ball) {
  constexpr int G = ball_group<S>;
  MovingBox<S> box;
  for (int k = 0; k < 3; ++k) {
    S low0 = static_cast<S>(HUGE_VAL), high0 = -low0, low1 = low0, high1 = -low0;
    for (int i = 0; i < G; ++i) {
      const S c = ball[k * G + i], end = c + ball[(3 + k) * G + i], r = ball[6 * G + i];
      low0 = minimum(low0, c - r), high0 = maximum(high0, c + r);
      low1 = minimum(low1, end - r), high1 = maximum(high1, end + r);
    }
    box.bound[k] = low0, box.bound[3 + k] = high0, box.bound[6 + k] = low1, box.bound[9 + k] = high1;
  }
  return box;
}

/// Box of the boxes of a group.
template <class S>
PINBALL_FUNCTION MovingBox<S> box_of_boxes(const S* boxes) {
  constexpr int G = ball_group<S>;
  MovingBox<S> box;
  for (int c = 0; c < 12; ++c) {
    const bool lower = c % 6 < 3;
    S bound = boxes[c * G];
    for (int i = 1; i < G; ++i) bound = lower ? minimum(bound, boxes[c * G + i]) : maximum(bound, boxes[c * G + i]);
    box.bound[c] = bound;
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

/// The boxes of a group that may meet a box, one bit each.
template <class T>
PINBALL_FUNCTION unsigned meeting_boxes(const ScalarOf<T>* boxes, const MovingBox<ScalarOf<T>>& box) {
  constexpr int G = ball_group<ScalarOf<T>>, W = width_of<T>;
  unsigned bits = 0;
  for (int first = 0; first < G; first += W) {
    const auto bound = [&](int c) { return load<T>(boxes + c * G + first); };
    const auto meet = [&](int k) {  // false for empty boxes
      return (bound(k) <= T(box.bound[3 + k]) || bound(6 + k) <= T(box.bound[9 + k])) &&
             (bound(3 + k) >= T(box.bound[k]) || bound(9 + k) >= T(box.bound[6 + k]));
    };
    bits |= lane_bits<T>(meet(0) && meet(1) && meet(2)) << first;
  }
  return bits;
}

/// Calls visit(group) for the groups of balls, from number `from` on, whose boxes may meet a box; in rising order.
template <class T, class Visit>
PINBALL_FUNCTION void for_each_meeting_group(const BallTreeView<ScalarOf<T>>& tree, const MovingBox<ScalarOf<T>>& box,
                                             std::int32_t from, const Visit& visit) {
  constexpr int G = ball_group<ScalarOf<T>>;
  std::int32_t first[ball_tree_levels];  // box of each level that holds `from`
  std::int32_t group[ball_tree_levels];
  unsigned bits[ball_tree_levels];
  const int top = tree.levels - 1;
  for (int l = 0; l <= top; ++l) first[l] = l == 0 ? from : first[l - 1] / G;
  const auto meeting = [&](int l, std::int32_t g) {
    const unsigned all = meeting_boxes<T>(tree.box[l] + static_cast<std::int64_t>(g) * 12 * G, box);
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
    const std::int32_t child = group[level] * G + __builtin_ctz(bits[level]);
    bits[level] &= bits[level] - 1;
    if (level == 0) {
      visit(child);
    } else {
      --level;
      group[level] = child;
      bits[level] = meeting(level, child);
    }
  }
}

/// Bounds of the balls of a group, one by one: components as in MovingBox, a pack of balls each.
template <class T>
struct BallBounds {
  T bound[ball_group<ScalarOf<T>> / width_of<T>][12];
};

template <class T>
PINBALL_FUNCTION BallBounds<T> bounds_of_balls(const ScalarOf<T>* balls) {
  constexpr int G = ball_group<ScalarOf<T>>, W = width_of<T>;
  BallBounds<T> bounds;
  for (int pack = 0; pack < G / W; ++pack) {
    const ScalarOf<T>* ball = balls + pack * W;
    const T radius = load<T>(ball + 6 * G);
    for (int k = 0; k < 3; ++k) {
      const T centre = load<T>(ball + k * G), end = centre + load<T>(ball + (3 + k) * G);
      bounds.bound[pack][k] = centre - radius, bounds.bound[pack][3 + k] = centre + radius;
      bounds.bound[pack][6 + k] = end - radius, bounds.bound[pack][9 + k] = end + radius;
    }
  }
  return bounds;
}

/// The balls of a group that may meet a box, one bit each.
template <class T>
PINBALL_FUNCTION unsigned balls_meeting_box(const BallBounds<T>& balls, const MovingBox<ScalarOf<T>>& box) {
  constexpr int G = ball_group<ScalarOf<T>>, W = width_of<T>;
  unsigned bits = 0;
  for (int pack = 0; pack < G / W; ++pack) {
    const T(&bound)[12] = balls.bound[pack];
    const auto meet = [&](int k) {
      return (bound[k] <= T(box.bound[3 + k]) || bound[6 + k] <= T(box.bound[9 + k])) &&
             (bound[3 + k] >= T(box.bound[k]) || bound[9 + k] >= T(box.bound[6 + k]));
    };
    bits |= lane_bits<T>(meet(0) && meet(1) && meet(2)) << (pack * W);
  }
  return bits;
}

/// The balls of a group that come nearer to one ball than the sum of the radii, one bit each. own: the components of
/// that ball.
template <class T>
PINBALL_FUNCTION unsigned meeting_balls(const ScalarOf<T>* balls, const ScalarOf<T> (&own)[7]) {
  constexpr int G = ball_group<ScalarOf<T>>, W = width_of<T>;
  unsigned bits = 0;
  for (int first = 0; first < G; first += W) {
    const auto difference = [&](int c) { return T(own[c]) - load<T>(balls + c * G + first); };
    const T x = difference(0), y = difference(1), z = difference(2);  // at the beginning
    const T u = difference(3), v = difference(4), w = difference(5);  // what it changes by
    const T reach = T(own[6]) + load<T>(balls + 6 * G + first), reach2 = reach * reach;
    const T way2 = u * u + v * v + w * w;
    // The time at which the distance is smallest; if (nothing changes) t = 0
    const auto moves = way2 > T(0);
    const T t = minimum(T(1), maximum(T(0), (T(0) - (x * u + y * v + z * w)) / select(moves, way2, T(1))));
    const T nx = x + t * u, ny = y + t * v, nz = z + t * w;
    bits |= lane_bits<T>(nx * nx + ny * ny + nz * nz < reach2) << first;
  }
  return bits;
}

}  // namespace pinball
