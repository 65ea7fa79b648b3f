#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <kernels/hexahedron.hpp>
#include <solver/base/faces.hpp>
#include <solver/model/model.hpp>

/// How deep bodies are in each other, from the places of the nodes alone: nothing of the contact is used.
namespace pinball::test {

/// Distance of a point from a triangle [length]. C. Ericson, Real-Time Collision Detection (2005), section 5.1.5.
inline double distance_from_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const auto from = [&p](const Point& q, const Point& u, double s, const Point& v, double t) {
    return norm(
        {p[0] - q[0] - s * u[0] - t * v[0], p[1] - q[1] - s * u[1] - t * v[1], p[2] - q[2] - s * u[2] - t * v[2]});
  };
  const Point ab = minus(b, a), ac = minus(c, a), ap = minus(p, a), bp = minus(p, b), cp = minus(p, c);
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
               d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return norm(ap);
  if (d3 >= 0 && d4 <= d3) return norm(bp);
  if (d6 >= 0 && d5 <= d6) return norm(cp);
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return from(a, ab, d1 / (d1 - d3), ac, 0);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return from(a, ab, 0, ac, d2 / (d2 - d6));
  if (va <= 0 && d4 >= d3 && d5 >= d6) return from(b, minus(c, b), (d4 - d3) / (d4 - d3 + d5 - d6), ac, 0);
  return from(a, ab, vb / (va + vb + vc), ac, vc / (va + vb + vc));
}

