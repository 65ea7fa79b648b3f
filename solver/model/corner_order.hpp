#pragma once

#include <algorithm>
#include <cstdint>

#include <solver/base/packs.hpp>

#include "model.hpp"

namespace pinball {

/// visit(tile, slot, i) for corner i of all elements, in the order in which the host adds their forces to the nodes:
/// colours, tiles, rows of the widest pack, corners, lanes (tile_kernels_instances.hpp).
template <class S, class Visit>
void for_each_corner_in_order(const Model<S>& model, const Visit& visit) {
  for (const std::int32_t tile : model.tile_colours.items) {
    const SlotRange slots = model.slots_of(tile);
    for (std::int64_t row = slots.first; row < slots.last; row += widest_pack<S>) {
      const std::int64_t end = std::min<std::int64_t>(row + widest_pack<S>, slots.last);
      for (int i = 0; i < 8; ++i) {
        for (std::int64_t slot = row; slot < end; ++slot) {
          if (!model.is_padding(slot)) visit(tile, slot, i);
        }
      }
    }
  }
}

}  // namespace pinball
