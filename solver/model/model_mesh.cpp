#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <solver/base/error.hpp>
#include <solver/mesh/array_mesh.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/quality.hpp>

#include "model.hpp"

namespace pinball {

double element_volume(const ModelMesh& mesh, std::size_t element) {
  return volume_by_quadrature(mesh.corners(element));
}

Point element_centre(const ModelMesh& mesh, std::size_t element) {
  Point centre{};
  for (const Point& corner : mesh.corners(element)) {
    for (std::size_t k = 0; k < 3; ++k) centre[k] += corner[k] / 8;
  }
  return centre;
}

Point element_extent(const ModelMesh& mesh, std::size_t element) {
  Point low = mesh.corner(element, 0), high = low;
  for (const Point& corner : mesh.corners(element)) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], corner[k]);
      high[k] = std::max(high[k], corner[k]);
    }
  }
  return {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
}

namespace {

/// Largest distance of a corner from the first one: 0 only if all are the same point.
double diameter(const std::array<Point, 8>& corners) {
  double largest = 0;
  const Point& a = corners[0];
  for (const Point& b : corners) {
    largest = std::max(largest, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  return largest;
}

/// Files and generators name what is wrong; of arrays only the scene knows to which body they belong.
Mesh mesh_of(const Body& body) {
  const auto* arrays = std::get_if<ArrayMesh>(&body.mesh);
  if (arrays == nullptr) return generate(body.mesh);
  try {
    return copy_mesh(*arrays);
  } catch (const InputError& error) {
    throw InputError(fmt::format("body.{}.{}", body.name, error.what()));
  }
}

}  // namespace

std::string message_head(const Scene& scene) { return scene.path.empty() ? "" : scene.path + ": "; }

ModelMesh build_mesh(const Scene& scene) {
  ModelMesh all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    Mesh mesh = mesh_of(body);
    try {
      place(mesh, body.axis, body.position);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}body {}: {}", message_head(scene), body.name, error.what()));
    }
    if (all.nodes.size() + mesh.nodes.size() > 2'000'000'000 / 4) {
      throw InputError(fmt::format("{}body {}: more than 500 million nodes", message_head(scene), body.name));
    }
    const auto offset = static_cast<std::int32_t>(all.nodes.size());
    all.nodes.insert(all.nodes.end(), mesh.nodes.begin(), mesh.nodes.end());
    for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
      std::array<std::int32_t, 8> hexahedron = mesh.hexahedra[e];
      for (std::int32_t& node : hexahedron) node += offset;
      all.hexahedra.push_back(hexahedron);
      const std::array<Point, 8> corners = all.corners(all.element_count() - 1);
      const double volume = volume_by_quadrature(corners);
      // A flat element has a volume of round-off, of either sign.
      if (!(volume > 1e-12 * std::pow(diameter(corners), 3))) {
        throw InputError(fmt::format("{}body {}: element {} is inverted or flat: its volume is {:.6g}, expected > 0",
                                     message_head(scene), body.name, e, volume));
      }
    }
    all.body.insert(all.body.end(), mesh.hexahedra.size(), static_cast<std::int32_t>(b));
    all.body_of_node.insert(all.body_of_node.end(), mesh.nodes.size(), static_cast<std::int32_t>(b));
    all.body_names.push_back(body.name);
  }
  return all;
}

}  // namespace pinball
