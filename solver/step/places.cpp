#include "places.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <kernels/hourglass.hpp>
#include <solver/model/model_surface.hpp>
#include <solver/model/place_names.hpp>

namespace pinball {

namespace {

/// What the hourglass forces of an element have kept: 8/3 V_0/(kappa M) Z.Z (kernels/hourglass.hpp) [energy].
template <class S>
double kept_hourglass_energy(const ElementStore& elements, const ElementConstants<S>& constants, std::int64_t slot) {
  const int components = elements.hourglass_state.size() / elements.slots;
  double square = 0;
  for (int c = 0; c < components; ++c) {
    const double z = elements.hourglass_state[elements.at(slot, c, components)];
    square += z * z;
  }
  const double modulus = constants.hourglass.modulus, volume = elements.mass[slot] * constants.specific_volume;
  return modulus > 0 ? 8.0 / 3.0 * volume / modulus * square : 0.0;
}

Vec3<double> vector_of(const auto* components) { return {components[0], components[1], components[2]}; }

/// What viscous hourglass forces take of an element while a wave crosses it: 24 k m h.h of the rates h [energy]. The
/// rates are none in a turn and in a uniform strain, whatever the shape of the element.
template <class S>
double moving_hourglass_energy(const Model<S>& model, const ElementConstants<S>& constants, std::int64_t slot) {
  const std::array<std::int32_t, 8> corners = model.elements.corners(slot);
  Vec3<double> position[8], velocity[8];
  for (std::size_t i = 0; i < 8; ++i) {
    position[i] = vector_of(model.nodes.position_of(corners[i]));
    velocity[i] = vector_of(model.nodes.velocity_of(corners[i]));
  }
  const HexahedronModes<double> x = to_modes(position), v = to_modes(velocity);
  const UniformGradient<double> gradient = uniform_gradient(x);
  const double volume = hexahedron_volume(gradient, x);
  if (!(volume > 0)) return 0;
  const Tensor<double> change = velocity_gradient(gradient, v, 1 / volume);
  double square = 0;
  for (int a = 0; a < 4; ++a) {
    const Vec3<double> rate = hourglass_rate(change, x, v, a);
    square += dot(rate, rate);
  }
  return 24.0 * constants.hourglass.coefficient * model.elements.mass[slot] * square;
}

/// Of an element whose kernel has hourglass forces; else 0: of rigid bodies, tetrahedra and wedges, and without
/// control.
template <class S>
double hourglass_energy(const Model<S>& model, std::int64_t slot) {
  const std::size_t number = model.part_of_slot(slot);
  const Part& part = model.parts[number];
  const ElementConstants<S>& constants = model.constants[number];
  const HourglassKind kind = part.features.hourglass;
  if (part.rigid || part.features.tetrahedra || constants.averaged_volumes || kind == HourglassKind::none) return 0;
  return keeps_hourglass_state(kind) ? kept_hourglass_energy(model.elements, constants, slot)
                                     : moving_hourglass_energy(model, constants, slot);
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
  std::int64_t most = -1;
  double largest = 0;
  for (const std::int64_t slot : model.slot_of_element) {
    if (!model.elements.alive(slot)) continue;
    const double energy = hourglass_energy(model, slot);
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
