#pragma once

#include <cstdint>
#include <vector>

#include <kernels/element_data.hpp>
#include <kernels/exec.hpp>
#include <solver/elements/nodal_volume_lists.hpp>

/// A model as it lies on a device: plain arrays that say nothing of the width of the host's packs, so that sources of a
/// device's compiler may include them (the host's stores have another layout there).
namespace pinball {

/// Elements in a row of all arrays: a warp's threads, or a wavefront's, read consecutive numbers.
inline constexpr int device_row = 32;

/// Elements of one material and one kind of settings, at consecutive places; from the first of a row to that of
/// another, the last row with padding.
template <class S>
struct DevicePart {
  ElementFeatures features{};
  ElementConstants<S> constants;  ///< its arrays of yield curves are the host's
  std::int64_t first = 0, last = 0;
  std::int32_t body = -1;  ///< that all of them are of, where output.body_energies asks for it
};

/// Elements with averaged volumes, by their places.
template <class S>
struct DeviceVolumes {
  NodalVolumeLists<S> lists;
  std::int64_t own = 0;  ///< the first of the lists are worked here; volumes of the others come from their ranks
  std::vector<std::int32_t> sent;  ///< of these: message after message
};

/// What never changes. A place is what a slot is to the host: where an element is in all arrays.
template <class S>
struct DeviceMesh {
  std::int32_t nodes = 0;
  std::int64_t places = 0;  ///< with padding
  std::int32_t tiles = 0;
  bool is_shared = false;  ///< with other ranks: `tile` says who works what (TileWork)
  std::vector<DevicePart<S>> parts;
  Array<std::int32_t> corner;            ///< [places x 8] in rows: nodes
  Array<std::int32_t> tile;              ///< [places / widest_pack]: of the host, each of whole packs of that width
  Array<S> mass_share;                   ///< [places]; empty: nothing has added mass
  Array<S> folding_onset;                ///< [places]; empty: no corner is near turning over at the start
  int material_numbers = 0;              ///< of an element in material_state
  Array<S> inverse_mass;                 ///< [nodes] [1/mass]
  Array<double> node_mass;               ///< [nodes] [mass]
  Array<std::uint32_t> first_of_node;    ///< [nodes + 1] (CornersOfNodes)
  Array<std::uint32_t> corners_of_node;  ///< [8 x elements], in the order in which the host adds their forces
  DeviceVolumes<S> volumes;
};

/// What a step changes. Element arrays are in rows, empty where no part needs them; units as of ElementView.
template <class S, class Memory = HostSpace>
struct DeviceState {
  Array<S, Memory> position, velocity;  ///< [nodes x 4]
  Array<S, Memory> mass, stress, plastic_strain, hourglass_state, viscous_stress, internal_energy, material_state,
      volume_ratio;

  /// Calls visit(array of this, array of other) for each of the element arrays.
  template <class Other, class Visit>
  void with_elements_of(Other& other, const Visit& visit) {
    visit(mass, other.mass);
    visit(stress, other.stress);
    visit(plastic_strain, other.plastic_strain);
    visit(hourglass_state, other.hourglass_state);
    visit(viscous_stress, other.viscous_stress);
    visit(internal_energy, other.internal_energy);
    visit(material_state, other.material_state);
    visit(volume_ratio, other.volume_ratio);
  }
  /// Of all arrays.
  template <class Other, class Visit>
  void with(Other& other, const Visit& visit) {
    visit(position, other.position);
    visit(velocity, other.velocity);
    with_elements_of(other, visit);
  }

  std::size_t bytes() const {
    return position.bytes() + velocity.bytes() + mass.bytes() + stress.bytes() + plastic_strain.bytes() +
           hourglass_state.bytes() + viscous_stress.bytes() + internal_energy.bytes() + material_state.bytes() +
           volume_ratio.bytes();
  }
};

}  // namespace pinball
