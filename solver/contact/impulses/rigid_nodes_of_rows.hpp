#pragma once

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

/// Calls give(place, change) with what impulses of rows change the velocities of nodes by, for the nodes of some rigid
/// bodies: impulses are gathered at nodes, summed up to a wrench of their body, and its twist is that of all its nodes.
/// first, end: of RowSystem::groups().
template <class Give>
void for_rigid_nodes(const RowSystem& system, std::int32_t first, std::int32_t end, const IslandLoops& loops,
                     const double* impulses, const Give& give) {
  const RigidPlaces& rigid = system.rigid();
  for (std::int32_t g = first; g < end; ++g) {
    const RigidGroup group = system.groups()[g];
    const auto wrench =
        loops.reduce<ImpulseWrench>(group.first_node, group.end_node, [&](std::int64_t i, ImpulseWrench& sum) {
          const std::int32_t place = system.nodes()[i];
          sum.add(system.impulse_at(place, impulses), rigid.arm_of(place));
        });
    const RigidSide& side = rigid.side(group.body);
    const Vec3<double> velocity = side.translation * wrench.impulse, spin = side.rotation * wrench.moment;
    loops.for_each(group.first_node, group.end_node, [&](std::int64_t i) {
      const std::int32_t place = system.nodes()[i];
      give(place, velocity + cross(spin, rigid.arm_of(place)));
    });
  }
}

}  // namespace pinball
