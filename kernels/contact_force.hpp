#pragma once

#include <cstdint>

#include "gather.hpp"
#include "pinball.hpp"

/// Penalty forces of pairs of pinballs, a pack of pairs at a time.
///
/// Of the pairs that a list holds few touch: they are found by touching_pairs and gathered into full packs for
/// pair_force. Each pair is computed once, and the force on its second pinball is the opposite of that on the first.
namespace pinball {

/// Pinball records of four scalars each, one record per pinball. A pinball whose B R is zero takes no part: its element
/// has eroded, or is not exposed yet.
template <class S>
struct PinballView {
  const S* centre;     ///< C, R [length]
  const S* velocity;   ///< V, element mass [length/time], [mass]
  const S* outward;    ///< outward normal, B R (bulk modulus times radius) [length^2], [stress length]
  const S* two_sided;  ///< two-sided normal [length^2]; its fourth number is that of PinballGeometryView
};

template <class S>
struct PenaltyConstants {
  S beta;     ///< factor of (3.11) [-]
  S damping;  ///< xi: p1 = 2 xi sqrt(p2 m), m = m1 m2 / (m1 + m2) with element masses [-]
};

/// What the pairs of a pack do to their first pinballs; all zero for a pair without contact.
template <class T>
struct PairForce {
  Vec3<T> force;        ///< [force]
  T stiffness;          ///< p2 [force/length]
  T stored;             ///< p2 g^2 / 2 [energy]
  T damped;             ///< (F - p2 g) gdot [power]
  T penetration_ratio;  ///< g / (R1 + R2) [-]
  MaskOf<T> active;     ///< pairs in contact
};

/// The pairs of a pack whose balls overlap, or that are in contact, one bit each. first, second: a pinball of each
/// pair; offset: see pair_force.
template <class T>
PINBALL_FUNCTION unsigned touching_pairs(const ScalarOf<T>* centre, const std::int32_t* first,
                                         const std::int32_t* second, const ScalarOf<T>* offset) {
  Vec3<T> c1, c2;
  T r1, r2;
  gather_records(centre, first, c1.x, c1.y, c1.z, r1);
  gather_records(centre, second, c2.x, c2.y, c2.z, r2);
  const Vec3<T> d = c1 - c2;
  const T reach = r1 + r2;
  return lane_bits<T>(dot(d, d) < reach * reach || !(load<T>(offset) < T(0)));
}

/// first, second: a pinball of each pair. offset: one number per pair, kept from step to step: the depth at which the
/// pair began, or negative while it is not in contact. A pair that comes into contact by approaching begins at depth 0.
/// One that is found deep inside another, because erosion exposed it or a normal turned, begins where it is found: the
/// depth that it did not reach by approach stores no energy and gives no force. The offset never exceeds the depth, and
/// so vanishes as the pair separates. dt: the step just made.
template <class T>
PINBALL_FUNCTION PairForce<T> pair_force(const PinballView<ScalarOf<T>>& view,
                                         const PenaltyConstants<ScalarOf<T>>& constants, const std::int32_t* first,
                                         const std::int32_t* second, T& offset, ScalarOf<T> dt) {
  using S = ScalarOf<T>;
  Vec3<T> c1, c2, v1, v2;
  T r1, r2, mass1, mass2, stiffness1, stiffness2, spare;
  PinballNormal<T> normal1, normal2;
  gather_records(view.centre, first, c1.x, c1.y, c1.z, r1);
  gather_records(view.centre, second, c2.x, c2.y, c2.z, r2);
  gather_records(view.outward, first, normal1.outward.x, normal1.outward.y, normal1.outward.z, stiffness1);
  gather_records(view.outward, second, normal2.outward.x, normal2.outward.y, normal2.outward.z, stiffness2);
  gather_records(view.two_sided, first, normal1.two_sided.x, normal1.two_sided.y, normal1.two_sided.z, spare);
  gather_records(view.two_sided, second, normal2.two_sided.x, normal2.two_sided.y, normal2.two_sided.z, spare);
  gather_records(view.velocity, first, v1.x, v1.y, v1.z, mass1);
  gather_records(view.velocity, second, v2.x, v2.y, v2.z, mass2);

  const Vec3<T> d = c1 - c2;
  const T reach = r1 + r2;
  const Vec3<T> n1 = unit_normal_towards(normal1, T(-1) * d);
  const Vec3<T> n2 = unit_normal_towards(normal2, d);
  const Penetration<T> p = penetration(d, reach, n1, n2);
  const auto active = p.active && stiffness1 > T(0) && stiffness2 > T(0);

  const T p2 = T(S(0.5) * constants.beta) * (stiffness1 + stiffness2);  // (3.11)
  const T reduced_mass = mass1 * mass2 / (mass1 + mass2);
  const T p1 = T(2 * constants.damping) * square_root(p2 * reduced_mass);
  const T rate = dot(v2 - v1, p.gradient);  // (3.10)
  // if (in contact before) offset = min(offset, depth); else offset = depth not explained by the approach of the step
  const T approach = maximum(T(0), rate) * T(dt);
  const T offset_now = select(!(offset < T(0)), minimum(offset, p.depth), maximum(T(0), p.depth - approach));
  offset = select(active, offset_now, T(-1));
  const T depth = p.depth - offset_now;
  const T elastic = p2 * depth;
  const T total = maximum(T(0), elastic + p1 * rate);  // (3.8), no adhesion
  const T force = select(active, total, T(0));

  PairForce<T> result;
  result.force = force * p.gradient;
  result.stiffness = select(active, p2, T(0));
  result.stored = select(active, number<T>(0.5) * elastic * depth, T(0));
  result.damped = select(active, (total - elastic) * rate, T(0));
  result.penetration_ratio = select(active, p.depth / reach, T(0));
  result.active = active;
  return result;
}

/// Adds a force and a stiffness to those of a pinball; sign: of the force. Aligned to four scalars.
template <int sign, class S>
PINBALL_FUNCTION void add_record_to(const S* touch, S* pinball) {
  if constexpr (native_width<S> >= 4) {
    using T = Pack<S, 4>;
    const T signs = select(lane_numbers<T>() < T(3), T(S(sign)), T(S(1)));
    store(load<T>(pinball) + signs * load<T>(touch), pinball);
  } else {
    for (int k = 0; k < 3; ++k) pinball[k] += S(sign) * touch[k];
    pinball[3] += touch[3];
  }
}

/// What a pack of pairs does to both of their pinballs.
template <class S, int W>
struct alignas(64) PairTouch {
  std::int32_t first[W], second[W];
  S force[4][W];  ///< on the first, and p2
};

/// Adds the forces of the first pairs of a pack to their pinballs, pair after pair: records F, sum of p2. Only pinballs
/// before number `end` get any.
template <class T>
PINBALL_FUNCTION void add_to_pinballs(const PairTouch<ScalarOf<T>, width_of<T>>& touch, int pairs, std::int32_t end,
                                      ScalarOf<T>* force) {
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>;
  alignas(64) S record[4 * W]{};
  alignas(64) std::int32_t number[W];
  for (int i = 0; i < W; ++i) number[i] = i;
  add_to_records(record, number, load<T>(touch.force[0]), load<T>(touch.force[1]), load<T>(touch.force[2]),
                 load<T>(touch.force[3]));
  for (int i = 0; i < pairs; ++i) {
    const std::int64_t first = touch.first[i], second = touch.second[i];
    add_record_to<1>(record + 4 * i, force + 4 * first);
    if (second < end) add_record_to<-1>(record + 4 * i, force + 4 * second);
  }
}

/// Adds an eighth of a pinball's force to one of the nodes of its element (3.12), and a quarter of the stiffness of its
/// contacts, which bounds the row of the node in the stiffness matrix. Both are node records: force [force], stiffness
/// [force/length]; aligned to four scalars.
template <class S>
PINBALL_FUNCTION void add_to_node(S* node, const S* pinball) {
  if constexpr (native_width<S> >= 4) {
    using T = Pack<S, 4>;
    const T share = select(lane_numbers<T>() < T(3), T(S(0.125)), T(S(0.25)));
    store(load<T>(node) + share * load<T>(pinball), node);
  } else {
    for (int k = 0; k < 3; ++k) node[k] += S(0.125) * pinball[k];
    node[3] += S(0.25) * pinball[3];
  }
}

}  // namespace pinball
