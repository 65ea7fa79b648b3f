#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "../../scene.hpp"
#include "key.hpp"
#include "selection.hpp"

/// The keys of what acts on a scene from outside, and of what is watched in it.
namespace pinball::schema {

/// Of its force in history.csv.
inline constexpr About name_of_force{.form = Form::name, .otherwise = "none"};
inline constexpr std::array<std::string_view, 2> constraint_types{"symmetry", "fixed"};
inline constexpr std::array<std::string_view, 3> component_names{"x", "y", "z"};
inline constexpr std::array<std::string_view, 6> all_probe_quantities{"position", "displacement",     "velocity",
                                                                      "stress",   "effective_stress", "plastic_strain"};
/// A wall has a body and a plane of its own.
inline constexpr std::array<std::string_view, 4> not_of_walls{"body", "plane", "line", "nearest"};

template <class Visit>
constexpr void describe(Of<PlaneConstraint>, Visit&& visit) {
  using T = PlaneConstraint;
  describe_type(visit, constraint_types[0]);
  visit(Key{"name", &T::name, "of its force, see above", name_of_force});
  const auto by_set = [](const T& plane, const Scene&) { return !plane.set.empty(); };
  visit(Key{"point", &T::point, "a point of the plane, which with `set` goes through its nodes", {.unit = "L"}}
            .idle_where(by_set, "beside set"));
  visit(Key{"normal",
            &T::normal,
            "nodes on the plane may not move along it",
            {.unit = "-", .need = Need::required, .form = Form::direction}});
  visit(Key{"body", &T::body, "only nodes of this body", {.otherwise = "all"}});
  visit(Key{"set",
            &T::set,
            "these nodes of the mesh file in the place of those on the plane",
            {.listed = Listed::where_given}});
  visit(Key{"tolerance",
            &T::tolerance,
            "how far from the plane a node may lie; 0: by the mesh",
            {.unit = "L", .bound = not_negative}}
            .idle_where(by_set, "beside set"));
  visit(Field{"where", &T::where, "for messages"});
}

template <class Visit>
constexpr void describe(Of<FixedConstraint>, Visit&& visit) {
  using T = FixedConstraint;
  describe_type(visit, constraint_types[1]);
  visit(Key{"name", &T::name, "of its force, see above", name_of_force});
  visit(Key{"frame", &T::frame,
            "`\"cylindrical\"`: the directions are `\"radial\"`, `\"circumferential\"`, `\"axial\"`, or 3 numbers "
            "along these, at the place that each node has at the start"});
  visit(Key{"directions",
            &T::directions,
            "`\"all\"`, or an array of directions: `\"x\"`, `\"y\"`, `\"z\"` or 3 numbers of any non-zero length",
            {.unit = "-", .need = Need::required, .done = Done::reading_by_hand}});
  visit(
      Key{"axis",
          &T::axis,
          "`{ point = [...], direction = [...] }`",
          {.unit = "L, -", .need = Need::one_of, .otherwise = "required if cylindrical", .done = Done::reading_by_hand}}
          .only_where([](const FixedConstraint& fixed) { return fixed.frame == Frame::cylindrical; },
                      "where frame is not \"cylindrical\""));
  visit(Group{"when", &T::when, "start, end"});
  visit(Group{"nodes", &T::nodes, "which nodes"});
}

template <class Visit>
constexpr void describe(Of<EquationTerm>, Visit&& visit) {
  using T = EquationTerm;
  visit(Key{"name",
            &T::name,
            "of the equation that this is a term of; those of one name add up to zero",
            {.need = Need::required, .form = Form::name}});
  visit(Key{"direction",
            &T::direction,
            "of the displacement that is a term",
            {.unit = "-", .need = Need::required, .form = Form::direction}});
  visit(Key{"factor", &T::factor, "of the displacement along it, not 0", {.unit = "-"}});
  visit(Group{"nodes", &T::nodes, "which nodes; several: an equation for each of them"});
}

template <class Visit>
constexpr void describe(Of<RigidWall>, Visit&& visit) {
  using T = RigidWall;
  visit(Key{"name",
            &T::name,
            "of the columns `NAME_force` and `NAME_impulse` in `history.csv`, counted from 0",
            {.form = Form::name, .otherwise = "wall_NUMBER", .listed = Listed::never}});
  visit(Group{"plane", &T::plane, "the normal points to the free side"});
  visit(Key{"friction", &T::friction, "Coulomb coefficient", {.unit = "-", .bound = not_negative}});
  visit(
      Key{"sliding", &T::sliding, "`false`: nodes do not move along the wall while they touch it; then no `friction`"});
  visit(Key{"edge",
            &T::edge,
            "of a rectangle with a corner in `point`: direction of its first side",
            {.unit = "-", .form = Form::direction, .otherwise = "none"}});
  visit(Key{"size",
            &T::size,
            "of that rectangle: lengths along `edge` and along normal x edge; 0: without end both ways",
            {.unit = "L", .bound = not_negative, .otherwise = "without end", .done = Done::by_hand}});
  visit(Key{"mass",
            &T::mass,
            "> 0: the nodes push it along its normal; it begins with `speed`",
            {.unit = "M", .bound = not_negative}});
  visit(Key{"speed", &T::speed, "at which it moves along the normal", {.unit = "L/T"}});
  visit(Group{"table", &T::table, "of the speed"});
  visit(Group{"when", &T::when, "when it acts"});
  visit(Key{"body", &T::body, "only nodes of this body", {.otherwise = "all"}});
  visit(Group{"nodes", &T::nodes, "only these nodes; nothing given: all", not_of_walls});
  visit(Field{"where", &T::where, "for messages"});
}

template <class Visit>
constexpr void describe(Of<PrescribedVelocity>, Visit&& visit) {
  using T = PrescribedVelocity;
  visit(Key{"name", &T::name, "of its force, see above", name_of_force});
  visit(Key{
      "velocity",
      &T::velocity,
      "all three components",
      {.unit = "L/T", .need = Need::one_of, .otherwise = "required, or the next two", .done = Done::reading_by_hand}});
  visit(Key{"direction",
            &T::direction,
            "only the component along it; the others are free",
            {.unit = "-", .form = Form::direction, .otherwise = "all three"}});
  visit(FileKey<double>{"speed",
                        "along the direction",
                        {.unit = "L/T", .need = Need::one_of, .otherwise = "required beside `direction`"}});
  visit(Key{"quantity", &T::quantity,
            "what the factors make of it: with `\"displacement\"` and `\"acceleration\"` `velocity` and `speed` are "
            "lengths and accelerations"});
  visit(Group{"table", &T::table, "factors"});
  visit(Group{"when", &T::when, "nodes are free before and after; factors are of the time of the run"});
  visit(Group{"nodes", &T::nodes, "which nodes"});
}

template <class Visit>
constexpr void describe(Of<NodalLoad>, Visit&& visit) {
  using T = NodalLoad;
  visit(Key{"force", &T::force, "on all the nodes together", {.unit = "M L/T^2", .need = Need::required}});
  visit(Key{"each", &T::each, "`true`: on each of the nodes"});
  visit(Group{"table", &T::table, "factors"});
  visit(Group{"nodes", &T::nodes, "which nodes"});
}

template <class Visit>
constexpr void describe(Of<Pressure>, Visit&& visit) {
  using T = Pressure;
  visit(Key{"name",
            &T::name,
            "of the columns `NAME_force_x`, `_y`, `_z` and `NAME_work` in `history.csv`, counted from 0",
            {.form = Form::name, .otherwise = "pressure_NUMBER", .listed = Listed::never}});
  visit(Key{
      "pressure", &T::pressure, "positive: it presses on the faces", {.unit = "M/(L T^2)", .need = Need::required}});
  visit(Key{"start", &T::start, "before it there is none; times count from it", {.unit = "T"}});
  visit(Group{"table", &T::table, "factors"});
  visit(Key{"faces",
            &T::corners,
            "`[[1, 2, 6, 5], ...]`: their nodes by the numbers of the mesh file; of a triangle the last one twice",
            {.bound = {.low = 0}, .field = "corners", .listed = Listed::where_given}});
  visit(Group{"faces", &T::faces, "which faces: those of a set, or the exposed ones with all corners here"});
}

template <class Visit>
constexpr void describe(Of<Gravity>, Visit&& visit) {
  using T = Gravity;
  visit(Key{"name", &T::name, "of its force, see above", name_of_force});
  visit(Key{
      "acceleration", &T::acceleration, "force over mass on every node", {.unit = "L/T^2", .need = Need::required}});
  visit(Key{"bodies",
            &T::bodies,
            "names of those that feel it",
            {.otherwise = "all", .done = Done::reading_by_hand, .listed = Listed::where_given}});
  visit(Group{"table", &T::table, "factors"});
}

template <class Visit>
constexpr void describe(Of<PointMass>, Visit&& visit) {
  using T = PointMass;
  visit(Key{"mass",
            &T::mass,
            "of all the nodes together, shared in proportion to the masses of their elements",
            {.unit = "M", .bound = positive, .need = Need::required}});
  visit(Key{"each", &T::each, "`true`: of each of the nodes"});
  visit(Group{"nodes", &T::nodes, "which nodes; of a node that several tables have the masses add up"});
}

template <class Visit>
constexpr void describe(Of<InitialVelocity>, Visit&& visit) {
  using T = InitialVelocity;
  visit(Key{"velocity",
            &T::velocity,
            "required, or the next one; the last table that selects a node counts",
            {.unit = "L/T"}});
  visit(Key{"angular_velocity", &T::angular_velocity, "adds a spin about an axis through `centre`", {.unit = "1/T"}});
  visit(Key{"centre", &T::centre, "a point of that axis", {.unit = "L"}}.idle_where(
      [](const T& given, const Scene&) { return given.angular_velocity == Point{}; }, "without angular_velocity"));
  visit(FileKey<std::vector<std::string>>{"components",
                                          "only these are set, the others stay as they were",
                                          {.otherwise = "all", .texts = component_names}});
  visit(Field{"components", &T::components, "those that are set"});
  visit(Group{"nodes", &T::nodes, "which nodes"});
}

template <class Visit>
constexpr void describe(Of<InitialStress>, Visit&& visit) {
  using T = InitialStress;
  visit(Key{
      "stress",
      &T::stress,
      "xx, yy, zz of Cauchy's stress, along x, y, z as the mesh lies; the last table that selects an element counts",
      {.unit = "M/(L T^2)"}});
  visit(Key{"shear_stress", &T::shear_stress, "xy, yz, zx", {.unit = "M/(L T^2)"}});
  visit(Key{"plastic_strain", &T::plastic_strain, "effective, of what yields", {.unit = "-", .bound = not_negative}});
  visit(Key{"elements",
            &T::elements,
            "`[11, 12, ...]`: the numbers that the mesh file gives its elements",
            {.bound = {.low = 0}, .listed = Listed::where_given}});
  visit(Group{"nodes", &T::nodes, "which elements: those of a set or a part, or those with all corners here"});
}

template <class Visit>
constexpr void describe(Of<Probe>, Visit&& visit) {
  using T = Probe;
  visit(Key{"name",
            &T::name,
            "unique, also among the bodies",
            {.need = Need::required, .form = Form::name, .listed = Listed::never}});
  visit(Key{"kind", &T::kind, "what is watched"});
  visit(
      Key{"point",
          &T::point,
          "the node, or the element whose centre, is nearest to this point at the start is watched",
          {.unit = "L", .need = Need::one_of, .otherwise = "required, or the next one", .done = Done::reading_by_hand}}
          .only_where([](const Probe& probe) { return !probe.number; }));
  visit(FileKey<std::int64_t>{"node",
                              "its number in the mesh file of `body`, which may be left out where there is "
                              "only one file",
                              {.bound = {.low = 0}, .need = Need::one_of, .otherwise = "required, or the one above"}});
  visit(FileKey<std::int64_t>{
      "element", "the same", {.bound = {.low = 0}, .need = Need::one_of, .otherwise = "required, or those above"}});
  visit(Field{"number", &T::number, "of the node or the element in the mesh file of its body"});
  visit(Key{"body", &T::body, "only of this body", {.otherwise = "all"}});
  visit(Key{"quantities",
            &T::quantities,
            "of nodes the first three, of elements the others",
            {.otherwise = "all of the kind", .done = Done::by_hand, .texts = all_probe_quantities}});
  visit(Field{"where", &T::where, "for messages"});
}

}  // namespace pinball::schema