/// Whether a point is inside a trilinear hexahedron: its parent coordinates, by Newton's method, are within +-1.
inline bool is_inside(const Point& p, const std::array<Point, 8>& corners) {
  constexpr int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                              {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  Point xi{};
  for (int iteration = 0; iteration < 20; ++iteration) {
    Point residual = p;
    std::array<Point, 3> tangent{};
    for (int i = 0; i < 8; ++i) {
      double factor[3], shape = 0.125;
      for (int k = 0; k < 3; ++k) shape *= factor[k] = 1 + sign[i][k] * xi[k];
      for (int c = 0; c < 3; ++c) {
        residual[c] -= shape * corners[i][c];
        for (int k = 0; k < 3; ++k) {
          tangent[k][c] += 0.125 * sign[i][k] * factor[(k + 1) % 3] * factor[(k + 2) % 3] * corners[i][c];
        }
      }
    }
    const Point yz = cross(tangent[1], tangent[2]), zx = cross(tangent[2], tangent[0]),
                xy = cross(tangent[0], tangent[1]);
    const double volume = dot(tangent[0], yz);
    const Point step{dot(residual, yz) / volume, dot(residual, zx) / volume, dot(residual, xy) / volume};
    for (int k = 0; k < 3; ++k) xi[k] += step[k];
    const double largest = std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
    if (largest < 1e-13) break;
    if (!(largest < 1e3)) return false;
  }
  return std::abs(xi[0]) <= 1 && std::abs(xi[1]) <= 1 && std::abs(xi[2]) <= 1;
}

/// Depth: of a point inside a body the distance from the nearest exposed face, of an edge that of its deepest point, so
/// that edges that cross have one although no node is inside. Costs nodes times elements; nothing may have eroded.
class GeometricDepth {
 public:
  explicit GeometricDepth(const ModelMesh& mesh) : mesh_(mesh) {
    const auto neighbours = face_neighbours(mesh.hexahedra);
    for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
      for (int f = 0; f < 6; ++f) {
        if (neighbours[e][f] != -1) continue;
        Face face{mesh.body[e], {}};
        for (int i = 0; i < 4; ++i) face.nodes[i] = mesh.hexahedra[e][face_nodes[f][i]];
        faces_.push_back(face);
        for (int i = 0; i < 4; ++i) {
          const std::int32_t a = face.nodes[i], b = face.nodes[(i + 1) % 4];
          nodes_.push_back(a);
          if (a != b) edges_.emplace_back(std::min(a, b), std::max(a, b));
        }
      }
    }
    keep_one_of_each(nodes_);
    keep_one_of_each(edges_);
  }

  /// Places of the nodes, in the order of the scene, from now on [length].
  template <class Place>
  void take(const Place& place) {
    x_.resize(mesh_.nodes.size());
    for (std::size_t n = 0; n < x_.size(); ++n) x_[n] = place(n);
    low_.resize(mesh_.hexahedra.size());
    high_.resize(mesh_.hexahedra.size());
    for (std::size_t e = 0; e < low_.size(); ++e) {
      low_[e] = high_[e] = x_[mesh_.hexahedra[e][0]];
      for (const std::int32_t n : mesh_.hexahedra[e]) {
        for (std::size_t k = 0; k < 3; ++k) {
          low_[e][k] = std::min(low_[e][k], x_[n][k]);
          high_[e][k] = std::max(high_[e][k], x_[n][k]);
        }
      }
    }
  }

  /// Deepest node of a body in other bodies; with `self`, in parts of its own body that it is no corner of.
  double deepest_node(std::int32_t body, bool self = false) const {
    double deepest = 0;
    for (const std::int32_t n : nodes_) {
      if (mesh_.body_of_node[n] == body) deepest = std::max(deepest, depth(x_[n], body, self, n, n));
    }
    return deepest;
  }

  /// The same of edges, tried in 17 points each and then between those beside the deepest.
  double deepest_edge(std::int32_t body, bool self = false) const {
    constexpr int pieces = 16;
    double deepest = 0;
    for (const auto& [a, b] : edges_) {
      if (mesh_.body_of_node[a] != body || !may_be_inside(a, b, body, self)) continue;
      const auto depth_at = [&, a = a, b = b](double t) {
        Point p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = (1 - t) * x_[a][k] + t * x_[b][k];
        return depth(p, body, self, a, b);
      };
      double best = 0, at = 0;
      for (int i = 0; i <= pieces; ++i) {
        const double d = depth_at(double(i) / pieces);
        if (d > best) best = d, at = double(i) / pieces;
      }
      for (double width = 0.5 / pieces; best > 0 && width > 1e-3; width /= 2) {
        for (const double t : {at - width, at + width}) {
          const double d = t < 0 || t > 1 ? 0 : depth_at(t);
          if (d > best) best = d, at = t;
        }
      }
      deepest = std::max(deepest, best);
    }
    return deepest;
  }

  /// Deepest node or edge of all bodies.
  double deepest(bool self = false) const {
    double depth = 0;
    for (std::int32_t b = 0; b < static_cast<std::int32_t>(mesh_.body_names.size()); ++b) {
      depth = std::max({depth, deepest_node(b, self), deepest_edge(b, self)});
    }
    return depth;
  }

 private:
  struct Face {
    std::int32_t body;
    std::array<std::int32_t, 4> nodes;
  };

  template <class T>
  static void keep_one_of_each(std::vector<T>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  template <class Nodes>
  static bool has(const Nodes& nodes, std::int32_t n) {
    return std::find(nodes.begin(), nodes.end(), n) != nodes.end();
  }

  bool may_be_inside(std::int32_t a, std::int32_t b, std::int32_t body, bool self) const {
    for (std::size_t e = 0; e < low_.size(); ++e) {
      if ((mesh_.body[e] == body) != self) continue;
      bool meets = true;
      for (std::size_t k = 0; k < 3; ++k) {
        meets = meets && std::max(x_[a][k], x_[b][k]) >= low_[e][k] && std::min(x_[a][k], x_[b][k]) <= high_[e][k];
      }
      if (meets) return true;
    }
    return false;
  }

  /// Of a point that belongs to nodes a and b.
  double depth(const Point& p, std::int32_t body, bool self, std::int32_t a, std::int32_t b) const {
    double deepest = 0;
    for (std::size_t e = 0; e < low_.size(); ++e) {
      if ((mesh_.body[e] == body) != self) continue;
      bool in_box = true;
      for (std::size_t k = 0; k < 3; ++k) in_box = in_box && low_[e][k] <= p[k] && p[k] <= high_[e][k];
      if (!in_box) continue;
      const auto& nodes = mesh_.hexahedra[e];
      if (self && (has(nodes, a) || has(nodes, b))) continue;
      std::array<Point, 8> corners;
      for (std::size_t i = 0; i < 8; ++i) corners[i] = x_[nodes[i]];
      if (is_inside(p, corners)) deepest = std::max(deepest, distance_from_surface(p, mesh_.body[e], self, a, b));
    }
    return deepest;
  }

  double distance_from_surface(const Point& p, std::int32_t body, bool self, std::int32_t a, std::int32_t b) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Face& face : faces_) {
      if (face.body != body || (self && (has(face.nodes, a) || has(face.nodes, b)))) continue;
      Point middle{};
      for (const std::int32_t n : face.nodes) {
        for (std::size_t k = 0; k < 3; ++k) middle[k] += 0.25 * x_[n][k];
      }
      for (int i = 0; i < 4; ++i) {
        const double d = distance_from_triangle(p, middle, x_[face.nodes[i]], x_[face.nodes[(i + 1) % 4]]);
        nearest = std::min(nearest, d);
      }
    }
    return nearest;
  }

  const ModelMesh& mesh_;
  std::vector<Face> faces_;
  std::vector<std::int32_t> nodes_;                           ///< of the surface
  std::vector<std::pair<std::int32_t, std::int32_t>> edges_;  ///< of the surface
  std::vector<Point> x_, low_, high_;                         ///< of nodes; boxes around elements
};

}  // namespace pinball::test
