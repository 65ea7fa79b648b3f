#pragma once

#include <vector>

#include "island_loops.hpp"
#include "row_system.hpp"

namespace pinball {

/// Impulse and moment that rows give a rigid body.
struct ImpulseWrench {
  Vec3<double> impulse{0, 0, 0}, moment{0, 0, 0};

  void add(const Vec3<double>& p, const Vec3<double>& arm) {
    impulse = impulse + p;
    moment = moment + cross(arm, p);
  }
  void join(const ImpulseWrench& other) {
    impulse = impulse + other.impulse;
    moment = moment + other.moment;
  }
};

inline ImpulseWrench wrench_of(const RowSystem& system, const RigidGroup& group, const IslandLoops& loops,
                               const double* impulses) {
  return loops.reduce<ImpulseWrench>(group.first_node, group.end_node, [&](std::int64_t i, ImpulseWrench& sum) {
    const std::int32_t place = system.nodes()[i];
    sum.add(system.impulse_at(place, impulses), system.rigid().arm_of(place));
  });
}

/// Changes of velocity and angular velocity of a body.
struct RigidChange {
  Vec3<double> velocity{0, 0, 0}, spin{0, 0, 0};

  /// What a wrench on another body that hangs together with this one adds, or on itself.
  void add(const RigidMechanism& mechanism, std::int32_t own, std::int32_t other, const ImpulseWrench& by) {
    const std::size_t width = 6 * mechanism.bodies.size();
    const double on[6] = {by.impulse.x, by.impulse.y, by.impulse.z, by.moment.x, by.moment.y, by.moment.z};
    double change[6] = {};
    for (std::size_t i = 0; i < 6; ++i) {
      const double* const row = mechanism.mobility.data() + (6 * own + i) * width + 6 * other;
      for (std::size_t j = 0; j < 6; ++j) change[i] += row[j] * on[j];
    }
    velocity = velocity + Vec3<double>{change[0], change[1], change[2]};
    spin = spin + Vec3<double>{change[3], change[4], change[5]};
  }
};

/// Calls give(place, change) with what impulses of rows change the velocities of nodes by, for the nodes of some rigid
/// bodies: impulses are gathered at nodes, summed up to a wrench of their body, and its twist is that of all its nodes.
/// Bodies that hang together by joints are moved by the wrenches of all of them, in their order. first, end: of
/// RowSystem::groups().
template <class Give>
void for_rigid_nodes(const RowSystem& system, std::int32_t first, std::int32_t end, const IslandLoops& loops,
                     const double* impulses, const Give& give) {
  const RigidPlaces& rigid = system.rigid();
  const bool jointed = rigid && !rigid.sides->mechanisms.empty();
  std::vector<ImpulseWrench> wrenches;
  for (std::int32_t g = first; jointed && g < end; ++g)
    wrenches.push_back(wrench_of(system, system.groups()[g], loops, impulses));
  for (std::int32_t g = first; g < end; ++g) {
    const RigidGroup group = system.groups()[g];
    const RigidSide& side = rigid.side(group.body);
    RigidChange change;
    if (side.mechanism < 0) {
      const ImpulseWrench wrench = jointed ? wrenches[g - first] : wrench_of(system, group, loops, impulses);
      change = {side.translation * wrench.impulse, side.rotation * wrench.moment};
    } else {
      for (std::int32_t other = first; other < end; ++other) {
        const RigidSide& by = rigid.side(system.groups()[other].body);
        if (by.mechanism == side.mechanism)
          change.add(rigid.sides->mechanisms[side.mechanism], side.in_mechanism, by.in_mechanism,
                     wrenches[other - first]);
      }
    }
    loops.for_each(group.first_node, group.end_node, [&](std::int64_t i) {
      const std::int32_t place = system.nodes()[i];
      give(place, change.velocity + cross(change.spin, rigid.arm_of(place)));
    });
  }
}

}  // namespace pinball
