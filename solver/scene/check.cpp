#include <fmt/format.h>

#include <cmath>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/scene/units/units.hpp>
#include <solver/scene_rules.hpp>

#include "names.hpp"
#include "numbers.hpp"

namespace pinball {

namespace {

/// One table of the scene: knows how to call its keys.
class Table {
 public:
  explicit Table(std::string path) : path_(std::move(path)) {}
  Table(const char* kind, std::size_t number) : Table(fmt::format("{}.{}", kind, number)) {}
  Table(const char* kind, const std::string& name) : Table(fmt::format("{}.{}", kind, name)) {}

  [[noreturn]] void fail(std::string_view key, const std::string& text) const {
    throw InputError(path_.empty() ? fmt::format("{}: {}", key, text) : fmt::format("{}.{}: {}", path_, key, text));
  }
  void require_none(const std::optional<Problem>& problem) const {
    if (problem) fail(problem->key, problem->text);
  }
  void number(std::string_view key, double value, const Bound& bound) const {
    if (!bound.holds(value)) fail(key, fmt::format("expected {}, got {}", bound.describe(), value));
  }
  void number(std::string_view key, const Point& value, const Bound& bound) const {
    for (std::size_t k = 0; k < 3; ++k) number(fmt::format("{}[{}]", key, k), value[k], bound);
  }
  template <class Settings>
  void numbers(Settings& settings) const {
    visit_numbers(settings, [this](std::string_view key, const auto& value, const Bound& bound, Need = Need::optional) {
      number(key, value, bound);
    });
  }

 private:
  std::string path_;
};

void check_material(Material& material, Names& earlier) {
  const Table table("material", material.name);
  table.require_none(name_problem(material.name));
  table.require_none(earlier.add(material.name));
  table.numbers(material);
  table.number("bulk_modulus", material.bulk_modulus, positive);
  table.number("shear_modulus", material.shear_modulus, positive);
  if (material.plastic) table.number("yield_stress", material.yield_stress, positive);
  if (!(material.ultimate_stress >= 0)) table.fail("ultimate_stress", "expected a number > 0, or 0 for none");
  table.require_none(problem_of(material));
}

void check_body(Body& body, const Names& materials, Names& earlier) {
  const Table table("body", body.name);
  table.require_none(name_problem(body.name));
  table.require_none(earlier.add(body.name));
  table.require_none(materials.reference_problem("material", "material", body.material));
  table.numbers(body);
  for (const Point& row : body.velocity_gradient) table.number("velocity_gradient", row, any_number);
  if (body.axis) table.require_none(direction_problem("axis", *body.axis));
  if (body.element) Table(fmt::format("body.{}.element", body.name)).numbers(*body.element);
}

/// The names of the bodies, and what refers to them: keys `body` and selections of nodes.
class BodyNames {
 public:
  explicit BodyNames(const Scene& scene) : bodies_(scene.bodies) {}

  void check_body(const Table& table, const std::string& body) const {
    if (!body.empty()) table.require_none(bodies_.reference_problem("body", "body", body));
  }
  void check_bodies(const Table& table, const std::vector<std::string>& bodies) const {
    for (const std::string& body : bodies) table.require_none(bodies_.reference_problem("bodies", "body", body));
  }
  /// Of which nothing has to be given.
  void check_any(const Table& table, NodeSelection& nodes, const std::string& where) const {
    if (nodes.where.empty()) nodes.where = where;
    table.number("tolerance", nodes.tolerance, not_negative);
    check_body(table, nodes.body);
    if (nodes.plane) table.require_none(direction_problem("plane.normal", nodes.plane->normal));
    if (nodes.line) table.require_none(direction_problem("line.direction", nodes.line->direction));
    if (nodes.box) table.require_none(problem_of(*nodes.box));
  }
  /// Names the selection in messages about its nodes, too.
  void check(const Table& table, NodeSelection& nodes, const std::string& where) const {
    check_any(table, nodes, where);
    if (nodes.all())
      table.fail("body", "missing, expected at least one of body, plane, line, box, nearest, set and nodes");
  }

