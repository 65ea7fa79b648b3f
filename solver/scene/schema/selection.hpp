#pragma once

#include <optional>
#include <type_traits>

#include "../../scene.hpp"
#include "key.hpp"

/// The keys that tables of boundary conditions have in common: which nodes, and when.
namespace pinball::schema {

template <class Visit>
constexpr void describe(Of<Plane>, Visit&& visit) {
  visit(Key{"point", &Plane::point, "a point of it", {.unit = "L"}});
  visit(Key{"normal", &Plane::normal, "across it", {.unit = "-", .need = Need::required, .form = Form::direction}});
}

template <class Visit>
constexpr void describe(Of<Line>, Visit&& visit) {
  visit(Key{"point", &Line::point, "a point of it", {.unit = "L"}});
  visit(Key{"direction", &Line::direction, "along it", {.unit = "-", .need = Need::required, .form = Form::direction}});
}

template <class Visit>
constexpr void describe(Of<Box>, Visit&& visit) {
  visit(Key{"low", &Box::low, "a corner", {.unit = "L", .need = Need::required}});
  visit(Key{
      "high", &Box::high, "the opposite corner, no component < that of `low`", {.unit = "L", .need = Need::required}});
}

template <>
struct IsInnerTable<Plane> : std::true_type {};
template <>
struct IsInnerTable<Line> : std::true_type {};
template <>
struct IsInnerTable<Box> : std::true_type {};

/// Whether neither a set nor a number says what of a mesh file is selected.
inline bool nothing_of_a_file(const NodeSelection& nodes, const Scene& scene) {
  for (const Pressure& pressure : scene.pressures) {
    if (&pressure.faces == &nodes && !pressure.corners.empty()) return false;
  }
  for (const InitialStress& given : scene.initial_stresses) {
    if (&given.nodes == &nodes && !given.elements.empty()) return false;
  }
  return nodes.set.empty() && nodes.nodes.empty() && nodes.without.empty();
}

template <class Visit>
constexpr void describe(Of<NodeSelection>, Visit&& visit) {
  using T = NodeSelection;
  visit(Key{"body", &T::body, "nodes of this body", {.otherwise = "all"}});
  visit(Key{"plane",
            &T::plane,
            "`{ point = [...], normal = [...] }`: nodes on the plane",
            {.unit = "L, -", .listed = Listed::where_given}});
  visit(Key{"line",
            &T::line,
            "`{ point = [...], direction = [...] }`: nodes on the line",
            {.unit = "L, -", .listed = Listed::where_given}});
  visit(Key{"box",
            &T::box,
            "`{ low = [...], high = [...] }`: nodes in the box, its faces included",
            {.unit = "L", .listed = Listed::where_given}});
  visit(Key{"nearest",
            &T::nearest,
            "of these nodes the one nearest to the point",
            {.unit = "L", .listed = Listed::where_given}});
  visit(Key{"set",
            &T::set,
            "name or number of a set in the mesh file of the bodies; of faces, elements or a part: their nodes",
            {.listed = Listed::where_given}});
  visit(Key{"nodes",
            &T::nodes,
            "`[11, 12, ...]`: the numbers that the mesh file gives its nodes",
            {.bound = {.low = 0}, .listed = Listed::where_given}});
  visit(Key{"file",
            &T::file,
            "the mesh file of sets and numbers, where bodies are from several",
            {.listed = Listed::where_given}}
            .idle_where(nothing_of_a_file, "without set, nodes or without"));
  visit(Key{"without", &T::without, "a set whose nodes are left out", {.listed = Listed::where_given}});
  visit(Key{"tolerance",
            &T::tolerance,
            "how far from plane, line and box a node may lie; 0: by the mesh",
            {.unit = "L", .bound = not_negative, .listed = Listed::where_given}}
            .idle_where([](const T& nodes, const Scene&) { return !nodes.plane && !nodes.line && !nodes.box; },
                        "without plane, line or box"));
  visit(Field{"where", &T::where, "for messages"});
}

template <class Visit>
constexpr void describe(Of<TimeTable>, Visit&& visit) {
  using T = TimeTable;
  visit(Key{"times", &T::times, "increasing", {.unit = "T", .listed = Listed::where_given}});
  visit(Key{"factors", &T::factors, "one per time, linear between them", {.unit = "-", .otherwise = "1 at all times"}});
}

template <class Visit>
constexpr void describe(Of<TimeSpan>, Visit&& visit) {
  using T = TimeSpan;
  visit(Key{"start", &T::start, "when it begins to act; not above 0: from the beginning", {.unit = "T"}});
  visit(Key{"end", &T::end, "when it ends to act", {.unit = "T", .unset = Unset::infinite, .otherwise = "never"}});
}

}  // namespace pinball::schema
