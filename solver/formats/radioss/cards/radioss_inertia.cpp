#include "radioss_inertia.hpp"

#include <algorithm>
#include <cmath>

#include <solver/base/moments_of_inertia.hpp>
#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>
#include <solver/mesh/file/node_masses.hpp>

namespace pinball {

namespace {

/// Per part of the mesh.
std::vector<double> densities(const RadiossData& data) {
  std::vector<double> density(data.mesh.parts.size(), 0.0);
  for (const RadiossBody& body : data.bodies) {
    const std::ptrdiff_t part = data.part_of(body);
    for (const RadiossBlock& block : data.deck.blocks) {
      if (!block.name.starts_with("MAT/") || block.id() != body.part.material) continue;
      RadiossLines lines(block);
      const DataLine first = lines.require("the density of the material");
      density[part] = RadiossFields(first, block, radioss::density).number("RHO_I");
    }
  }
  return density;
}

/// The place of two masses.
Point centre_of(double mass_a, const Point& a, double mass_b, const Point& b) {
  Point centre{};
  for (std::size_t k = 0; k < 3; ++k) centre[k] = (mass_a * a[k] + mass_b * b[k]) / (mass_a + mass_b);
  return centre;
}

/// The node with the largest of some size.
template <class Size>
std::int32_t largest(const std::vector<std::int32_t>& nodes, const Size& size) {
  return *std::ranges::max_element(nodes, {}, size);
}

}  // namespace

RadiossInertia radioss_inertia(const RadiossData& data, const std::vector<bool>& nodes,
                               const std::optional<Point>& centre) {
  const std::vector<double> mass = node_masses(data.mesh, densities(data));
  const std::vector<Point>& places = data.mesh.mesh.nodes;
  RadiossInertia all;
  for (std::size_t n = 0; n < places.size(); ++n) {
    if (!nodes[n]) continue;
    all.mass += mass[n];
    for (std::size_t k = 0; k < 3; ++k) all.centre[k] += mass[n] * places[n][k];
  }
  for (double& component : all.centre) component /= all.mass;
  if (centre) all.centre = *centre;
  for (std::size_t n = 0; n < places.size(); ++n) {
    if (nodes[n]) add_moments(all.about, mass[n], minus(places[n], all.centre));
  }
  return all;
}

bool RadiossMainMass::changes_nothing() const {
  const bool no_inertia = std::ranges::all_of(inertia, [](const Point& row) { return norm(row) == 0; });
  return mass == 0 && no_inertia && centre <= 2 && !is_sphere;
}

RadiossInertia with_main_node(const RadiossData& data, const std::vector<bool>& nodes, const Point& main,
                              const RadiossMainMass& given) {
  RadiossInertia all{given.mass, main, {}};
  if (given.centre <= 3) {
    const RadiossInertia own = radioss_inertia(data, nodes);
    if (given.centre == 1) all.centre = centre_of(own.mass, own.centre, given.mass, main);
    if (given.centre == 2) all.centre = own.centre;
    all.about = radioss_inertia(data, nodes, all.centre).about;
    all.mass += own.mass;
    if (given.centre == 1) add_moments(all.about, given.mass, minus(main, all.centre));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) all.about[k][l] += given.inertia[k][l];
  }
  if (given.is_sphere) {
    const double mean = (all.about[0][0] + all.about[1][1] + all.about[2][2]) / 3;
    all.about = {{{mean, 0, 0}, {0, mean, 0}, {0, 0, mean}}};
  }
  return all;
}

std::vector<bool> nodes_of(const RadiossData& data, const RadiossRigidBody& rigid) {
  const std::ptrdiff_t number = &rigid - data.rigid.data();
  std::vector<bool> nodes;
  for (const std::int32_t of : data.rigid_of_node) nodes.push_back(of == number);
  return nodes;
}

/// The corners of a large tetrahedron, and the shares of the point among its volumes.
std::vector<std::pair<std::int32_t, double>> shares_at(const RadiossData& data, const RadiossRigidBody& rigid,
                                                       const Point& point) {
  const std::vector<bool> own = nodes_of(data, rigid);
  std::vector<std::int32_t> nodes;
  for (std::size_t n = 0; n < own.size(); ++n) {
    if (own[n] && data.used[n]) nodes.push_back(static_cast<std::int32_t>(n));
  }
  if (nodes.size() < 4) return {};
  const auto from = [&](std::int32_t node, std::int32_t other) {
    return minus(data.mesh.mesh.nodes[node], data.mesh.mesh.nodes[other]);
  };
  const std::int32_t a = nodes.front();
  const std::int32_t b = largest(nodes, [&](std::int32_t n) { return norm(from(n, a)); });
  const std::int32_t c = largest(nodes, [&](std::int32_t n) { return norm(cross(from(b, a), from(n, a))); });
  const Point normal = cross(from(b, a), from(c, a));
  const std::int32_t d = largest(nodes, [&](std::int32_t n) { return std::abs(dot(normal, from(n, a))); });
  const Point u = from(b, a), v = from(c, a), w = from(d, a), p = minus(point, data.mesh.mesh.nodes[a]);
  const double volume = dot(u, cross(v, w)), size = norm(u);
  if (!(std::abs(volume) > 1e-9 * size * size * size)) return {};
  const double of_b = dot(p, cross(v, w)) / volume, of_c = dot(u, cross(p, w)) / volume,
               of_d = dot(u, cross(v, p)) / volume;
  return {{a, 1 - of_b - of_c - of_d}, {b, of_b}, {c, of_c}, {d, of_d}};
}

}  // namespace pinball
