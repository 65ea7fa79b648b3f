#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <kernels/element_data.hpp>
#include <kernels/exec/array.hpp>
#include <solver/base/packs.hpp>
#include <solver/base/records.hpp>

/// The hot data: what a step touches, and nothing else. Layouts are those of the kernels' views.
namespace pinball {

/// Nodes, in the order in which the elements first touch them. Records of four numbers per node (gather.hpp).
template <class S>
struct NodeStore {
  std::int32_t count = 0;
  Array<S> position;      ///< x, y, z, unused [length]
  Array<S> velocity;      ///< at the middle of the last step, unused [length/time]
  Array<S> force;         ///< force, contact stiffness [force], [force/length]; zero between steps
  Array<S> inverse_mass;  ///< one per node; 0 for a node of no element [1/mass]

  explicit NodeStore(std::int32_t n = 0)
      : count(n), position(numbers(n)), velocity(numbers(n)), force(numbers(n)), inverse_mass(n) {}

  /// The record of four numbers of a node.
  S* position_of(std::int64_t node) { return record(position.data(), node); }
  S* velocity_of(std::int64_t node) { return record(velocity.data(), node); }
  S* force_of(std::int64_t node) { return record(force.data(), node); }
  const S* position_of(std::int64_t node) const { return record(position.data(), node); }
  const S* velocity_of(std::int64_t node) const { return record(velocity.data(), node); }
  const S* force_of(std::int64_t node) const { return record(force.data(), node); }

  /// Records behind those of the nodes: of corners that are kept apart (parallel/corner_exchange.hpp).
  void add_records(std::int64_t more) {
    for (Array<S>* array : {&position, &velocity, &force}) {
      Array<S> longer(numbers(count + more));
      std::copy_n(array->data(), numbers(count), longer.data());
      *array = std::move(longer);
    }
  }

  NodeView<S> view() { return {position.data(), velocity.data(), force.data()}; }
  std::size_t bytes() const { return position.bytes() + velocity.bytes() + force.bytes() + inverse_mass.bytes(); }

 private:
  static constexpr std::int64_t numbers(std::int64_t records) { return 4 * records; }
};

/// What the arrays of an ElementStore have to hold.
struct ElementStoreFeatures {
  bool plastic = false;
  bool erosion = false;
  bool bulk_viscosity = false;
  bool hourglass_state = false;
  int material_numbers = 0;  ///< of an element in material_state
  bool mass_share = false;
  bool folding_onset = false;
};

/// Elements in tiles of one pack (ElementView). A "slot" is a place in the store: pack * W + lane; some are padding.
template <class S>
struct ElementStore {
  static constexpr int width = native_width<S>;

  std::int64_t slots = 0;
  int material_numbers = 0;  ///< of an element in material_state
  Array<std::int32_t> corner;
  Array<S> mass;
  Array<S> stress;
  Array<S> plastic_strain;
  Array<S> hourglass_state;
  Array<S> viscous_stress;
  Array<S> internal_energy;
  Array<S> material_state;
  Array<S> mass_share;     ///< never changes; only where mass is added
  Array<S> folding_onset;  ///< never changes; only where a corner is near turning over at the start

  ElementStore() = default;
  ElementStore(std::int64_t packs, const ElementStoreFeatures& features) : slots(packs * width) {
    corner = Array<std::int32_t>(8 * slots);
    mass = Array<S>(slots);
    stress = Array<S>(6 * slots);
    if (features.plastic) plastic_strain = Array<S>(slots);
    if (features.hourglass_state) hourglass_state = Array<S>(12 * slots);
    if (features.bulk_viscosity) viscous_stress = Array<S>(slots);
    if (features.erosion) internal_energy = Array<S>(slots);
    material_numbers = features.material_numbers;
    material_state = Array<S>(material_numbers * slots);
    if (features.mass_share) mass_share = Array<S>(slots);
    if (features.folding_onset) folding_onset = Array<S>(slots);
  }

  ElementView<S> view() {
    return {corner.data(),
            mass.data(),
            stress.data(),
            plastic_strain.data(),
            hourglass_state.data(),
            viscous_stress.data(),
            internal_energy.data(),
            material_state.data(),
            mass_share.empty() ? nullptr : mass_share.data(),
            folding_onset.empty() ? nullptr : folding_onset.data(),
            material_numbers};
  }
  std::size_t bytes() const {
    return corner.bytes() + mass.bytes() + stress.bytes() + plastic_strain.bytes() + hourglass_state.bytes() +
           viscous_stress.bytes() + internal_energy.bytes() + material_state.bytes() + mass_share.bytes() +
           folding_onset.bytes();
  }

  /// Whether a slot holds an element that has not been eroded; padding does not.
  bool alive(std::int64_t slot) const { return mass[slot] > S(0); }
  /// Nodes of the store at the corners of a slot; those of padding are a real element's.
  std::array<std::int32_t, 8> corners(std::int64_t slot) const { return components_of<8>(corner, slot); }
  /// xx yy zz xy yz zx [stress]
  std::array<S, 6> stress_of(std::int64_t slot) const { return components_of<6>(stress, slot); }
  S& stress_of(std::int64_t slot, int c) { return stress[at(slot, c, 6)]; }
  const S& stress_of(std::int64_t slot, int c) const { return stress[at(slot, c, 6)]; }

  /// Number of those in material_state that a material has at a place (MaterialPlaces).
  S material_number(std::int64_t slot, int place) const { return material_state[at(slot, place, material_numbers)]; }

  /// Place of component c of slot s in an array of n components.
  static std::size_t at(std::int64_t s, int c, int n) { return place_in_packs<width>(s, c, n); }

 private:
  template <int N, class T>
  static std::array<T, N> components_of(const Array<T>& array, std::int64_t slot) {
    std::array<T, N> components;
    for (int c = 0; c < N; ++c) components[c] = array[at(slot, c, N)];
    return components;
  }
};

}  // namespace pinball
