#include "piercing_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <solver/base/face_corners.hpp>
#include <solver/contact/search/box_pairs.hpp>

namespace pinball {

namespace {

/// Cosine between an edge and the normal of a face that it goes through steeply, and between the normals of two faces
/// that it goes through one after the other.
constexpr double steep = 0.3, opposed = -0.3;
/// Extent of a common box in which bodies lie on each other, over that of its longest side.
constexpr double flat = 1e-6;
/// Elements of both in the common box from which on nobody looks: less than a tenth of a second goes there. So many are
/// fine enough for points of them to lie in what they go through.
constexpr std::size_t most_elements = 20000;
/// Where an edge inside a body is looked at: not in the middle alone, where faces between elements may lie.
constexpr std::array<double, 3> looked_at = {0.29, 0.5, 0.71};

using FaceNodes = std::array<std::int32_t, 4>;
using EdgeNodes = std::pair<std::int32_t, std::int32_t>;

Bounds bounds_of(const ModelMesh& mesh, const std::int32_t* nodes, std::size_t count) {
  Bounds bounds;
  for (std::size_t i = 0; i < count; ++i) bounds.take(mesh.nodes[nodes[i]]);
  return bounds;
}

std::vector<std::size_t> elements_in(const ModelMesh& mesh, const BodyParts& body, const Bounds& box) {
  std::vector<std::size_t> elements;
  for (const std::size_t e : body.elements) {
    if (!common(bounds_of(mesh, mesh.hexahedra[e].data(), 8), box).empty()) elements.push_back(e);
    if (elements.size() > most_elements) break;
  }
  return elements;
}

/// Faces of elements that meet a box and have none of these on the other side: other elements of the body have no face
/// in common with them that meets it.
std::vector<FaceNodes> surface_in(const ModelMesh& mesh, const std::vector<std::size_t>& elements, const Bounds& box) {
  std::vector<std::pair<FaceNodes, FaceNodes>> faces;  // by their keys
  for (const std::size_t e : elements) {
    for (std::size_t f = 0; f < 6; ++f) {
      const FaceNodes nodes = face_of(mesh.hexahedra[e], f);
      const FaceNodes key = face_key(nodes);
      if (key[2] >= 0) faces.emplace_back(key, nodes);
    }
  }
  std::ranges::sort(faces);
  std::vector<FaceNodes> surface;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].first == faces[i].first) ++end;
    const FaceNodes& nodes = faces[i].second;
    if (end == i + 1 && !common(bounds_of(mesh, nodes.data(), 4), box).empty()) surface.push_back(nodes);
    i = end;
  }
  return surface;
}

std::vector<EdgeNodes> edges_of(const std::vector<FaceNodes>& faces) {
  std::vector<EdgeNodes> edges;
  for (const FaceNodes& nodes : faces) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int32_t from = nodes[i], to = nodes[(i + 1) % 4];
      if (from != to) edges.emplace_back(std::min(from, to), std::max(from, to));
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// A place where an edge goes through a triangle.
struct Crossing {
  double at = 0;     ///< from 0 to 1 along the edge
  double slope = 0;  ///< cosine between the edge and the normal; negative: it goes in
  Point normal{};    ///< outwards, of unit length
};

void add_crossing(const std::array<Point, 3>& x, const Point& from, const Point& way, std::vector<Crossing>& found) {
  const Point a = minus(x[1], x[0]), b = minus(x[2], x[0]);
  Point normal = cross(a, b);
  const double along = dot(way, normal), twice_area = norm(normal);
  if (!(twice_area > collapsed_share * norm(a) * norm(b)) || along == 0) return;
  const Point to = minus(x[0], from);
  const double at = dot(to, normal) / along;
  if (!(at > 0 && at < 1)) return;
  Point out = to;  // from the point in the plane to corner 0
  for (std::size_t k = 0; k < 3; ++k) out[k] -= at * way[k];
  const double scale = twice_area * twice_area;
  const double u = -dot(cross(out, b), normal) / scale, v = -dot(cross(a, out), normal) / scale;
  if (u < 0 || v < 0 || u + v > 1) return;
  for (double& n : normal) n /= twice_area;
  found.push_back({at, along / (twice_area * norm(way)), normal});
}

bool goes_through(std::vector<Crossing>& crossings, const Point& from, const Point& way, const BodyInside& body,
                  const Bounds& box, double depth) {
  std::ranges::sort(crossings, {}, &Crossing::at);
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const Crossing &in = crossings[i], &out = crossings[i + 1];
    if (!(in.slope < 0 && out.slope > 0)) continue;
    const bool across = in.slope < -steep && out.slope > steep && dot(in.normal, out.normal) < opposed;
    const double length = (out.at - in.at) * norm(way);
    const bool inside = std::ranges::any_of(looked_at, [&](double part) {
      const double at = in.at + part * (out.at - in.at);
      const Point x = {from[0] + at * way[0], from[1] + at * way[1], from[2] + at * way[2]};
      return box.holds(x) && (across ? body.depth_at(x) > depth * length : body.holds(x, depth));
    });
    if (inside) return true;
  }
  return false;
}

