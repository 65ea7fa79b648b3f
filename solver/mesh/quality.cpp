#include "quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/base/point.hpp>

#include "element_types.hpp"

namespace pinball {
namespace {

double determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Parent coordinates of the corners.
constexpr int corner_signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

/// The three neighbours of each corner, in an order that makes the triple product of a box positive.
constexpr int corner_neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                         {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

using Hexahedron = std::array<std::int32_t, 8>;

/// det(e1, e2, e3) / (|e1| |e2| |e3|) of the edges from a corner to three others; -1 if an edge has no length.
double scaled_jacobian(const std::array<Point, 8>& x, int corner, const std::array<int, 3>& ends) {
  const Point a = minus(x[ends[0]], x[corner]), b = minus(x[ends[1]], x[corner]), c = minus(x[ends[2]], x[corner]);
  const double lengths = norm(a) * norm(b) * norm(c);
  return lengths > 0.0 ? determinant(a, b, c) / lengths : -1.0;
}

/// Smallest scaled Jacobian over the corners; -1 if an edge between different nodes has no length.
///
/// Where an edge is collapsed to one node, the edges that go on from its other end take its place: at the edge of a
/// wedge that gives the sine of its angle. A corner where two or three edges are collapsed has no Jacobian.
double worst_corner(const Hexahedron& nodes, const std::array<Point, 8>& x) {
  double worst = 1.0;
  for (int corner = 0; corner < 8; ++corner) {
    const auto& ends = corner_neighbours[corner];
    int collapsed = -1, count = 0;
    for (int i = 0; i < 3; ++i) {
      if (nodes[ends[i]] != nodes[corner]) continue;
      collapsed = i;
      ++count;
    }
    if (count == 0) worst = std::min(worst, scaled_jacobian(x, corner, {ends[0], ends[1], ends[2]}));
    if (count != 1) continue;
    for (const int next : corner_neighbours[ends[collapsed]]) {
      std::array<int, 3> others{ends[0], ends[1], ends[2]};
      others[collapsed] = next;
      bool distinct = nodes[next] != nodes[corner];
      for (int i = 0; i < 3; ++i) distinct = distinct && (i == collapsed || nodes[ends[i]] != nodes[next]);
      if (distinct) worst = std::min(worst, scaled_jacobian(x, corner, others));
    }
  }
  return worst;
}

/// A number at each Gauss point: there are as many as corners.
using AtPoints = std::array<double, 8>;

/// Derivatives of the trilinear shape functions: [node][parent coordinate].
constexpr std::array<std::array<AtPoints, 3>, 8> derivatives_of_shapes() {
  constexpr double gauss = 1.0 / 1.7320508075688772;  // 1/sqrt(3)
  std::array<std::array<AtPoints, 3>, 8> derivatives{};
  for (int node = 0; node < 8; ++node) {
    for (int point = 0; point < 8; ++point) {
      double factor[3]{};
      for (int i = 0; i < 3; ++i) factor[i] = 1.0 + corner_signs[node][i] * corner_signs[point][i] * gauss;
      for (int i = 0; i < 3; ++i) {
        derivatives[node][i][point] = corner_signs[node][i] * factor[(i + 1) % 3] * factor[(i + 2) % 3] / 8.0;
      }
    }
  }
  return derivatives;
}

/// Of the place, along a parent coordinate: [axis].
std::array<AtPoints, 3> tangents_along(int parent, const std::array<Point, 8>& corners) {
  static constexpr auto derivatives = derivatives_of_shapes();
  std::array<AtPoints, 3> tangents{};
  for (int axis = 0; axis < 3; ++axis) {
    for (int node = 0; node < 8; ++node) {
      for (int point = 0; point < 8; ++point) {
        tangents[axis][point] += derivatives[node][parent][point] * corners[node][axis];
      }
    }
  }
  return tangents;
}

}  // namespace

double volume_by_quadrature(const std::array<Point, 8>& corners) {
  // The Jacobian determinant is of degree 2 in each parent coordinate, so that 2 Gauss points in each are exact. All at
  // once: a compiler makes a vector of them.
  const std::array<AtPoints, 3> a = tangents_along(0, corners), b = tangents_along(1, corners),
                                c = tangents_along(2, corners);
  AtPoints determinants;
  for (int p = 0; p < 8; ++p) {
    determinants[p] =
        determinant({a[0][p], a[1][p], a[2][p]}, {b[0][p], b[1][p], b[2][p]}, {c[0][p], c[1][p], c[2][p]});
  }
  double volume = 0.0;
  for (const double at_point : determinants) volume += at_point;
  return volume;
}

MeshQuality measure_quality(const Mesh& mesh) {
  MeshQuality quality;
  if (mesh.hexahedra.empty()) return quality;
  quality.min_scaled_jacobian = 1.0;
  quality.min_edge = std::numeric_limits<double>::infinity();
  for (const auto& hexahedron : mesh.hexahedra) {
    std::array<Point, 8> x;
    for (int node = 0; node < 8; ++node) x[node] = mesh.nodes[hexahedron[node]];

    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;
    for (const auto& edge : edges_of_hexahedron) {
      if (hexahedron[edge[0]] == hexahedron[edge[1]]) continue;
      const double length = norm(minus(x[edge[0]], x[edge[1]]));
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    quality.min_edge = std::min(quality.min_edge, shortest);
    quality.max_edge = std::max(quality.max_edge, longest);
    quality.max_aspect_ratio = std::max(quality.max_aspect_ratio, longest / shortest);

    const double worst = worst_corner(hexahedron, x);
    quality.min_scaled_jacobian = std::min(quality.min_scaled_jacobian, worst);
    quality.mean_scaled_jacobian += worst;
    if (!(worst > 0.0)) ++quality.inverted;
    quality.volume += volume_by_quadrature(x);
  }
  quality.mean_scaled_jacobian /= static_cast<double>(mesh.hexahedra.size());
  return quality;
}

}  // namespace pinball
