#pragma once

#include <array>
#include <string>
#include <vector>

#include "../../scene.hpp"
#include "boundary.hpp"
#include "choices.hpp"
#include "contact.hpp"
#include "key.hpp"
#include "material.hpp"
#include "meshes.hpp"
#include "rigid.hpp"
#include "settings.hpp"

/// The keys of bodies and of the scene itself, and all others with them.
namespace pinball::schema {

/// Whether another table gives all nodes of a body their initial velocities.
inline bool has_other_velocity(const Body& body, const Scene& scene) {
  for (const RigidBody& rigid : scene.rigid_bodies) {
    if (!rigid.velocity && !rigid.angular_velocity) continue;
    for (const std::string& name : rigid.bodies) {
      if (name == body.name) return true;
    }
  }
  for (const InitialVelocity& given : scene.initial_velocities) {
    NodeSelection nodes = given.nodes;
    if (nodes.body != body.name || !nodes.without.empty()) continue;
    nodes.body.clear();
    if (nodes.all() && given.components == std::array{true, true, true}) return true;
  }
  return false;
}

template <class Visit>
constexpr void describe(Of<Body>, Visit&& visit) {
  using T = Body;
  const auto where_it_counts = [&visit](const auto& key) {
    visit(key.idle_where(has_other_velocity,
                         "where an initial_velocity or its rigid_body gives all of its nodes theirs"));
  };
  visit(Key{"name", &T::name, "unique", {.need = Need::required, .form = Form::name, .listed = Listed::never}});
  visit(Key{"material", &T::material, "name of a `[[material]]`", {.need = Need::required}});
  visit(FileKey<MeshSettings>{"mesh", "table, see below", {.need = Need::required}});
  visit(Field{"mesh", &T::mesh, "by a generator, from a file or of arrays"});
  visit(
      Key{"elements", &T::elements,
          "`\"tetrahedra\"`: each hexahedron of a generated mesh is cut into six, as those of meshes that have them"});
  visit(Key{"position", &T::position, "translation, after the rotation", {.unit = "L"}});
  visit(Key{"axis",
            &T::axis,
            "the body's z axis is turned onto this direction by the shortest rotation",
            {.unit = "-", .form = Form::direction, .otherwise = "not turned"}});
  where_it_counts(Key{"velocity", &T::velocity, "initial, uniform", {.unit = "L/T"}});
  where_it_counts(
      Key{"angular_velocity", &T::angular_velocity, "initial rigid spin about the body's centroid", {.unit = "1/T"}});
  where_it_counts(Key{"velocity_gradient",
                      &T::velocity_gradient,
                      "3 rows of 3: adds G (x - centroid) to the initial velocity",
                      {.unit = "1/T"}});
  where_it_counts(Key{"velocity_noise",
                      &T::velocity_noise,
                      "adds a pseudo-random velocity of this amplitude, the same in every run",
                      {.unit = "L/T", .bound = not_negative}});
  visit(Key{"element",
            &T::element,
            "table with keys of `[element]` that this body has in their place: `element = { hourglass = \"viscous\", "
            "linear_viscosity = 0.1 }`",
            {.otherwise = "that of the scene", .done = Done::reading_by_hand}});
}

/// [variant.NAME]: any dotted keys with values.
struct Variants {};

/// A table of the top level, or several of one name, and the member that has them.
template <class T, class Part>
struct Tables : Field<T, Part> {
  const char* name;

  constexpr Tables(const char* name_, const char* field_, Part T::*member_, const char* meaning_)
      : Field<T, Part>(field_, member_, meaning_), name(name_) {}
};

template <class Visit>
constexpr void describe(Of<Scene>, Visit&& visit) {
  using T = Scene;
  visit(Field{"name", &T::name, "of the file, without folder and ending"});
  visit(Field{"path", &T::path, "the file it was read from"});
  visit(Key{"title", &T::title, "one line for people"});
  visit(Key{"units", &T::units, "name of the consistent set of units, such as `\"in-lbf-s\"` (above)"});
  visit(Key{"precision", &T::precision,
            "of numbers; `\"mixed\"`: of elements single, of all else double precision; `--precision` overrides it"});
  visit(Field{"device", &T::device, "where steps are made: of no file"});
  visit(Field{"refine", &T::refine, "already in the numbers of elements"});
  visit(Field{"of_deck", &T::of_deck, "of a deck that says nothing of contact"});
  visit(Tables{"time", "time", &T::time, "how long, and in which steps"});
  visit(Tables{"element", "element", &T::element, "what elements do beside their material"});
  visit(Tables{"contact", "contact", &T::contact, "what happens where bodies meet"});
  visit(Field{"contact_pairs", &T::contact_pairs, "contact.pair: what may touch what; none: all touches all"});
  visit(Field{"tied_contacts", &T::tied_contacts, "contact.tied: nodes that move with faces"});
  visit(Tables{"skip", "skip", &T::skip, "work that may be left out"});
  visit(Tables{"guard", "guard", &T::guard, "when a run stops because something is wrong"});
  visit(Tables{"output", "output", &T::output, "what a run leaves"});
  visit(Tables{"material", "materials", &T::materials, "what bodies are of"});
  visit(Tables{"body", "bodies", &T::bodies, "what moves"});
  visit(Tables{"rigid_body", "rigid_bodies", &T::rigid_bodies, "bodies that do not deform"});
  visit(Tables{"rigid_nodes", "attached_nodes", &T::attached_nodes, "nodes that move with a rigid body"});
  visit(Tables{"rigid_motion", "rigid_motions", &T::rigid_motions, "rigid bodies that move as given"});
  visit(Tables{"joint", "joints", &T::joints, "how rigid bodies move with each other"});
  visit(Tables{"constraint", "symmetry_planes", &T::constraints, "nodes on a plane do not move across it"});
  visit(Tables{"constraint", "fixed", &T::fixed_constraints, "nodes do not move along some directions"});
  visit(Tables{"equation", "equation_terms", &T::equation_terms, "displacements that add up to zero"});
  visit(Tables{"rigid_wall", "rigid_walls", &T::rigid_walls, "planes that nodes do not cross"});
  visit(Tables{"prescribed_velocity", "prescribed_velocities", &T::prescribed_velocities, "nodes that move as given"});
  visit(Tables{"load", "loads", &T::loads, "forces on nodes"});
  visit(Tables{"pressure", "pressures", &T::pressures, "on faces of elements"});
  visit(Tables{"gravity", "gravities", &T::gravities, "accelerations of bodies"});
  visit(Tables{"point_mass", "point_masses", &T::point_masses, "at nodes, beside those of elements"});
  visit(Tables{"initial_velocity", "initial_velocities", &T::initial_velocities, "of nodes, in place of their body's"});
  visit(Tables{"initial_stress", "initial_stresses", &T::initial_stresses, "of elements at the start"});
  visit(Tables{"damping", "damping", &T::damping, "of all nodes"});
  visit(Tables{"probe", "probes", &T::probes, "history of a node or an element"});
  visit(FileKey<Variants>{"variant", "`[variant.NAME]`: changes of keys that `--set variant=NAME` makes"});
}

}  // namespace pinball::schema
