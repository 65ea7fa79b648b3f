#pragma once

#include <algorithm>

#include <kernels/element_update.hpp>
#include <kernels/tetrahedron_update.hpp>

#include "element_features.hpp"
#include "tile_kernels.hpp"

/// The kernels behind choose_tile_kernel. Included by one source file per precision, because compiling them takes long.
namespace pinball {

/// Asks the caches for a pack in eight parts, of each the nodes of one corner and some of the element state. Where
/// nodes lie nothing but the corner numbers says, so that the processor cannot foresee it; element state it can, but
/// not beyond a page of memory, which is five packs.
///
/// All is inlined by force: GCC 12 takes a function that only prefetches for one that does nothing, and drops the call.
template <class T, ElementFeatures features, class N>
class PackAhead {
  using S = ScalarOf<T>;
  static constexpr int W = width_of<T>;
  static constexpr bool mixed = sizeof(N) != sizeof(S);
  static constexpr int line = 64 / sizeof(S);           ///< scalars of a cache line
  static constexpr int records = 64 / (4 * sizeof(N));  ///< of nodes in one

 public:
  /// there: whether the tile has such a pack. Small tiles have few, in small meshes, which lie in the caches anyway.
  PackAhead(const ElementView<S>& elements, const NodeView<N>& nodes, std::int64_t pack, bool there)
      : elements_(elements), nodes_(nodes), pack_(pack), there_(there) {
    if constexpr (mixed) in_rows_ = there && lie_in_rows<T>(elements.corner + pack * 8 * W);
  }

  PINBALL_FUNCTION void operator()(int part) const {
    if (!there_) return;
    if constexpr (mixed) {
      // All corner numbers are looked at before the first of them; behind the last they are asked for in vain.
      __builtin_prefetch(elements_.corner + ((pack_ + 3) * 8 + part) * W);
    }
    const bool next_has_it = part == 1 || part == 2 || part == 5 || part == 6;
    if (!in_rows_ || !next_has_it) ask_for_nodes(elements_.corner + (pack_ * 8 + part) * W);
    if (part < 2) ask_for_state(elements_.stress, 6, 3 * part, 3);
    if constexpr (stores_hourglass_modes(features.hourglass)) {
      const bool there = keeps_hourglass_state(features.hourglass) || elements_.hourglass_state != nullptr;
      if (there && part >= 2 && part < 6) ask_for_state(elements_.hourglass_state, 12, 3 * (part - 2), 3);
    }
    if (part == 6) {
      ask_for_state(elements_.mass, 1, 0, 1);
      if constexpr (features.plastic) ask_for_state(elements_.plastic_strain, 1, 0, 1);
      if constexpr (features.yield == YieldLaw::general) {
        ask_for_state(elements_.material_state, elements_.material_numbers, 0, elements_.material_numbers);
      }
    }
    if (part == 7) {
      if constexpr (features.bulk_viscosity) {
        if (elements_.viscous_stress != nullptr) ask_for_state(elements_.viscous_stress, 1, 0, 1);
      }
      if constexpr (features.erosion) {
        if (elements_.internal_energy != nullptr) ask_for_state(elements_.internal_energy, 1, 0, 1);
      }
    }
  }

 private:
  PINBALL_FUNCTION void ask_for_nodes(const std::int32_t* corner) const {
    PINBALL_UNROLL
    for (int i = 0; i < W; i += records) {  // elements of a row have records side by side
      const std::int64_t record = 4 * static_cast<std::int64_t>(corner[i]);
      __builtin_prefetch(nodes_.position + record);
      __builtin_prefetch(nodes_.velocity + record);
      __builtin_prefetch(nodes_.force + record);
    }
  }

  /// Components first ... first + count - 1 of an array of N components.
  PINBALL_FUNCTION void ask_for_state(const S* array, int n, int first, int count) const {
    const S* begin = array + (pack_ * n + first) * W;
    PINBALL_UNROLL
    for (int i = 0; i < count * W; i += line) __builtin_prefetch(begin + i);
  }

