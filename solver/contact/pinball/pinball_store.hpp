#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <kernels/contact_force.hpp>
#include <kernels/exec/array.hpp>
#include <kernels/pinball_geometry.hpp>

namespace pinball {

/// The pinballs that have neighbours (PinballGeometryView, PinballView), in the order of their slots, so that the
/// pinballs of a tile of elements are consecutive. Those of elements behind the surface wait with B R = 0 until erosion
/// exposes them, so that lists and numbers last over many erosions.
template <class S>
struct PinballStore {
  std::int32_t count = 0;
  int row = 1;                                       ///< W
  S radius_factor = 1;                               ///< contact.radius_factor [-]
  Array<std::int32_t> corner;                        ///< in tiles of W
  Array<S> exposed;                                  ///< in tiles of W
  Array<S> bulk_modulus;                             ///< in tiles of W
  Array<S> centre;                                   ///< records: C, R
  Array<S> velocity;                                 ///< records: V, element mass
  Array<S> outward;                                  ///< records: outward normal, B R
  Array<S> two_sided;                                ///< records: two-sided normal, 1 for an element of a bar
  Array<S> force;                                    ///< records: F, sum of p2
  std::vector<std::array<std::int32_t, 8>> corners;  ///< node numbers, per pinball
  std::vector<std::int32_t> slot;                    ///< of the element
  std::vector<std::int32_t> tile_first;              ///< first pinball of each tile of elements; tiles + 1 entries

  /// Makes room for n pinballs; all numbers but of `slot` and `corners` are zero.
  void reset(std::int32_t n, int width) {
    count = n;
    row = width;
    const std::size_t padded = (n + width - 1) / width * width;
    corner.reset(8 * padded);
    exposed.reset(6 * padded);
    bulk_modulus.reset(padded);
    for (Array<S>* records : {&centre, &velocity, &outward, &two_sided, &force}) records->reset(4 * padded);
    corners.resize(n);
    slot.resize(n);
  }

  PinballGeometryView<S> geometry() {
    return {corner.data(),   exposed.data(), bulk_modulus.data(), centre.data(),
            velocity.data(), outward.data(), two_sided.data(),    row,
            radius_factor};
  }
  std::size_t bytes() const {
    return corner.bytes() + exposed.bytes() + bulk_modulus.bytes() + centre.bytes() + velocity.bytes() +
           outward.bytes() + two_sided.bytes() + force.bytes() + (slot.capacity() + 8 * corners.capacity()) * 4;
  }
};

}  // namespace pinball
