#pragma once

#include <array>
#include <random>
#include <vector>

#include <solver/mesh/tetrahedra.hpp>

#include "tetrahedra_case.hpp"

/// Meshes of hosts with wedges and pyramids.
namespace pinball::test {

enum class Cut {
  none,
  across_x,  ///< two wedges, whose triangles are normal to x
  across_y,
  across_z,
  pyramids  ///< six around a node in the middle
};

/// Adds what a hexahedron is cut into, to elements and, of pyramids, nodes.
inline void add_cut(const Corners8& h, Cut how, HostMesh& mesh) {
  const auto add_wedges = [&](const std::array<int, 4>& below, const std::array<int, 4>& above) {
    for (const int i : {1, 2})
      mesh.elements.push_back(
          wedge(h[below[0]], h[below[i]], h[below[i + 1]], h[above[0]], h[above[i]], h[above[i + 1]]));
  };
  switch (how) {
    case Cut::none:
      mesh.elements.push_back(h);
      return;
    case Cut::across_x:
      return add_wedges({0, 3, 7, 4}, {1, 2, 6, 5});
    case Cut::across_y:
      return add_wedges({0, 4, 5, 1}, {3, 7, 6, 2});
    case Cut::across_z:
      return add_wedges({0, 1, 2, 3}, {4, 5, 6, 7});
    case Cut::pyramids: {
      Point middle{};
      for (const std::int32_t node : h) {
        for (std::size_t k = 0; k < 3; ++k) middle[k] += mesh.nodes[node][k] / 8;
      }
      const auto top = static_cast<std::int32_t>(mesh.nodes.size());
      mesh.nodes.push_back(middle);
      for (const auto& f : face_nodes)  // counterclockwise seen from outside
        mesh.elements.push_back(pyramid(h[f[3]], h[f[2]], h[f[1]], h[f[0]], top));
      return;
    }
  }
}

/// A block of cubes, each cut as how(i, j, k) says; skew: of the places of inner nodes, over the edge.
template <class How>
HostMesh block_cut(const std::array<int, 3>& cubes, const Point& size, const How& how, double skew = 0) {
  HostMesh mesh;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> away(-skew, skew);
  const auto number = [&](int i, int j, int k) { return i + (cubes[0] + 1) * (j + (cubes[1] + 1) * k); };
  for (int k = 0; k <= cubes[2]; ++k) {
    for (int j = 0; j <= cubes[1]; ++j) {
      for (int i = 0; i <= cubes[0]; ++i) {
        const std::array<int, 3> at{i, j, k};
        Point x{};
        for (std::size_t c = 0; c < 3; ++c) {
          const bool inside = at[c] > 0 && at[c] < cubes[c];
          x[c] = size[c] / cubes[c] * (at[c] + (inside ? away(random) : 0));
        }
        mesh.nodes.push_back(x);
      }
    }
  }
  for (int k = 0; k < cubes[2]; ++k) {
    for (int j = 0; j < cubes[1]; ++j) {
      for (int i = 0; i < cubes[0]; ++i) {
        add_cut({number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k),
                 number(i, j, k + 1), number(i + 1, j, k + 1), number(i + 1, j + 1, k + 1), number(i, j + 1, k + 1)},
                how(i, j, k), mesh);
      }
    }
  }
  return mesh;
}

inline HostMesh block_cut(const std::array<int, 3>& cubes, const Point& size, Cut how) {
  return block_cut(cubes, size, [how](int, int, int) { return how; });
}

/// Hexahedra, columns of wedges along z, and pyramids, whose quadrilaterals meet.
inline HostMesh block_of_shapes(const std::array<int, 3>& cubes, double h, double skew = 0) {
  const auto how = [](int i, int j, int k) {
    if ((i + j) % 2 == 0) return Cut::across_z;
    return (i + k) % 3 == 0 ? Cut::pyramids : Cut::none;
  };
  return block_cut(cubes, {cubes[0] * h, cubes[1] * h, cubes[2] * h}, how, skew);
}

/// mesh: has to stay until models are built.
inline Body body_of(const HostMesh& mesh, const std::string& material = "steel") {
  Body body;
  body.name = "a";
  body.material = material;
  body.mesh = ArrayMesh{view_records(mesh.nodes.data()->data(), mesh.nodes.size(), 3),
                        view_records(mesh.elements.data()->data(), mesh.elements.size(), 8),
                        0,
                        {}};
  return body;
}

/// As torn_block, of all shapes.
inline Scene torn_shapes(Precision precision = Precision::float64) {
  static const HostMesh mesh = block_of_shapes({7, 5, 6}, 0.01, 0.1);
  Scene scene = torn_block(precision);
  Body body = body_of(mesh);
  body.velocity_gradient = scene.bodies[0].velocity_gradient;
  body.velocity_noise = scene.bodies[0].velocity_noise;
  scene.bodies = {body};
  return scene;
}

}  // namespace pinball::test
