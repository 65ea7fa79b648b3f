#include "info_rigid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <solver/scene/schema/choices.hpp>

#include "info_boundary.hpp"
#include "info_material.hpp"

namespace pinball {

namespace {

void print_joints(const Scene& scene, const Units& units) {
  for (const Joint& joint : scene.joints) {
    fmt::print("  joint {} ({}) of {} and {} at {}{}{}\n", joint.name, schema::name_of(joint.kind), joint.bodies[0],
               joint.bodies[1], vector_text(joint.point.value_or(Point{}), units.length),
               joint.axis ? ", axis " + vector_text(*joint.axis, "") : "",
               joint.second_axis ? ", of the second body " + vector_text(*joint.second_axis, "") : "");
  }
}

}  // namespace

void print_rigid_bodies(const Scene& scene, const std::vector<RigidBodyResult>& results, const Units& units) {
  for (std::size_t r = 0; r < results.size(); ++r) {
    const RigidBody& rigid = scene.rigid_bodies[r];
    fmt::print("  rigid body {} of {}: mass {}, centre {}{}\n", rigid.name,
               rigid.bodies.empty() ? "attached nodes" : fmt::format("{}", fmt::join(rigid.bodies, ", ")),
               with_unit(results[r].mass, units.mass), vector_text(results[r].centre, units.length),
               rigid.inertia == std::array<Point, 3>{} ? ", inertia of its nodes" : ", inertia as given");
    if (rigid.velocity || rigid.angular_velocity)
      fmt::print("    begins with velocity {}, angular velocity {}\n",
                 vector_text(rigid.velocity.value_or(Point{}), units.velocity),
                 vector_text(rigid.angular_velocity.value_or(Point{}), per_time(units)));
    if (!rigid.held.empty()) fmt::print("    held along {}\n", directions_text(rigid.held));
    if (!rigid.held_rotations.empty())
      fmt::print("    does not turn about {}\n", directions_text(rigid.held_rotations));
    for (const RigidMotion& motion : scene.rigid_motions) {
      if (motion.rigid_body != rigid.name) continue;
      if (motion.direction)
        fmt::print("    moves along {} with {} ({}{})\n", vector_text(*motion.direction, ""),
                   motion_text(motion.quantity, fmt::format("{:.6g}", motion.speed), units.length, units),
                   table_text(motion.table), span_text(motion.when, units));
      if (motion.axis)
        fmt::print("    turns about {} with {} ({}{})\n", vector_text(*motion.axis, ""),
                   motion_text(motion.quantity, fmt::format("{:.6g}", motion.angular_speed), "rad", units),
                   table_text(motion.table), span_text(motion.when, units));
    }
  }
  print_joints(scene, units);
}

}  // namespace pinball
