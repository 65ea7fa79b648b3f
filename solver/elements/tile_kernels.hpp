#pragma once

#include <cstdint>

#include <kernels/element_data.hpp>

namespace pinball {

/// What one tile of elements reports; combined in the order of the tiles.
template <class S>
struct TileResult {
  double internal = 0, hourglass = 0, viscous = 0, eroded = 0;  ///< energy increments of the step
  double hourglass_plastic = 0;                                 ///< of `internal`: what yield took of hourglass modes
  double folding = 0;                                           ///< energy that corners near turning over store now
  S time_step = 0;                                              ///< smallest stable step [time]
  std::int64_t time_step_slot = -1;                             ///< slot of the element that sets it
  std::int32_t eroded_count = 0;
  std::int32_t inverted_count = 0;
  std::int64_t inside_out_count = 0;  ///< elements with a corner that has turned over
};

/// Packs first ... last - 1: a tile, of one part. E: the elements' numbers; S: the nodes'.
template <class E, class S>
struct TilePacks {
  ElementView<E> elements;
  NodeView<S> nodes;
  const ElementConstants<E>& constants;
  ElementStep<E> step;
  std::int64_t first, last;
};

/// Works one tile through a step.
template <class E, class S>
using TileKernel = void (*)(const TilePacks<E, S>& tile, TileResult<S>&);

/// The kernel for a combination of features: each is compiled for itself, the choice is made once, at the start.
template <class E, class S>
TileKernel<E, S> choose_tile_kernel(const ElementFeatures& features);

/// The same for YieldLaw::general. Behind choose_tile_kernel.
template <class E, class S>
TileKernel<E, S> choose_general_tile_kernel(const ElementFeatures& features);

/// Of tetrahedra there is one. Behind choose_tile_kernel.
template <class E, class S>
TileKernel<E, S> tetrahedron_tile_kernel();

}  // namespace pinball
