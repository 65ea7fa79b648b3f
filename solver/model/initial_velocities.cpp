#include "initial_velocities.hpp"

#include <random>
#include <unordered_map>

#include <solver/model/elements/element_parts.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

/// Of the masses of an element at its corners.
template <class S>
Point centre_of_nodes(const Model<S>& model, std::size_t element) {
  const CornerShares share = corner_shares(model.scene, model.mesh, element);
  Point centre{};
  for (std::size_t i = 0; i < 8; ++i) {
    const Point& corner = model.mesh.corner(element, i);
    for (std::size_t k = 0; k < 3; ++k) centre[k] += share[i] * corner[k];
  }
  return centre;
}

template <class S>
std::vector<Point> centroids_of_bodies(const Model<S>& model) {
  std::vector<Point> centroid(model.scene.bodies.size(), Point{});
  std::vector<double> mass(centroid.size(), 0.0);
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    const std::int32_t b = model.mesh.body[e];
    const Point c = centre_of_nodes(model, e);
    for (std::size_t k = 0; k < 3; ++k) centroid[b][k] += model.element_mass[e] * c[k];
    mass[b] += model.element_mass[e];
  }
  for (std::size_t b = 0; b < centroid.size(); ++b) {
    for (double& c : centroid[b]) c /= mass[b];
  }
  return centroid;
}

/// What a body gives a point, without noise [length/time].
Point velocity_in(const Body& body, const Point& centroid, const Point& x) {
  Point v = body.velocity;
  const Point r = minus(x, centroid);
  const Point spin = cross(body.angular_velocity, r);
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& g = body.velocity_gradient[k];
    v[k] += spin[k] + g[0] * r[0] + g[1] * r[1] + g[2] * r[2];
  }
  return v;
}

/// What the bodies around a node would have it do.
struct MeetingVelocities {
  Point first{}, momentum{};
  double mass = 0;
  bool differ = false, rigid = false;
};

/// Velocities of the nodes that bodies with different ones share, by nodes of the scene.
template <class S>
std::unordered_map<std::int32_t, Point> velocities_between_bodies(const Model<S>& model,
                                                                  const std::vector<Point>& centroid) {
  std::unordered_map<std::int32_t, MeetingVelocities> at;
  for (const std::vector<std::int32_t>& nodes : model.mesh.shared) {
    for (const std::int32_t n : nodes) at.try_emplace(n);
  }
  for (std::size_t e = 0; e < model.mesh.hexahedra.size() && !at.empty(); ++e) {
    const std::int32_t b = model.mesh.body[e];
    const CornerShares share = corner_shares(model.scene, model.mesh, e);
    for (std::size_t i = 0; i < 8; ++i) {
      const std::int32_t n = model.mesh.hexahedra[e][i];
      const double mass = share[i] * model.element_mass[e];
      const auto found = at.find(n);
      if (found == at.end()) continue;
      MeetingVelocities& node = found->second;
      const Point v = velocity_in(model.scene.bodies[b], centroid[b], model.mesh.nodes[n]);
      if (node.mass == 0) node.first = v;
      node.differ = node.differ || v != node.first;
      node.rigid = node.rigid || model.rigid_of_body[b] >= 0;
      node.mass += mass;
      for (std::size_t k = 0; k < 3; ++k) node.momentum[k] += mass * v[k];
    }
  }
  std::unordered_map<std::int32_t, Point> velocities;
  for (const auto& [n, node] : at) {
    if (!node.differ || node.rigid) continue;
    Point& v = velocities[n];
    for (std::size_t k = 0; k < 3; ++k) v[k] = node.momentum[k] / node.mass;
  }
  return velocities;
}

}  // namespace

template <class S>
void set_initial_velocities(Model<S>& model) {
  const std::vector<Point> centroid = centroids_of_bodies(model);
  const std::unordered_map<std::int32_t, Point> between = velocities_between_bodies(model, centroid);
  std::mt19937_64 random(20240101);  // the same noise in every run
  const auto noise = [&random] { return 2.0 * ((random() >> 11) * 0x1.0p-53) - 1.0; };
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    const std::int32_t b = model.mesh.body_of_node[n];
    const Body& body = model.scene.bodies[b];
    const auto shared = between.find(static_cast<std::int32_t>(n));
    Point v = shared != between.end() ? shared->second : velocity_in(body, centroid[b], model.mesh.nodes[n]);
    S* velocity = model.nodes.velocity_of(model.node_of_scene_node[n]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (body.velocity_noise > 0) v[k] += body.velocity_noise * noise();
      velocity[k] = static_cast<S>(v[k]);
    }
  }
  for (const InitialVelocity& given : model.scene.initial_velocities) {
    for (const std::int32_t n : select_nodes(model.mesh, given.nodes)) {
      S* velocity = model.nodes.velocity_of(model.node_of_scene_node[n]);
      const Point spin = cross(given.angular_velocity, minus(model.mesh.nodes[n], given.centre));
      for (std::size_t k = 0; k < 3; ++k) {
        if (given.components[k]) velocity[k] = static_cast<S>(given.velocity[k] + spin[k]);
      }
    }
  }
}

template void set_initial_velocities<double>(Model<double>&);
template void set_initial_velocities<float>(Model<float>&);

}  // namespace pinball
