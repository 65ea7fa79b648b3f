#include <fmt/format.h>

#include <utility>

#include <solver/base/error.hpp>
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
}

/// The names of the bodies, and what refers to them: keys `body` and selections of nodes.
class BodyNames {
 public:
  explicit BodyNames(const Scene& scene) : bodies_(scene.bodies) {}

  void check_body(const Table& table, const std::string& body) const {
    if (!body.empty()) table.require_none(bodies_.reference_problem("body", "body", body));
  }
  /// Names the selection in messages about its nodes, too.
  void check(const Table& table, NodeSelection& nodes, const std::string& where) const {
    if (nodes.where.empty()) nodes.where = where;
    check_body(table, nodes.body);
    if (nodes.plane) table.require_none(direction_problem("plane.normal", nodes.plane->normal));
    if (nodes.line) table.require_none(direction_problem("line.direction", nodes.line->direction));
    if (nodes.box) table.require_none(problem_of(*nodes.box));
    if (nodes.all())
      table.fail("body", "missing, expected at least one of body, plane, line, box, nearest, set and nodes");
  }

 private:
  Names bodies_;
};

/// Each table of a list, with its name for messages.
template <class Item, class Check>
void for_each(std::vector<Item>& items, const char* kind, const Check& check) {
  for (std::size_t i = 0; i < items.size(); ++i) check(Table(kind, i), items[i], fmt::format("{}.{}", kind, i));
}

void check_boundary(Scene& scene) {
  const BodyNames names(scene);
  for_each(scene.constraints, "symmetry constraint", [&](const Table& table, PlaneConstraint& plane, const auto&) {
    table.numbers(plane);
    table.require_none(direction_problem("normal", plane.normal));
    names.check_body(table, plane.body);
  });
  for_each(scene.fixed_constraints, "fixed constraint",
           [&](const Table& table, FixedConstraint& fixed, const auto& where) {
             names.check(table, fixed.nodes, where);
             if (fixed.directions.empty()) table.fail("directions", "expected at least one direction, got none");
             for (const Point& direction : fixed.directions)
               table.require_none(direction_problem("directions", direction));
             if (fixed.frame == Frame::cylindrical)
               table.require_none(direction_problem("axis.direction", fixed.axis.direction));
           });
  Names walls;
  for_each(scene.rigid_walls, "rigid_wall", [&](const Table& table, RigidWall& wall, const auto& where) {
    if (wall.where.empty()) wall.where = where;
    table.require_none(name_problem(wall.name));
    table.require_none(walls.add(wall.name));
    table.numbers(wall);
    table.require_none(direction_problem("normal", wall.plane.normal));
    names.check_body(table, wall.body);
  });
  for_each(scene.prescribed_velocities, "prescribed_velocity",
           [&](const Table& table, PrescribedVelocity& given, const auto& where) {
             names.check(table, given.nodes, where);
             table.number("velocity", given.velocity, any_number);
             if (given.direction) table.require_none(direction_problem("direction", *given.direction));
             table.require_none(problem_of(given.table));
           });
  for_each(scene.loads, "load", [&](const Table& table, NodalLoad& load, const auto& where) {
    names.check(table, load.nodes, where);
    table.numbers(load);
    table.require_none(problem_of(load.table));
  });
  for_each(scene.gravities, "gravity", [&](const Table& table, Gravity& gravity, const auto&) {
    table.numbers(gravity);
    table.require_none(problem_of(gravity.table));
  });
  for_each(scene.initial_velocities, "initial_velocity",
           [&](const Table& table, InitialVelocity& given, const auto& where) {
             names.check(table, given.nodes, where);
             table.numbers(given);
           });
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
  check_boundary(scene);
  return scene;
}

}  // namespace pinball