  const ElementView<S>& elements_;
  const NodeView<N>& nodes_;
  std::int64_t pack_;
  bool there_;
  bool in_rows_ = false;  ///< most elements of the pack have corners 1, 2, 5 and 6 where others have 0, 3, 4 and 7
};

/// One pack of a tile.
template <class T, ElementFeatures features, class N, class Forces>
PINBALL_FUNCTION void update_pack_of_tile(const TilePacks<ScalarOf<T>, N>& tile, std::int64_t pack,
                                          const Forces& forces, ElementSums<T>& sums) {
  if constexpr (features.tetrahedra) {
    update_tetrahedron_pack<T, features>(tile.elements, tile.nodes, tile.constants, tile.step, pack, pack - tile.first,
                                         sums, forces);
  } else {
    const PackAhead<T, features, N> ahead(tile.elements, tile.nodes, pack + 3, pack + 3 < tile.last);
    update_element_pack<T, features>(tile.elements, tile.nodes, tile.constants, tile.step, pack, pack - tile.first,
                                     sums, forces, ahead);
  }
}

/// A block of packs that are narrower than it: their forces are kept until all are known.
template <class T, ElementFeatures features, class N>
PINBALL_FUNCTION void update_block_of_tile(const TilePacks<ScalarOf<T>, N>& tile, std::int64_t first,
                                           ElementSums<T>& sums) {
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>, packs = widest_pack<S> / W;
  alignas(64) S kept[24 * W * packs] = {};
  const std::int64_t last = std::min<std::int64_t>(first + packs, tile.last);
  for (std::int64_t pack = first; pack < last; ++pack) {
    update_pack_of_tile<T, features>(tile, pack, KeptAtCorners<S>{kept, first * W}, sums);
  }
  constexpr bool mixed = sizeof(N) != sizeof(S);
  for (std::int64_t pack = first; mixed && pack < last; ++pack) {
    Vec3<T> value[8];
    for (int i = 0; i < 8; ++i) {
      const S* const force = kept + ((pack - first) * 24 + 3 * i) * W;
      value[i] = {load<T>(force), load<T>(force + W), load<T>(force + 2 * W)};
    }
    add_balance_to_records(tile.nodes.force, tile.elements.corner + pack * 8 * W, value);
  }
  for (int i = mixed ? 1 : 0; i < 8; ++i) {
    for (std::int64_t pack = first; pack < last; ++pack) {
      const S* const force = kept + ((pack - first) * 24 + 3 * i) * W;
      add_to_records(tile.nodes.force, tile.elements.corner + (pack * 8 + i) * W, load<T>(force), load<T>(force + W),
                     load<T>(force + 2 * W), T(0));
    }
  }
}

/// T: a pack of any width, that of the rows of the arrays.
template <class T, ElementFeatures features, class N>
PINBALL_FUNCTION void update_packs(const TilePacks<ScalarOf<T>, N>& tile, TileResult<N>& result) {
  using S = ScalarOf<T>;
  ElementSums<T> sums;
  if constexpr (width_of<T> >= widest_pack<S>) {
    for (std::int64_t pack = tile.first; pack < tile.last; ++pack) {
      update_pack_of_tile<T, features>(tile, pack, AddedToNodes<N>{tile.nodes.force}, sums);
    }
  } else {
    for (std::int64_t pack = tile.first; pack < tile.last; pack += widest_pack<S> / width_of<T>) {
      update_block_of_tile<T, features>(tile, pack, sums);
    }
  }
  result.internal = lane_sum(sums.internal);
  result.hourglass = lane_sum(sums.hourglass);
  result.viscous = lane_sum(sums.viscous);
  result.eroded = lane_sum(sums.eroded);
  result.hourglass_plastic = lane_sum(sums.hourglass_plastic);
  result.folding = lane_sum(sums.folding);
  result.eroded_count = sums.eroded_count;
  result.inverted_count = sums.inverted_count;
  result.inside_out_count = sums.inside_out_count;
  S rate = 0;
  result.time_step_slot = -1;
  for (int i = 0; i < width_of<T>; ++i) {
    if (lane(sums.stable_rate, i) > rate) {
      rate = lane(sums.stable_rate, i);
      const auto pack = tile.first + static_cast<std::int64_t>(lane(sums.stable_rate_pack, i));
      result.time_step_slot = pack * width_of<T> + i;
    }
  }
  result.time_step = S(2) / rate;  // infinite for a tile without living elements
}

template <class E, class N, ElementFeatures features>
void update_tile(const TilePacks<E, N>& tile, TileResult<N>& result) {
  update_packs<Pack<E, native_width<E>>, features>(tile, result);
}

/// The kernel that update_tile is for each of the features.
template <class E, class N>
struct UpdatesTiles {
  template <ElementFeatures features>
  TileKernel<E, N> of() const {
    return update_tile<E, N, features>;
  }
};

}  // namespace pinball
