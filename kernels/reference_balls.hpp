#pragma once

#include "ball_tree.hpp"

/// Which pairs of balls of one body were close to each other in the undeformed mesh. Such a pair says nothing about
/// contact: balls of flat elements may overlap from the start.
namespace pinball {

/// Components of a group of G reference balls: centre, radius [length], number of the body (below 2^24).
inline constexpr int reference_components = 5;

/// Single precision, as many lanes as divide a group of balls in precision S.
template <class S>
using ReferencePack = Pack<float, (native_width<float> < ball_group<S> ? native_width<float> : ball_group<S>)>;

/// For each ball of a group the balls of another group that belong to the same body.
template <class S>
PINBALL_FUNCTION BallBits<ball_group<S>> balls_of_one_body(const float* own, const float* others) {
  using T = ReferencePack<S>;
  constexpr int G = ball_group<S>;
  return test_all_balls<T, G>([own, others](int first) {
    const T body = load<T>(others + 4 * G + first);
    return [=](int i) { return body == T(own[4 * G + i]); };
  });
}

/// Test whether balls of two groups are further off than the sum of the radii.
template <class S>
PINBALL_FUNCTION auto apart_test(const float* own, const float* others) {
  using T = ReferencePack<S>;
  constexpr int G = ball_group<S>;
  return [own, others](int first) {
    const auto component = [&](int c) { return load<T>(others + c * G + first); };
    const T x = component(0), y = component(1), z = component(2), radius = component(3);
    return [=](int i) {
      const T dx = x - T(own[i]), dy = y - T(own[G + i]), dz = z - T(own[2 * G + i]);
      const T reach = radius + T(own[3 * G + i]);
      return dx * dx + dy * dy + dz * dz > T(1.0001f) * reach * reach;
    };
  };
}

/// For each ball of a group the balls of another group that are further off than the sum of the radii.
template <class S>
PINBALL_FUNCTION BallBits<ball_group<S>> balls_apart(const float* own, const float* others) {
  return test_all_balls<ReferencePack<S>, ball_group<S>>(apart_test<S>(own, others));
}

}  // namespace pinball
