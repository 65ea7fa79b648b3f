#pragma once

#include "tile_kernels_instances.hpp"

/// Included by one source file per precision, as tile_kernels_general.hpp is.
namespace pinball {

template <class E, class S>
TileKernel<E, S> choose_tile_kernel(const ElementFeatures& features) {
  if constexpr (built::plasticity) {
    if (features.tetrahedra) return tetrahedron_tile_kernel<E, S>();
    if (is_general(features)) return choose_general_tile_kernel<E, S>(features);
  }
  return choose_linear_features(UpdatesTiles<E, S>{}, features);
}

}  // namespace pinball
