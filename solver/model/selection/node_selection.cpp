#include "node_selection.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/base/point.hpp>

#include "named_nodes.hpp"

namespace pinball {

namespace {

std::string text(const Point& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]); }

double distance(const Point& p, const Line& line) {
  const Point d = minus(p, line.point);
  const double along = dot(d, line.direction);
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) square += std::pow(d[k] - along * line.direction[k], 2);
  return std::sqrt(square);
}

bool inside(const Point& p, const Box& box, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (p[k] < box.low[k] - tolerance || p[k] > box.high[k] + tolerance) return false;
  }
  return true;
}

}  // namespace

double mesh_size(const ModelMesh& mesh) {
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto by_component = [k](const Point& a, const Point& b) { return a[k] < b[k]; };
    const auto [low, high] = std::minmax_element(mesh.nodes.begin(), mesh.nodes.end(), by_component);
    if (low != mesh.nodes.end()) size = std::max(size, (*high)[k] - (*low)[k]);
  }
  return size;
}

std::string describe(const NodeSelection& s) {
  std::string words;
  const auto add = [&words](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
  if (s.plane) add(fmt::format("on the plane through {} with normal {}", text(s.plane->point), text(s.plane->normal)));
  if (s.line) add(fmt::format("on the line through {} along {}", text(s.line->point), text(s.line->direction)));
  if (s.box) add(fmt::format("in the box from {} to {}", text(s.box->low), text(s.box->high)));
  if (s.nearest) add("nearest to " + text(*s.nearest));
  if (!s.set.empty()) add("in the set " + s.set);
  if (!s.nodes.empty()) add(fmt::format("among the {} that are listed", s.nodes.size()));
  if (!s.body.empty()) add("of body " + s.body);
  if (!s.without.empty()) add("not in the set " + s.without);
  return words;
}

namespace {

std::vector<std::int32_t> all_nodes(const ModelMesh& mesh) {
  std::vector<std::int32_t> nodes(mesh.nodes.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

void keep_common(std::vector<std::int32_t>& nodes, const std::vector<std::int32_t>& others) {
  std::erase_if(nodes, [&](std::int32_t n) { return !std::binary_search(others.begin(), others.end(), n); });
}

}  // namespace

PlaceTolerance::PlaceTolerance(const ModelMesh& mesh, double given) : mesh_(mesh), given_(given) {
  double furthest = 0;
  for (const Point& node : mesh.nodes) {
    for (const double x : node) furthest = std::max(furthest, std::abs(x));
  }
  rounding_ = 2e-6 * furthest;
  least_ = 1e-9 * mesh_size(mesh);
}

double PlaceTolerance::of(std::int32_t node) const {
  if (given_ > 0) return given_;
  const double edge = edge_of(node);
  return std::max(least_, std::min(1e-2 * edge, std::max(1e-3 * edge, rounding_)));
}

double PlaceTolerance::near(std::int32_t node) const { return std::max(of(node), 0.1 * edge_of(node)); }

namespace {

/// The nodes that fulfil what is not said by places.
std::vector<std::int32_t> named_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  std::vector<std::int32_t> nodes;
  bool all = true;
  const auto keep = [&](std::vector<std::int32_t> others) {  // the whole mesh is looked through where nothing else says
    if (!std::exchange(all, false)) return keep_common(nodes, others);
    nodes = std::move(others);
  };
  if (!selection.set.empty()) keep(nodes_of_set(mesh, selection, selection.set));
  if (!selection.nodes.empty()) keep(numbered_nodes(mesh, selection));
  if (!selection.body.empty()) keep(nodes_of_body(mesh, selection.body));
  if (all) nodes = all_nodes(mesh);
  if (!selection.without.empty()) {
    const std::vector<std::int32_t> others = nodes_of_set(mesh, selection, selection.without);
    std::erase_if(nodes, [&](std::int32_t n) { return std::binary_search(others.begin(), others.end(), n); });
  }
  return nodes;
}

bool lies_in(const NodeSelection& selection, const Point& place, double tolerance) {
  const auto& plane = selection.plane;
  if (plane && std::abs(dot(minus(place, plane->point), plane->normal)) > tolerance) return false;
  if (selection.line && distance(place, *selection.line) > tolerance) return false;
  return !selection.box || inside(place, *selection.box, tolerance);
}

bool by_place(const NodeSelection& selection) { return selection.plane || selection.line || selection.box; }

}  // namespace

bool selects_by_place(const Scene& scene) {
  const auto any = [](const auto& items, auto member) {
    return std::ranges::any_of(items, [member](const auto& item) { return by_place(item.*member); });
  };
  return !scene.constraints.empty() || !scene.rigid_walls.empty() ||
         any(scene.fixed_constraints, &FixedConstraint::nodes) || any(scene.equation_terms, &EquationTerm::nodes) ||
         any(scene.attached_nodes, &AttachedNodes::nodes) ||
         any(scene.prescribed_velocities, &PrescribedVelocity::nodes) || any(scene.loads, &NodalLoad::nodes) ||
         any(scene.pressures, &Pressure::faces) || any(scene.point_masses, &PointMass::nodes) ||
         any(scene.initial_velocities, &InitialVelocity::nodes) || any(scene.initial_stresses, &InitialStress::nodes);
}

SelectedNodes selected_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  SelectedNodes found{named_nodes(mesh, selection), 0};
  if (by_place(selection)) {
    const PlaceTolerance tolerance(mesh, selection.tolerance);
    std::erase_if(found.nodes, [&](std::int32_t n) {
      const Point& place = mesh.nodes[n];
      if (lies_in(selection, place, tolerance.of(n))) return false;
      if (lies_in(selection, place, tolerance.near(n))) ++found.near;
      return true;
    });
  }
  if (!selection.nearest || found.nodes.empty()) return found;
  const auto square = [&](std::int32_t n) {
    const Point d = minus(mesh.nodes[n], *selection.nearest);
    return dot(d, d);
  };
  const auto nearer = [&](std::int32_t a, std::int32_t b) { return square(a) < square(b); };
  return {{*std::min_element(found.nodes.begin(), found.nodes.end(), nearer)}, 0};
}

std::vector<std::int32_t> matching_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  return selected_nodes(mesh, selection).nodes;
}

std::vector<std::int32_t> select_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  std::vector<std::int32_t> nodes = matching_nodes(mesh, selection);
  if (nodes.empty()) {
    throw InputError(
        fmt::format("{}: expected at least one node, there is none {}", selection.where, describe(selection)));
  }
  return nodes;
}

NodeSelection nodes_of(const PlaneConstraint& plane) {
  NodeSelection nodes{.where = plane.where, .body = plane.body, .set = plane.set};
  if (plane.set.empty()) nodes.plane = Plane{plane.point, plane.normal};
  nodes.tolerance = plane.tolerance;
  return nodes;
}

NodeSelection nodes_of(const RigidWall& wall) {
  NodeSelection nodes = wall.nodes;
  if (!wall.body.empty()) nodes.body = wall.body;
  if (nodes.where.empty()) nodes.where = wall.where;
  return nodes;
}

}  // namespace pinball
