#include "impact_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pinball {

namespace {

/// Bounds of the velocities of a body's nodes.
struct Velocities {
  Point low, high;
  void take(const Point& v) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v[k]);
      high[k] = std::max(high[k], v[k]);
    }
  }
};

/// Per component.
Point largest_relative_velocity(const Velocities& a, const Velocities& b) {
  Point most;
  for (std::size_t k = 0; k < 3; ++k) most[k] = std::max({0.0, a.high[k] - b.low[k], b.high[k] - a.low[k]});
  return most;
}

/// Of all pairs. Of many bodies nearly all pairs are known by their squares to be slower.
double largest_relative_speed(const std::vector<Velocities>& of_body) {
  double speed = 0, square = 0;
  for (std::size_t a = 0; a < of_body.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Point v = largest_relative_velocity(of_body[a], of_body[b]);
      const double own = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
      if (own < (1 - 1e-12) * square) continue;
      square = std::max(square, own);
      speed = std::max(speed, std::hypot(v[0], v[1], v[2]));
    }
  }
  return speed;
}

}  // namespace

template <class S>
double longest_contact_step(const Model<S>& model) {
  const double infinite = std::numeric_limits<double>::infinity();
  const ModelMesh& mesh = model.mesh;
  std::vector<Velocities> of_body(mesh.body_names.size(),
                                  {{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}});
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const S* v = record(model.nodes.velocity.data(), model.node_of_scene_node[n]);
    of_body[mesh.body_of_node[n]].take({v[0], v[1], v[2]});
  }
  const double speed = largest_relative_speed(of_body);
  double volume = infinite;
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) volume = std::min(volume, element_volume(mesh, e));
  const double radius = model.scene.contact.radius_factor * std::cbrt(3 * volume / (4 * M_PI));
  return speed > 0 ? radius / speed : infinite;
}

template double longest_contact_step<double>(const Model<double>&);
template double longest_contact_step<float>(const Model<float>&);

}  // namespace pinball
