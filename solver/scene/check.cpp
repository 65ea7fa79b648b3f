#include <fmt/format.h>

#include <cmath>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/scene/schema/scene.hpp>
#include <solver/scene/schema/unset.hpp>
#include <solver/scene/units/units.hpp>
#include <solver/scene_rules.hpp>

#include "names.hpp"

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
  /// All numbers and directions that the keys of a table set.
  template <class T>
  void keys(const T& object) const;

 private:
  std::string path_;
};

/// Whether what is set has the values that files may have.
template <class T>
class KeyChecker {
 public:
  KeyChecker(const Table& table, const T& object, std::string prefix = {})
      : table_(table), object_(object), prefix_(std::move(prefix)) {}

  template <class Value>
  void operator()(const schema::FileKey<Value>&) const {}
  template <class Value>
  void operator()(const schema::Field<T, Value>&) const {}
  template <class Value>
  void operator()(const schema::Key<T, Value>& key) const {
    const Value& value = object_.*key.member;
    if (key.may_be_of(object_) && !schema::is_unset(value, key.about)) check(key, value);
  }
  /// All of them: a host can set what no file can.
  template <class Part>
  void operator()(const schema::Group<T, Part>& group) const {
    describe(schema::Of<Part>{}, KeyChecker<Part>(table_, object_.*group.member, prefix_));
  }

 private:
  template <class Value>
  void check(const schema::AnyKey& key, const Value& value) const {
    const std::string name = prefix_ + key.name;
    if constexpr (std::is_same_v<Value, Point>) {
      if (key.about.form == schema::Form::direction) {
        table_.require_none(direction_problem(name, value));
      } else {
        table_.number(name, value, key.about.bound);
      }
    } else if constexpr (std::is_same_v<Value, double>) {
      table_.number(name, value, key.about.bound);
    } else if constexpr (std::is_same_v<Value, std::array<double, 2>>) {
      for (const double one : value) table_.number(name, one, key.about.bound);
    } else if constexpr (std::is_same_v<Value, std::array<Point, 3>>) {
      for (const Point& row : value) table_.number(name, row, key.about.bound);
    } else if constexpr (schema::InnerTable<Value>) {
      check_part(name, value);
    } else if constexpr (requires { value.has_value(); }) {
      check(key, *value);
    }
  }
  template <class Part>
  void check_part(const std::string& name, const Part& part) const {
    describe(schema::Of<Part>{}, KeyChecker<Part>(table_, part, name + '.'));
  }
  template <class Part>
  void check_part(const std::string& name, const std::optional<Part>& part) const {
    check_part(name, *part);
  }

  const Table& table_;
  const T& object_;
  std::string prefix_;
};

template <class T>
void Table::keys(const T& object) const {
  describe(schema::Of<T>{}, KeyChecker<T>(*this, object));
}

void check_material(Material& material, Names& earlier) {
  const Table table("material", material.name);
  table.require_none(name_problem(material.name));
  table.require_none(earlier.add(material.name));
  table.keys(material);
  if (has_yield_stress(material)) table.number("yield_stress", material.yield_stress, positive);
  table.require_none(problem_of(material));
}