/// Edges of the first surface that go through the second body.
std::int64_t edges_through(const ModelMesh& mesh, const std::vector<FaceNodes>& of, const std::vector<FaceNodes>& faces,
                           const BodyParts& in, const Bounds& box, double depth) {
  const std::vector<EdgeNodes> edges = edges_of(of);
  if (edges.empty() || faces.empty()) return 0;
  const auto first_edge = static_cast<std::int32_t>(faces.size());
  MovingBoxes<double> boxes(first_edge + static_cast<std::int32_t>(edges.size()));
  const auto set = [&](std::int32_t number, const Bounds& bounds) {
    MovingBox<double> moving = empty_box<double>();
    for (std::size_t k = 0; k < 3; ++k) {
      moving.bound[k] = moving.bound[6 + k] = bounds.low[k];
      moving.bound[3 + k] = moving.bound[9 + k] = bounds.high[k];
    }
    boxes.set(number, moving);
  };
  for (std::int32_t f = 0; f < first_edge; ++f) set(f, bounds_of(mesh, faces[f].data(), 4));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::array<std::int32_t, 2> nodes = {edges[i].first, edges[i].second};
    set(first_edge + static_cast<std::int32_t>(i), bounds_of(mesh, nodes.data(), 2));
  }
  BoxPairs<double> pairs;
  pairs.find(boxes, ContactSearch::tree,
             [first_edge](std::int32_t a, std::int32_t b) { return a < first_edge && b >= first_edge; });
  std::vector<std::pair<std::int32_t, std::int32_t>> near;  // edges and faces
  for (std::int64_t piece = 0; piece < fixed_pieces; ++piece) {
    const auto firsts = pairs.firsts(piece), seconds = pairs.seconds(piece);
    for (std::size_t p = 0; p < firsts.size(); ++p) near.emplace_back(seconds[p] - first_edge, firsts[p]);
  }
  std::ranges::sort(near);
  const BodyInside body(mesh, in.elements, box);
  std::int64_t count = 0;
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < near.size();) {
    const std::int32_t edge = near[i].first;
    const Point& from = mesh.nodes[edges[edge].first];
    const Point way = minus(mesh.nodes[edges[edge].second], from);
    crossings.clear();
    for (; i < near.size() && near[i].first == edge; ++i) {
      const FaceNodes& nodes = faces[near[i].second];
      const auto x = [&](std::size_t k) -> const Point& { return mesh.nodes[nodes[k]]; };
      add_crossing({x(0), x(1), x(2)}, from, way, crossings);
      add_crossing({x(0), x(2), x(3)}, from, way, crossings);
    }
    if (goes_through(crossings, from, way, body, box, depth)) ++count;
  }
  return count;
}

}  // namespace

std::int64_t edges_through(const ModelMesh& mesh, const BodyParts& a, const BodyParts& b, const Bounds& box,
                           double depth) {
  const Point size = minus(box.high, box.low);
  if (!(std::ranges::min(size) > flat * std::ranges::max(size))) return 0;  // they lie on each other
  const std::vector<std::size_t> in_a = elements_in(mesh, a, box), in_b = elements_in(mesh, b, box);
  if (in_a.size() + in_b.size() > most_elements) return 0;
  const std::vector<FaceNodes> of_a = surface_in(mesh, in_a, box), of_b = surface_in(mesh, in_b, box);
  return edges_through(mesh, of_a, of_b, b, box, depth) + edges_through(mesh, of_b, of_a, a, box, depth);
}

}  // namespace pinball
