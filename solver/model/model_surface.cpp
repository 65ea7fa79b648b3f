#include "model_surface.hpp"

#include <algorithm>

#include <kernels/pinball.hpp>
#include <solver/base/built_features.hpp>
#include <solver/base/faces.hpp>

#include "exposed_faces.hpp"
#include "interfaces/contact_sides.hpp"

namespace pinball {

template <class S>
ModelSurface<S>::ModelSurface(const Model<S>& model, S* node_force) : model_(model) {
  this->lists_last = model.scene.skip.contact_search;
  this->node_count = model.nodes.count;
  this->position = model.nodes.position.data();
  this->velocity = model.nodes.velocity.data();
  this->force = node_force;
  this->inverse_mass =
      model.contact_inverse_mass != nullptr ? model.contact_inverse_mass : model.nodes.inverse_mass.data();
  this->slots = model.elements.slots;
  this->tile_packs = model.tile_packs;
  this->tile_pack_width = model.elements.width;
  this->tile_colours = &model.tile_colours;
}

template <class S>
ContactElement ModelSurface<S>::element(std::int64_t slot) const {
  const std::size_t e = model_.element_of_slot[slot];
  const Material& material = model_.scene.materials[model_.parts[model_.part_of_slot(slot)].material];
  ContactElement element{};
  for (int i = 0; i < 8; ++i) {
    const std::size_t corner = i;
    element.corners[corner] = model_.elements.corner[model_.elements.at(slot, i, 8)];
    element.reference[corner] = model_.mesh.nodes[model_.mesh.hexahedra[e][corner]];
  }
  element.body = model_.mesh.body[e];
  if (const std::int32_t rigid = model_.rigid_of_body[element.body]; rigid >= 0) {
    element.rigid = true;
    element.body = model_.rigid[rigid].first_body;
  }
  element.mass = model_.element_mass[e];
  element.volume = model_.material_mass(e) / material.density;
  element.radius = ball_radius(element.volume);
  element.bulk_modulus = material.bulk_modulus;
  return element;
}

template <class S>
bool ModelSurface<S>::may_soon_erode(std::int64_t slot) const {
  const std::size_t part = model_.part_of_slot(slot);
  if (!model_.parts[part].features.erosion) return false;
  const S limit = std::min(S(1), model_.constants[part].failure.plastic_strain);
  return static_cast<S>(model_.elements.plastic_strain[slot]) > S(0.7) * limit;
}

template <class S>
HeldDirections held_directions(const Model<S>& model) {
  std::vector<HeldDirection> held;
  const auto hold = [&held](std::int32_t node, const S* n) { held.push_back({node, {n[0], n[1], n[2]}}); };
  for (const NodeConstraint<S>& c : model.constraints) hold(c.node, c.normal);
  for (const NodePrescription<S>& p : model.prescribed) hold(p.node, p.normal);
  return {model.nodes.count, held};
}

template <class S>
SurfaceTopology surface_topology(const Model<S>& model) {
  SurfaceTopology topology(model.elements.slots);
  const std::vector<std::array<std::int32_t, 6>> neighbours = face_neighbours(model.mesh.hexahedra);
  const std::vector<std::uint8_t> exposed = find_exposed_faces(model.mesh, model.scene.constraints, neighbours);
  for (std::size_t e = 0; e < neighbours.size(); ++e) {
    const std::size_t slot = model.slot_of_element[e];
    topology.alive[slot] = 1;
    topology.exposed[slot] = exposed[e];
    for (std::size_t f = 0; f < 6; ++f) {
      if (neighbours[e][f] < 0) continue;
      topology.neighbour[slot][f] = model.slot_of_element[neighbours[e][f]];
    }
  }
  return topology;
}

template <class S>
std::unique_ptr<ContactAlgorithm<S>> make_model_contact([[maybe_unused]] const Model<S>& model) {
  if constexpr (built::contact) {
    const ContactSettings& settings = model.scene.contact;
    if (settings.method == ContactMethod::none) return nullptr;
    const bool by_impulses = settings.enforcement != Enforcement::penalty;
    return make_contact(
        settings, ModelSurface<S>(model),
        {surface_topology(model), by_impulses ? held_directions(model) : HeldDirections(), make_contact_pairs(model)});
  }
  return nullptr;
}

template class ModelSurface<double>;
template class ModelSurface<float>;
template HeldDirections held_directions(const Model<double>&);
template HeldDirections held_directions(const Model<float>&);
template SurfaceTopology surface_topology(const Model<double>&);
template SurfaceTopology surface_topology(const Model<float>&);
template std::unique_ptr<ContactAlgorithm<double>> make_model_contact(const Model<double>&);
template std::unique_ptr<ContactAlgorithm<float>> make_model_contact(const Model<float>&);

}  // namespace pinball