void check_body(Body& body, const Scene& scene, const Names& materials, Names& earlier) {
  const Table table("body", body.name);
  table.require_none(name_problem(body.name));
  table.require_none(earlier.add(body.name));
  table.require_none(materials.reference_problem("material", "material", body.material));
  table.keys(body);
  if (body.element) Table(fmt::format("body.{}.element", body.name)).keys(*body.element);
  table.require_none(problem_of(body, scene));
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
    check_body(table, nodes.body);
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
  table.keys(sides);
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

void check_rigid_bodies(Scene& scene, const BodyNames& names) {
  Names rigid_bodies;
  for_each(scene.rigid_bodies, "rigid_body", [&](const Table& table, RigidBody& rigid, const auto& where) {
    if (rigid.where.empty()) rigid.where = where;
    table.require_none(problem_of(rigid));
    table.require_none(name_problem(rigid.name));
    table.require_none(rigid_bodies.add(rigid.name));
    table.keys(rigid);
    names.check_bodies(table, rigid.bodies);
    table.require_none(problem_of(rigid, scene));
  });
  for_each(scene.attached_nodes, "rigid_nodes", [&](const Table& table, AttachedNodes& attached, const auto& where) {
    names.check(table, attached.nodes, where);
    table.keys(attached);
    table.require_none(rigid_bodies.reference_problem("rigid_body", "rigid_body", attached.rigid_body));
  });
  for_each(scene.rigid_motions, "rigid_motion", [&](const Table& table, RigidMotion& motion, const auto& where) {
    if (motion.where.empty()) motion.where = where;
    table.keys(motion);
    table.require_none(rigid_bodies.reference_problem("rigid_body", "rigid_body", motion.rigid_body));
    table.require_none(problem_of(motion));
    table.require_none(problem_of(motion.table));
    table.require_none(problem_of(motion.when));
  });
  Names joints;
  for_each(scene.joints, "joint", [&](const Table& table, Joint& joint, const auto& where) {
    if (joint.where.empty()) joint.where = where;
    table.require_none(name_problem(joint.name));
    table.require_none(joints.add(joint.name));
    table.keys(joint);
    table.require_none(problem_of(joint));
    table.require_none(problem_of(joint, scene));
  });
}

void check_constraints(Scene& scene, const BodyNames& names) {
  for_each(scene.constraints, "symmetry constraint",
           [&](const Table& table, PlaneConstraint& plane, const auto& where) {
             table.keys(plane);
             names.check_body(table, plane.body);
             table.require_none(force_name_problem(plane.name, scene));
             if (plane.where.empty()) plane.where = where;
           });
  for_each(scene.fixed_constraints, "fixed constraint",
           [&](const Table& table, FixedConstraint& fixed, const auto& where) {
             table.keys(fixed);
             names.check(table, fixed.nodes, where);
             table.require_none(force_name_problem(fixed.name, scene));
             table.require_none(problem_of(fixed.when));
             if (fixed.directions.empty()) table.fail("directions", "expected at least one direction, got none");
             for (const Point& direction : fixed.directions)
               table.require_none(direction_problem("directions", direction));
           });
}

void check_equations(Scene& scene, const BodyNames& names) {
  for_each(scene.equation_terms, "equation", [&](const Table& table, EquationTerm& term, const auto& where) {
    table.require_none(name_problem(term.name));
    table.keys(term);
    names.check(table, term.nodes, where);
    table.require_none(problem_of(term));
  });
}

void check_walls(Scene& scene, const BodyNames& names) {
  Names walls;
  for_each(scene.rigid_walls, "rigid_wall", [&](const Table& table, RigidWall& wall, const auto& where) {
    if (wall.where.empty()) wall.where = where;
    table.require_none(name_problem(wall.name));
    table.require_none(walls.add(wall.name));
    table.keys(wall);
    table.require_none(problem_of(wall.table));
    table.require_none(problem_of(wall));
    table.require_none(problem_of(wall.when));
    names.check_body(table, wall.body);
    names.check_any(table, wall.nodes, wall.where);
  });
}

void check_motion(Scene& scene, const BodyNames& names) {
  for_each(scene.prescribed_velocities, "prescribed_velocity",
           [&](const Table& table, PrescribedVelocity& given, const auto& where) {
             table.keys(given);
             names.check(table, given.nodes, where);
             table.require_none(force_name_problem(given.name, scene));
             table.require_none(problem_of(given.table));
             table.require_none(problem_of(given.when));
           });
  for_each(scene.initial_velocities, "initial_velocity",
           [&](const Table& table, InitialVelocity& given, const auto& where) {
             names.check(table, given.nodes, where);
             table.keys(given);
           });
  for_each(scene.initial_stresses, "initial_stress", [&](const Table& table, InitialStress& given, const auto& where) {
    if (given.elements.empty()) names.check(table, given.nodes, where);
    names.check_any(table, given.nodes, where);
    table.keys(given);
  });
}

void check_loads(Scene& scene, const BodyNames& names) {
  for_each(scene.loads, "load", [&](const Table& table, NodalLoad& load, const auto& where) {
    names.check(table, load.nodes, where);
    table.keys(load);
    table.require_none(problem_of(load.table));
  });
  for_each(scene.point_masses, "point_mass", [&](const Table& table, PointMass& point, const auto& where) {
    names.check(table, point.nodes, where);
    table.keys(point);
  });
  Names pressures;
  for_each(scene.pressures, "pressure", [&](const Table& table, Pressure& pressure, const auto& where) {
    table.require_none(name_problem(pressure.name));
    table.require_none(pressures.add(pressure.name));
    if (pressure.corners.empty()) names.check(table, pressure.faces, where);
    names.check_any(table, pressure.faces, where);
    table.keys(pressure);
    table.require_none(problem_of(pressure.table));
  });
  for_each(scene.gravities, "gravity", [&](const Table& table, Gravity& gravity, const auto&) {
    table.keys(gravity);
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
    table.keys(probe);
    names.check_body(table, probe.body);
  });
}

}  // namespace

Scene checked_scene(Scene scene) {
  complete_scene(scene);
  const auto settings = [](const char* path, auto& table) { Table(path).keys(table); };
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
  for (Body& body : scene.bodies) check_body(body, scene, materials, bodies);
  check_contact(scene);
  const BodyNames names(scene);
  check_rigid_bodies(scene, names);
  check_constraints(scene, names);
  check_equations(scene, names);
  check_walls(scene, names);
  check_motion(scene, names);
  check_loads(scene, names);
  check_probes(scene, names);
  return scene;
}

}  // namespace pinball
