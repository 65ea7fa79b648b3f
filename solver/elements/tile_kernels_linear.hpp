#pragma once

#include "tile_kernels_instances.hpp"

/// Included by one source file per precision, as tile_kernels_general.hpp is.
namespace pinball {

template <class S>
TileKernel<S> choose_tile_kernel(const ElementFeatures& f) {
  if constexpr (built::plasticity) {
    if (f.plastic && f.yield == YieldLaw::general) return choose_general_tile_kernel<S>(f);
  }
  if constexpr (built::plasticity && built::erosion) {
    if (f.plastic && f.erosion) return choose_viscosity<S, true, true>(f);
  }
  if constexpr (built::plasticity) {
    if (f.plastic) return choose_viscosity<S, true, false>(f);
  }
  return choose_viscosity<S, false, false>(f);
}

}  // namespace pinball
