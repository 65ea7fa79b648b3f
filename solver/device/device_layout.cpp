#include "device_layout.hpp"

#include <algorithm>
#include <utility>

#include <solver/base/packs.hpp>
#include <solver/model/corner_order.hpp>

namespace pinball {

namespace {

template <int n>
constexpr std::size_t multiple_of(std::size_t places) {
  return (places + n - 1) / n * n;
}

}  // namespace

template <class S>
DeviceLayout<S>::DeviceLayout(const Model<S>& model) : place_of_slot_(model.elements.slots, std::int64_t{-1}) {
  std::int32_t tile = 0;
  for (std::int32_t part = 0; part < std::ssize(model.parts); ++part) {
    const auto is_of_part = [&] { return tile < model.tile_count() && model.tile_part[tile] == part; };
    while (is_of_part()) {
      const std::int64_t first = slot_of_place_.size();
      const std::int32_t body = model.tile_body.empty() ? -1 : model.tile_body[tile];
      for (; is_of_part() && (body < 0 || model.tile_body[tile] == body); ++tile) add_tile(model, tile);
      slot_of_place_.resize(multiple_of<device_row>(slot_of_place_.size()), -1);
      tile_.resize(slot_of_place_.size() / widest_pack<S>, tile - 1);
      if (model.parts[part].rigid) continue;  // no kernel works them
      parts_.push_back({model.parts[part].features, model.constants[part], first, std::ssize(slot_of_place_), body});
    }
  }
}

template <class S>
void DeviceLayout<S>::add_tile(const Model<S>& model, std::int32_t tile) {
  for (const std::int64_t slot : model.slots_of(tile)) {
    if (model.is_padding(slot)) continue;
    place_of_slot_[slot] = slot_of_place_.size();
    slot_of_place_.push_back(slot);
  }
  slot_of_place_.resize(multiple_of<widest_pack<S>>(slot_of_place_.size()), -1);
  tile_.resize(slot_of_place_.size() / widest_pack<S>, tile);
}

/// In rows, what the host has in packs; padding is zero.
template <class S>
template <class T>
Array<T> DeviceLayout<S>::rows_of(const Array<T>& packs, int components) const {
  if (packs.empty()) return {};
  Array<T> rows(components * slot_of_place_.size());
  for (std::size_t place = 0; place < slot_of_place_.size(); ++place) {
    const std::int64_t slot = slot_of_place_[place];
    if (slot < 0) continue;
    for (int c = 0; c < components; ++c) {
      rows[place_in_packs<device_row>(place, c, components)] =
          packs[place_in_packs<native_width<S>>(slot, c, components)];
    }
  }
  return rows;
}

template <class S>
template <class T>
void DeviceLayout<S>::rows_to(const Array<T>& rows, int components, Array<T>& packs) const {
  if (packs.empty()) return;
  for (std::size_t place = 0; place < slot_of_place_.size(); ++place) {
    const std::int64_t slot = slot_of_place_[place];
    if (slot < 0) continue;
    for (int c = 0; c < components; ++c) {
      packs[place_in_packs<native_width<S>>(slot, c, components)] =
          rows[place_in_packs<device_row>(place, c, components)];
    }
  }
}

/// Padding has no mass, but it has a shape, that of the element before it: strains are found of that, too.
template <class S>
void DeviceLayout<S>::repeat_last_element(Array<std::int32_t>& corner) const {
  for (std::size_t place = 1; place < slot_of_place_.size(); ++place) {
    if (slot_of_place_[place] >= 0) continue;
    const std::int64_t here = place;
    for (int i = 0; i < 8; ++i) {
      corner[place_in_packs<device_row>(here, i, 8)] = corner[place_in_packs<device_row>(here - 1, i, 8)];
    }
  }
}

template <class S>
DeviceMesh<S> DeviceLayout<S>::mesh(const Model<S>& model) const {
  DeviceMesh<S> mesh;
  mesh.nodes = model.nodes.count;
  mesh.places = slot_of_place_.size();
  mesh.parts = parts_;
  mesh.corner = rows_of(model.elements.corner, 8);
  repeat_last_element(mesh.corner);
  mesh.tiles = model.tile_count();
  mesh.tile = Array<std::int32_t>(tile_.size());
  std::copy(tile_.begin(), tile_.end(), mesh.tile.data());
  mesh.mass_share = rows_of(model.elements.mass_share.template in<S>(), 1);
  mesh.folding_onset = rows_of(model.elements.folding_onset.template in<S>(), 1);
  mesh.material_numbers = model.elements.material_numbers;
  mesh.inverse_mass = Array<S>(mesh.nodes);
  mesh.node_mass = Array<double>(mesh.nodes);
  std::copy_n(model.nodes.inverse_mass.data(), mesh.nodes, mesh.inverse_mass.data());
  std::copy_n(model.node_mass.data(), mesh.nodes, mesh.node_mass.data());
  add_corners_of_nodes(model, mesh);
  return mesh;
}

template <class S>
NodalVolumeLists<S> DeviceLayout<S>::lists_of_places(NodalVolumeLists<S> by_slots) const {
  for (std::int64_t t = 0; t < by_slots.elements(); ++t) by_slots.place[t] = place_of_slot(by_slots.place[t]);
  return by_slots;
}

/// The corners of each node in the order in which the host adds their forces.
template <class S>
void DeviceLayout<S>::add_corners_of_nodes(const Model<S>& model, DeviceMesh<S>& mesh) const {
  const auto for_each_corner = [&](const auto& visit) {
    for_each_corner_in_order(model, [&](std::int32_t /*tile*/, std::int64_t slot, int i) {
      visit(model.elements.corner[model.elements.at(slot, i, 8)],
            static_cast<std::uint32_t>(8 * place_of_slot(slot) + i));
    });
  };
  mesh.first_of_node = Array<std::uint32_t>(static_cast<std::size_t>(mesh.nodes) + 1);
  for_each_corner([&](std::size_t node, std::uint32_t) { ++mesh.first_of_node[node + 1]; });
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.nodes); ++n) {
    mesh.first_of_node[n + 1] += mesh.first_of_node[n];
  }
  mesh.corners_of_node = Array<std::uint32_t>(mesh.first_of_node[mesh.nodes]);
  std::vector<std::uint32_t> next(mesh.first_of_node.data(), mesh.first_of_node.data() + mesh.nodes);
  for_each_corner([&](std::size_t node, std::uint32_t corner) { mesh.corners_of_node[next[node]++] = corner; });
}

