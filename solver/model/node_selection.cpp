#include "node_selection.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <solver/base/error.hpp>
#include <solver/base/point.hpp>
#include <solver/base/text_distance.hpp>

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
  return words;
}

namespace {

std::vector<std::int32_t> all_nodes(const ModelMesh& mesh) {
  std::vector<std::int32_t> nodes(mesh.nodes.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

/// Those of a body that it has to itself, and those that it shares.
std::vector<std::int32_t> nodes_of_body(const ModelMesh& mesh, const std::string& name) {
  const auto found = std::ranges::find(mesh.body_names, name);
  if (found == mesh.body_names.end()) return {};
  const auto body = static_cast<std::int32_t>(found - mesh.body_names.begin());
  std::vector<std::int32_t> nodes = mesh.shared[body];
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.body_of_node[n] == body) nodes.push_back(static_cast<std::int32_t>(n));
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// The file that a set or numbers of nodes are of. Throws InputError where that is not one.
const FileNodes& file_of(const ModelMesh& mesh, const NodeSelection& selection) {
  const auto fail = [&](const std::string& problem) {
    throw InputError(fmt::format("{}: {}", selection.where, problem));
  };
  if (mesh.files.empty()) fail("sets and numbers of nodes are those of a mesh file, and no body is from one");
  if (selection.file.empty()) {
    if (mesh.files.size() > 1)
      fail("expected file, the mesh file that the set or the numbers are of: there are several");
    return mesh.files.front();
  }
  std::vector<std::string> known;
  for (const FileNodes& file : mesh.files) {
    if (file.path.ends_with(selection.file)) return file;
    known.push_back(file.path);
  }
  fail(fmt::format("no body is from a mesh file {}, nearest is {}", selection.file, nearest(selection.file, known)));
  return mesh.files.front();
}

std::vector<std::int32_t> nodes_of_set(const ModelMesh& mesh, const NodeSelection& selection) {
  const FileNodes& file = file_of(mesh, selection);
  const MeshSet* set = find_set(file.sets, selection.set);
  if (set == nullptr) {
    std::vector<std::string> known = set_names(file.sets);
    throw InputError(
        fmt::format("{}: {} has no set of nodes \"{}\"{}", selection.where, file.path, selection.set,
                    known.empty() ? "" : fmt::format(", nearest is \"{}\"", nearest(selection.set, known))));
  }
  if (!set->problem.empty()) throw InputError(fmt::format("{}: {}", selection.where, set->problem));
  return set->members;
}

std::vector<std::int32_t> numbered_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  const FileNodes& file = file_of(mesh, selection);
  std::vector<std::int32_t> nodes;
  for (const std::int64_t number : selection.nodes) {
    const auto found = std::lower_bound(file.numbers.begin(), file.numbers.end(), std::pair{number, std::int32_t{-1}});
    if (found == file.numbers.end() || found->first != number) {
      throw InputError(fmt::format("{}: {} has no node {} that a body uses", selection.where, file.path, number));
    }
    nodes.push_back(found->second);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void keep_common(std::vector<std::int32_t>& nodes, const std::vector<std::int32_t>& others) {
  std::erase_if(nodes, [&](std::int32_t n) { return !std::binary_search(others.begin(), others.end(), n); });
}

}  // namespace

std::vector<std::int32_t> matching_nodes(const ModelMesh& mesh, const NodeSelection& selection) {
  std::vector<std::int32_t> nodes = selection.body.empty() ? all_nodes(mesh) : nodes_of_body(mesh, selection.body);
  if (!selection.set.empty()) keep_common(nodes, nodes_of_set(mesh, selection));
  if (!selection.nodes.empty()) keep_common(nodes, numbered_nodes(mesh, selection));
  const double tolerance = 1e-9 * mesh_size(mesh);
  std::erase_if(nodes, [&](std::int32_t n) {
    const Point& p = mesh.nodes[n];
    const auto& plane = selection.plane;
    if (plane && std::abs(dot(minus(p, plane->point), plane->normal)) > tolerance) return true;
    if (selection.line && distance(p, *selection.line) > tolerance) return true;
    return selection.box && !inside(p, *selection.box, tolerance);
  });
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
