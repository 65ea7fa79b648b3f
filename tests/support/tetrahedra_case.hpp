#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "torn_block.hpp"

/// Scenes of tetrahedra.
namespace pinball::test {

inline Body cut(Body body) {
  body.elements = ElementShape::tetrahedra;
  return body;
}

/// As torn_block, with tetrahedra that erode.
inline Scene torn_tetrahedra(Precision precision = Precision::float64, const std::array<int, 3>& elements = {7, 5, 6}) {
  Scene scene = torn_block(precision, elements);
  scene.bodies[0] = cut(scene.bodies[0]);
  return scene;
}

/// A block through a plate, both of tetrahedra that erode; a third body is of hexahedra of another material.
inline Scene striking_tetrahedra() {
  Scene scene = scene_of({cut(block("plate", {7, 7, 2}, 0.01, {0, 0, 0})),
                          cut(block("block", {2, 2, 3}, 0.011, {0.029, 0.031, 0.0201}, {50, 0, -600}, "other")),
                          block("below", {5, 5, 2}, 0.013, {0, 0, -0.0262}, {}, "other")},
                         4e-5);
  scene.materials = {plastic_material("steel", 4e8, 0.3), plastic_material("other", 6e8, 0.5)};
  scene.element.bulk_viscosity = true;
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  return scene;
}

/// Nodes and elements of a host.
struct HostMesh {
  std::vector<Point> nodes;
  std::vector<std::array<std::int32_t, 8>> elements;
};

/// A bar of 5 x 5 x 12 cubes of size h along z, of which the upper half are hexahedra and the lower ones six
/// tetrahedra each (Kuhn), so that both have nodes in common. flatness: height of the lower ones, over h.
inline HostMesh half_of_tetrahedra(double h, double flatness = 1) {
  const std::array<int, 3> cubes{5, 5, 12};
  HostMesh mesh;
  const auto number = [&](int i, int j, int k) { return i + (cubes[0] + 1) * (j + (cubes[1] + 1) * k); };
  for (int k = 0; k <= cubes[2]; ++k) {
    const double z = h * (std::min(k, cubes[2] / 2) * flatness + std::max(0, k - cubes[2] / 2));
    for (int j = 0; j <= cubes[1]; ++j) {
      for (int i = 0; i <= cubes[0]; ++i) mesh.nodes.push_back({i * h, j * h, z});
    }
  }
  const auto add = [&](std::array<int, 3> c) {
    const auto at = [&](std::array<int, 3> d) { return number(c[0] + d[0], c[1] + d[1], c[2] + d[2]); };
    if (c[2] >= cubes[2] / 2) {
      mesh.elements.push_back({at({0, 0, 0}), at({1, 0, 0}), at({1, 1, 0}), at({0, 1, 0}), at({0, 0, 1}), at({1, 0, 1}),
                               at({1, 1, 1}), at({0, 1, 1})});
      return;
    }
    std::array<int, 3> axes{0, 1, 2};
    do {
      std::array<int, 3> corner{0, 0, 0};
      std::array<std::int32_t, 4> n{at(corner)};
      for (int i = 0; i < 3; ++i) {
        corner[axes[i]] = 1;
        n[i + 1] = at(corner);
      }
      const bool odd = (axes[1] - axes[0] + 3) % 3 == 2;  // the permutation: it turns the volume inside out
      if (odd) std::swap(n[1], n[2]);
      mesh.elements.push_back({n[0], n[1], n[2], n[2], n[3], n[3], n[3], n[3]});
    } while (std::ranges::next_permutation(axes).found);
  };
  for (int k = 0; k < cubes[2]; ++k) {
    for (int j = 0; j < cubes[1]; ++j) {
      for (int i = 0; i < cubes[0]; ++i) add({i, j, k});
    }
  }
  return mesh;
}

/// Such a bar strikes a wall with its tetrahedra. mesh: has to stay until models are built.
inline Scene striking_bar_of(const HostMesh& mesh, Precision precision) {
  Body bar;
  bar.name = "bar";
  bar.material = "steel";
  bar.mesh = ArrayMesh{view_records(mesh.nodes.data()->data(), mesh.nodes.size(), 3),
                       view_records(mesh.elements.data()->data(), mesh.elements.size(), 8),
                       0,
                       {}};
  bar.velocity = {0, 0, -200};
  Scene scene = scene_of({bar}, 5e-5, false);
  scene.materials = {plastic_material("steel", 3e8, 0)};
  scene.element.bulk_viscosity = true;
  scene.precision = precision;
  scene.rigid_walls = {{"floor", {{0, 0, -1e-4}, {0, 0, 1}}, "", "here"}};
  return scene;
}

inline Scene striking_bar_of_both(Precision precision = Precision::float64) {
  static const HostMesh mesh = half_of_tetrahedra(0.01);
  return striking_bar_of(mesh, precision);
}

}  // namespace pinball::test