template <class S>
DeviceState<S> DeviceLayout<S>::state(const Model<S>& model) const {
  const ElementStore& e = model.elements;
  DeviceState<S> state;
  const auto copy = [](const Array<S>& from, Array<S>& to) {
    to.reset(from.size());
    std::copy_n(from.data(), from.size(), to.data());
  };
  copy(model.nodes.position, state.position);
  copy(model.nodes.velocity, state.velocity);
  state.mass = rows_of(e.mass.template in<S>(), 1);
  state.stress = rows_of(e.stress.template in<S>(), 6);
  state.plastic_strain = rows_of(e.plastic_strain.template in<S>(), 1);
  state.hourglass_state = rows_of(e.hourglass_state.template in<S>(), 12);
  state.viscous_stress = rows_of(e.viscous_stress.template in<S>(), 1);
  state.internal_energy = rows_of(e.internal_energy.template in<S>(), 1);
  state.material_state = rows_of(e.material_state.template in<S>(), e.material_numbers);
  state.volume_ratio = rows_of(e.volume_ratio.template in<S>(), 2);
  return state;
}

template <class S>
void DeviceLayout<S>::to_model(const DeviceState<S>& state, Model<S>& model) const {
  ElementStore& e = model.elements;
  std::copy_n(state.position.data(), state.position.size(), model.nodes.position.data());
  std::copy_n(state.velocity.data(), state.velocity.size(), model.nodes.velocity.data());
  rows_to(state.mass, 1, e.mass.template in<S>());
  rows_to(state.stress, 6, e.stress.template in<S>());
  rows_to(state.plastic_strain, 1, e.plastic_strain.template in<S>());
  rows_to(state.hourglass_state, 12, e.hourglass_state.template in<S>());
  rows_to(state.viscous_stress, 1, e.viscous_stress.template in<S>());
  rows_to(state.internal_energy, 1, e.internal_energy.template in<S>());
  rows_to(state.material_state, e.material_numbers, e.material_state.template in<S>());
  rows_to(state.volume_ratio, 2, e.volume_ratio.template in<S>());
}

template class DeviceLayout<double>;
template class DeviceLayout<float>;

}  // namespace pinball