 private:
  Names bodies_;
};

void check_time_span(const Table& table, const TimeSpan& when) {
  table.number("start", when.start, any_number);
  if (!std::isinf(when.end)) table.number("end", when.end, any_number);
  table.require_none(problem_of(when));
}

void check_wall(const Table& table, RigidWall& wall) {
  table.numbers(wall);
  table.number("mass", wall.mass, not_negative);
  table.number("speed", wall.speed, any_number);
  for (const double side : wall.size) table.number("size", side, not_negative);
  table.require_none(direction_problem("normal", wall.plane.normal));
  if (wall.edge) table.require_none(direction_problem("edge", *wall.edge));
  table.require_none(problem_of(wall.table));
  table.require_none(problem_of(wall));
  check_time_span(table, wall.when);
}

/// Each table of a list, with its name for messages.
template <class Item, class Check>
void for_each(std::vector<Item>& items, const char* kind, const Check& check) {
  for (std::size_t i = 0; i < items.size(); ++i) check(Table(kind, i), items[i], fmt::format("{}.{}", kind, i));
}

/// What a pair and a tie have in common: a name, numbers and two sides with bodies.
template <class Sides>
void check_sides(const Table& table, Sides& sides, const std::string& where, const Names& bodies, Names& earlier) {
  if (sides.where.empty()) sides.where = where;
  table.require_none(name_problem(sides.name));
  table.require_none(earlier.add(sides.name));
  table.numbers(sides);
  for (const std::string& body : sides.first.bodies)
    table.require_none(bodies.reference_problem("first", "body", body));
  for (const std::string& body : sides.second.bodies)
    table.require_none(bodies.reference_problem("second", "body", body));
}

void check_contact(Scene& scene) {
  const Names bodies(scene.bodies);
  Names pairs, ties;
  for_each(scene.contact_pairs, "contact.pair", [&](const Table& table, ContactPair& pair, const auto& where) {
    check_sides(table, pair, where, bodies, pairs);
    table.require_none(problem_of(pair, scene.contact));
    table.require_none(column_problem(pair.name, bodies));
  });
  for_each(scene.tied_contacts, "contact.tied", [&](const Table& table, TiedContact& tied, const auto& where) {
    check_sides(table, tied, where, bodies, ties);
    table.require_none(problem_of(tied));
  });
}

void check_constraints(Scene& scene, const BodyNames& names) {
  for_each(scene.constraints, "symmetry constraint",
           [&](const Table& table, PlaneConstraint& plane, const auto& where) {
             table.numbers(plane);
             table.require_none(direction_problem("normal", plane.normal));
             names.check_body(table, plane.body);
             table.require_none(force_name_problem(plane.name, scene));
             if (plane.where.empty()) plane.where = where;
           });
  for_each(scene.fixed_constraints, "fixed constraint",
           [&](const Table& table, FixedConstraint& fixed, const auto& where) {
             names.check(table, fixed.nodes, where);
             table.require_none(force_name_problem(fixed.name, scene));
             check_time_span(table, fixed.when);
             if (fixed.directions.empty()) table.fail("directions", "expected at least one direction, got none");
             for (const Point& direction : fixed.directions)
               table.require_none(direction_problem("directions", direction));
             if (fixed.frame == Frame::cylindrical)
               table.require_none(direction_problem("axis.direction", fixed.axis.direction));
           });
}

void check_walls(Scene& scene, const BodyNames& names) {
  Names walls;
  for_each(scene.rigid_walls, "rigid_wall", [&](const Table& table, RigidWall& wall, const auto& where) {
    if (wall.where.empty()) wall.where = where;
    table.require_none(name_problem(wall.name));
    table.require_none(walls.add(wall.name));
    check_wall(table, wall);
    names.check_body(table, wall.body);
    names.check_any(table, wall.nodes, wall.where);
  });
}

void check_motion(Scene& scene, const BodyNames& names) {
  for_each(scene.prescribed_velocities, "prescribed_velocity",
           [&](const Table& table, PrescribedVelocity& given, const auto& where) {
             names.check(table, given.nodes, where);
             table.require_none(force_name_problem(given.name, scene));
             table.number("velocity", given.velocity, any_number);
             if (given.direction) table.require_none(direction_problem("direction", *given.direction));
             table.require_none(problem_of(given.table));
             check_time_span(table, given.when);
           });
  for_each(scene.initial_velocities, "initial_velocity",
           [&](const Table& table, InitialVelocity& given, const auto& where) {
             names.check(table, given.nodes, where);
             table.numbers(given);
           });
}

void check_loads(Scene& scene, const BodyNames& names) {
  for_each(scene.loads, "load", [&](const Table& table, NodalLoad& load, const auto& where) {
    names.check(table, load.nodes, where);
    table.numbers(load);
    table.require_none(problem_of(load.table));
  });
  Names pressures;
  for_each(scene.pressures, "pressure", [&](const Table& table, Pressure& pressure, const auto& where) {
    table.require_none(name_problem(pressure.name));
    table.require_none(pressures.add(pressure.name));
    if (pressure.corners.empty()) names.check(table, pressure.faces, where);
    names.check_any(table, pressure.faces, where);
    table.numbers(pressure);
    table.require_none(problem_of(pressure.table));
  });
  for_each(scene.gravities, "gravity", [&](const Table& table, Gravity& gravity, const auto&) {
    table.numbers(gravity);
    names.check_bodies(table, gravity.bodies);
    table.require_none(force_name_problem(gravity.name, scene));
    table.require_none(problem_of(gravity.table));
  });
}

void check_probes(Scene& scene, const BodyNames& names) {
  Names taken(scene.bodies);
  for_each(scene.probes, "probe", [&](const Table& table, Probe& probe, const auto& where) {
    if (probe.where.empty()) probe.where = where;
    table.require_none(name_problem(probe.name));
    table.require_none(taken.add(probe.name));
    table.numbers(probe);
    names.check_body(table, probe.body);
  });
}

}  // namespace

Scene checked_scene(Scene scene) {
  complete_scene(scene);
  const auto settings = [](const char* path, auto& table) { Table(path).numbers(table); };
  Table("").require_none(units_problem(scene.units));
  settings("time", scene.time);
  Table("time").require_none(problem_of(scene.time));
  settings("element", scene.element);
  settings("contact", scene.contact);
  Table("contact").require_none(problem_of(scene.contact));
  settings("guard", scene.guard);
  settings("damping", scene.damping);
  settings("output", scene.output);
  Names materials, bodies;
  for (Material& material : scene.materials) check_material(material, materials);
  if (scene.bodies.empty()) Table("").fail("body", "missing, expected at least one [[body]]");
  for (Body& body : scene.bodies) check_body(body, materials, bodies);
  check_contact(scene);
  const BodyNames names(scene);
  check_constraints(scene, names);
  check_walls(scene, names);
  check_motion(scene, names);
  check_loads(scene, names);
  check_probes(scene, names);
  return scene;
}

}  // namespace pinball
