#pragma once

#include <cstdint>
#include <pinball/kernels/gather.hpp>
#include <pinball/kernels/pinball.hpp>

/// Penalty forces on one pinball from all pinballs in its neighbour list, a pack of neighbours at a time.
///
/// Every pair stands in both lists: each pinball sums its own force and writes nothing else, so that the loop over
/// pinballs needs neither atomics nor colours, and its sums have one order. The two forces of a pair are equal and
/// opposite to the last bit. Lists are sorted by the number of the neighbour and pairs that do not touch add zeros, so
/// that the sums do not depend on which of these happen to be listed.
namespace pinball {

/// Pinball records of four scalars each, one record per pinball. A pinball whose B R is zero takes no part: its element
/// has eroded, or is not exposed yet.
template <class S>
struct PinballView {
  const S* centre;     ///< C, R [length]
  const S* velocity;   ///< V, element mass [length/time], [mass]
  const S* outward;    ///< outward normal, B R (bulk modulus times radius) [length^2], [stress length]
  const S* two_sided;  ///< two-sided normal, unused [length^2]
};

template <class S>
struct PenaltyConstants {
  S beta;     ///< factor of (3.11) [-]
  S damping;  ///< xi: p1 = 2 xi sqrt(p2 m), m = m1 m2 / (m1 + m2) with element masses [-]
};

/// Sums over the pairs of one pinball. Energies count half of each pair, because each pair is met twice.
template <class S>
struct PinballForce {
  Vec3<S> force{};        ///< [force]
  S stiffness{};          ///< sum of p2 over the active pairs [force/length]
  S stored{};             ///< sum of p2 g^2 / 4 [energy]
  S damped{};             ///< sum of (F - p2 g) gdot / 2 [power]
  S penetration_ratio{};  ///< largest g / (R1 + R2) [-]
  std::int32_t pairs{};   ///< active pairs, each met twice
};

/// neighbour: padded to whole packs with any valid pinball; count: real entries. T: pack of neighbours.
///
/// offset: one number per entry of the list, kept from step to step: the depth at which the pair began, or negative
/// while it is not in contact. A pair that comes into contact by approaching begins at depth 0. One that is found deep
/// inside another, because erosion exposed it or a normal turned, begins where it is found: the depth that it did not
/// reach by approach stores no energy and gives no force. The offset never exceeds the depth, and so vanishes as the
/// pair separates. stored: likewise, the half of the pair's spring energy that this entry stands for. dt: the step just
/// made.
template <class T>
PINBALL_FUNCTION PinballForce<ScalarOf<T>> pinball_force(const PinballView<ScalarOf<T>>& view,
                                                         const PenaltyConstants<ScalarOf<T>>& constants,
                                                         std::int32_t self, const std::int32_t* neighbour,
                                                         std::int32_t count, ScalarOf<T>* offset, ScalarOf<T>* stored,
                                                         ScalarOf<T> dt) {
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>;
  const S* own = view.centre + 4 * static_cast<std::int64_t>(self);
  const Vec3<T> c1{T(own[0]), T(own[1]), T(own[2])};
  const T r1(own[3]);

  PinballForce<S> result;
  for (std::int32_t first = 0; first < count; first += W) {
    const std::int32_t* index = neighbour + first;
    Vec3<T> c2;
    T r2;
    gather_records(view.centre, index, c2.x, c2.y, c2.z, r2);
    const Vec3<T> d = c1 - c2;
    const T reach = r1 + r2;
    const auto listed = lane_numbers<T>() < T(static_cast<S>(count - first));
    const T offset_before = load<T>(offset + first);
    const auto continues = !(offset_before < T(0));
    if (!any_lane((listed && dot(d, d) < reach * reach) || continues)) continue;  // most packs end here

    const S* own_velocity = view.velocity + 4 * static_cast<std::int64_t>(self);
    const S* own_outward = view.outward + 4 * static_cast<std::int64_t>(self);
    const S* own_two_sided = view.two_sided + 4 * static_cast<std::int64_t>(self);
    const PinballNormal<T> normal1{{T(own_outward[0]), T(own_outward[1]), T(own_outward[2])},
                                   {T(own_two_sided[0]), T(own_two_sided[1]), T(own_two_sided[2])}};
    PinballNormal<T> normal2;
    Vec3<T> v2;
    T stiffness2, mass2, spare;
    gather_records(view.outward, index, normal2.outward.x, normal2.outward.y, normal2.outward.z, stiffness2);
    gather_records(view.two_sided, index, normal2.two_sided.x, normal2.two_sided.y, normal2.two_sided.z, spare);
    gather_records(view.velocity, index, v2.x, v2.y, v2.z, mass2);

    const Vec3<T> n1 = unit_normal_towards(normal1, T(-1) * d);
    const Vec3<T> n2 = unit_normal_towards(normal2, d);
    const Penetration<T> p = penetration(d, reach, n1, n2);
    const auto active = p.active && listed && stiffness2 > T(0);

    const T p2 = T(S(0.5) * constants.beta) * (T(own_outward[3]) + stiffness2);  // (3.11)
    const T mass1(own_velocity[3]);
    const T reduced_mass = mass1 * mass2 / (mass1 + mass2);
    const T p1 = T(2 * constants.damping) * square_root(p2 * reduced_mass);
    const Vec3<T> v1{T(own_velocity[0]), T(own_velocity[1]), T(own_velocity[2])};
    const T rate = dot(v2 - v1, p.gradient);  // (3.10)
    // if (!continues) offset = depth not explained by the approach of the last step; else offset = min(offset, depth)
    const T approach = maximum(T(0), rate) * T(dt);
    const T offset_now = select(continues, minimum(offset_before, p.depth), maximum(T(0), p.depth - approach));
    store(select(active, offset_now, T(-1)), offset + first);
    const T depth = p.depth - offset_now;
    const T elastic = p2 * depth;
    const T total = maximum(T(0), elastic + p1 * rate);  // (3.8), no adhesion
    const T force = select(active, total, T(0));

    add_lanes_to(result.force.x, force * p.gradient.x);
    add_lanes_to(result.force.y, force * p.gradient.y);
    add_lanes_to(result.force.z, force * p.gradient.z);
    add_lanes_to(result.stiffness, select(active, p2, T(0)));
    const T energy = select(active, number<T>(0.25) * elastic * depth, T(0));
    store(energy, stored + first);
    add_lanes_to(result.stored, energy);
    add_lanes_to(result.damped, select(active, number<T>(0.5) * (total - elastic) * rate, T(0)));
    const S ratio = lane_maximum(select(active, p.depth / reach, T(0)));
    result.penetration_ratio = maximum(result.penetration_ratio, ratio);
    result.pairs += count_lanes(active);
  }
  return result;
}

}  // namespace pinball
