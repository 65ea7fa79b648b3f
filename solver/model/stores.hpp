#pragma once

#include <cstdint>

#include <kernels/element_update.hpp>
#include <solver/base/aligned_array.hpp>
#include <solver/base/packs.hpp>

/// The hot data: what a step touches, and nothing else. Layouts are those of the kernels' views.
namespace pinball {

/// Nodes, in the order in which the elements first touch them. Records of four numbers per node (gather.hpp).
template <class S>
struct NodeStore {
  std::int32_t count = 0;
  AlignedArray<S> position;      ///< x, y, z, unused [length]
  AlignedArray<S> velocity;      ///< at the middle of the last step, unused [length/time]
  AlignedArray<S> force;         ///< force, contact stiffness [force], [force/length]; zero between steps
  AlignedArray<S> inverse_mass;  ///< one per node; 0 for a node of no element [1/mass]

  explicit NodeStore(std::int32_t n = 0)
      : count(n),
        position(4 * static_cast<std::size_t>(n)),
        velocity(4 * static_cast<std::size_t>(n)),
        force(4 * static_cast<std::size_t>(n)),
        inverse_mass(static_cast<std::size_t>(n)) {}

  NodeView<S> view() { return {position.data(), velocity.data(), force.data()}; }
  std::size_t bytes() const { return position.bytes() + velocity.bytes() + force.bytes() + inverse_mass.bytes(); }
};

/// What the arrays of an ElementStore have to hold.
struct ElementStoreFeatures {
  bool plastic = false;
  bool erosion = false;
  bool bulk_viscosity = false;
  bool hourglass_force = false;
};

/// Elements in tiles of one pack (ElementView). A "slot" is a place in the store: pack * W + lane; some are padding.
template <class S>
struct ElementStore {
  static constexpr int width = native_width<S>;

  std::int64_t slots = 0;
  AlignedArray<std::int32_t> corner;
  AlignedArray<S> mass;
  AlignedArray<S> stress;
  AlignedArray<S> plastic_strain;
  AlignedArray<S> hourglass_force;
  AlignedArray<S> viscous_stress;
  AlignedArray<S> internal_energy;

  ElementStore() = default;
  ElementStore(std::int64_t packs, const ElementStoreFeatures& features) : slots(packs * width) {
    const auto n = static_cast<std::size_t>(slots);
    corner = AlignedArray<std::int32_t>(8 * n);
    mass = AlignedArray<S>(n);
    stress = AlignedArray<S>(6 * n);
    if (features.plastic) plastic_strain = AlignedArray<S>(n);
    if (features.hourglass_force) hourglass_force = AlignedArray<S>(12 * n);
    if (features.bulk_viscosity) viscous_stress = AlignedArray<S>(n);
    if (features.erosion) internal_energy = AlignedArray<S>(n);
  }

  ElementView<S> view() {
    return {corner.data(),          mass.data(),           stress.data(),         plastic_strain.data(),
            hourglass_force.data(), viscous_stress.data(), internal_energy.data()};
  }
  std::size_t bytes() const {
    return corner.bytes() + mass.bytes() + stress.bytes() + plastic_strain.bytes() + hourglass_force.bytes() +
           viscous_stress.bytes() + internal_energy.bytes();
  }

  /// Place of component c of slot s in an array of n components.
  static std::size_t at(std::int64_t s, int c, int n) { return place_in_packs<width>(s, c, n); }
};

}  // namespace pinball
