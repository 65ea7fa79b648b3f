#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <kernels/element_data.hpp>
#include <kernels/exec/array.hpp>
#include <solver/base/packs.hpp>
#include <solver/base/real_array.hpp>
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
  Array<S> inverse_mass;  ///< one per node; 0 for a node that is tied [1/mass]

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
  bool volume_ratio = false;
};

/// Elements in tiles of one pack (ElementView). A "slot" is a place in the store: pack * width + lane; some are
/// padding.
struct ElementStore {
  std::int64_t slots = 0;
  bool single = false;       ///< numbers have single precision
  int width = 1;             ///< of a pack
  int material_numbers = 0;  ///< of an element in material_state
  Array<std::int32_t> corner;
  RealArray mass;
  RealArray stress;
  RealArray plastic_strain;
  RealArray hourglass_state;
  RealArray viscous_stress;
  RealArray internal_energy;
  RealArray material_state;
  RealArray mass_share;     ///< never changes; only where mass is added
  RealArray folding_onset;  ///< never changes; only where a corner is near turning over at the start
  RealArray volume_ratio;   ///< only where volumes are averaged over nodes

  ElementStore() = default;
  ElementStore(std::int64_t packs, const ElementStoreFeatures& features, bool in_single)
      : slots(packs * width_in(in_single)), single(in_single), width(width_in(in_single)) {
    const auto numbers = [this](int components) { return RealArray(components * slots, single); };
    corner = Array<std::int32_t>(8 * slots);
    mass = numbers(1);
    stress = numbers(6);
    plastic_strain = numbers(features.plastic ? 1 : 0);
    hourglass_state = numbers(features.hourglass_state ? 12 : 0);
    viscous_stress = numbers(features.bulk_viscosity ? 1 : 0);
    internal_energy = numbers(features.erosion ? 1 : 0);
    material_numbers = features.material_numbers;
    material_state = numbers(material_numbers);
    mass_share = numbers(features.mass_share ? 1 : 0);
    folding_onset = numbers(features.folding_onset ? 1 : 0);
    volume_ratio = numbers(features.volume_ratio ? 2 : 0);
  }

  /// Lanes of a pack of this program.
  static constexpr int width_in(bool in_single) { return in_single ? native_width<float> : native_width<double>; }

  /// E: their precision.
  template <class E>
  ElementView<E> view() {
    return {corner.data(),
            mass.data<E>(),
            stress.data<E>(),
            plastic_strain.data<E>(),
            hourglass_state.data<E>(),
            viscous_stress.data<E>(),
            internal_energy.data<E>(),
            material_state.data<E>(),
            mass_share.data<E>(),
            folding_onset.data<E>(),
            material_numbers,
            volume_ratio.data<E>()};
  }
  /// What a step changes, in a fixed order.
  std::array<RealArray*, 8> state() {
    return {&mass,           &stress,          &plastic_strain, &hourglass_state,
            &viscous_stress, &internal_energy, &material_state, &volume_ratio};
  }
  std::size_t bytes() const {
    return corner.bytes() + mass.bytes() + stress.bytes() + plastic_strain.bytes() + hourglass_state.bytes() +
           viscous_stress.bytes() + internal_energy.bytes() + material_state.bytes() + mass_share.bytes() +
           folding_onset.bytes() + volume_ratio.bytes();
  }

  /// Whether a slot holds an element that has not been eroded; padding does not.
  bool alive(std::int64_t slot) const { return mass[slot] > 0; }
  /// Nodes of the store at the corners of a slot; those of padding are a real element's.
  std::array<std::int32_t, 8> corners(std::int64_t slot) const {
    std::array<std::int32_t, 8> nodes;
    for (int i = 0; i < 8; ++i) nodes[i] = corner[at(slot, i, 8)];
    return nodes;
  }
  /// xx yy zz xy yz zx [stress]
  std::array<double, 6> stress_of(std::int64_t slot) const {
    std::array<double, 6> components;
    for (int c = 0; c < 6; ++c) components[c] = stress_of(slot, c);
    return components;
  }
  double stress_of(std::int64_t slot, int c) const { return stress[at(slot, c, 6)]; }

  /// Number of those in material_state that a material has at a place (MaterialPlaces).
  double material_number(std::int64_t slot, int place) const {
    return material_state[at(slot, place, material_numbers)];
  }

  /// Place of component c of slot s in an array of n components.
  std::size_t at(std::int64_t s, int c, int n) const { return place_in_packs(width, s, c, n); }
};

}  // namespace pinball
