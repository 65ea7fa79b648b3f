#pragma once

#include <string>

#include "../../scene.hpp"
#include "../../scene_rigid.hpp"
#include "key.hpp"
#include "selection.hpp"

/// The keys of rigid bodies and of what moves them.
namespace pinball::schema {

/// Whether a body is of a rigid one.
inline bool is_rigid(const Body& body, const Scene& scene) {
  for (const RigidBody& rigid : scene.rigid_bodies) {
    for (const std::string& name : rigid.bodies) {
      if (name == body.name) return true;
    }
  }
  return false;
}

template <class Visit>
constexpr void describe(Of<RigidBody>, Visit&& visit) {
  using T = RigidBody;
  visit(Key{"name",
            &T::name,
            "of its columns in `history.csv`",
            {.form = Form::name, .otherwise = "that of the first of its bodies", .listed = Listed::never}});
  visit(Key{"bodies",
            &T::bodies,
            "names of the bodies that move as one and do not deform",
            {.otherwise = "none: nodes of `[[rigid_nodes]]` alone", .done = Done::reading_by_hand}});
  visit(Key{"held",
            &T::held,
            "`\"all\"`, or directions at right angles along which its centre does not move: `\"x\"`, `\"y\"`, `\"z\"` "
            "or 3 numbers",
            {.unit = "-", .otherwise = "none", .done = Done::reading_by_hand}});
  visit(Key{"held_rotations",
            &T::held_rotations,
            "`\"all\"`, or directions at right angles about which it does not turn",
            {.unit = "-", .otherwise = "none", .done = Done::reading_by_hand}});
  visit(Key{"mass",
            &T::mass,
            "in the place of that of its materials, whose densities follow",
            {.unit = "M", .bound = not_negative, .unset = Unset::zero, .otherwise = "that of its elements"}});
  visit(Key{"inertia",
            &T::inertia,
            "3 rows of 3, at the start, about its centre along x, y, z; all 0: that of the masses of its nodes",
            {.unit = "M L^2"}});
  visit(Key{"centre",
            &T::centre,
            "of its mass, at the start; required beside it is `inertia`",
            {.unit = "L", .otherwise = "that of the masses of its nodes"}});
  visit(Key{"velocity",
            &T::velocity,
            "of its centre at the start, whatever velocities its bodies and nodes have; 0 beside `angular_velocity`",
            {.unit = "L/T", .otherwise = "as its nodes move"}});
  visit(Key{"angular_velocity",
            &T::angular_velocity,
            "at the start, the same; 0 beside `velocity`",
            {.unit = "1/T", .otherwise = "as its nodes turn"}});
  visit(Field{"where", &T::where, "for messages"});
}

template <class Visit>
constexpr void describe(Of<AttachedNodes>, Visit&& visit) {
  using T = AttachedNodes;
  visit(Key{"rigid_body", &T::rigid_body, "name of a `[[rigid_body]]`", {.need = Need::required}});
  visit(Group{"nodes", &T::nodes, "which nodes"});
}

template <class Visit>
constexpr void describe(Of<RigidMotion>, Visit&& visit) {
  using T = RigidMotion;
  visit(Key{"rigid_body", &T::rigid_body, "name of a `[[rigid_body]]`", {.need = Need::required}});
  visit(Key{"direction",
            &T::direction,
            "in which its centre moves",
            {.unit = "-", .need = Need::one_of, .form = Form::direction, .otherwise = "required, or `axis`"}});
  visit(Key{"speed", &T::speed, "along the direction", {.unit = "L/T"}});
  visit(Key{"axis",
            &T::axis,
            "about which it turns",
            {.unit = "-", .need = Need::one_of, .form = Form::direction, .otherwise = "required, or `direction`"}});
  visit(Key{"angular_speed", &T::angular_speed, "about the axis", {.unit = "1/T"}});
  visit(Key{"quantity", &T::quantity,
            "what the factors make of it: with `\"displacement\"` and `\"acceleration\"` speeds are ways, angles and "
            "accelerations"});
  visit(Group{"table", &T::table, "factors"});
  visit(Group{"when", &T::when, "the body is free before and after; factors are of the time of the run"});
  visit(Field{"where", &T::where, "for messages"});
}

template <class Visit>
constexpr void describe(Of<Joint>, Visit&& visit) {
  using T = Joint;
  visit(Key{"name",
            &T::name,
            "of its columns in `history.csv`",
            {.form = Form::name, .otherwise = "`joint_0`, `joint_1`, ...", .listed = Listed::never}});
  visit(Key{"kind", &T::kind, "what the bodies still do with each other (below)", {.need = Need::required}});
  visit(Key{"bodies",
            &T::bodies,
            "names of two `[[rigid_body]]`; in the place of one of them `\"ground\"`, which does not move",
            {.need = Need::required, .done = Done::reading_by_hand}});
  visit(Key{"point", &T::point, "where it is at the start, of both bodies", {.unit = "L", .need = Need::required}});
  visit(Key{"axis",
            &T::axis,
            "that it turns about or slides along; of a `\"universal\"` one that of the first body",
            {.unit = "-", .form = Form::direction, .otherwise = "required but for `\"spherical\"` and `\"locking\"`"}});
  visit(Key{"second_axis",
            &T::second_axis,
            "of a `\"universal\"` one: that of the second body, at right angles to the first",
            {.unit = "-", .form = Form::direction, .otherwise = "required of a `\"universal\"` one"}});
  visit(Field{"where", &T::where, "for messages"});
}

}  // namespace pinball::schema
