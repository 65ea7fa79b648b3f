#include "node_selection.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <solver/base/error.hpp>
#include <solver/base/point.hpp>

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
  if (!s.body.empty()) add("of body " + s.body);
  return words;
}

std::vector<std::int32_t> matching_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  const double tolerance = 1e-9 * mesh_size(mesh);
  std::vector<std::int32_t> nodes;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Point& p = mesh.nodes[n];
    const std::string& body = mesh.body_names[mesh.body_of_node[n]];
    if (!selection.body.empty() && selection.body != body) continue;
    const auto& plane = selection.plane;
    if (plane && std::abs(dot(minus(p, plane->point), plane->normal)) > tolerance) continue;
    if (selection.line && distance(p, *selection.line) > tolerance) continue;
    if (selection.box && !inside(p, *selection.box, tolerance)) continue;
    nodes.push_back(static_cast<std::int32_t>(n));
  }
  if (!selection.nearest || nodes.empty()) return nodes;
  const auto square = [&](std::int32_t n) {
    const Point d = minus(mesh.nodes[n], *selection.nearest);
    return dot(d, d);
  };
  return {*std::min_element(nodes.begin(), nodes.end(),
                            [&](std::int32_t a, std::int32_t b) { return square(a) < square(b); })};
}

std::vector<std::int32_t> select_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  std::vector<std::int32_t> nodes = matching_nodes(mesh, selection);
  if (nodes.empty()) {
    throw InputError(
        fmt::format("{}: expected at least one node, there is none {}", selection.where, describe(selection)));
  }
  return nodes;
}

}  // namespace pinball
