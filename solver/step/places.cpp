#include "places.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <solver/model/model_surface.hpp>
#include <solver/model/place_names.hpp>

namespace pinball {

namespace {

/// Square of what is kept of the hourglass modes, stresses or viscous forces, times the mass: in proportion to their
/// energy where elements are alike.
double kept_hourglass_energy(const ElementStore& elements, std::int64_t slot) {
  const int components = elements.hourglass_state.size() / elements.slots;
  double square = 0;
  for (int c = 0; c < components; ++c) {
    const double p = elements.hourglass_state[elements.at(slot, c, components)];
    square += p * p;
  }
  return square * elements.mass[slot];
}

/// Mass times square of the velocities of the hourglass modes.
template <class S>
double moving_hourglass_energy(const Model<S>& model, std::int64_t slot) {
  // Signs of the corners in the modes eta zeta, zeta xi, xi eta and xi eta zeta.
  constexpr int xi[8] = {-1, 1, 1, -1, -1, 1, 1, -1}, eta[8] = {-1, -1, 1, 1, -1, -1, 1, 1};
  constexpr int zeta[8] = {-1, -1, -1, -1, 1, 1, 1, 1};
  const std::array<std::int32_t, 8> corners = model.elements.corners(slot);
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    double mode[4] = {};
    for (int i = 0; i < 8; ++i) {
      const double v = model.nodes.velocity_of(corners[i])[k];
      mode[0] += eta[i] * zeta[i] * v;
      mode[1] += zeta[i] * xi[i] * v;
      mode[2] += xi[i] * eta[i] * v;
      mode[3] += xi[i] * eta[i] * zeta[i] * v;
    }
    for (const double m : mode) square += m * m;
  }
  return model.elements.mass[slot] * square;
}

}  // namespace

template <class S>
std::array<Point, 8> corners_at_forces(const Model<S>& model, std::int64_t slot, double dt) {
  std::array<Point, 8> corners;
  const std::array<std::int32_t, 8> nodes = model.elements.corners(slot);
  for (std::size_t i = 0; i < 8; ++i) {
    const S *const x = model.nodes.position_of(nodes[i]), *const v = model.nodes.velocity_of(nodes[i]);
    for (std::size_t k = 0; k < 3; ++k) corners[i][k] = static_cast<double>(x[k]) - dt * static_cast<double>(v[k]);
  }
  return corners;
}

template <class S>
std::string node_name(const Model<S>& model, std::int64_t node) {
  if (node < 0) return "";
  const auto at = std::find(model.node_of_scene_node.begin(), model.node_of_scene_node.end(), node);
  if (at == model.node_of_scene_node.end()) return "";
  return node_name(model.mesh, at - model.node_of_scene_node.begin());
}

template <class S>
std::int64_t most_pushed_node(const Model<S>& model, const ContactAlgorithm<S>& contact) {
  Array<Point> force(model.nodes.count);
  contact.add_node_forces({force.data(), force.size()});
  std::int64_t most = -1;
  double largest = 0;
  for (const std::int32_t node : model.node_of_scene_node) {  // the first in the order of the scene
    const double square = dot(force[node], force[node]);
    if (!(square > largest)) continue;
    largest = square;
    most = node;
  }
  return most;
}

template <class S>
std::int64_t most_hourglassed_slot(const Model<S>& model) {
  const bool any_kept = std::any_of(model.parts.begin(), model.parts.end(),
                                    [](const auto& part) { return keeps_hourglass_state(part.features.hourglass); });
  std::int64_t most = -1;
  double largest = 0;
  for (const std::int64_t slot : model.slot_of_element) {
    if (!model.elements.alive(slot)) continue;
    const double energy = any_kept ? kept_hourglass_energy(model.elements, slot) : moving_hourglass_energy(model, slot);
    if (!(energy > largest)) continue;
    largest = energy;
    most = slot;
  }
  return most;
}

template std::array<Point, 8> corners_at_forces(const Model<double>&, std::int64_t, double);
template std::array<Point, 8> corners_at_forces(const Model<float>&, std::int64_t, double);
template std::string node_name(const Model<double>&, std::int64_t);
template std::string node_name(const Model<float>&, std::int64_t);
template std::int64_t most_pushed_node(const Model<double>&, const ContactAlgorithm<double>&);
template std::int64_t most_pushed_node(const Model<float>&, const ContactAlgorithm<float>&);
template std::int64_t most_hourglassed_slot(const Model<double>&);
template std::int64_t most_hourglassed_slot(const Model<float>&);

}  // namespace pinball
