#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include <tests/simulation/array_scene.hpp>

/// Bodies turned in any way: the meshes of the generators, in arrays.
namespace pinball::test {

using Matrix = std::array<Point, 3>;  ///< rows

inline Point times(const Matrix& m, const Point& x) { return {dot(m[0], x), dot(m[1], x), dot(m[2], x)}; }

inline Matrix times(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) product[i][j] += a[i][k] * b[k][j];
    }
  }
  return product;
}

/// Turns about coordinate axis 0, 1 or 2 [degree].
inline Matrix turn(std::size_t axis, double degrees) {
  const double angle = degrees * M_PI / 180, c = std::cos(angle), s = std::sin(angle);
  const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
  Matrix m{};
  m[axis][axis] = 1;
  m[j][j] = m[k][k] = c;
  m[k][j] = s;
  m[j][k] = -s;
  return m;
}

/// Any turn, none more likely than others.
inline Matrix random_turn(std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  std::array<double, 4> q{};
  for (double& part : q) part = normal(generator);
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const auto [a, b, c, d] = std::array{q[0] / length, q[1] / length, q[2] / length, q[3] / length};
  return {Point{1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)},
          Point{2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)},
          Point{2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)}};
}

/// The shortest turn that takes `from` to `to`, both of unit length and not opposite.
inline Matrix shortest_turn(const Point& from, const Point& to) {
  const Point w = cross(from, to);
  const Matrix skew{{{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}}};
  const Matrix square = times(skew, skew);
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = (i == j) + skew[i][j] + square[i][j] / (1 + dot(from, to));
  }
  return m;
}

/// The body with its mesh moved node by node, and then by its position, in arrays that it keeps itself.
template <class Move>
Body mapped(Body body, const Move& move) {
  Mesh mesh = generate(body.mesh);
  for (Point& x : mesh.nodes) x = move(x);
  const auto arrays = std::make_shared<HostMesh<>>(mesh, 0);
  ArrayMesh view = arrays->view();
  view.owner = arrays;
  body.mesh = view;
  return body;
}

/// Middle of the box around a mesh.
inline Point middle_of(const Mesh& mesh) {
  Point low = mesh.nodes[0], high = low;
  for (const Point& x : mesh.nodes) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
}

/// The body turned about the middle of its mesh, which is put at `centre`.
inline Body turned(Body body, const Matrix& rotation, const Point& centre) {
  const Point middle = middle_of(generate(body.mesh));
  body.position = {};
  return mapped(std::move(body), [&](const Point& x) {
    Point y = times(rotation, minus(x, middle));
    for (std::size_t k = 0; k < 3; ++k) y[k] += centre[k];
    return y;
  });
}

/// How far a box of these edges, turned, reaches down from its middle.
inline double reach_down(const Point& edges, const Matrix& rotation) {
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k) reach += 0.5 * edges[k] * std::abs(rotation[2][k]);
  return reach;
}

/// Lowest corner of a turned box, from its middle; of an edge or a face that lies level, the middle.
inline Point lowest_point(const Point& edges, const Matrix& rotation) {
  Point low{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double up = rotation[2][k];
    if (std::abs(up) < 1e-12) continue;
    for (std::size_t c = 0; c < 3; ++c) low[c] -= 0.5 * edges[k] * rotation[c][k] * (up > 0 ? 1 : -1);
  }
  return low;
}

}  // namespace pinball::test
