#pragma once

#include <cmath>

#include "node_arrays.hpp"

/// Friction of rigid walls: the force across the normal that stops the node within the step, at most friction times the
/// reaction N. Of a node that is held, or moved as given, along some directions h it moves nothing along these, but it
/// acts against all of the way s on which the node slides: with d, the part of the normal n that is free,
///
///     g = -friction N s/|s| ,   N d.d + g.d: what puts the node on the plane ,
///
/// and what holds the node takes up what N n + g has along h.
namespace pinball {

/// What a wall is, where it was at the start.
template <class S>
struct WallPlane {
  S point[3], normal[3];
  S friction;                     ///< infinite where nothing slides [-]
  bool ends = false;              ///< in space or in time
  S past;                         ///< how far behind it a node is past a wall that ends [length]
  S edge[3], across[3], size[2];  ///< of a rectangle, from the point on; a size of 0: without end [length]
};

/// From here on nothing slides [-].
template <class S>
inline constexpr S infinite_friction = S(1e30);

/// Directions of a node that is held along one or two, or moved as given.
template <class S>
struct WallHold {
  S free[3];     ///< the part of the wall's normal across those [-]
  S held[2][3];  ///< at right angles to each other; zero: there is no second one [-]
};

/// Force that stops a node across the normal, as far as friction allows it. f: all other forces on the node.
template <class S>
PINBALL_OUTLINED void wall_drag(const WallPlane<S>& wall, S reaction, const S* v, const S* f, S velocity_step,
                                S inverse_mass, S* stopping) {
  S along = 0, square = 0;
  for (int k = 0; k < 3; ++k) {
    stopping[k] = -v[k] / (velocity_step * inverse_mass) - f[k];
    along += stopping[k] * wall.normal[k];
  }
  for (int k = 0; k < 3; ++k) {
    stopping[k] -= along * wall.normal[k];
    square += stopping[k] * stopping[k];
  }
  const S size = std::sqrt(square), most = wall.friction * reaction;
  if (size > most) {
    for (int k = 0; k < 3; ++k) stopping[k] *= most / size;
  }
}

/// What a wall does to a node that is held.
template <class S>
struct WallRub {
  S reaction;  ///< N [force]
  S drag[3];   ///< g, along held directions, too [force]
};

/// needed: N d.d without friction; w: velocity that the node would have after the step without friction; rest: up to
/// which w is nothing but rounding; mobility: change of velocity over force.
template <class S>
PINBALL_OUTLINED WallRub<S> wall_rub_of_held(const WallPlane<S>& wall, const WallHold<S>& hold, S needed, const S* w,
                                             S rest, S mobility) {
  const S *n = wall.normal, *d = hold.free, *h = hold.held[0], *second = hold.held[1];
  const auto product = [](const S* a, const S* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const S free = product(d, d), along = product(w, n);
  // Friction slows the node down along the direction, if any, that is free and across the normal.
  S e[3] = {h[1] * d[2] - h[2] * d[1], h[2] * d[0] - h[0] * d[2], h[0] * d[1] - h[1] * d[0]};
  const S scale = product(second, second) > S(0) ? S(0) : S(1) / std::sqrt(product(e, e));
  for (S& component : e) component *= scale;
  const S to_slow = product(w, e), way = std::abs(to_slow), sign = to_slow < S(0) ? S(-1) : S(1);
  S given[3];
  for (int k = 0; k < 3; ++k) given[k] = w[k] - along * n[k] - to_slow * e[k];
  const S given_speed = std::sqrt(product(given, given));
  const bool slides = given_speed > rest, ends = wall.friction < infinite_friction<S>;
  WallRub<S> rub{needed / free, {S(0), S(0), S(0)}};
  if (!slides || !ends) {  // what is given and slides without end has no friction of any size
    const S most = ends ? wall.friction * rub.reaction : way / mobility;
    const S stopping = -sign * (way < mobility * most ? way / mobility : most);
    for (int k = 0; k < 3; ++k) rub.drag[k] = stopping * e[k];
    return rub;
  }
  S friction = wall.friction, left = 0;  // of the way: left (1 + change/speed) = way, by Newton's method from below
  constexpr S digits = sizeof(S) == 8 ? S(0x1p-48) : S(0x1p-20);
  for (int i = 0; i < 50; ++i) {
    const S before = rub.reaction;
    const S change = mobility * friction * rub.reaction;
    const S square = given_speed * given_speed + left * left, speed = std::sqrt(square);
    const S slope = S(1) + change * given_speed * given_speed / (square * speed);
    left += (way - left * (S(1) + change / speed)) / slope;
    const S size = std::sqrt(given_speed * given_speed + left * left);
    S unit[3];
    for (int k = 0; k < 3; ++k) unit[k] = (given[k] + sign * left * e[k]) / size;
    // A wedge that would hold itself is pushed ten times as hard as without friction, and no harder.
    const S lifts = product(unit, d);
    friction = wall.friction * lifts < S(0.9) * free ? wall.friction : S(0.9) * free / lifts;
    rub.reaction = needed / (free - friction * lifts);
    for (int k = 0; k < 3; ++k) rub.drag[k] = -friction * rub.reaction * unit[k];
    if (i > 5 && std::abs(rub.reaction - before) <= digits * before) break;
  }
  return rub;
}

/// The part of a force that a node which is held can follow.
template <class S>
PINBALL_FUNCTION void across_held(const WallHold<S>& hold, const S* force, S* free) {
  for (int k = 0; k < 3; ++k) free[k] = force[k];
  for (const S(&h)[3] : hold.held) {
    const S along = force[0] * h[0] + force[1] * h[1] + force[2] * h[2];
    for (int k = 0; k < 3; ++k) free[k] -= along * h[k];
  }
}

}  // namespace pinball
