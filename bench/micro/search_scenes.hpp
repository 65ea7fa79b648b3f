#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <kernels/ball_tree.hpp>
#include <solver/base/tile_size.hpp>
#include <solver/model/ordering.hpp>

/// Sets of moving boxes as contact searches have them.
namespace pinball::bench {

struct BoxScene {
  std::vector<MovingBox<double>> boxes;
  std::vector<std::int32_t> body;
  /// Corners of a face, or -1: boxes of one body that share one are no pair.
  std::vector<std::array<std::int32_t, 4>> corners;

  void add(const Point& low, const Point& high, const Point& way, std::int32_t of_body,
           const std::array<std::int32_t, 4>& nodes = {-1, -2, -3, -4}) {
    MovingBox<double> box;
    for (std::size_t c = 0; c < 12; ++c) box.bound[c] = (c % 6 < 3 ? low : high)[c % 3] + (c < 6 ? 0 : way[c % 3]);
    boxes.push_back(box);
    body.push_back(of_body);
    corners.push_back(nodes);
  }
  std::int32_t count() const { return static_cast<std::int32_t>(boxes.size()); }

  /// Whether a pair is wanted.
  bool wants(std::int32_t first, std::int32_t second) const {
    const auto a = static_cast<std::size_t>(first), b = static_cast<std::size_t>(second);
    std::int32_t shared = 0;
    for (const std::int32_t m : corners[a]) {
      for (const std::int32_t n : corners[b]) shared |= static_cast<std::int32_t>(m == n);
    }
    return body[a] != body[b] || shared == 0;
  }

  /// Brings the boxes behind `begin` into the order of a model: in tiles.
  void put_in_tiles(std::int32_t begin = 0) {
    std::vector<Point> centres, extents;
    for (const auto& b : boxes) {
      Point centre, extent;
      for (std::size_t k = 0; k < 3; ++k) {
        centre[k] = 0.5 * (b.bound[k] + b.bound[3 + k]);
        extent[k] = b.bound[3 + k] - b.bound[k] + 1e-12;
      }
      centres.push_back(centre);
      extents.push_back(extent);
    }
    std::vector<std::int32_t> own(static_cast<std::size_t>(count() - begin));
    std::iota(own.begin(), own.end(), begin);
    const auto order = compact_tiles(centres, extents, own, tile_size(count()), 8).order;
    const BoxScene before = *this;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto from = static_cast<std::size_t>(order[i]), to = static_cast<std::size_t>(begin) + i;
      boxes[to] = before.boxes[from];
      body[to] = before.body[from];
      corners[to] = before.corners[from];
    }
  }
};

/// Boxes of all faces of a block of unit elements, with what a node may stray; its lower corner, number of elements and
/// size of an element per axis, way.
inline void add_block(BoxScene& scene, const Point& corner, const std::array<int, 3>& n, const Point& size,
                      const Point& way, std::int32_t body) {
  const std::int32_t begin = scene.count();
  const double stray = 0.05 * std::min({size[0], size[1], size[2]});
  const auto node = [&](const std::array<int, 3>& at) {
    return (body * (n[2] + 1) + at[2]) * (n[1] + 1) * (n[0] + 1) + at[1] * (n[0] + 1) + at[0];
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int layer : {0, n[axis]}) {
      for (int j = 0; j < n[v]; ++j) {
        for (int i = 0; i < n[u]; ++i) {
          std::array<int, 3> at{};
          at[axis] = layer, at[u] = i, at[v] = j;
          Point low, high;
          std::array<std::int32_t, 4> nodes{};
          for (std::size_t k = 0; k < 3; ++k) {
            low[k] = corner[k] + size[k] * at[k] - stray;
            high[k] = corner[k] + size[k] * (at[k] + (k == axis ? 0 : 1)) + stray;
          }
          for (std::size_t c = 0; c < 4; ++c) {
            auto end = at;
            end[u] += c == 1 || c == 2 ? 1 : 0, end[v] += c >= 2 ? 1 : 0;
            nodes[c] = node(end);
          }
          scene.add(low, high, way, body, nodes);
        }
      }
    }
  }
  scene.put_in_tiles(begin);
}

/// The surfaces of two blocks, side x side elements across and a quarter as many along, that meet. height: of an
/// element; lower, upper: ways of the blocks along the normal.
inline BoxScene meeting_blocks(int side, double height, double gap, double lower, double upper) {
  BoxScene scene;
  const std::array<int, 3> n{side, side, side / 4};
  add_block(scene, {0, 0, 0}, n, {1, 1, height}, {0, 0, lower}, 0);
  add_block(scene, {0.4, 0.3, height * n[2] + gap}, n, {1, 1, height}, {0, 0, upper}, 1);
  return scene;
}

/// Uniform.
inline BoxScene two_blocks(int side) { return meeting_blocks(side, 1, 0.2, 0.3, -0.3); }

/// The same with elements ten times as long across as along.
inline BoxScene two_flat_blocks(int side) { return meeting_blocks(side, 0.1, 0.02, 0.03, -0.03); }

/// Fast: the same as two_blocks with ways of three elements.
inline BoxScene two_fast_blocks(int side) { return meeting_blocks(side, 1, 1.0, 0, -3); }

/// Mixed: a block of small elements above one of large flat ones, 50 : 1, and a grid of bars 100 times as long as
/// thick.
inline BoxScene mixed_blocks(int side) {
  BoxScene scene;
  add_block(scene, {0, 0, 0}, {side, side, side / 4}, {1, 1, 1}, {0, 0, -0.3}, 0);
  add_block(scene, {-50, -50, -1.2}, {side / 25 + 2, side / 25 + 2, 1}, {50, 50, 1}, {0, 0, 0}, 1);
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side / 100 + 1; ++i) {
      scene.add({100.0 * i, 1.0 * j, side / 4 + 0.3}, {100.0 * i + 100, 1.0 * j + 0.9, side / 4 + 1.2}, {0, 0, 0}, 2);
    }
  }
  return scene;
}

/// Boxes anywhere: 2.5 side^2 of them, each of which meets six others.
inline BoxScene cloud(int side, bool tiles) {
  std::mt19937 random(7);
  BoxScene scene;
  const int count = 5 * side * side / 2;
  std::uniform_real_distribution<double> place(0, std::cbrt(count * 8 / 6.0)), way(-0.1, 0.1);
  for (int i = 0; i < count; ++i) {
    const Point p{place(random), place(random), place(random)};
    scene.add(p, {p[0] + 1, p[1] + 1, p[2] + 1}, {way(random), way(random), way(random)}, i);
  }
  if (tiles) scene.put_in_tiles();
  return scene;
}
inline BoxScene sorted_cloud(int side) { return cloud(side, true); }
inline BoxScene shuffled_cloud(int side) { return cloud(side, false); }

/// Graded: sizes 1 : 1000, the smaller the nearer to the middle.
inline BoxScene graded(int side) {
  std::mt19937 random(7);
  BoxScene scene;
  const int count = 5 * side * side / 2;
  std::uniform_real_distribution<double> place(-1, 1), exponent(-3, 0);
  const double reach = 0.55 * std::cbrt(count / 3.0);
  for (int i = 0; i < count; ++i) {
    const double size = std::pow(10.0, exponent(random));
    const Point p{reach * size * place(random), reach * size * place(random), reach * size * place(random)};
    scene.add(p, {p[0] + size, p[1] + size, p[2] + size}, {0, 0, 0}, i);
  }
  scene.put_in_tiles();
  return scene;
}

}  // namespace pinball::bench
