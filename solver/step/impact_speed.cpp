#include "impact_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/model/nodes_of_bodies.hpp>

namespace pinball {

namespace {

/// A ball that holds the velocities of a body's nodes, about their mean: turned with the scene it is the same ball, as
/// no box is.
struct Velocities {
  Point first{}, beside{};  ///< of the first node, and the sum of what the others have beside it
  double count = 0;
  double radius = 0;

  void take(const Point& v) {
    if (count == 0) first = v;
    for (std::size_t k = 0; k < 3; ++k) beside[k] += v[k] - first[k];
    ++count;
  }
  /// Exactly that of the nodes where all have the same.
  Point mean() const {
    Point mean = first;
    for (std::size_t k = 0; k < 3; ++k) mean[k] += beside[k] / count;
    return mean;
  }
};

/// Of all pairs. Of many bodies nearly all pairs are known by their squares to be slower.
double largest_relative_speed(const std::vector<Velocities>& of_body) {
  std::vector<Point> mean;
  for (const Velocities& own : of_body) mean.push_back(own.mean());
  double speed = 0;
  for (std::size_t a = 0; a < of_body.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Point v = minus(mean[a], mean[b]);
      const double spread = of_body[a].radius + of_body[b].radius, least = (1 - 1e-12) * speed - spread;
      if (least > 0 && dot(v, v) < least * least) continue;
      speed = std::max(speed, std::hypot(v[0], v[1], v[2]) + spread);
    }
  }
  return speed;
}

/// Of each body at the start.
template <class S>
std::vector<Velocities> velocities_of_bodies(const Model<S>& model) {
  std::vector<Velocities> of_body(model.mesh.body_names.size());
  const auto for_nodes = [&](const auto& visit) {
    for_nodes_of_bodies(model.mesh, [&](std::int32_t body, std::int32_t n) {
      const S* const v = record(model.nodes.velocity.data(), model.node_of_scene_node[n]);
      visit(of_body[body], Point{v[0], v[1], v[2]});
    });
  };
  for_nodes([](Velocities& own, const Point& v) { own.take(v); });
  for_nodes([](Velocities& own, const Point& v) { own.radius = std::max(own.radius, norm(minus(v, own.mean()))); });
  return of_body;
}

/// Of the pinballs [length].
double smallest_radius(const Scene& scene, const ModelMesh& mesh) {
  double volume = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) volume = std::min(volume, element_volume(mesh, e));
  return scene.contact.radius_factor * std::cbrt(3 * volume / (4 * M_PI));
}

}  // namespace

template <class S>
double longest_contact_step(const Model<S>& model) {
  const double speed = largest_relative_speed(velocities_of_bodies(model));
  return speed > 0 ? smallest_radius(model.scene, model.mesh) / speed : std::numeric_limits<double>::infinity();
}

template <class S>
RigidImpacts<S>::RigidImpacts(const Model<S>& model, bool contact) {
  if (!contact || model.rigid.empty()) return;
  radius_ = smallest_radius(model.scene, model.mesh);
  const std::vector<Velocities> of_body = velocities_of_bodies(model);
  for (std::size_t b = 0; b < of_body.size(); ++b) {
    if (model.rigid_of_body[b] < 0) others_.push_back({of_body[b].mean(), of_body[b].radius});
  }
}

template <class S>
double RigidImpacts<S>::longest_step(const RigidBodies<S>& bodies, double leap, double most) const {
  if (radius_ == 0) return std::numeric_limits<double>::infinity();
  const double speed = bodies.relative_speed(others_, leap, radius_ / most);
  return speed > 0 ? radius_ / speed : std::numeric_limits<double>::infinity();
}

template double longest_contact_step<double>(const Model<double>&);
template double longest_contact_step<float>(const Model<float>&);
template class RigidImpacts<double>;
template class RigidImpacts<float>;

}  // namespace pinball
